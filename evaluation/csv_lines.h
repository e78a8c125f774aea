// The lines of a CSV, with the place for every refusal.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/error.h"

namespace evaluation {

/// One pass over the lines of a CSV without quotes. Refers to its text and its name.
class CsvLines {
 public:
  CsvLines(std::string_view csv, const std::string& name) : rest_(csv), name_(name) {}

  bool next() {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
    if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
    ++number_;
    return true;
  }

  std::string_view line() const { return line_; }

  std::vector<std::string_view> fields() const {
    std::vector<std::string_view> fields;
    std::string_view rest = line_;
    for (;;) {
      const std::size_t comma = rest.find(',');
      fields.push_back(rest.substr(0, comma));
      if (comma == std::string_view::npos) return fields;
      rest = rest.substr(comma + 1);
    }
  }

  /// A field as a number, which may be "nan" or "inf". Refuses any other text, naming the column,
  /// counted from 0.
  double number(std::string_view field, std::size_t column) const {
    double value = 0;
    const auto [end, ec] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (ec != std::errc{} || end != field.data() + field.size()) refuse_number(field, column);
    return value;
  }

  double finite_number(std::string_view field, std::size_t column) const {
    const double value = number(field, column);
    if (!std::isfinite(value)) refuse_number(field, column);
    return value;
  }

  /// Throws Errc::bad_input: "NAME: line 3: " + what.
  [[noreturn]] void refuse(const std::string& what) const {
    throw brdf::Error(brdf::Errc::bad_input,
                      name_ + ": line " + std::to_string(number_) + ": " + what);
  }

 private:
  [[noreturn]] void refuse_number(std::string_view field, std::size_t column) const {
    refuse("column " + std::to_string(column + 1) + ": \"" + std::string(field.substr(0, 40)) +
           "\" is not a finite number");
  }

  std::string_view rest_, line_;
  const std::string& name_;
  std::uint64_t number_ = 0;
};

}  // namespace evaluation
