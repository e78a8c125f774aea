// Responses made of the lobes of a window, lit at 75 deg.
#pragma once

#include <cmath>
#include <functional>

#include "evaluation/period/ridges.h"

constexpr double ridge_sigma_um = 16.25;
constexpr double ridge_sigma_f = 1 / (2 * brdf::pi * ridge_sigma_um);

inline evaluation::PlaneOfIncidence plane_at(double theta_i_deg) {
  return {brdf::Angle::deg(theta_i_deg), 1, ridge_sigma_f};
}

/// A response with value(lambda [nm], f [1/um]), light at 75 deg.
inline evaluation::ResponseMatrix response_of(const std::function<double(double, double)>& value,
                                              double lambda_step_nm = 5) {
  evaluation::ResponseMatrix response;
  for (double lambda = 400; lambda <= 700; lambda += lambda_step_nm)
    response.lambda_nm.values.push_back(lambda);
  for (int i = 0; i <= 900; ++i) response.theta_r_deg.values.push_back(-70 + i * 0.1);
  response.values.resize(static_cast<Eigen::Index>(response.lambda_nm.size()),
                         static_cast<Eigen::Index>(response.theta_r_deg.size()));
  for (Eigen::Index i = 0; i < response.values.rows(); ++i)
    for (Eigen::Index j = 0; j < response.values.cols(); ++j) {
      const double lambda_nm = response.lambda_nm[static_cast<std::size_t>(i)];
      const double sines = plane_at(75).sines(response.theta_r_deg[static_cast<std::size_t>(j)]);
      response.values(i, j) = value(lambda_nm, sines / brdf::Length::nm(lambda_nm).um());
    }
  return response;
}

/// The window's lobe about an order.
inline double lobe(double f_per_um, double at_per_um, double sigma_um = ridge_sigma_um) {
  return std::exp(-std::pow(2 * brdf::pi * sigma_um * (f_per_um - at_per_um), 2));
}
