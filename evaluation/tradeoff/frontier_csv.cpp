#include <algorithm>
#include <array>
#include <charconv>

#include "evaluation/csv_lines.h"
#include "evaluation/tradeoff/tradeoff.h"

namespace evaluation {
namespace {

constexpr std::string_view header =
    "row,method,surface,replicas_x,replicas_y,terms,window_radius_sigma_f,interpolation,tolerance,"
    "lambda_step_nm,cells,plan_s,query_s,total_s,runs,cells_timed,peak_memory_mb,terms_used,"
    "storage,worst_error,rms_error,peak_angle_error_deg,period_relative_error,ciede2000,"
    "on_frontier,sources,refused";

/// The columns that make a trial again.
enum Column : std::size_t {
  row_column,
  method_column,
  surface_column,
  replicas_x_column,
  replicas_y_column,
  terms_column,
  radius_column,
  interpolation_column,
  tolerance_column,
  lambda_step_column,
  cells_column,
};

/// What was measured, to six digits: more would be noise.
std::string measured_text(double value) {
  std::array<char, 32> text{};
  const auto [end, ec] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
  return ec == std::errc{} ? std::string(text.data(), end) : std::string("?");
}

std::string measured_text(const std::optional<double>& value) {
  return value ? measured_text(*value) : "";
}

std::string text_of(const std::optional<double>& value) {
  return value ? number_text(*value) : "";
}

std::string text_of(const std::optional<int>& value) {
  return value ? std::to_string(*value) : "";
}

/// Text that keeps to its cell.
std::string cell_text(std::string text) {
  std::ranges::replace(text, ',', ';');
  std::ranges::replace(text, '\n', ' ');
  return text;
}

std::vector<std::string> knobs(const Trial& trial) {
  const bool has_copies = trial.model == brdf::SurfaceModel::replicated;
  return {trial.method,
          std::string(name_of(trial.model)),
          has_copies ? std::to_string(trial.replicas.x) : "",
          has_copies ? std::to_string(trial.replicas.y) : "",
          text_of(trial.terms),
          text_of(trial.radius_sigma_f),
          trial.interpolation ? std::string(name_of(*trial.interpolation)) : "",
          text_of(trial.tolerance),
          text_of(trial.lambda_step_nm),
          std::string(name_of(trial.cells))};
}

std::vector<std::string> measured(const TradeoffRow& row) {
  if (!row.refused.empty()) return std::vector<std::string>(13);
  const FindingErrors& found = row.errors.findings;
  return {measured_text(row.time.plan_s),
          measured_text(row.time.query_s),
          measured_text(row.time.total_s()),
          std::to_string(row.runs),
          std::to_string(row.cells_timed),
          row.peak_bytes ? measured_text(static_cast<double>(*row.peak_bytes) / 1e6) : "",
          row.terms_used > 0 ? std::to_string(row.terms_used) : "",
          row.storage,
          measured_text(row.errors.worst),
          measured_text(row.errors.rms),
          measured_text(found.peak_angle_deg),
          measured_text(found.period_relative),
          measured_text(found.ciede2000)};
}

/// A cell as the value that has this name.
template <class T, std::size_t N>
T named(const CsvLines& lines, std::string_view field, const std::array<T, N>& values) {
  for (const T value : values)
    if (name_of(value) == field) return value;
  lines.refuse(std::string("\"").append(field.substr(0, 40)) + "\" is none of the names there are");
}

/// An empty cell is a knob that was not set.
std::optional<double> optional_number(const CsvLines& lines, std::string_view field,
                                      std::size_t column) {
  if (field.empty()) return std::nullopt;
  return lines.finite_number(field, column);
}

std::optional<int> optional_count(const CsvLines& lines, std::string_view field,
                                  std::size_t column) {
  const std::optional<double> value = optional_number(lines, field, column);
  if (!value) return std::nullopt;
  if (!(*value >= 1 && *value <= 1e9 && *value == static_cast<int>(*value)))
    lines.refuse("column " + std::to_string(column + 1) + ": " + std::string(field.substr(0, 40)) +
                 " is no count from 1 to 1e9");
  return static_cast<int>(*value);
}

Trial trial_of(const CsvLines& lines, const std::vector<std::string_view>& fields) {
  using brdf::BinInterpolation;
  using brdf::SurfaceModel;
  Trial trial;
  trial.method = fields[method_column];
  const auto known = [&](const Method& method) { return method.name == trial.method; };
  if (std::ranges::none_of(methods(), known))
    lines.refuse("method \"" + trial.method.substr(0, 40) + "\" is not known");
  trial.model =
      named(lines, fields[surface_column],
            std::array{SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated});
  const auto count = [&](Column column) { return optional_count(lines, fields[column], column); };
  const auto number = [&](Column column) { return optional_number(lines, fields[column], column); };
  trial.replicas = {count(replicas_x_column).value_or(1), count(replicas_y_column).value_or(1)};
  trial.terms = count(terms_column);
  trial.radius_sigma_f = number(radius_column);
  if (!fields[interpolation_column].empty())
    trial.interpolation = named(lines, fields[interpolation_column],
                                std::array{BinInterpolation::nearest, BinInterpolation::linear,
                                           BinInterpolation::sinc, BinInterpolation::exact});
  trial.tolerance = number(tolerance_column);
  trial.lambda_step_nm = number(lambda_step_column);
  if (trial.lambda_step_nm && !(*trial.lambda_step_nm > 0))
    lines.refuse("wavelength step " + number_text(*trial.lambda_step_nm) + " nm must be > 0");
  trial.cells = named(lines, fields[cells_column], std::array{Cells::all, Cells::orders});
  return trial;
}

}  // namespace

std::string to_csv(std::span<const TradeoffRow> rows) {
  std::string csv = std::string(header) + "\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    csv += std::to_string(i + 1);
    for (const auto& cells : {knobs(rows[i].trial), measured(rows[i])})
      for (const std::string& cell : cells) csv += "," + cell;
    csv += std::string(rows[i].on_frontier ? ",yes," : ",,") + rows[i].trial.sources + "," +
           cell_text(rows[i].refused) + "\n";
  }
  return csv;
}

Trial trial_from_csv(std::string_view csv, const std::string& name, std::size_t row) {
  CsvLines lines(csv, name);
  if (!lines.next() || lines.line() != header)
    throw brdf::Error(brdf::Errc::bad_input,
                      name + ": line 1: is not the header of a table of tradeoff");
  const std::size_t columns = lines.fields().size();
  std::size_t last = 0;
  while (lines.next()) {
    const std::vector<std::string_view> fields = lines.fields();
    if (fields.size() != columns)
      lines.refuse(std::to_string(fields.size()) + " fields, the header has " +
                   std::to_string(columns));
    ++last;
    if (fields[row_column] != std::to_string(last))
      lines.refuse("row " + std::string(fields[row_column].substr(0, 40)) + " stands where " +
                   std::to_string(last) + " belongs");
    if (last != row) continue;
    if (!fields.back().empty())
      lines.refuse("row " + std::to_string(row) + " was refused: " + std::string(fields.back()));
    return trial_of(lines, fields);
  }
  throw brdf::Error(brdf::Errc::invalid_argument, name + ": row " + std::to_string(row) +
                                                      ": it has rows 1 to " + std::to_string(last));
}

}  // namespace evaluation
