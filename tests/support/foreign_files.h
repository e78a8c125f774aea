// Files that other programs wrote, in tests/data/foreign, and their values.
#pragma once

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "brdf/height_field.h"

inline std::filesystem::path foreign_file(const std::string& name) {
  return std::filesystem::path(SHEDLIGHT_FOREIGN) / name;
}

inline std::string foreign_bytes(const std::string& name) {
  std::ifstream file(foreign_file(name), std::ios::binary);
  if (!file) throw std::runtime_error("no file " + name);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

/// A CSV of doubles of 17 digits. strtod, which is not what the readers use.
inline brdf::HeightArray foreign_values(const std::string& name) {
  std::istringstream lines(foreign_bytes(name));
  std::vector<double> numbers;
  Eigen::Index rows = 0;
  for (std::string line; std::getline(lines, line); ++rows) {
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      char* end = nullptr;
      numbers.push_back(std::strtod(cell.c_str(), &end));
      if (end == cell.c_str() || *end != '\0') throw std::runtime_error(name + ": " + cell);
    }
  }
  const auto count = static_cast<Eigen::Index>(numbers.size());
  if (rows == 0 || count % rows != 0) throw std::runtime_error(name + ": no whole rows");
  return Eigen::Map<brdf::HeightArray>(numbers.data(), rows, count / rows);
}

/// The same, row by row.
inline std::vector<double> foreign_numbers(const std::string& name) {
  const brdf::HeightArray values = foreign_values(name);
  return {values.data(), values.data() + values.size()};
}

constexpr double no_height = std::numeric_limits<double>::quiet_NaN();

/// The same numbers to the last bit; any NaN is the same as any other.
inline void check_same_bits(const brdf::HeightArray& values, const brdf::HeightArray& expected) {
  REQUIRE(values.rows() == expected.rows());
  REQUIRE(values.cols() == expected.cols());
  for (Eigen::Index row = 0; row < values.rows(); ++row)
    for (Eigen::Index col = 0; col < values.cols(); ++col) {
      INFO("row " << row << ", column " << col);
      if (std::isnan(expected(row, col)))
        CHECK(std::isnan(values(row, col)));
      else
        CHECK(std::bit_cast<std::uint64_t>(values(row, col)) ==
              std::bit_cast<std::uint64_t>(expected(row, col)));
    }
}
