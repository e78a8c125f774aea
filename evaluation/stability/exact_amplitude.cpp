#include "evaluation/stability/exact_amplitude.h"

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace evaluation::stability {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

struct Complex {
  Real re = 0, im = 0;

  Complex& operator+=(const Complex& other) {
    re += other.re;
    im += other.im;
    return *this;
  }
};

Complex operator*(const Complex& a, const Complex& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
Complex operator*(const Real& factor, const Complex& a) {
  return {factor * a.re, factor * a.im};
}

Complex turned(const Real& phase) {
  return {cos(phase), sin(phase)};
}

/// One axis: the positions of all pixels of the patch, repetition by repetition, and the window.
class ExactAxis {
 public:
  ExactAxis(const brdf::Surface& surface, const brdf::SurfaceAxis& axis)
      : count_(axis.count), pixel_um_(axis.pixel_um) {
    const bool replicated = surface.model == brdf::SurfaceModel::replicated;
    if (replicated) copies_ = axis.last_copy + 1;
    const Real middle = Real(axis.count - 1) / 2;
    for (int copy = replicated ? 0 : axis.first_copy; copy <= (replicated ? 0 : axis.last_copy);
         ++copy)
      for (Eigen::Index index = 0; index < axis.count; ++index) {
        x_um_.push_back(pixel_um_ * (Real(index) + Real(copy) * Real(axis.count) - middle));
        const Real sigmas = x_um_.back() / Real(surface.window.sigma_um());
        g_.push_back(replicated ? Real(1) : Real(exp(-sigmas * sigmas / 2)));
        sum_ += g_.back();
      }
  }

  /// Per pixel of the patch: sum over its repetitions of g exp(i q x) / sum g.
  std::vector<Complex> weights(double q_per_um) const {
    std::vector<Complex> weights(static_cast<std::size_t>(count_));
    const Real scale = replica_factor(q_per_um) / sum_;
    for (std::size_t n = 0; n < x_um_.size(); ++n)
      weights[n % weights.size()] += (scale * g_[n]) * turned(Real(q_per_um) * x_um_[n]);
    return weights;
  }

 private:
  /// sin(N pi nu) / (N sin(pi nu)), nu = q L / (2 pi).
  Real replica_factor(double q_per_um) const {
    const Real half = Real(q_per_um) * pixel_um_ * Real(count_) / 2;
    if (copies_ == 1 || sin(half) == 0) return 1;
    return sin(Real(copies_) * half) / (Real(copies_) * sin(half));
  }

  Eigen::Index count_;
  Real pixel_um_;
  int copies_ = 1;
  std::vector<Real> x_um_, g_;
  Real sum_ = 0;
};

}  // namespace

std::vector<std::complex<long double>> exact_amplitudes(const brdf::Surface& surface,
                                                        std::span<const brdf::Query> queries) {
  const ExactAxis x(surface, x_axis(surface)), y(surface, y_axis(surface));
  const brdf::HeightArray& heights_um = surface.heights->heights_um();
  std::vector<std::complex<long double>> amplitudes;
  for (const brdf::Query& q : queries) {
    const std::vector<Complex> along_x = x.weights(q.qx_per_um), along_y = y.weights(q.qy_per_um);
    Complex total;
    for (Eigen::Index row = 0; row < heights_um.rows(); ++row)
      for (Eigen::Index col = 0; col < heights_um.cols(); ++col)
        total += along_y[static_cast<std::size_t>(row)] * along_x[static_cast<std::size_t>(col)] *
                 turned(Real(q.c_per_um) * Real(heights_um(row, col)));
    amplitudes.emplace_back(static_cast<long double>(total.re), static_cast<long double>(total.im));
  }
  return amplitudes;
}

}  // namespace evaluation::stability
