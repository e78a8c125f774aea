// Figures that docs/derivations.md quotes, measured by the tests.
#pragma once

#include <cstdio>
#include <cstdlib>

/// Hands a measured figure on. Where SHEDLIGHT_FIGURES is set, it is printed as one line:
/// step or erratum, what it is, value.
inline double figure(const char* step, const char* what, double value) {
  if (std::getenv("SHEDLIGHT_FIGURES") != nullptr)
    std::printf("figure | %-22s | %-62s | %.4g\n", step, what, value);
  return value;
}
