#include "evaluation/kernels/series_kernels.h"

#include <cmath>

// Vectors of unknown size cannot be kept in arrays.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "evaluation/kernels/series_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
#include <hwy/highway.h>

#include "evaluation/kernels/axis_block-inl.h"
#include "evaluation/kernels/phase_sum.h"
#include "evaluation/kernels/pixel_kernels.h"
#include "evaluation/kernels/sine_cosine-inl.h"

// Only plain arrays and Highway inside: a template of the standard library would be instantiated
// with the instruction set of one target and linked into all of them.
HWY_BEFORE_NAMESPACE();
namespace evaluation::HWY_NAMESPACE {

using brdf::Query;
using brdf::TermTable;

// Four running sums hide the latency of a product and leave registers for the rest.
constexpr int group = 4;
constexpr double max_phase_rad = 1e5;  // the reach of sine_cosine

struct SineCosine {
  Vec sine, cosine;
};

HWY_INLINE SineCosine turned(Vec phase) {
  SineCosine turn;
  sine_cosine(d, phase, turn.sine, turn.cosine);
  return turn;
}

HWY_INLINE Vec load(const double* from) {
  return hn::LoadU(d, from);
}
HWY_INLINE Vec load(const float* from) {
  return hn::PromoteTo(d, hn::LoadU(hn::Rebind<float, D>(), from));
}

/// sum over taps of count vectors of an entry, times T_n of the query: (re, im) added to sum.
/// planar: the outer axis has one tap, of weight 1.
template <bool planar, int count, class Real>
HWY_INLINE Vec gather_group(const TermTable<Real>& table, const Real* entry, std::size_t row,
                            const double* outer, const double* inner, const double* chebyshev) {
  Vec total[count];
  for (int v = 0; v < count; ++v) total[v] = hn::Zero(d);
  const std::size_t line = static_cast<std::size_t>(table.inner.count) * row;
  for (int o = 0; o < (planar ? 1 : table.outer.width); ++o) {
    Vec along[count];
    for (int v = 0; v < count; ++v) along[v] = hn::Zero(d);
    const Real* from = entry + static_cast<std::size_t>(o) * line;
#pragma GCC unroll 4
    for (int i = 0; i < table.inner.width; ++i, from += row) {
      const Vec weight = hn::Set(d, inner[i]);
      for (int v = 0; v < count; ++v)
        along[v] = hn::MulAdd(weight, load(from + v * lanes), along[v]);
    }
    const Vec weight = hn::Set(d, outer[o]);
    for (int v = 0; v < count; ++v)
      total[v] = planar ? along[v] : hn::MulAdd(weight, along[v], total[v]);
  }
  // [T_0, T_1, ...] to [T_0, T_0, T_1, T_1, ...], for (re, im).
  HWY_ALIGN hn::TFromD<decltype(di)> pairs[lanes];
  for (int l = 0; l < lanes; ++l) pairs[l] = l / 2;
  const auto twice = hn::SetTableIndices(d, pairs);
  Vec sum = hn::Zero(d);
  for (int v = 0; v < count; ++v) {
    const int n = v * lanes / 2;
    const double* from = chebyshev + n / 4 * (4 * block) + n % 4;
    sum = hn::MulAdd(hn::TableLookupLanes(hn::LoadU(d, from), twice), total[v], sum);
  }
  return sum;
}

template <bool planar, class Real>
HWY_INLINE Vec gather_some(int count, const TermTable<Real>& table, const Real* entry,
                           std::size_t row, const double* outer, const double* inner,
                           const double* chebyshev) {
  switch (count) {
    case 1:
      return gather_group<planar, 1>(table, entry, row, outer, inner, chebyshev);
    case 2:
      return gather_group<planar, 2>(table, entry, row, outer, inner, chebyshev);
    case 3:
      return gather_group<planar, 3>(table, entry, row, outer, inner, chebyshev);
    default:
      return gather_group<planar, 4>(table, entry, row, outer, inner, chebyshev);
  }
}

/// Adds the sums over the even and over the odd lanes to to[0] and to[1].
template <class Lanes, class V>
HWY_INLINE void add_pairs(Lanes tag, V sum, double* to) {
#if HWY_TARGET != HWY_SCALAR
  if constexpr (hn::MaxLanes(Lanes()) > 2) {
    const hn::Half<Lanes> half;
    return add_pairs(half, hn::Add(hn::LowerHalf(half, sum), hn::UpperHalf(half, sum)), to);
  }
#endif
  hn::Store(hn::Add(hn::Load(tag, to), sum), tag, to);
}

/// T_n, and the step to the next; twice_tau is 2 tau.
HWY_INLINE Vec next_chebyshev(Vec twice_tau, Vec& current, Vec& previous) {
  const Vec t = current;
  current = hn::MulSub(twice_tau, current, previous);
  previous = t;
  return t;
}

/// u_r of a table with a basis.
template <class Real>
HWY_INLINE Vec basis_term(const TermTable<Real>& table, int r, const double* powers) {
  Vec sum = hn::Zero(d);
  if (r >= table.terms) return sum;
  const double* row = table.basis + r * table.degrees;
  for (int n = r < table.even_terms ? 0 : 1; n < table.degrees; n += 2)
    sum = hn::MulAdd(hn::Set(d, row[n]), hn::Load(d, powers + n * block), sum);
  return sum;
}

template <bool planar, class Real>
HWY_INLINE void gather_block(const TermTable<Real>& table, const Query* queries, double* out) {
  HWY_ALIGN double qx[block], qy[block], sums[2 * block] = {};  // (re, im) of each query
  Vec tau[block / lanes], previous[block / lanes], current[block / lanes], phase[block / lanes];
  bool far = false;
  for (int q = 0, g = 0; q < block; q += lanes, ++g) {
    Vec x, y, c;
    hn::LoadInterleaved3(d, &queries[q].qx_per_um, x, y, c);
    hn::Store(x, d, qx + q);
    hn::Store(y, d, qy + q);
    tau[g] = hn::Mul(hn::Sub(c, hn::Set(d, table.c_mid_per_um)), hn::Set(d, table.per_c_um));
    previous[g] = tau[g];  // T_{-1} = T_1
    current[g] = hn::Set(d, 1.0);
    tau[g] = hn::Add(tau[g], tau[g]);
    phase[g] = hn::Add(hn::Add(hn::Mul(hn::Set(d, table.phase_per_c_um), c),
                               hn::Mul(hn::Set(d, table.phase_per_qx_um), x)),
                       hn::Mul(hn::Set(d, table.phase_per_qy_um), y));
    far = far || !hn::AllTrue(d, hn::Le(hn::Abs(phase[g]), hn::Set(d, max_phase_rad)));
  }
  AxisBlock outer, inner;
  prepare(table.outer, qx, qy, outer);
  prepare(table.inner, qx, qy, inner);
  const auto row = static_cast<std::size_t>(2 * ((table.terms + 3) / 4 * 4));
  const int vectors = static_cast<int>(row) / lanes;
  // [four terms][query][term], and what a load of whole vectors reads past it.
  constexpr int size = group * lanes / 2 * block;
  HWY_ALIGN double chebyshev[size + block];
  for (int i = size; i < size + block; ++i) chebyshev[i] = 0;
  HWY_ALIGN double powers[TermTable<Real>::max_degrees * block];  // [n][query]: T_n
  if (table.basis != nullptr)
    for (int n = 0; n < table.degrees; ++n)
      for (int q = 0, g = 0; q < block; q += lanes, ++g)
        hn::Store(next_chebyshev(tau[g], current[g], previous[g]), d, powers + n * block + q);
  for (int v = 0; v < vectors; v += group) {
    const int count = vectors - v < group ? vectors - v : group;
    for (int n = 0; n < count * lanes / 2; n += 4)
      for (int q = 0, g = 0; q < block; q += lanes, ++g) {
        Vec u[4];
        for (int k = 0; k < 4; ++k)
          u[k] = table.basis != nullptr ? basis_term(table, v * lanes / 2 + n + k, powers + q)
                                        : next_chebyshev(tau[g], current[g], previous[g]);
        hn::StoreInterleaved4(u[0], u[1], u[2], u[3], d, chebyshev + n * block + 4 * q);
      }
    for (int q = 0; q < block; ++q) {
      const Real* entry =
          table.entries +
          (static_cast<std::size_t>(outer.first[q]) * static_cast<std::size_t>(table.inner.count) +
           static_cast<std::size_t>(inner.first[q])) *
              row +
          static_cast<std::size_t>(v * lanes);
      const Vec sum = gather_some<planar>(count, table, entry, row, outer.taps[q], inner.taps[q],
                                          chebyshev + 4 * q);
      add_pairs(d, sum, sums + 2 * q);
    }
  }
  for (int q = 0, g = 0; q < block; q += lanes, ++g) {
    SineCosine turn = turned(phase[g]);
    if (far) {
      HWY_ALIGN double angle[lanes], sine[lanes], cosine[lanes];
      hn::Store(phase[g], d, angle);
      for (int l = 0; l < lanes; ++l) {
        sine[l] = std::sin(angle[l]);
        cosine[l] = std::cos(angle[l]);
      }
      turn = {hn::Load(d, sine), hn::Load(d, cosine)};
    }
    const Vec sign = hn::Mul(hn::Load(d, outer.sign + q), hn::Load(d, inner.sign + q));
    Vec re, im;
    hn::LoadInterleaved2(d, sums + 2 * q, re, im);
    const Vec a = hn::Mul(sign, re), b = hn::Mul(sign, im);
    hn::StoreInterleaved2(hn::Sub(hn::Mul(a, turn.cosine), hn::Mul(b, turn.sine)),
                          hn::Add(hn::Mul(a, turn.sine), hn::Mul(b, turn.cosine)), d, out + 2 * q);
  }
}

template <bool planar, class Real>
HWY_INLINE void gather_blocks(const TermTable<Real>& table, const Query* queries, std::size_t count,
                              std::complex<double>* amplitudes) {
  auto* out = reinterpret_cast<double*>(amplitudes);
  std::size_t first = 0;
  for (; first + block <= count; first += block)
    gather_block<planar>(table, queries + first, out + 2 * first);
  if (first == count) return;
  // The last ones once more through the same instructions: a query's bits never depend on its
  // place.
  Query rest[block];
  double results[2 * block];
  for (std::size_t q = 0; q < block; ++q)
    rest[q] = queries[first + q < count ? first + q : count - 1];
  gather_block<planar>(table, rest, results);
  for (std::size_t q = 0; q < 2 * (count - first); ++q) out[2 * first + q] = results[q];
}

template <class Real>
HWY_INLINE void gather(const TermTable<Real>& table, const Query* queries, std::size_t count,
                       std::complex<double>* amplitudes) {
  if (table.outer.width == 1)
    gather_blocks<true>(table, queries, count, amplitudes);
  else
    gather_blocks<false>(table, queries, count, amplitudes);
}

void gather_float(const TermTable<float>& table, const Query* queries, std::size_t count,
                  std::complex<double>* amplitudes) {
  gather(table, queries, count, amplitudes);
}

void gather_double(const TermTable<double>& table, const Query* queries, std::size_t count,
                   std::complex<double>* amplitudes) {
  gather(table, queries, count, amplitudes);
}

const char* target_name() {
  return hwy::TargetName(HWY_TARGET);
}

}  // namespace evaluation::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace evaluation {

HWY_EXPORT(gather_float);
HWY_EXPORT(gather_double);
HWY_EXPORT(target_name);

const brdf::SeriesKernels& vectorised_kernels() {
  static const brdf::SeriesKernels kernels = [] {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    const PixelKernels pixels = vectorised_pixel_kernels();
    return brdf::SeriesKernels{&HWY_DYNAMIC_DISPATCH(gather_float),
                               &HWY_DYNAMIC_DISPATCH(gather_double), pixels.moments, pixels.spread,
                               vectorised_phase_kernels(),
                               // A sine, a cosine and two products; benchmarks/results.
                               1.1e-9};
  }();
  return kernels;
}

std::string_view instruction_set() {
  return HWY_DYNAMIC_DISPATCH(target_name)();
}

}  // namespace evaluation
#endif
