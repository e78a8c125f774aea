// The XYZ that `map` writes, read by the tests themselves.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

/// The text and the numbers of an NPY file of doubles.
struct Npy {
  std::string header;
  std::vector<double> numbers;
};

inline Npy npy_of(const std::string& bytes) {
  const std::size_t head =
      10 + static_cast<unsigned char>(bytes.at(8)) + 256u * static_cast<unsigned char>(bytes.at(9));
  Npy npy{bytes.substr(10, head - 10), std::vector<double>((bytes.size() - head) / sizeof(double))};
  std::memcpy(npy.numbers.data(), bytes.data() + head, npy.numbers.size() * sizeof(double));
  return npy;
}

inline std::vector<double> numbers_of(const std::string& bytes) {
  return npy_of(bytes).numbers;
}

/// sin theta_r cos phi_r of a column, or sin theta_r sin phi_r of a row, at a pixel's centre.
inline double place_of(int pixel, int size) {
  return (2.0 * pixel + 1) / size - 1;
}

/// Whether a pixel's centre lies inside the disk of directions.
inline bool in_disk(int column, int row, int size) {
  return std::hypot(place_of(column, size), place_of(row, size)) < 1;
}

/// The angle whose sine is a place, for an option. An axis takes no more digits than these;
/// 1e-12 deg are far below what a colour shows.
inline std::string angle_at(double place) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(12) << std::asin(place) * 180 / 3.14159265358979323846
       << "deg";
  return text.str();
}

/// Largest difference of the luminances of two maps.
inline double worst_y(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double worst = 0;
  for (std::size_t i = 1; i < a.size(); i += 3)
    worst = std::abs(a[i] - b[i]) <= worst ? worst : std::abs(a[i] - b[i]);
  return worst;
}

/// Errors of a map as a part of the local brightness.
struct LocalError {
  double rms, worst;
};

/// Differences of X, Y and Z at each pixel of a map of one light, over the mean luminance of the
/// 5 x 5 pixels around it, or over a thousandth of the largest where that is more: code 3 of 255.
inline LocalError local_error(const std::vector<double>& found, const std::vector<double>& exact,
                              int size) {
  REQUIRE(found.size() == exact.size());
  REQUIRE(exact.size() == 3 * static_cast<std::size_t>(size * size));
  const auto at = [size](int column, int row) {
    return 3 * static_cast<std::size_t>(row * size + column);
  };
  double largest = 0;
  for (std::size_t i = 1; i < exact.size(); i += 3) largest = std::max(largest, exact[i]);
  double squares = 0, worst = 0;
  int pixels = 0;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      if (!in_disk(column, row, size)) continue;
      double sum = 0;
      int near = 0;
      for (int r = std::max(0, row - 2); r <= std::min(size - 1, row + 2); ++r)
        for (int c = std::max(0, column - 2); c <= std::min(size - 1, column + 2); ++c)
          if (in_disk(c, r, size)) {
            sum += exact[at(c, r) + 1];
            ++near;
          }
      const double brightness = std::max(sum / near, 1e-3 * largest);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t place = at(column, row) + i;
        const double part = std::abs(found[place] - exact[place]) / brightness;
        squares += part * part;
        worst = part <= worst ? worst : part;  // a NaN is the worst
      }
      ++pixels;
    }
  return {std::sqrt(squares / (3 * pixels)), worst};
}
