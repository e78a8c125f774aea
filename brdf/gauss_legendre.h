// The quadrature for smooth functions on an interval.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "brdf/units.h"

namespace brdf {

struct QuadratureRule {
  std::vector<double> nodes, weights;
};

/// Gauss-Legendre rule on [0, 1], exact for polynomials of degree 2 count - 1.
inline QuadratureRule gauss_legendre(int count) {
  QuadratureRule rule;
  for (int i = 0; i < count; ++i) {
    double x = std::cos(pi * (i + 0.75) / (count + 0.5)), derivative = 1;
    for (int step = 0; step < 6; ++step) {  // Newton doubles the digits: 1e-2 to below rounding
      double previous = 1, current = x;
      for (int n = 2; n <= count; ++n)
        previous = std::exchange(current, ((2 * n - 1) * x * current - (n - 1) * previous) / n);
      derivative = count * (x * current - previous) / (x * x - 1);
      x -= current / derivative;
    }
    rule.nodes.push_back((1 - x) / 2);
    rule.weights.push_back(1 / ((1 - x * x) * derivative * derivative));
  }
  return rule;
}

}  // namespace brdf
