#include "evaluation/readers/text_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brdf/error.h"
#include "evaluation/lengths.h"
#include "evaluation/readers/point_grid.h"
#include "evaluation/readers/text_header.h"
#include "evaluation/readers/text_lines.h"
#include "evaluation/readers/text_table.h"

namespace evaluation::detail {
namespace {

using brdf::Length;

std::optional<Length> part(const std::optional<Length>& side, Eigen::Index count) {
  if (!side) return std::nullopt;
  return Length::um(side->um() / static_cast<double>(count));
}

std::optional<Length> scaled(const std::string& unit, double number) {
  const std::optional<Length> one = length_unit(unit);
  if (!one) return std::nullopt;
  return Length::um(number * one->um());
}

/// A unit of the last digit that was written of the largest number.
double last_digit(const brdf::HeightArray& values, int digits) {
  double largest = 0;
  for (const double value : values.reshaped())
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  if (largest == 0 || digits == 0) return 0;
  return std::max(std::pow(10, std::floor(std::log10(largest)) + 1 - digits),
                  largest * std::numeric_limits<double>::epsilon());
}

/// Whether a table of three columns holds points; refused where nothing tells.
bool holds_points(const TextTable& table, const TextHeader& header, const PointGrid& grid,
                  const std::string& name) {
  const auto refuse = [&](const std::string& what) {
    throw brdf::Error(brdf::Errc::bad_input, name + ": " + what);
  };
  if (header.is_points) {
    if (!grid.problem.empty()) refuse(grid.problem);
    return true;
  }
  if (header.is_matrix || table.values.rows() <= 3) return false;
  const std::string hint =
      "; a first line \"x [um], y [um], z [um]\" says that they are points, \"# Value units: um\" "
      "that they are a matrix";
  if (!grid.problem.empty())
    refuse("three columns that are no grid of x, y, z: " + grid.problem + hint);
  if (grid.nodes != static_cast<std::uint64_t>(table.values.rows()))
    refuse("three columns that do not fill a grid of x, y, z" + hint);
  return true;
}

}  // namespace

bool is_text(std::string_view head) {
  if (head.empty()) return false;
  const FileSource beginning("", std::string(head));
  TextLines lines(beginning);
  TextHeader header;
  try {
    return read_text_header(lines, header) && looks_like_numbers(lines.line());
  } catch (const brdf::Error&) {
    return true;  // one of Gwyddion's lines, to be refused with its place
  }
}

RawHeights decode_text(const FileSource& source, const HeightRequest& request) {
  const std::string& name = source.name();
  TextLines lines(source);
  TextHeader header;
  if (!read_text_header(lines, header))
    throw brdf::Error(brdf::Errc::bad_input, name + ": holds no numbers");
  TextTable table = read_text_table(lines, [&](std::size_t cols, std::size_t rows) {
    require_grid(cols == 3 ? 1 : cols, rows, request, name);
    // Each cell has a separator, a line its end or that of the file.
    if (cols > (source.size() + 1) / rows)
      throw brdf::Error(brdf::Errc::bad_input, name + ": " + std::to_string(source.size()) +
                                                   " bytes cannot hold " + std::to_string(cols) +
                                                   " x " + std::to_string(rows) + " numbers");
  });
  if (header.is_points && table.values.cols() != 3)
    throw brdf::Error(brdf::Errc::bad_input, name + ": " + std::to_string(table.values.cols()) +
                                                 " columns below the names x, y, z");
  RawHeights raw;
  raw.channel = header.title;
  raw.unit_name = header.z_unit;
  raw.unit = length_unit(header.z_unit);
  PointGrid grid;
  if (table.values.cols() == 3) grid = grid_of(table.values, request.max_pixels);
  if (table.values.cols() == 3 && holds_points(table, header, grid, name)) {
    raw.format = "text, points x, y, z on a grid";
    raw.values = std::move(grid.heights);
    raw.pixel_x = scaled(header.x_unit, grid.dx);
    raw.pixel_y = scaled(header.y_unit, grid.dy);
  } else {
    raw.format = "text, matrix";
    raw.values = std::move(table.values);
    raw.pixel_x = part(header.width, raw.values.cols());
    raw.pixel_y = part(header.height, raw.values.rows());
  }
  raw.step = last_digit(raw.values, table.digits);
  return raw;
}

}  // namespace evaluation::detail
