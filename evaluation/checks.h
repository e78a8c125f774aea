// Checks of numbers against limits, each a row of a table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "evaluation/worst_error.h"

namespace evaluation {

enum class Verdict {
  passed,
  failed,   ///< an error above its limit or no number at all, or a refusal without need
  refused,  ///< nothing was computed, as it should be
};

/// "ok", "FAILED" or "refused as it should be".
std::string_view name_of(Verdict verdict);

/// What was found of one subject over a range of cases.
struct CheckRow {
  std::string subject;        ///< what was checked
  std::string range;          ///< the cases, or the method
  std::string unit;           ///< of error and limit
  double worst;               ///< error of the case nearest to its limit, or above it; NaN: none
  std::string where;          ///< that case
  double limit;               ///< of that case
  std::string reason;         ///< of the limit
  std::string first_refusal;  ///< the first case that was refused, with why; or empty
  Verdict verdict;
};

/// Whether no row failed. No rows are no success.
bool all_hold(const std::vector<CheckRow>& rows);

/// Gathers the cases of a row.
class CheckTally {
 public:
  /// What a refusal of a case means.
  enum class Refusal { fault, as_it_should_be };

  CheckTally(std::string subject, std::string range, std::string unit, std::string reason);

  /// A case was computed. Holds where error <= limit, so a NaN never does. limit: > 0.
  void see(double error, double limit, const std::string& where);
  /// A case was refused.
  void refused(const std::string& where, const std::string& why, Refusal refusal);

  CheckRow row() const;

 private:
  CheckRow row_;
  WorstError worst_ratio_;  ///< of error and limit
  bool failed_ = false;
};

}  // namespace evaluation
