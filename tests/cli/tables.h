// The CSV files of the program, taken apart by the tests themselves.
#pragma once

#include <charconv>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using Cells = std::vector<std::string>;

/// The lines of a text, without their ends.
inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The cells of one line; a comma at its end is followed by an empty cell.
inline Cells cells_of(const std::string& line) {
  Cells cells(1);
  for (const char c : line)
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  return cells;
}

inline std::vector<Cells> table_of(const std::string& csv) {
  std::vector<Cells> table;
  for (const std::string& line : lines_of(csv)) table.push_back(cells_of(line));
  return table;
}

/// The whole text as a number, read without a locale.
inline double value_of(const std::string& text) {
  double value = 0;
  const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (ec != std::errc{} || end != text.data() + text.size())
    throw std::runtime_error("not a number: '" + text + "'");
  return value;
}
