// One sampled axis of a response.
#pragma once

#include <string>
#include <vector>

namespace evaluation {

/// Strictly increasing values; their unit is in the name of whatever holds the axis.
struct Axis {
  /// Written with the shortest text that reads back the same.
  static constexpr int shortest = -1;

  std::vector<double> values;
  int decimals = shortest;  ///< digits after the point when written, as the user gave them

  std::size_t size() const { return values.size(); }
  double operator[](std::size_t i) const { return values[i]; }
  double front() const { return values.front(); }
  double back() const { return values.back(); }
};

/// Locale-free text of a value, with a fixed number of decimals or the shortest exact one.
std::string number_text(double value, int decimals = Axis::shortest);

}  // namespace evaluation
