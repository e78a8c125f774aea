// The largest of many errors.
#pragma once

#include <cmath>

namespace evaluation {

/// Kept so that no NaN is lost: it counts as larger than any number, and stays.
class WorstError {
 public:
  /// error: >= 0 or NaN. Whether it is the largest so far.
  bool see(double error) {
    if (std::isnan(worst_) || error <= worst_) return false;
    worst_ = error;
    return true;
  }
  bool has_seen_any() const { return worst_ != none; }
  /// NaN where an error was; 0 where none was seen.
  double value() const { return has_seen_any() ? worst_ : 0; }

 private:
  static constexpr double none = -1;
  double worst_ = none;
};

}  // namespace evaluation
