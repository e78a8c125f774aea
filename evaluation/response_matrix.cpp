#include "evaluation/response_matrix.h"

#include <cmath>
#include <vector>

#include "brdf/error.h"
#include "evaluation/csv_lines.h"

namespace evaluation {
namespace {

constexpr std::string_view long_header = "lambda_nm,theta_r_deg,value";

/// Digits after the point of a plain decimal.
int decimals_of(std::string_view field) {
  if (field.find_first_of("eE") != std::string_view::npos) return Axis::shortest;
  const std::size_t point = field.find('.');
  return point == std::string_view::npos ? 0 : static_cast<int>(field.size() - point - 1);
}

/// One response as it is read.
struct Reading {
  CsvLines& lines;
  CsvContent content;
  ResponseMatrix& response;
  std::vector<double>& values;

  double cell(std::string_view field, std::size_t column) const {
    return content == CsvContent::checked ? lines.finite_number(field, column)
                                          : lines.number(field, column);
  }
};

void append(Axis& axis, double value, std::string_view field, const Reading& reading) {
  const CsvLines& lines = reading.lines;
  if (reading.content == CsvContent::checked && !axis.values.empty() &&
      !(value > axis.values.back()))
    lines.refuse("axis value " + std::string(field) + " does not increase");
  if (axis.values.empty()) axis.decimals = decimals_of(field);
  if (decimals_of(field) != axis.decimals) axis.decimals = Axis::shortest;
  axis.values.push_back(value);
}

void require_physical(const ResponseMatrix& response, const std::string& name) {
  for (const double lambda : response.lambda_nm.values)
    if (!(lambda > 0))
      throw brdf::Error(brdf::Errc::bad_input,
                        name + ": wavelength " + number_text(lambda) + " nm must be > 0");
  for (const double theta : response.theta_r_deg.values)
    if (!(std::abs(theta) < 90))
      throw brdf::Error(brdf::Errc::bad_input, name + ": viewing angle " + number_text(theta) +
                                                   " deg must lie between -90 and 90");
}

void read_matrix(const Reading& reading) {
  auto& [lines, content, response, values] = reading;
  const std::vector<std::string_view> header = lines.fields();
  if (header.size() < 2 || header[0] != "lambda_nm")
    lines.refuse("header must begin with lambda_nm and hold at least one angle");
  for (std::size_t i = 1; i < header.size(); ++i)
    append(response.theta_r_deg, lines.finite_number(header[i], i), header[i], reading);
  while (lines.next()) {
    const std::vector<std::string_view> fields = lines.fields();
    if (fields.size() != header.size())
      lines.refuse(std::to_string(fields.size()) + " fields, the header has " +
                   std::to_string(header.size()));
    append(response.lambda_nm, lines.finite_number(fields[0], 0), fields[0], reading);
    for (std::size_t i = 1; i < fields.size(); ++i) values.push_back(reading.cell(fields[i], i));
  }
}

void read_long_table(const Reading& reading) {
  auto& [lines, content, response, values] = reading;
  Axis& lambda_nm = response.lambda_nm;
  Axis& theta_r_deg = response.theta_r_deg;
  while (lines.next()) {
    const std::vector<std::string_view> fields = lines.fields();
    if (fields.size() != 3) lines.refuse(std::to_string(fields.size()) + " fields, not 3");
    const double lambda = lines.finite_number(fields[0], 0);
    const double theta = lines.finite_number(fields[1], 1);
    if (lambda_nm.values.empty() || lambda != lambda_nm.back()) {
      if (lambda_nm.size() > 0 && values.size() != lambda_nm.size() * theta_r_deg.size())
        lines.refuse("the row of wavelength " + number_text(lambda_nm.back()) + " is not complete");
      append(lambda_nm, lambda, fields[0], reading);
    }
    if (lambda_nm.size() == 1) {
      append(theta_r_deg, theta, fields[1], reading);
    } else {
      const std::size_t column = values.size() % theta_r_deg.size();
      if (values.size() >= lambda_nm.size() * theta_r_deg.size() || theta != theta_r_deg[column])
        lines.refuse("angle " + std::string(fields[1]) + " is not on the grid of the first row");
    }
    values.push_back(reading.cell(fields[2], 2));
  }
  if (values.size() != lambda_nm.size() * theta_r_deg.size())
    lines.refuse("the last wavelength is not complete");
}

}  // namespace

std::string to_csv(const ResponseMatrix& response, CsvLayout layout) {
  const Axis& lambda_nm = response.lambda_nm;
  const Axis& theta_r_deg = response.theta_r_deg;
  std::vector<std::string> angles;
  for (const double angle : theta_r_deg.values)
    angles.push_back(number_text(angle, theta_r_deg.decimals));

  std::string csv;
  csv.reserve(lambda_nm.size() * theta_r_deg.size() *
              (layout == CsvLayout::matrix ? std::size_t{23} : std::size_t{36}));
  if (layout == CsvLayout::long_table) {
    csv.append(long_header).append("\n");
  } else {
    csv += "lambda_nm";
    for (const std::string& angle : angles) csv.append(",").append(angle);
    csv += '\n';
  }
  for (std::size_t i = 0; i < lambda_nm.size(); ++i) {
    const std::string lambda = number_text(lambda_nm[i], lambda_nm.decimals);
    if (layout == CsvLayout::matrix) csv += lambda;
    for (std::size_t j = 0; j < theta_r_deg.size(); ++j) {
      if (layout == CsvLayout::long_table) csv.append(lambda).append(",").append(angles[j]);
      csv.append(",").append(
          number_text(response.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j))));
      if (layout == CsvLayout::long_table) csv += '\n';
    }
    if (layout == CsvLayout::matrix) csv += '\n';
  }
  return csv;
}

ResponseMatrix response_from_csv(std::string_view csv, const std::string& name,
                                 CsvContent content) {
  CsvLines lines(csv, name);
  if (!lines.next()) throw brdf::Error(brdf::Errc::bad_input, name + ": file is empty");
  ResponseMatrix response;
  std::vector<double> values;
  const Reading reading{lines, content, response, values};
  if (lines.line() == long_header)
    read_long_table(reading);
  else
    read_matrix(reading);
  if (values.empty()) throw brdf::Error(brdf::Errc::bad_input, name + ": holds no rows");
  require_physical(response, name);
  response.values = Eigen::Map<const brdf::HeightArray>(
      values.data(), static_cast<Eigen::Index>(response.lambda_nm.size()),
      static_cast<Eigen::Index>(response.theta_r_deg.size()));
  return response;
}

}  // namespace evaluation
