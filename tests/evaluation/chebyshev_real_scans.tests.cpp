// Real scans by the Chebyshev series and the vectorised direct sum.
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "brdf/chebyshev_series.h"
#include "brdf/direct_sum.h"
#include "evaluation/kernels/phase_sum.h"
#include "evaluation/kernels/series_kernels.h"
#include "tests/support/random_inputs.h"
#include "tests/support/real_data.h"
#include "tests/support/real_scans.h"
#include "tests/support/worst_error.h"

using brdf::ChebyshevSeries;
using brdf::DirectSum;
using brdf::GaussianWindow;
using brdf::HeightField;
using brdf::Length;
using brdf::Query;
using brdf::Surface;
using brdf::SurfaceModel;

namespace {

const ChebyshevSeries series(evaluation::vectorised_kernels(), {brdf::SmallRequests::by_series});
const DirectSum direct_sum(evaluation::vectorised_phase_kernels());

template <class Plan>
Amplitudes amplitudes_of(const Plan& plan, const std::vector<Query>& queries) {
  Amplitudes amplitudes(queries.size());
  plan.evaluate(queries, amplitudes);
  return amplitudes;
}

double worst_error(const Amplitudes& amplitudes, const std::vector<ScanCase>& cases) {
  WorstError worst;
  for (std::size_t i = 0; i < cases.size(); ++i)
    worst.see(std::abs(amplitudes[i] - cases[i].amplitude));
  return worst.value();
}

double worst_error(const Amplitudes& amplitudes, const Amplitudes& reference) {
  WorstError worst;
  for (std::size_t i = 0; i < reference.size(); ++i)
    worst.see(std::abs(amplitudes[i] - reference[i]));
  return worst.value();
}

/// The middle of the scan of Elaphe, a relief of many scales.
HeightField elaphe_crop(const std::filesystem::path& folder) {
  const HeightField scan = read_scan(folder, "elaphe_65um.png").field;
  constexpr Eigen::Index side = 256;
  return HeightField(
      scan.heights_um().block((scan.rows() - side) / 2, (scan.cols() - side) / 2, side, side),
      Length::um(scan.dx_um()), Length::um(scan.dy_um()));
}

}  // namespace

TEST_CASE("series and vectorised sums of real scans equal those made in another language",
          "[chebyshev_series][oracle][real]") {
  const auto folder = real_data();
  if (!folder) return;
  const auto by_file = scan_cases();
  REQUIRE(by_file.size() == 4);
  for (const auto& [name, list] : by_file) {
    CAPTURE(name);
    const evaluation::HeightFile scan = read_scan(*folder, name);
    const Surface surface{&scan.field, GaussianWindow(Length::um(list[0].sigma_um)),
                          SurfaceModel::isolated};
    const std::vector<Query> queries = queries_of(list);
    REQUIRE(queries.size() == 40);
    const auto direct = direct_sum.plan(surface, bounds_of(queries, 1e-12));
    // Phases reach 1e3 rad, so two sums may differ by 1e3 eps x root N.
    CHECK(worst_error(amplitudes_of(direct, queries), list) <= 1e-11);
    for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
      const auto plan = series.plan(surface, bounds_of(queries, tolerance));
      const double error = worst_error(amplitudes_of(plan, queries), list);
      CAPTURE(tolerance, error, plan.report().error_bound);
      REQUIRE(plan.explain().path == brdf::SeriesPath::general);
      CHECK(error <= tolerance);
      CHECK(error <= plan.report().error_bound + 1e-13);  // the other sum's own rounding
    }
  }
}

TEST_CASE("a real relief keeps every tolerance, eight per decade",
          "[chebyshev_series][oracle][real][long]") {
  const auto folder = real_data();
  if (!folder) return;
  constexpr std::uint64_t seed = 502;
  CAPTURE(seed);
  const HeightField field = elaphe_crop(*folder);
  const auto model =
      GENERATE(SurfaceModel::isolated, SurfaceModel::periodic, SurfaceModel::replicated);
  const bool in_plane = GENERATE(true, false);
  CAPTURE(static_cast<int>(model), in_plane);
  // A patch of 12.5 um: the window is cut at its edge at two sigma.
  const Surface surface{
      &field, GaussianWindow(Length::um(3.125)), model, brdf::Origin::patch_centre, {2, 3}};
  Uniform uniform(seed);
  std::vector<Query> queries;
  for (int i = 0; i < 40; ++i) {
    queries.push_back(
        query(random_direction(uniform), random_direction(uniform), Length::nm(uniform(380, 780))));
    if (in_plane) queries.back().qy_per_um = 0.2;
  }
  const Amplitudes reference =
      amplitudes_of(direct_sum.plan(surface, bounds_of(queries, 1e-12)), queries);
  WorstError ratio;
  for (int eighth = 8; eighth <= 96; ++eighth) {
    const double tolerance = std::pow(10.0, -eighth / 8.0);
    const auto plan = series.plan(surface, bounds_of(queries, tolerance));
    const double error = worst_error(amplitudes_of(plan, queries), reference);
    ratio.see(error / tolerance);
    CAPTURE(tolerance, plan.report().error_bound);
    CHECK(error <= tolerance);
    // Phases below 2000 rad: the rounding of both sums, 2e-16 times that, is part of the bound.
    CHECK(error <= plan.report().error_bound);
    CHECK(plan.report().error_bound <= tolerance);
  }
  INFO("largest error over tolerance " << ratio.value());
  CHECK(ratio.value() <= 1);
}
