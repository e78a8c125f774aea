#include "evaluation/checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace evaluation {

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return "ok";
    case Verdict::failed:
      return "FAILED";
    case Verdict::refused:
      return "refused as it should be";
  }
  return "?";
}

bool all_hold(const std::vector<CheckRow>& rows) {
  return !rows.empty() && std::none_of(rows.begin(), rows.end(), [](const CheckRow& row) {
    return row.verdict == Verdict::failed;
  });
}

CheckTally::CheckTally(std::string subject, std::string range, std::string unit,
                       std::string reason) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  row_ = {
      std::move(subject), std::move(range), std::move(unit), none, {}, none, std::move(reason), {},
      Verdict::failed};
}

void CheckTally::see(double error, double limit, const std::string& where) {
  if (!(error <= limit)) failed_ = true;
  if (!worst_ratio_.see(error / limit)) return;
  row_.worst = error;
  row_.limit = limit;
  row_.where = where;
}

void CheckTally::refused(const std::string& where, const std::string& why, Refusal refusal) {
  if (refusal == Refusal::fault) failed_ = true;
  if (row_.first_refusal.empty()) row_.first_refusal = where + ": " + why;
}

CheckRow CheckTally::row() const {
  CheckRow row = row_;
  if (failed_ || std::isnan(worst_ratio_.value()))
    row.verdict = Verdict::failed;
  else if (worst_ratio_.has_seen_any())
    row.verdict = Verdict::passed;
  else
    row.verdict = row.first_refusal.empty() ? Verdict::failed : Verdict::refused;
  return row;
}

}  // namespace evaluation
