// Reads the tables of tests/oracles.
#pragma once

#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// One cell of a table as a number.
inline double number(const std::string& cell) {
  double value = 0;
  const auto [end, ec] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (ec != std::errc{} || end != cell.data() + cell.size())
    throw std::runtime_error("not a number in an oracle table: '" + cell + "'");
  return value;
}

using OracleRow = std::vector<std::string>;

/// The rows of a table below its comments and its column names. Throws where the table is missing
/// or empty, so that no test passes for want of rows.
inline std::vector<OracleRow> oracle_table(const std::string& name) {
  const std::string path = std::string(SHEDLIGHT_ORACLES) + "/" + name;
  std::ifstream file(path);
  if (!file) throw std::runtime_error("no oracle table " + path);
  std::vector<OracleRow> rows;
  bool named = false;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (!named) {
      named = true;
      continue;
    }
    OracleRow row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    rows.push_back(row);
  }
  if (rows.empty()) throw std::runtime_error("empty oracle table " + path);
  return rows;
}
