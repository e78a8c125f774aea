// The scales of a relief: its heights, and the wavelengths it is lit by, from long to short.
#include <cmath>

#include "evaluation/stability/groups.h"
#include "evaluation/stability/method_tallies.h"

namespace evaluation::stability {
namespace {

constexpr double tolerance = 1e-9;
constexpr const char* reason =
    "the tolerance asked for, 1e-9, where refused the bound stated; phases of 2e4 rad round by "
    "5e-12";

/// (k u, k v, k w) in a plane of incidence, c within a tenth.
std::vector<brdf::Query> queries_at(brdf::Length wavelength) {
  const double k_per_um = brdf::wavenumber_per_um(wavelength);
  std::vector<brdf::Query> queries;
  for (const double u : {0.0, 0.11, 0.43})
    queries.push_back({k_per_um * u, 0, -k_per_um * (1.95 - 0.4 * u)});
  return queries;
}

}  // namespace

std::vector<CheckRow> height_rows() {
  MethodTallies tallies("peak to valley 1e-15 m to 1 mm at 550 nm", reason);
  for (int decade = -15; decade <= -3; ++decade) {
    const brdf::HeightField field = relief(std::pow(10.0, decade + 6));
    tallies.see({"1e" + std::to_string(decade) + " m", under_window(field),
                 queries_at(brdf::Length::nm(550)), tolerance});
  }
  return tallies.rows();
}

std::vector<CheckRow> wavelength_rows() {
  MethodTallies tallies("100 um to 10 nm, 300 nm peak to valley", reason);
  const brdf::HeightField field = relief(0.3);
  for (const double lambda_nm : {1e5, 1e4, 5e3, 2e3, 780.0, 380.0, 200.0, 100.0, 50.0, 20.0, 10.0})
    tallies.see({brdf::text(lambda_nm) + " nm", under_window(field),
                 queries_at(brdf::Length::nm(lambda_nm)), tolerance});
  return tallies.rows();
}

}  // namespace evaluation::stability
