#include "evaluation/period/ridge_orders.h"

#include <catch2/catch.hpp>

using brdf::Length;

TEST_CASE("orders follow the strongest ridges, a guess or an order", "[invariant][ridges]") {
  using evaluation::number_ridges;
  using Orders = std::vector<std::optional<int>>;
  // Orders 1 to 3, the second the strongest.
  CHECK(number_ridges({{0.4, 1}, {0.8, 3}, {1.2, 1}}, {}, {}).orders == Orders{1, 2, 3});
  // Sub-populations are one order.
  CHECK(number_ridges({{0.85, 1}, {0.97, 3}, {1.06, 1}}, {}, {}).orders == Orders{1, 1, 1});
  CHECK(number_ridges({{-0.4, 1}, {0.8, 2}}, {}, {}).orders == Orders{-1, 2});
  CHECK(number_ridges({{0.8, 1}}, {}, {}).orders == Orders{1});
  CHECK(number_ridges({{0.8, 1}}, 2, {}).orders == Orders{2});
  CHECK(number_ridges({{0.8, 1}, {0.6, 0.1}}, {}, Length::um(2.5)).orders ==
        Orders{2, std::nullopt});
}
