#include "evaluation/axis.h"

#include <catch2/catch.hpp>
#include <limits>

TEST_CASE("numbers are written with the decimals asked for", "[invariant]") {
  CHECK(evaluation::number_text(-50, 2) == "-50.00");
  CHECK(evaluation::number_text(380, 0) == "380");
  CHECK(evaluation::number_text(0.1) == "0.1");
  CHECK(evaluation::number_text(1e-300) == "1e-300");
  CHECK(evaluation::number_text(std::numeric_limits<double>::max(), 3).size() == 309 + 4);
}
