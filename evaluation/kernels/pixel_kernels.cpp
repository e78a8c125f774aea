#include "evaluation/kernels/pixel_kernels.h"

// Vectors of unknown size cannot be kept in arrays.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "evaluation/kernels/pixel_kernels.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
#include <hwy/highway.h>

#include "evaluation/kernels/axis_block-inl.h"

// Only plain arrays and Highway inside: a template of the standard library would be instantiated
// with the instruction set of one target and linked into all of them.
HWY_BEFORE_NAMESPACE();
namespace evaluation::HWY_NAMESPACE {

using brdf::PixelStrip;

/// `unrolled` steps of one vector of lanes: the sums are loaded and stored once for all of them.
template <int unrolled>
HWY_INLINE void moment_steps(const PixelStrip& strip, const double* from, std::size_t step,
                             int degrees, double* sums) {
  Vec twice[unrolled], previous[unrolled], current[unrolled];  // the latter times the weight
  // Each step may lie in a page of its own, where no hardware looks ahead.
  const std::size_t left = strip.steps - step;
  const std::size_t ahead = step + (left < 3 * unrolled ? left - unrolled : 2 * unrolled);
  for (int u = 0; u < unrolled; ++u) {
    hwy::Prefetch(from + static_cast<std::ptrdiff_t>(ahead + u) * strip.stride + lanes - 1);
    const Vec h = hn::LoadU(d, from + static_cast<std::ptrdiff_t>(step + u) * strip.stride);
    const Vec s =
        hn::Mul(hn::Sub(h, hn::Set(d, strip.mid_um)), hn::Set(d, strip.per_half_range_um));
    twice[u] = hn::Add(s, s);
    current[u] = hn::Set(d, strip.weights[step + u]);
    previous[u] = hn::Mul(current[u], s);  // T_{-1} = T_1
  }
  for (int m = 0; m < degrees; ++m, sums += PixelStrip::lanes) {
    Vec part[unrolled];
    for (int u = 0; u < unrolled; ++u) {
      part[u] = current[u];
      current[u] = hn::MulSub(twice[u], current[u], previous[u]);
      previous[u] = part[u];
    }
    // In pairs: one long chain of sums would take longer than the products.
    for (int half = unrolled / 2; half > 0; half /= 2)
      for (int u = 0; u < half; ++u) part[u] = hn::Add(part[u], part[u + half]);
    hn::StoreU(hn::Add(hn::LoadU(d, sums), part[0]), d, sums);
  }
}

void moments(const PixelStrip& strip, int degrees, double* sums) {
  for (int i = 0; i < PixelStrip::lanes * degrees; ++i) sums[i] = 0;
  // Three vectors a step have to stay in registers: 32 of them with AVX-512, 16 else.
  constexpr int unrolled = lanes == 8 ? 8 : 4;
  for (int lane = 0; lane < PixelStrip::lanes; lane += lanes) {
    std::size_t step = 0;
    for (; step + unrolled <= strip.steps; step += unrolled)
      moment_steps<unrolled>(strip, strip.first_um + lane, step, degrees, sums + lane);
    for (; step < strip.steps; ++step)
      moment_steps<1>(strip, strip.first_um + lane, step, degrees, sums + lane);
  }
}

void spread(const brdf::SpreadLine& line, const double* positions, const double* weights, int count,
            const double* moments) {
  static_assert(PixelStrip::lanes == block && brdf::SpreadLine::step % lanes == 0);
  HWY_ALIGN double along[block], across[block] = {};
  for (int l = 0; l < block; ++l) along[l] = positions[l];
  AxisBlock axis;
  prepare(line.axis, along, across, axis);
  HWY_ALIGN hn::TFromD<decltype(di)> rows[lanes];
  for (int m = 0; m < lanes; ++m) rows[m] = m * PixelStrip::lanes;
  const auto degree = hn::Load(di, rows);
  for (int l = 0; l < count; ++l) {
    double* const first = line.samples + static_cast<std::size_t>(axis.first[l]) * line.stride;
    const Vec weight = hn::Set(d, weights[l]);
    for (int m = 0; m < line.degrees; m += lanes) {
      const Vec pixel =
          hn::Mul(weight, hn::GatherIndex(d, moments + m * PixelStrip::lanes + l, degree));
      double* to = first + m;
      for (int tap = 0; tap < line.axis.width; ++tap, to += line.stride)
        hn::StoreU(hn::MulAdd(hn::Set(d, axis.taps[l][tap]), pixel, hn::LoadU(d, to)), d, to);
    }
  }
}

}  // namespace evaluation::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace evaluation {

HWY_EXPORT(moments);
HWY_EXPORT(spread);

PixelKernels vectorised_pixel_kernels() {
  return {&HWY_DYNAMIC_DISPATCH(moments), &HWY_DYNAMIC_DISPATCH(spread)};
}

}  // namespace evaluation
#endif
