#include "evaluation/kernels/phase_sum.h"

#include <algorithm>
#include <cmath>

// Vectors of unknown size cannot be kept in structures.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "evaluation/kernels/phase_sum.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
#include <hwy/highway.h>

#include "evaluation/kernels/sine_cosine-inl.h"

// Nothing of the standard library inside: it would be instantiated with the instruction set of one
// target and linked into all of them.
HWY_BEFORE_NAMESPACE();
namespace evaluation::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::ScalableTag<double>;
using Vector = hn::Vec<Lanes>;
constexpr std::size_t lanes = hn::MaxLanes(Lanes{});

/// The entries from `first` on; zeros beyond the last, which then add nothing.
struct RowEnd {
  HWY_ALIGN double entries[lanes] = {};

  HWY_INLINE RowEnd(const double* row, std::size_t first, std::size_t count) {
    for (std::size_t j = first; j < count; ++j) entries[j - first] = row[j];
  }
  HWY_INLINE Vector load() const { return hn::Load(Lanes{}, entries); }
  HWY_INLINE void copy_to(double* row, std::size_t first, std::size_t count) const {
    for (std::size_t j = first; j < count; ++j) row[j] = entries[j - first];
  }
};

struct RowSum {
  Vector re, im;

  HWY_INLINE void add(Vector phase, Vector weight_re, Vector weight_im) {
    Vector sine, cosine;
    sine_cosine(Lanes{}, phase, sine, cosine);
    re = hn::NegMulAdd(weight_im, sine, hn::MulAdd(weight_re, cosine, re));
    im = hn::MulAdd(weight_im, cosine, hn::MulAdd(weight_re, sine, im));
  }
};

void row_sum(const brdf::PhaseRow& row, double* re, double* im) {
  const Lanes d;
  const Vector c = hn::Set(d, row.c_per_um), mid = hn::Set(d, row.mid_um);
  RowSum sum{hn::Zero(d), hn::Zero(d)};
  std::size_t j = 0;
  for (; j + lanes <= row.count; j += lanes)
    sum.add(hn::Mul(c, hn::Sub(hn::LoadU(d, row.heights_um + j), mid)),
            hn::LoadU(d, row.weight_re + j), hn::LoadU(d, row.weight_im + j));
  if (j < row.count)
    sum.add(hn::Mul(c, hn::Sub(RowEnd(row.heights_um, j, row.count).load(), mid)),
            RowEnd(row.weight_re, j, row.count).load(), RowEnd(row.weight_im, j, row.count).load());
  *re = hn::GetLane(hn::SumOfLanes(d, sum.re));
  *im = hn::GetLane(hn::SumOfLanes(d, sum.im));
}

/// (re, im) += g (cos, sin)(phase).
HWY_INLINE void add_phasor(Vector phase, Vector g, double* re, double* im) {
  const Lanes d;
  Vector sine, cosine;
  sine_cosine(d, phase, sine, cosine);
  hn::StoreU(hn::MulAdd(g, cosine, hn::LoadU(d, re)), d, re);
  hn::StoreU(hn::MulAdd(g, sine, hn::LoadU(d, im)), d, im);
}

void add_phasors(const brdf::PhasePoints& points, double q_per_um, double* re, double* im) {
  const Lanes d;
  const Vector q = hn::Set(d, q_per_um);
  const std::size_t count = points.count;
  std::size_t j = 0;
  for (; j + lanes <= count; j += lanes)
    add_phasor(hn::Mul(q, hn::LoadU(d, points.x_um + j)), hn::LoadU(d, points.illumination + j),
               re + j, im + j);
  if (j == count) return;
  RowEnd end_re(re, j, count), end_im(im, j, count);
  add_phasor(hn::Mul(q, RowEnd(points.x_um, j, count).load()),
             RowEnd(points.illumination, j, count).load(), end_re.entries, end_im.entries);
  end_re.copy_to(re, j, count);
  end_im.copy_to(im, j, count);
}

}  // namespace evaluation::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace evaluation {

HWY_EXPORT(row_sum);
HWY_EXPORT(add_phasors);

namespace {

// The reach of sine_cosine, see sine_cosine-inl.h.
constexpr double max_phase_rad = 1e5;

std::complex<double> best_row_sum(const brdf::PhaseRow& row) {
  if (!(std::abs(row.c_per_um) * row.half_range_um <= max_phase_rad))
    return brdf::portable_row_sum(row);
  double re = 0, im = 0;
  HWY_DYNAMIC_DISPATCH(row_sum)(row, &re, &im);
  return {re, im};
}

void best_add_phasors(const brdf::PhasePoints& points, double q_per_um, double* re, double* im) {
  if (points.count == 0) return;
  const double reach_um =
      std::max(std::abs(points.x_um[0]), std::abs(points.x_um[points.count - 1]));
  if (!(std::abs(q_per_um) * reach_um <= max_phase_rad))
    return brdf::portable_add_phasors(points, q_per_um, re, im);
  HWY_DYNAMIC_DISPATCH(add_phasors)(points, q_per_um, re, im);
}

}  // namespace

const brdf::PhaseKernels& vectorised_phase_kernels() {
  static constexpr brdf::PhaseKernels kernels{best_row_sum, best_add_phasors};
  return kernels;
}

}  // namespace evaluation
#endif
