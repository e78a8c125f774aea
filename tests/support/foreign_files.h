// Files that other programs wrote, and the numbers that they were given: tests/data/foreign.
#pragma once

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

inline std::filesystem::path foreign_file(const std::string& name) {
  return std::filesystem::path(SHEDLIGHT_FOREIGN_FILES) / name;
}

inline std::string foreign_bytes(const std::string& name) {
  std::ifstream file(foreign_file(name), std::ios::binary);
  REQUIRE(file);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

/// Row by row. strtod, which is not what the readers use.
inline std::vector<double> foreign_numbers(const std::string& csv) {
  std::vector<double> numbers;
  std::istringstream lines(foreign_bytes(csv));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');)
      numbers.push_back(std::strtod(field.c_str(), nullptr));
  }
  return numbers;
}
