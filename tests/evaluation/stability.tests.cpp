#include "evaluation/stability.h"

#include <catch2/catch.hpp>
#include <set>

using evaluation::CheckRow;
using evaluation::StabilityGroup;
using evaluation::Verdict;

TEST_CASE("every method and formula keeps its limit at its extremes, or refuses as it should",
          "[stability][oracle]") {
  const StabilityGroup group = GENERATE(Catch::Generators::from_range(
      evaluation::stability_groups().begin(), evaluation::stability_groups().end()));
  DYNAMIC_SECTION(group.name) {
    const std::vector<CheckRow> rows = group.measure();
    CHECK(!rows.empty());
    for (const CheckRow& row : rows) {
      INFO(row.subject << ", " << row.range << ": " << row.worst << " against " << row.limit
                       << " at " << row.where << "; refused: " << row.first_refusal);
      CHECK(row.verdict != Verdict::failed);
      // A verdict of its own: no NaN passes, and nothing passes without having been measured.
      CHECK(
          (row.verdict == Verdict::refused ? !row.first_refusal.empty() : row.worst <= row.limit));
    }
  }
}
