#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "brdf/pq_factors.h"
#include "evaluation/stability/groups.h"

namespace evaluation::stability {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

/// sin(N pi nu) / (N sin(pi nu)), the order taken off first: exact for any double.
Real exact_factor(double cycles, int replicas) {
  const double order = std::round(cycles);
  const Real x = boost::math::constants::pi<Real>() * (Real(cycles) - Real(order));
  const Real sign = replicas % 2 == 0 && std::fmod(order, 2) != 0 ? -1 : 1;
  if (x == 0) return sign;
  return sign * sin(Real(replicas) * x) / (Real(replicas) * sin(x));
}

CheckRow factor_row(const char* range, std::initializer_list<int> all_replicas) {
  CheckTally tally("PQ factor", range, "of the peak",
                   "two sines, a product and a quotient round by half a unit each, with margin 4");
  constexpr double limit = 2e-15;
  for (const int replicas : all_replicas)
    for (const double order : {0.0, 1.0, -1.0, 2.0, 3.0, 10.0, 999.0, 65537.0, 1e6, -1e6})
      for (int decade = 0; decade <= 16; ++decade)
        for (const double digit : {-1.0, 1.0, 3.7}) {
          // Decade 0: the order itself.
          const double distance = decade == 0 ? 0 : digit * std::pow(10.0, -decade);
          const double cycles = order + distance;
          const auto error = static_cast<double>(
              abs(Real(brdf::pq_factor(cycles, replicas)) - exact_factor(cycles, replicas)));
          tally.see(error, limit,
                    brdf::text(order) + " + " + brdf::text(distance) + ", " +
                        std::to_string(replicas) + " copies");
        }
  return tally.row();
}

}  // namespace

std::vector<CheckRow> order_rows() {
  return {factor_row("orders to 1e6 at distances 1e-1 to 1e-16, 1 to 100 copies",
                     {1, 2, 3, 7, 10, 99, 100}),
          factor_row("orders to 1e6 at distances 1e-1 to 1e-16, 1e3 to 1e9 copies",
                     {1000, 1'000'001, 1'000'000'000})};
}

}  // namespace evaluation::stability
