#include <cmath>

#include "evaluation/self_check/checker.h"

namespace evaluation::self {
namespace {

double total_power(const Amplitudes& amplitudes) {
  double sum = 0;
  for (const std::complex<double>& a : amplitudes) sum += std::norm(a);
  return sum;
}

/// At fixed c the powers at all frequencies of a tile add up to 1.
CheckRow parseval(const Method& method) {
  const brdf::HeightField field = relief();
  // |sum of |a|^2 - 1| <= 2 sum |a| e <= 2 e sqrt(count), as sum |a|^2 = 1.
  const double limit = 2 * tolerance * std::sqrt(static_cast<double>(field.heights_um().size()));
  CheckTally found = tally("energy: sum over the frequencies of a tile", method,
                           "twice the tolerance asked for times the root of their number");
  for (const double c_per_um : {-3.0, -12.0, -30.0})
    for (const brdf::Surface& surface : tiles(method, field))
      found.see(std::abs(total_power(amplitudes(method, surface, all_cycles(field, c_per_um))) - 1),
                limit, std::string(name_of(surface.model)) + ", c = " + brdf::text(c_per_um));
  return found.row();
}

/// With the gain C = 1 the orders of a sinusoid share the light among them: sum of J_m^2 = 1.
CheckRow orders(const Method& method) {
  constexpr int last = 12;
  constexpr double depth_rad = 3;
  const brdf::HeightField field = one_period({.profile = brdf::Profile::sinusoid,
                                              .period = brdf::Length::um(2.5),
                                              .height = brdf::Length::um(0.3)},
                                             64);
  std::vector<brdf::Query> queries;
  for (int order = -last; order <= last; ++order)
    queries.push_back(at_cycles(field, order, 0, -depth_rad / 0.3));
  CheckTally found = tally("energy: sum over the orders of a sinusoid", method,
                           "twice the tolerance asked for times the root of their number; the "
                           "orders left out hold 2 J_13(1.5)^2 = 3e-23");
  for (const brdf::Surface& surface : tiles(method, field))
    found.see(std::abs(total_power(amplitudes(method, surface, queries)) - 1),
              2 * tolerance * std::sqrt(static_cast<double>(queries.size())),
              std::string(name_of(surface.model)));
  return found.row();
}

}  // namespace

std::vector<CheckRow> energy_rows(const Method& method) {
  return {parseval(method), orders(method)};
}

}  // namespace evaluation::self
