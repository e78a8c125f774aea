// Files that other programs wrote, in tests/data/foreign, and their values.
#pragma once

#include <unistd.h>

#include <bit>
#include <catch2/catch.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "brdf/error.h"
#include "evaluation/readers/height_formats.h"

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

/// A CSV of doubles of 17 digits.
inline brdf::HeightArray foreign_values(const std::string& name) {
  std::istringstream lines(foreign_bytes(name));
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      double value = 0;
      const auto [end, ec] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
      if (ec != std::errc{} || end != cell.data() + cell.size())
        throw std::runtime_error(name + ": " + cell);
      rows.back().push_back(value);
    }
  }
  brdf::HeightArray values(rows.size(), rows.at(0).size());
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t col = 0; col < rows[row].size(); ++col)
      values(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(col)) = rows.at(row).at(col);
  return values;
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

constexpr double no_height = std::numeric_limits<double>::quiet_NaN();

inline evaluation::HeightRequest request_for(std::optional<std::string> channel = {}) {
  return {std::move(channel), 1 << 20};
}

/// Decoded by the format that recognises the content.
inline evaluation::RawHeights decoded(const std::filesystem::path& path,
                                      const evaluation::HeightRequest& request = request_for()) {
  const evaluation::FileSource source(path);
  const evaluation::HeightFormat* format = evaluation::height_format_of(source.head());
  if (!format || !format->is_built_in)
    throw brdf::Error(brdf::Errc::bad_input, path.string() + ": no format that is built in");
  return format->decode(source, request);
}

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

/// A file of given bytes, removed at the end.
class BytesFile {
 public:
  explicit BytesFile(const std::string& bytes) {
    std::string name = (std::filesystem::temp_directory_path() / "shedlight-XXXXXX").string();
    const int descriptor = mkstemp(name.data());
    if (descriptor < 0) throw std::runtime_error("no temporary file");
    close(descriptor);
    path_ = name;
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  BytesFile(const BytesFile&) = delete;
  BytesFile& operator=(const BytesFile&) = delete;
  ~BytesFile() { std::filesystem::remove(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The one line that refuses these bytes; empty where they are read.
inline std::string decoder_refusal(const std::string& bytes,
                                   const evaluation::HeightRequest& request = request_for()) {
  const BytesFile file(bytes);
  try {
    decoded(file.path(), request);
  } catch (const brdf::Error& error) {
    return error.what();
  }
  return {};
}

/// Checks that a file cut after any of its bytes is refused in one line.
inline void check_refused_wherever_cut(const std::string& bytes) {
  for (std::size_t size = 1; size < bytes.size(); ++size) {
    INFO("cut after " << size << " of " << bytes.size() << " bytes");
    const std::string refusal = decoder_refusal(bytes.substr(0, size));
    CHECK(refusal != "");
    CHECK(refusal.find('\n') == std::string::npos);
  }
}
