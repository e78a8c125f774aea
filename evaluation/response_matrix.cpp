#include "evaluation/response_matrix.h"

#include <charconv>
#include <cmath>
#include <vector>

#include "brdf/error.h"

namespace evaluation {
namespace {

constexpr std::string_view long_header = "lambda_nm,theta_r_deg,value";

/// One pass over the lines of a CSV, with the place for every refusal.
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

  double number(std::string_view field, std::size_t column) const {
    double value = 0;
    const auto [end, ec] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (ec != std::errc{} || end != field.data() + field.size() || !std::isfinite(value))
      refuse("column " + std::to_string(column + 1) + ": \"" + std::string(field.substr(0, 40)) +
             "\" is not a finite number");
    return value;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw brdf::Error(brdf::Errc::bad_input,
                      name_ + ": line " + std::to_string(number_) + ": " + what);
  }

 private:
  std::string_view rest_, line_;
  const std::string& name_;
  int number_ = 0;
};

/// Digits after the point of a plain decimal.
int decimals_of(std::string_view field) {
  if (field.find_first_of("eE") != std::string_view::npos) return Axis::shortest;
  const std::size_t point = field.find('.');
  return point == std::string_view::npos ? 0 : static_cast<int>(field.size() - point - 1);
}

void append(Axis& axis, double value, std::string_view field, const CsvLines& lines) {
  if (!axis.values.empty() && !(value > axis.values.back()))
    lines.refuse("axis value " + std::string(field) + " does not increase");
  if (axis.values.empty()) axis.decimals = decimals_of(field);
  if (decimals_of(field) != axis.decimals) axis.decimals = Axis::shortest;
  axis.values.push_back(value);
}

void require_physical(const ResponseMatrix& response, const std::string& name) {
  if (!(response.lambda_nm.front() > 0))
    throw brdf::Error(
        brdf::Errc::bad_input,
        name + ": wavelength " + number_text(response.lambda_nm.front()) + " nm must be > 0");
  for (const double theta : {response.theta_r_deg.front(), response.theta_r_deg.back()})
    if (!(std::abs(theta) < 90))
      throw brdf::Error(brdf::Errc::bad_input, name + ": viewing angle " + number_text(theta) +
                                                   " deg must lie between -90 and 90");
}

void read_matrix(CsvLines& lines, ResponseMatrix& response, std::vector<double>& values) {
  const std::vector<std::string_view> header = lines.fields();
  if (header.size() < 2 || header[0] != "lambda_nm")
    lines.refuse("header must begin with lambda_nm and hold at least one angle");
  for (std::size_t i = 1; i < header.size(); ++i)
    append(response.theta_r_deg, lines.number(header[i], i), header[i], lines);
  while (lines.next()) {
    const std::vector<std::string_view> fields = lines.fields();
    if (fields.size() != header.size())
      lines.refuse(std::to_string(fields.size()) + " fields, the header has " +
                   std::to_string(header.size()));
    append(response.lambda_nm, lines.number(fields[0], 0), fields[0], lines);
    for (std::size_t i = 1; i < fields.size(); ++i) values.push_back(lines.number(fields[i], i));
  }
}

void read_long_table(CsvLines& lines, ResponseMatrix& response, std::vector<double>& values) {
  Axis& lambda_nm = response.lambda_nm;
  Axis& theta_r_deg = response.theta_r_deg;
  while (lines.next()) {
    const std::vector<std::string_view> fields = lines.fields();
    if (fields.size() != 3) lines.refuse(std::to_string(fields.size()) + " fields, not 3");
    const double lambda = lines.number(fields[0], 0), theta = lines.number(fields[1], 1);
    if (lambda_nm.values.empty() || lambda != lambda_nm.back()) {
      if (lambda_nm.size() > 0 && values.size() != lambda_nm.size() * theta_r_deg.size())
        lines.refuse("the row of wavelength " + number_text(lambda_nm.back()) + " is not complete");
      append(lambda_nm, lambda, fields[0], lines);
    }
    if (lambda_nm.size() == 1) {
      append(theta_r_deg, theta, fields[1], lines);
    } else {
      const std::size_t column = values.size() % theta_r_deg.size();
      if (values.size() >= lambda_nm.size() * theta_r_deg.size() || theta != theta_r_deg[column])
        lines.refuse("angle " + std::string(fields[1]) + " is not on the grid of the first row");
    }
    values.push_back(lines.number(fields[2], 2));
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

ResponseMatrix response_from_csv(std::string_view csv, const std::string& name) {
  CsvLines lines(csv, name);
  if (!lines.next()) throw brdf::Error(brdf::Errc::bad_input, name + ": file is empty");
  ResponseMatrix response;
  std::vector<double> values;
  if (lines.line() == long_header)
    read_long_table(lines, response, values);
  else
    read_matrix(lines, response, values);
  if (values.empty()) throw brdf::Error(brdf::Errc::bad_input, name + ": holds no rows");
  require_physical(response, name);
  response.values = Eigen::Map<const brdf::HeightArray>(
      values.data(), static_cast<Eigen::Index>(response.lambda_nm.size()),
      static_cast<Eigen::Index>(response.theta_r_deg.size()));
  return response;
}

}  // namespace evaluation
