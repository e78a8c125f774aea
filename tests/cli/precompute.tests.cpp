#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <limits>

#include "tests/cli/fourier_tables.h"
#include "tests/cli/gratings.h"
#include "tests/cli/height_files.h"
#include "tests/cli/refusal.h"
#include "tests/cli/sidecars.h"

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Complex = std::complex<double>;

constexpr double pi = 3.14159265358979323846;
constexpr double eps = std::numeric_limits<double>::epsilon();

const std::string precompute = "precompute g.gsf --terms 6 -o t.npy";

/// s of the heights of the grating, which are the same in every row.
std::vector<double> scaled_heights(const Scratch& folder) {
  std::vector<double> s = read_gsf(folder.read("g.gsf")).heights;
  const auto [low, high] = std::minmax_element(s.begin(), s.end());
  const double middle = (*low + *high) / 2, half = (*high - *low) / 2;
  for (double& value : s) value = (value - middle) / half;
  return s;
}

}  // namespace

TEST_CASE("the tables are the transforms of the powers of the scaled height",
          "[cli][precompute][oracle]") {
  const Scratch folder;
  make_small(folder);
  const Outcome outcome = folder.shedlight(precompute);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out == "");
  CHECK(outcome.err == "");
  CHECK(folder.contents().size() == 4);
  const FourierTables tables = read_tables(folder, "t.npy");
  CHECK_THAT(
      tables.header,
      Catch::StartsWith("{'descr': '<c16', 'fortran_order': False, 'shape': (6, 10, 13), }"));
  REQUIRE(tables.values.size() == 6 * 10 * 13);
  const std::vector<double> s = scaled_heights(folder);
  double worst = 0;
  for (std::size_t n = 0; n < 6; ++n)
    for (std::size_t j = 0; j < 10; ++j)
      for (std::size_t l = 0; l < 13; ++l) {
        // The convention of numpy.fft.rfft2: minus, not normalised.
        Complex sum = 0;
        for (std::size_t row = 0; row < 10; ++row)
          for (std::size_t col = 0; col < 24; ++col)
            sum += std::pow(s[row * 24 + col], static_cast<double>(n)) *
                   std::polar(1.0, -2 * pi *
                                       (static_cast<double>(j * row % 10) / 10 +
                                        static_cast<double>(l * col % 24) / 24));
        worst = std::max(worst, std::abs(tables.values[(n * 10 + j) * 13 + l] - sum));
      }
  // 240 numbers of at most 1, each with a few roundings.
  CHECK(worst <= 240 * 4 * eps);
}

TEST_CASE("the sidecar of the tables says what they are of", "[cli][precompute][sidecar]") {
  const Scratch folder;
  make_small(folder);
  folder.prepare("precompute g.gsf --reduce 2 --level mean --terms 3 -o t.npy");
  const json sidecar = sidecar_of(folder, "t.npy");
  CHECK(sidecar.at("command") == "precompute");
  CHECK(sidecar.at("input").at("file") == "g.gsf");
  CHECK(sidecar.at("input").at("sha256") == sha256sum(folder, "g.gsf"));
  CHECK(sidecar.at("output").at("file") == "t.npy");
  CHECK(sidecar.at("output").at("sha256") == sha256sum(folder, "t.npy"));
  CHECK_FALSE(sidecar.contains("extrema"));
  CHECK_FALSE(sidecar.contains("pictures"));
  const json p = sidecar.at("parameters");
  CHECK(p.at("terms") == 3);
  CHECK(p.at("rows") == 5);
  CHECK(p.at("columns") == 12);
  CHECK(p.at("pixel_um").at(0).get<double>() == Approx(0.2).epsilon(1e-14));
  CHECK(p.at("pixel_um").at(1).get<double>() == Approx(0.2).epsilon(1e-14));
  CHECK(p.at("reduce") == 2);
  CHECK(p.at("level") == "mean");
  CHECK(p.at("normalisation") == "none");
  // Heights by `info`, which knows nothing of tables.
  const json info = json::parse(folder.shedlight("info g.gsf --reduce 2 --level mean --json").out);
  const double low = info.at("height_min_um"), high = info.at("height_max_um");
  CHECK(p.at("mid_range_um").get<double>() == Approx((low + high) / 2).margin(1e-15));
  CHECK(p.at("half_range_um").get<double>() == Approx((high - low) / 2).epsilon(1e-14));
}

TEST_CASE("normalised tables and the extrema in the sidecar give the tables back",
          "[cli][precompute][erratum][E24]") {
  const Scratch folder;
  make_small(folder);
  folder.prepare(precompute);
  const std::vector<Complex> exact = read_tables(folder, "t.npy").values;
  folder.prepare("precompute g.gsf --terms 6 --normalise extrema -o n.npy");
  const std::vector<Complex> stored = read_tables(folder, "n.npy").values;
  const json sidecar = sidecar_of(folder, "n.npy");
  CHECK(sidecar.at("parameters").at("normalisation") == "extrema");
  const json extrema = sidecar.at("extrema");
  REQUIRE(extrema.size() == 6);
  REQUIRE(stored.size() == exact.size());
  const std::size_t each = 10 * 13;
  const double bound = 240 * sidecar.at("error").at("rescaled_value").get<double>();
  for (std::size_t n = 0; n < 6; ++n) {
    CAPTURE(n);
    const auto number = [&](const char* name) { return extrema.at(n).at(name).get<double>(); };
    double low = 0, worst = 0, printed = 0;
    double re_min = exact[n * each].real(), re_max = re_min;
    for (std::size_t i = n * each; i < (n + 1) * each; ++i) {
      const auto rescaled = [](double x, double min, double max) { return x * (max - min) + min; };
      low = std::min(
          {low, stored[i].real(), stored[i].imag(), 1 - stored[i].real(), 1 - stored[i].imag()});
      const Complex back{rescaled(stored[i].real(), number("re_min"), number("re_max")),
                         rescaled(stored[i].imag(), number("im_min"), number("im_max"))};
      worst = std::max(worst, std::abs(back - exact[i]));
      printed = std::max(printed, std::abs(stored[i].real() * number("re_max") + number("re_min") -
                                           exact[i].real()));
      re_min = std::min(re_min, exact[i].real());
      re_max = std::max(re_max, exact[i].real());
    }
    CHECK(low >= 0);
    CHECK(worst <= bound);
    CHECK(bound <= 240 * 20 * eps);
    // The very numbers: the text reads back the same.
    CHECK(number("re_min") == re_min);
    CHECK(number("re_max") == re_max);
    if (n > 0) CHECK(printed > 1);
  }
}

TEST_CASE("tables, sidecar and pictures are the same in every run",
          "[cli][precompute][invariant]") {
  const Scratch folder;
  make_small(folder);
  const std::string command = precompute + " --normalise extrema --pictures pics";
  folder.prepare(command);
  const auto before = folder.contents();
  folder.prepare(command);
  const bool same = folder.contents() == before;
  CHECK(same);
}

TEST_CASE("what precompute cannot use is refused, and older files stay",
          "[cli][precompute][refusal]") {
  const Scratch folder;
  make_small(folder);
  folder.prepare(precompute);
  const std::string to_older = " -o older.csv";
  for (const std::string terms : {"0", "-3", "2001", "3.5", "many", "99999999999999999999"})
    check_refused(folder, "precompute g.gsf --terms " + terms + to_older, 2, {"--terms", terms});
  check_refused(folder, "precompute g.gsf --terms 3 --normalise max" + to_older, 2,
                {"--normalise", "max", "extrema"});
  check_refused(folder, "precompute g.gsf --terms 3 -o g.gsf", 2, {"g.gsf", "input"});
  check_refused(folder, "precompute missing.gsf --terms 3" + to_older, 3, {"missing.gsf"});
  check_refused(folder, "precompute g.gsf --width 2um --height-range 1um --terms 3" + to_older, 2,
                {"--height-range"});
}

TEST_CASE("a transform that needs more memory than allowed is refused with the size on disk",
          "[cli][precompute][limit]") {
  const Scratch folder;
  folder.prepare("synth flat --size 65um --pixels 650 -o g.gsf");
  // Heights, samples and half a spectrum: 3 x 3.4 MB.
  check_refused(folder, "precompute g.gsf --terms 30 --memory-limit 10MB -o older.csv", 6,
                {"g.gsf", "10.2 MB", "10 MB", "--memory-limit", "102 MB on disk"});
  CHECK(folder.shedlight("precompute g.gsf --terms 2 --memory-limit 11MB -o t.npy").exit_code == 0);
  CHECK(fs::file_size(folder / "t.npy") == 128 + 2 * 650 * 326 * 16);
}
