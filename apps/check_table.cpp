#include "apps/check_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brdf/error.h"

namespace apps {
namespace {

using evaluation::CheckRow;
using evaluation::Verdict;

/// RFC 4180.
std::string quoted_field(const std::string& text) {
  std::string field = "\"";
  for (const char c : text) field.append(c == '"' ? 2 : 1, c);
  return field + "\"";
}

std::string number_field(double value) {
  return std::isfinite(value) ? brdf::text(value) : "";
}

std::string counted(const std::vector<CheckRow>& rows, Verdict verdict) {
  return std::to_string(std::count_if(rows.begin(), rows.end(),
                                      [&](const CheckRow& row) { return row.verdict == verdict; }));
}

}  // namespace

std::string table_for_people(const std::vector<CheckRow>& rows) {
  std::size_t subject = 0, range = 0;
  for (const CheckRow& row : rows) {
    subject = std::max(subject, row.subject.size());
    range = std::max(range, row.range.size());
  }
  std::string text;
  for (const CheckRow& row : rows) {
    if (row.verdict == Verdict::refused)
      text += fmt::format("refused  {:<{}}  {:<{}}  as it should be, {}\n", row.subject, subject,
                          row.range, range, row.first_refusal);
    else
      text += fmt::format("{:<7}  {:<{}}  {:<{}}  {:>8.2g} of at most {:<8.2g} {}, at {}{}\n",
                          name_of(row.verdict), row.subject, subject, row.range, range, row.worst,
                          row.limit, row.unit, row.where,
                          row.first_refusal.empty() ? "" : "; refused from " + row.first_refusal);
  }
  return text + fmt::format("{} ok, {} refused as they should be, {} FAILED\n",
                            counted(rows, Verdict::passed), counted(rows, Verdict::refused),
                            counted(rows, Verdict::failed));
}

std::string table_csv(const std::vector<CheckRow>& rows) {
  std::string csv = "subject,range,unit,worst,where,limit,reason,first_refusal,verdict\n";
  for (const CheckRow& row : rows)
    csv += fmt::format("{},{},{},{},{},{},{},{},{}\n", quoted_field(row.subject),
                       quoted_field(row.range), quoted_field(row.unit), number_field(row.worst),
                       quoted_field(row.where), number_field(row.limit), quoted_field(row.reason),
                       quoted_field(row.first_refusal), name_of(row.verdict));
  return csv;
}

evaluation::Json table_json(const std::vector<CheckRow>& rows) {
  evaluation::Json json = evaluation::Json::array();
  // A number that is none becomes null.
  for (const CheckRow& row : rows)
    json.push_back({{"subject", row.subject},
                    {"range", row.range},
                    {"unit", row.unit},
                    {"worst", row.worst},
                    {"where", row.where},
                    {"limit", row.limit},
                    {"reason", row.reason},
                    {"first_refusal", row.first_refusal},
                    {"verdict", name_of(row.verdict)}});
  return json;
}

}  // namespace apps
