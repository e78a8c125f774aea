// The largest of many errors, kept so that a NaN is never lost.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

/// Catch prints doubles in fixed notation with 10 digits: small errors would all read 0.0.
inline const bool small_errors_are_shown = [] {
  Catch::StringMaker<double>::precision = 20;
  return true;
}();

class WorstError {
 public:
  void see(double error) {
    ++seen_;
    if (std::isnan(worst_)) return;
    if (!(error <= worst_)) worst_ = error;
  }
  /// NaN where any error was, or where none was seen: fails every comparison.
  double value() const { return seen_ > 0 ? worst_ : std::numeric_limits<double>::quiet_NaN(); }

 private:
  double worst_ = 0;
  long seen_ = 0;
};
