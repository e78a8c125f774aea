#include "evaluation/worst_error.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>

#include "evaluation/checks.h"

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

evaluation::WorstError worst_of(std::initializer_list<double> errors) {
  evaluation::WorstError worst;
  for (const double error : errors) worst.see(error);
  return worst;
}

}  // namespace

TEST_CASE("the worst error is the largest, and NaN wherever one was", "[worst_error][invariant]") {
  CHECK(!worst_of({}).has_seen_any());
  CHECK(worst_of({0}).has_seen_any());
  CHECK(worst_of({0}).value() == 0);
  CHECK(worst_of({1, 3, 2}).value() == 3);
  CHECK(worst_of({1, infinite, 2}).value() == infinite);
  for (const evaluation::WorstError& worst :
       {worst_of({no_number, 1, 2}), worst_of({1, no_number, 2}), worst_of({1, 2, no_number})}) {
    CHECK(std::isnan(worst.value()));
    CHECK(worst.has_seen_any());
  }
  evaluation::WorstError one;
  CHECK(one.see(0));
  CHECK(!one.see(0));
  CHECK(one.see(1e-300));
  CHECK(one.see(no_number));
  CHECK(!one.see(no_number));
  CHECK(!one.see(infinite));
}

TEST_CASE("a tally fails for an error that is no number, wherever it comes",
          "[worst_error][invariant]") {
  for (const int place : {0, 1, 2}) {
    evaluation::CheckTally tally("subject", "range", "", "");
    for (int i = 0; i < 3; ++i) tally.see(i == place ? no_number : 0.5, 1, std::to_string(i));
    INFO(place);
    CHECK(tally.row().verdict == evaluation::Verdict::failed);
    CHECK(std::isnan(tally.row().worst));
    CHECK(tally.row().where == std::to_string(place));
  }
}
