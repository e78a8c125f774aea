// Real scans, read from their files and summed directly, against sums made in another language.
#include <catch2/catch.hpp>
#include <charconv>
#include <complex>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "brdf/direct_sum.h"
#include "brdf/directions.h"
#include "evaluation/parallel.h"
#include "evaluation/readers/height_reader.h"
#include "tests/support/real_data.h"

namespace {

using brdf::Angle;
using brdf::Length;

struct Case {
  double sigma_um;
  brdf::Query query;
  std::complex<double> amplitude;
};

double number(const std::string& text) {
  double value = 0;
  const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), value);
  REQUIRE(ec == std::errc{});
  REQUIRE(end == text.data() + text.size());
  return value;
}

/// file,sigma_um,theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,lambda_nm,re,im
std::map<std::string, std::vector<Case>> cases() {
  std::ifstream file(std::string(SHEDLIGHT_ORACLES) + "/direct_real_scans.csv");
  std::string line;
  std::getline(file, line);
  std::map<std::string, std::vector<Case>> by_file;
  while (std::getline(file, line)) {
    std::stringstream fields(line);
    std::string name, field;
    std::getline(fields, name, ',');
    std::vector<double> v;
    while (std::getline(fields, field, ',')) v.push_back(number(field));
    REQUIRE(v.size() == 8);
    const Eigen::Vector3d q =
        brdf::wavenumber_per_um(Length::nm(v[5])) *
        brdf::scattering_vector(brdf::direction(Angle::deg(v[1]), Angle::deg(v[2])),
                                brdf::direction(Angle::deg(v[3]), Angle::deg(v[4])));
    by_file[name].push_back({v[0], {q.x(), q.y(), q.z()}, {v[6], v[7]}});
  }
  return by_file;
}

evaluation::HeightScale scale_of(const std::string& name) {
  evaluation::HeightScale scale;
  if (name == "xenopeltis_65um.png") {
    scale.width = Length::um(65);
    scale.height_range = Length::nm(818.69);
  } else if (name == "elaphe_65um.png") {
    scale.pixel = {Length::um(0.048828125), Length::um(0.048828125)};
    scale.height_range = Length::nm(434.7);
  }
  return scale;
}

}  // namespace

TEST_CASE("direct sums of real scans equal those made in another language", "[oracle][real]") {
  const auto folder = real_data();
  if (!folder) return;
  const auto by_file = cases();
  REQUIRE(by_file.size() == 4);
  for (const auto& [name, list] : by_file) {
    CAPTURE(name);
    const evaluation::HeightFile scan = evaluation::read_heights(*folder / name, scale_of(name));
    const brdf::Surface surface{&scan.field, brdf::GaussianWindow(Length::um(list[0].sigma_um)),
                                brdf::SurfaceModel::isolated};
    std::vector<brdf::Query> queries;
    for (const Case& c : list) queries.push_back(c.query);
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
