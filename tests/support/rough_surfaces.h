// The rough surfaces that the microfacet tests go through.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "brdf/microfacet.h"

inline constexpr std::array all_maskings = {brdf::Masking::implicit, brdf::Masking::cook_torrance,
                                            brdf::Masking::kelemen, brdf::Masking::smith};

/// Every distribution at one roughness, gtr with a longer and a shorter tail than ggx.
inline std::vector<brdf::Roughness> roughnesses(double alpha) {
  using brdf::Distribution;
  std::vector<brdf::Roughness> all{{Distribution::beckmann, alpha, 2},
                                   {Distribution::ggx, alpha, 2},
                                   {Distribution::gtr, alpha, 1},
                                   {Distribution::gtr, alpha, 3}};
  if (alpha <= 1) all.push_back({Distribution::blinn_phong, alpha, 2});
  return all;
}

/// The width at which `integral_over_facets` finds all facets: long tails need wider spread points.
inline double quadrature_width(const brdf::Roughness& roughness) {
  const bool long_tail = roughness.distribution == brdf::Distribution::gtr && roughness.gamma < 2;
  return long_tail ? std::sqrt(roughness.alpha) : roughness.alpha;
}
