// Real scans, read from their files and summed directly, against sums made in another language.
#include <catch2/catch.hpp>
#include <complex>
#include <string>
#include <vector>

#include "brdf/direct_sum.h"
#include "evaluation/parallel.h"
#include "tests/support/real_data.h"
#include "tests/support/real_scans.h"

TEST_CASE("direct sums of real scans equal those made in another language", "[oracle][real]") {
  const auto folder = real_data();
  if (!folder) return;
  const auto by_file = scan_cases();
  REQUIRE(by_file.size() == 4);
  for (const auto& [name, list] : by_file) {
    CAPTURE(name);
    const evaluation::HeightFile scan = read_scan(*folder, name);
    const brdf::Surface surface{&scan.field,
                                brdf::GaussianWindow(brdf::Length::um(list[0].sigma_um)),
                                brdf::SurfaceModel::isolated};
    const std::vector<brdf::Query> queries = queries_of(list);
    const auto plan = brdf::DirectSum{}.plan(surface, bounds_of(queries, 1e-12));
    std::vector<std::complex<double>> amplitudes(queries.size());
    evaluation::parallel_for(queries.size(), 2, [&](std::size_t i) {
      plan.evaluate(std::span(queries).subspan(i, 1), std::span(amplitudes).subspan(i, 1));
    });
    double worst = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
      const double error = std::abs(amplitudes[i] - list[i].amplitude);
      CHECK(error <= 1e-11);  // phases reach 1e3 rad, so two sums may differ by 1e3 eps x root N
      worst = std::max(worst, error);
    }
    INFO("worst error " << worst);
    CHECK(list.size() == 40);
    // The bound that the plan states must hold as well, beside the other sum's own rounding.
    CHECK(worst <= plan.report().error_bound + 1e-13);
  }
}
