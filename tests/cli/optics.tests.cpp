#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>

#include "tests/cli/gratings.h"
#include "tests/cli/refusal.h"
#include "tests/cli/tables.h"

namespace {

using nlohmann::json;

const std::string scene = " --theta-i 40deg --theta-r -70:70:10deg --lambda 400:700:100nm ";
constexpr double degree = 3.14159265358979323846 / 180;

/// The numbers of a response without its axes.
std::vector<std::vector<double>> values(const Scratch& folder, const std::string& options) {
  folder.prepare("sweep g.gsf" + scene + options + " -o R.csv");
  std::vector<std::vector<double>> rows;
  const auto table = table_of(folder.read("R.csv"));
  for (std::size_t row = 1; row < table.size(); ++row) {
    rows.emplace_back();
    for (std::size_t column = 1; column < table[row].size(); ++column)
      rows.back().push_back(value_of(table[row][column]));
  }
  return rows;
}

/// cos of half the angle between light and viewer, theta_r on the light's side.
double cos_half(double theta_r_deg) {
  return std::cos((40 - theta_r_deg) / 2 * degree);
}

template <class Expected>
void check_ratio(const std::vector<std::vector<double>>& a,
                 const std::vector<std::vector<double>>& b, Expected expected) {
  REQUIRE(a.size() == 4);
  for (std::size_t row = 0; row < a.size(); ++row)
    for (std::size_t column = 0; column < a[row].size(); ++column) {
      const double theta_r_deg = -70 + 10.0 * static_cast<double>(column);
      CAPTURE(row, theta_r_deg);
      // The test's own trigonometry and the shortest text of a double: some roundings.
      CHECK(std::abs(a[row][column] - b[row][column] * expected(theta_r_deg)) <=
            1e-12 * std::abs(a[row][column]));
    }
}

}  // namespace

TEST_CASE("Schlick's reflectance multiplies a response, relative to normal incidence or absolute",
          "[cli][optics][oracle]") {
  const Scratch folder;
  make_grating(folder);
  const auto schlick = [](double theta_r_deg) {  // n = 1.5: R_0 = 0.04
    return 0.04 + 0.96 * std::pow(1 - cos_half(theta_r_deg), 5);
  };
  check_ratio(values(folder, "--fresnel schlick"), values(folder, ""),
              [&](double theta_r_deg) { return schlick(theta_r_deg) / 0.04; });
  check_ratio(values(folder, "--fresnel schlick --quantity brdf"),
              values(folder, "--quantity brdf"), schlick);
  // The sources square it.
  check_ratio(values(folder, "--fresnel schlick-amplitude --quantity brdf"),
              values(folder, "--quantity brdf"),
              [&](double theta_r_deg) { return std::pow(schlick(theta_r_deg), 2); });
}

TEST_CASE("a metal's reflectance is Fresnel's at its complex index", "[cli][optics][oracle]") {
  const Scratch folder;
  make_grating(folder);
  check_ratio(
      values(folder, "--fresnel conductor --index 0.97,1.87 --quantity brdf"),
      values(folder, "--quantity brdf"), [](double theta_r_deg) {
        const std::complex<double> m(0.97, 1.87);
        const double c = cos_half(theta_r_deg);
        const std::complex<double> g = std::sqrt(m * m - 1.0 + c * c);
        return (std::norm((c - g) / (c + g)) + std::norm((m * m * c - g) / (m * m * c + g))) / 2;
      });
}

TEST_CASE("radiance is the BRDF times the cosine of incidence", "[cli][optics][oracle]") {
  const Scratch folder;
  make_grating(folder);
  check_ratio(values(folder, "--quantity radiance"), values(folder, "--quantity brdf"),
              [](double) { return std::cos(40 * degree); });
}

TEST_CASE("V-shaped grooves take their part", "[cli][optics][oracle]") {
  const Scratch folder;
  make_grating(folder);
  check_ratio(values(folder, "--shadowing v-cavity"), values(folder, ""), [](double theta_r_deg) {
    const double n_h = std::cos((40 + theta_r_deg) / 2 * degree), v_h = cos_half(theta_r_deg);
    return std::min({1.0, 2 * n_h * std::cos(theta_r_deg * degree) / v_h,
                     2 * n_h * std::cos(40 * degree) / v_h});
  });
}

TEST_CASE("the sidecar names material, shadowing and model", "[cli][optics][sidecar]") {
  const Scratch folder;
  make_grating(folder);
  const auto parameters = [&](const std::string& options) {
    values(folder, options);
    return json::parse(folder.read("R.csv.json")).at("parameters");
  };
  const json bare = parameters("");
  CHECK(bare.at("fresnel") == json({{"model", "none"}}));
  CHECK(bare.at("shadowing") == "none");
  const json metal = parameters("--fresnel conductor --index 0.97,1.87 --shadowing v-cavity");
  CHECK(metal.at("fresnel") == json({{"model", "conductor"}, {"index", {0.97, 1.87}}}));
  CHECK(metal.at("shadowing") == "v-cavity");
  const json facets = parameters(
      "--method microfacet --distribution gtr --tail 1.5 --roughness 0.2 --masking kelemen "
      "--material gold");
  CHECK(facets.at("quantity") == "brdf");
  CHECK(facets.at("distribution") == "gtr");
  CHECK(facets.at("tail") == 1.5);
  CHECK(facets.at("roughness") == 0.2);
  CHECK(facets.at("masking") == "kelemen");
  CHECK(facets.at("material") == "gold");
  CHECK(parameters("--method lambert --albedo 0.25").at("albedo") == 0.25);
}

TEST_CASE("a microfacet surface takes its roughness from the heights", "[cli][optics][oracle]") {
  const Scratch folder;
  // h = H / 2 cos(2 pi x / d): slope pi H / d / sqrt(2), less what 250 samples a period leave out.
  folder.prepare(
      "synth sinusoid --period 2500nm --height 500nm --size 50um,1um --pixels 5000,4 -o g.gsf");
  values(folder, "--method microfacet");
  const json p = json::parse(folder.read("R.csv.json")).at("parameters");
  CHECK(p.at("distribution") == "beckmann");
  // Heights are stored as 32-bit floats, 3e-8 of 250 nm over pixels of 10 nm.
  CHECK(p.at("roughness").get<double>() ==
        Approx(3.14159265 * 0.5 / 2.5 / std::sqrt(2.0)).epsilon(2e-4));
}

TEST_CASE("a diffuse surface has the same BRDF everywhere", "[cli][optics][oracle]") {
  const Scratch folder;
  make_grating(folder);
  for (const auto& row : values(folder, "--method lambert --albedo 0.25"))
    for (const double value : row) CHECK(value == Approx(0.25 / 3.14159265358979).epsilon(1e-12));
}

TEST_CASE("factors and models that mean nothing together are refused", "[cli][optics][refusal]") {
  const Scratch folder;
  make_grating(folder);
  const auto refused = [&](const std::string& options, const std::vector<std::string>& named) {
    check_refused(folder, "sweep g.gsf" + scene + options + " -o older.csv", 2, named);
  };
  refused("--fresnel magic", {"--fresnel", "magic", "schlick", "conductor"});
  refused("--fresnel schlick --quantity power", {"--fresnel", "power"});
  refused("--shadowing v-cavity --quantity power", {"--shadowing", "power"});
  refused("--index 1.5", {"--index", "--fresnel"});
  refused("--fresnel conductor", {"conductor", "--index"});
  refused("--fresnel dielectric --index 1.5,2", {"refractive index 1.5", "dielectric"});
  refused("--fresnel dielectric --index 1", {"refractive index 1"});
  refused("--fresnel dielectric --index nan", {"--index", "nan"});
  refused("--fresnel conductor --index 1,x", {"--index", "x"});
  refused("--method microfacet --distribution magic", {"--distribution", "magic", "ggx"});
  refused("--method microfacet --masking magic", {"--masking", "magic", "smith"});
  refused("--method microfacet --material magic", {"magic", "gold"});
  refused("--method microfacet --material gold --fresnel schlick", {"--material", "--fresnel"});
  refused("--method microfacet --roughness 0", {"roughness 0"});
  refused("--method microfacet --distribution blinn-phong --roughness 2", {"roughness 2"});
  refused("--method microfacet --tail 3", {"--tail", "gtr"});
  refused("--method microfacet --quantity relative", {"--quantity relative", "microfacet"});
  refused("--method microfacet --tolerance 1e-3", {"--tolerance", "microfacet"});
  refused("--method microfacet --orders-only --period 2um", {"--orders-only", "microfacet"});
  refused("--method microfacet --preset thesis", {"--preset", "microfacet"});
  refused("--method microfacet --albedo 1", {"--albedo", "lambert"});
  refused("--method lambert --albedo 1.5", {"albedo 1.5"});
  refused("--method lambert --roughness 1", {"--roughness", "microfacet"});
  refused("--method lambert --fresnel schlick", {"--fresnel", "lambert"});
  refused("--roughness 0.2", {"--roughness", "auto", "microfacet"});
}

TEST_CASE("a flat patch has no slope to take the roughness from", "[cli][optics][refusal]") {
  const Scratch folder;
  folder.prepare("synth flat --size 10um --pixels 10 -o g.gsf");
  check_refused(folder, "sweep g.gsf" + scene + "--method microfacet -o older.csv", 2,
                {"roughness 0"});
}
