// Random numbers that are the same on every machine: none of the standard's distributions, whose
// numbers are each library's own, and no logarithm of the system.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace brdf {

/// Its numbers, and those of std::seed_seq, are fixed by the C++ standard.
using RandomEngine = std::mt19937_64;

/// An engine of its own for each part of a whole: std::seed_seq of the halves of the seed, the
/// number of the part, and the halves of an index within it.
inline RandomEngine random_engine(std::uint64_t seed, std::uint32_t part, std::int64_t index = 0) {
  const auto low = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
  const auto high = [](std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32); };
  const auto place = static_cast<std::uint64_t>(index);
  std::seed_seq sequence{low(seed), high(seed), part, low(place), high(place)};
  return RandomEngine(sequence);
}

/// ((bits >> 12) + 1/2) 2^-52: a multiple of 2^-53 inside (0, 1), exact. With a bit more the sum
/// would round, and the largest be 1.
inline double unit_interval(std::uint64_t bits) {
  return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

namespace detail {

/// c[0] + c[1] x + ... by Horner's rule.
template <std::size_t n>
double polynomial(const std::array<double, n>& c, double x) {
  double sum = c[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) sum = sum * x + c[i];
  return sum;
}

/// log x, x > 0, of +, -, *, / alone: x = 2^e m, sqrt(1/2) <= m < sqrt 2, log m = 2 atanh s with
/// s = (m - 1) / (m + 1). |s| < 0.172: what follows s^21 is below 1e-18 of the sum.
inline double portable_log(double x) {
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);
  if (mantissa < 1 / std::numbers::sqrt2) {
    mantissa *= 2;
    --exponent;
  }
  const double s = (mantissa - 1) / (mantissa + 1), s2 = s * s;
  double sum = 0;
  for (int power = 21; power >= 1; power -= 2) sum = sum * s2 + 1.0 / power;
  return 2 * s * sum + exponent * std::numbers::ln2;
}

}  // namespace detail

/// z with Phi(z) = p, Phi the normal distribution of mean 0 and standard deviation 1.
///
/// p inside (0, 1). M. J. Wichura, Algorithm AS 241: PPND16, Applied Statistics 37 (1988) 477. Of
/// IEEE +, -, *, /, sqrt alone, so the same to the last bit wherever products and sums are not
/// fused (-ffp-contract=off). Measured: relative error at most 5e-16 ("quantiles of the normal
/// distribution are those of the table").
inline double normal_quantile(double p) {
  using detail::polynomial;
  const double q = p - 0.5;
  if (std::abs(q) <= 0.425) {
    const double r = 0.180625 - q * q;
    return q *
           polynomial<8>(
               {3.3871328727963666080e+0, 1.3314166789178437745e+2, 1.9715909503065514427e+3,
                1.3731693765509461125e+4, 4.5921953931549871457e+4, 6.7265770927008700853e+4,
                3.3430575583588128105e+4, 2.5090809287301226727e+3},
               r) /
           polynomial<8>(
               {1.0, 4.2313330701600911252e+1, 6.8718700749205790830e+2, 5.3941960214247511077e+3,
                2.1213794301586595867e+4, 3.9307895800092710610e+4, 2.8729085735721942674e+4,
                5.2264952788528545610e+3},
               r);
  }
  const double r = std::sqrt(-detail::portable_log(q < 0 ? p : 1 - p));
  const double z = r <= 5
                       ? polynomial<8>({1.42343711074968357734e+0, 4.63033784615654529590e+0,
                                        5.76949722146069140550e+0, 3.64784832476320460504e+0,
                                        1.27045825245236838258e+0, 2.41780725177450611770e-1,
                                        2.27238449892691845833e-2, 7.74545014278341407640e-4},
                                       r - 1.6) /
                             polynomial<8>({1.0, 2.05319162663775882187e+0,
                                            1.67638483018380384940e+0, 6.89767334985100004550e-1,
                                            1.48103976427480074590e-1, 1.51986665636164571966e-2,
                                            5.47593808499534494600e-4, 1.05075007164441684324e-9},
                                           r - 1.6)
                       : polynomial<8>({6.65790464350110377720e+0, 5.46378491116411436990e+0,
                                        1.78482653991729133580e+0, 2.96560571828504891230e-1,
                                        2.65321895265761230930e-2, 1.24266094738807843860e-3,
                                        2.71155556874348757815e-5, 2.01033439929228813265e-7},
                                       r - 5) /
                             polynomial<8>({1.0, 5.99832206555887937690e-1,
                                            1.36929880922735805310e-1, 1.48753612908506148525e-2,
                                            7.86869131145613259100e-4, 1.84631831751005468180e-5,
                                            1.42151175831644588870e-7, 2.04426310338993978564e-15},
                                           r - 5);
  return q < 0 ? -z : z;
}

/// The next normal number, mean 0 and standard deviation 1.
inline double random_normal(RandomEngine& engine) {
  return normal_quantile(unit_interval(engine()));
}

}  // namespace brdf
