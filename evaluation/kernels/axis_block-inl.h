// Vectors of eight frequencies, and the taps of a kernel at each, for the instruction set being
// compiled. Included once per instruction set by way of hwy/foreach_target.h.
#if defined(SHEDLIGHT_KERNELS_AXIS_BLOCK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEDLIGHT_KERNELS_AXIS_BLOCK_INL_H_
#undef SHEDLIGHT_KERNELS_AXIS_BLOCK_INL_H_
#else
#define SHEDLIGHT_KERNELS_AXIS_BLOCK_INL_H_
#endif

#include <hwy/highway.h>

#include "brdf/term_table.h"

HWY_BEFORE_NAMESPACE();
namespace evaluation::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using brdf::TableAxis;

constexpr int block = 8;  // queries, or pixels, prepared together
using D = hn::CappedTag<double, block>;
using Vec = hn::Vec<D>;
constexpr D d;
constexpr hn::RebindToSigned<D> di;
constexpr int lanes = static_cast<int>(hn::MaxLanes(D()));

/// One axis of a block.
struct AxisBlock {
  HWY_ALIGN double taps[block][brdf::InterpolationKernel::max_width];
  HWY_ALIGN double first[block];
  HWY_ALIGN double sign[block];  // of the weights
};

HWY_INLINE void prepare(const TableAxis& axis, const double* qx, const double* qy, AxisBlock& out) {
  if (axis.width == 1) {
    for (int q = 0; q < block; ++q) {
      out.taps[q][0] = 1;
      out.first[q] = 0;
      out.sign[q] = 1;
    }
    return;
  }
  HWY_ALIGN double t[block], piece[block];
  for (int q = 0; q < block; q += lanes) {
    // Products rounded one by one as in the portable loop: both must pick the same grid points.
    const Vec start =
        hn::Sub(hn::Add(hn::Mul(hn::Load(d, qx + q), hn::Set(d, axis.grid_per_qx_um)),
                        hn::Mul(hn::Load(d, qy + q), hn::Set(d, axis.grid_per_qy_um))),
                hn::Set(d, 0.5 * axis.width));
    const Vec k0 = hn::Ceil(start);
    const Vec scaled = hn::Mul(hn::Sub(k0, start), hn::Set(d, axis.pieces));
    const Vec whole = hn::Min(hn::Floor(scaled), hn::Set(d, axis.pieces - 1.0));
    const Vec fraction = hn::Sub(scaled, whole);
    hn::Store(hn::Sub(hn::Add(fraction, fraction), hn::Set(d, 1.0)), d, t + q);
    hn::Store(whole, d, piece + q);
    const Vec local = hn::Sub(k0, hn::Set(d, static_cast<double>(axis.first)));
    const Vec period = hn::Set(d, static_cast<double>(axis.period));
    const Vec turns = hn::Floor(hn::Div(local, period));
    const Vec wrapped = hn::Sub(local, hn::Mul(turns, period));
    hn::Store(hn::Min(hn::Max(wrapped, hn::Zero(d)),
                      hn::Set(d, static_cast<double>(axis.count - axis.width))),
              d, out.first + q);
    const Vec half = hn::Mul(turns, hn::Set(d, 0.5));
    hn::Store(
        hn::IfThenElse(hn::Eq(half, hn::Floor(half)), hn::Set(d, 1.0), hn::Set(d, axis.turn_sign)),
        d, out.sign + q);
  }
  constexpr int side_by_side = 4;  // products wait for their forerunner: several queries at once
  for (int q = 0; q < block; q += side_by_side) {
    const double* highest[side_by_side];
    Vec x[side_by_side];
    for (int k = 0; k < side_by_side; ++k) {
      const long first_power = static_cast<long>(piece[q + k]) * (axis.degree + 1);
      highest[k] = axis.coefficients + (first_power + axis.degree) * axis.tap_stride;
      x[k] = hn::Set(d, t[q + k]);
    }
    for (int tap = 0; tap < axis.tap_stride; tap += lanes) {
      Vec weight[side_by_side];
      for (int k = 0; k < side_by_side; ++k) weight[k] = hn::LoadU(d, highest[k] + tap);
      for (long below = tap - axis.tap_stride; below >= tap - axis.degree * axis.tap_stride;
           below -= axis.tap_stride)
        for (int k = 0; k < side_by_side; ++k)
          weight[k] = hn::MulAdd(weight[k], x[k], hn::LoadU(d, highest[k] + below));
      for (int k = 0; k < side_by_side; ++k) hn::StoreU(weight[k], d, &out.taps[q + k][tap]);
    }
  }
}

}  // namespace evaluation::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
