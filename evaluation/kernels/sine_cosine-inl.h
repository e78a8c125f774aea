// Sine and cosine of many phases at once, for the instruction set being compiled.
// Included once per instruction set by way of hwy/foreach_target.h.
#if defined(SHEDLIGHT_KERNELS_SINE_COSINE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEDLIGHT_KERNELS_SINE_COSINE_INL_H_
#undef SHEDLIGHT_KERNELS_SINE_COSINE_INL_H_
#else
#define SHEDLIGHT_KERNELS_SINE_COSINE_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace evaluation::HWY_NAMESPACE {

/// c[0] + c[1] x + ... + c[4] x^4.
template <class D, class V>
HWY_INLINE V degree_4(D tag, V x, const double (&c)[5]) {
  namespace hn = hwy::HWY_NAMESPACE;
  V sum = hn::Set(tag, c[4]);
  for (int power : {3, 2, 1, 0}) sum = hn::MulAdd(sum, x, hn::Set(tag, c[power]));
  return sum;
}

/// Sine and cosine of |phase| <= 1e5 rad, each right to 2.5e-16 absolute (phase_sum.tests.cpp).
///
/// Up to 1.6e6 rad whole multiples of the first two parts of pi/2 are exact, with or without fused
/// products.
/// The phase less the nearest multiple of pi/2, which is taken off in three parts (Cody, Waite
/// 1980); polynomials of least largest error on [-pi/4, pi/4]: sin to 1.6e-18, cos to 7.7e-17,
/// found by Remez' exchange in 50 digits; then the quadrant.
template <class D, class V = hwy::HWY_NAMESPACE::Vec<D>>
HWY_INLINE void sine_cosine(D tag, V phase, V& sine, V& cosine) {
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::RebindToUnsigned<D> du;
  // Adding 1.5 2^52 rounds to a whole number and leaves it in the lowest bits.
  const V rounder = hn::Set(tag, 0x1.8p52);
  const V shifted = hn::MulAdd(phase, hn::Set(tag, 0x1.45f306dc9c883p-1), rounder);
  const V quarters = hn::Sub(shifted, rounder);
  const auto quadrant = hn::BitCast(du, shifted);
  // pi/2 in parts of 33, 33 and 53 bits.
  V r = hn::NegMulAdd(quarters, hn::Set(tag, 0x1.921fb544p+0), phase);
  r = hn::NegMulAdd(quarters, hn::Set(tag, 0x1.0b4611a6p-34), r);
  r = hn::NegMulAdd(quarters, hn::Set(tag, 0x1.3198a2e037073p-69), r);

  constexpr double of_sine[] = {0x1.111111110eb15p-7, -0x1.a01a019ab3959p-13, 0x1.71de34747fa8dp-19,
                                -0x1.ae5db3cc4e404p-26, 0x1.5d6498a061a4fp-33};
  constexpr double of_cosine[] = {0x1.555555555310ap-5, -0x1.6c16c1676ab6bp-10,
                                  0x1.a019faa953d38p-16, -0x1.27e02a0d43316p-22,
                                  0x1.1bc79c0ba4b59p-29};
  const V r2 = hn::Mul(r, r);
  const V p = hn::MulAdd(degree_4(tag, r2, of_sine), r2, hn::Set(tag, -0x1.555555555553dp-3));
  const V s = hn::MulAdd(hn::Mul(p, r2), r, r);
  const V c = hn::MulAdd(hn::MulAdd(degree_4(tag, r2, of_cosine), r2, hn::Set(tag, -0.5)), r2,
                         hn::Set(tag, 1.0));

  const auto one = hn::Set(du, 1), two = hn::Set(du, 2);
  const auto odd = hn::RebindMask(tag, hn::TestBit(quadrant, one));
  const auto sign = [&](auto quarter) {
    return hn::BitCast(tag, hn::ShiftLeft<62>(hn::And(quarter, two)));
  };
  sine = hn::Xor(hn::IfThenElse(odd, c, s), sign(quadrant));
  cosine = hn::Xor(hn::IfThenElse(odd, s, c), sign(hn::Add(quadrant, one)));
}

}  // namespace evaluation::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
