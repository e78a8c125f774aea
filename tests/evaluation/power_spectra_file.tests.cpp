#include "evaluation/power_spectra_file.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <limits>

#include "brdf/pq_series.h"
#include "brdf/taylor_series.h"
#include "evaluation/npy.h"
#include "tests/support/amplitudes.h"
#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/worst_error.h"

namespace {

using brdf::Errc;
using brdf::HalfSpectrum;
using brdf::Length;
using brdf::PowerSpectra;
using brdf::Surface;
using brdf::SurfaceModel;
using evaluation::HeightFile;
using evaluation::Json;
using evaluation::read_power_spectra;
using evaluation::TableNormalisation;
using evaluation::TableSource;
using Complex = std::complex<double>;

constexpr int terms = 24;

HeightFile some_heights() {
  constexpr std::uint64_t seed = 231;
  CAPTURE(seed);
  Uniform uniform(seed);
  return {random_heights(uniform, {9, 14, 0.1, 0.13}, -0.1, 0.3), "random", "0123abc"};
}

/// Tables in a folder that is removed at the end.
class Tables {
 public:
  Tables(const TableSource& source, TableNormalisation normalisation) {
    evaluation::OutputWithSidecar output(path());
    evaluation::PowerSpectraWriter writer(output, source, terms, normalisation);
    brdf::ComputedPowerSpectra(source.input->field)
        .visit(terms, [&](int, const HalfSpectrum& spectrum) { writer.write(spectrum); });
    sidecar_ = writer.commit({{"input", {{"sha256", source.input->sha256}}}});
  }

  std::filesystem::path path() const { return folder_ / "tables.npy"; }
  const Json& sidecar() const { return sidecar_; }
  void replace_sidecar(const std::string& text) const {
    std::ofstream(path().string() + ".json") << text;
  }

 private:
  TemporaryFolder folder_;
  Json sidecar_;
};

std::vector<Complex> values_of(const PowerSpectra& spectra, int count = terms) {
  std::vector<Complex> values;
  spectra.visit(count, [&](int, const HalfSpectrum& spectrum) {
    values.insert(values.end(), spectrum.half.begin(), spectrum.half.end());
  });
  return values;
}

}  // namespace

TEST_CASE("tables that were written read back the same to the last bit",
          "[power_spectra_file][invariant]") {
  const HeightFile heights = some_heights();
  const TableSource source{&heights, 1, "none"};
  const Tables tables(source, TableNormalisation::none);
  const auto read = read_power_spectra(tables.path(), source);
  CHECK(read.sha256 == tables.sidecar().at("output").at("sha256"));
  CHECK(read.spectra->shape().terms == terms);
  CHECK(read.spectra->value_error() == 0);
  CHECK(read.spectra->visit_bytes() == 9 * 8 * sizeof(Complex));
  CHECK_NOTHROW(brdf::require_match(*read.spectra, heights.field, terms));
  CHECK(values_of(*read.spectra) == values_of(brdf::ComputedPowerSpectra(heights.field)));
  // As often as wanted, and only what is wanted.
  CHECK(values_of(*read.spectra, 3) == values_of(brdf::ComputedPowerSpectra(heights.field), 3));
  CHECK(std::filesystem::file_size(tables.path()) ==
        evaluation::PowerSpectraWriter::file_bytes(read.spectra->shape()));
}

TEST_CASE("tables normalised by their extrema lie in 0 to 1 and are rescaled as they are read",
          "[power_spectra_file][erratum][E24]") {
  const HeightFile heights = some_heights();
  const TableSource source{&heights, 1, "none"};
  const Tables tables(source, TableNormalisation::extrema);
  for (const double number : evaluation::read_npy(tables.path(), 1 << 20).numbers)
    if (!(number >= 0 && number <= 1)) FAIL_CHECK(number << " is outside 0 to 1");
  const auto read = read_power_spectra(tables.path(), source);
  const std::vector<Complex> values = values_of(*read.spectra);
  const std::vector<Complex> exact = values_of(brdf::ComputedPowerSpectra(heights.field));
  WorstError error;
  for (std::size_t i = 0; i < values.size(); ++i) error.see(std::abs(values[i] - exact[i]));
  constexpr double pixels = 9 * 14;
  CHECK(error.value() <= read.spectra->value_error() * pixels);
  CHECK(error.value() > 0);
  // Values are at most the pixels; two roundings of their range and one of themselves, on two
  // parts.
  CHECK(read.spectra->value_error() <=
        5 * std::numeric_limits<double>::epsilon() * std::sqrt(2.0) * 2);
  CHECK(tables.sidecar().at("error").at("rescaled_value") == read.spectra->value_error());
}

TEST_CASE("a plan from normalised tables owns up to what rescaling changes",
          "[power_spectra_file][invariant]") {
  const HeightFile heights = some_heights();
  const TableSource source{&heights, 1, "none"};
  const Tables tables(source, TableNormalisation::extrema);
  const auto spectra = read_power_spectra(tables.path(), source).spectra;
  Uniform uniform(232);
  std::vector<brdf::Query> queries;
  for (int i = 0; i < 30; ++i)
    queries.push_back({uniform(-20, 20), uniform(-10, 10), uniform(-30, -5)});
  const brdf::QueryBounds bounds = brdf::bounds_of(queries, 1e-9);
  const auto check = [&](const Surface& surface, const auto& kept, const auto& computed) {
    const auto plan = kept.plan(surface, bounds), exact = computed.plan(surface, bounds);
    const double error =
        largest_difference(amplitudes_of(plan, queries), amplitudes_of(exact, queries));
    const double added = plan.report().error_bound - exact.report().error_bound;
    CHECK(error <= added);
    CHECK(added > 0);
    CHECK(added <= 1e-10);  // e^6 times 126 pixels times 1e-15: of no account
  };
  const Surface periodic{&heights.field, brdf::GaussianWindow(Length::um(0.35)),
                         SurfaceModel::periodic};
  check(periodic, brdf::TaylorSeries({terms, 7.0, spectra}), brdf::TaylorSeries({terms, 7.0, {}}));
  const Surface copies{&heights.field, periodic.window, SurfaceModel::replicated};
  for (const auto interpolation : {brdf::BinInterpolation::linear, brdf::BinInterpolation::exact})
    check(copies, brdf::PqSeries({terms, interpolation, spectra}),
          brdf::PqSeries({terms, interpolation, {}}));
}

TEST_CASE("tables of other heights are refused by what differs", "[power_spectra_file]") {
  const HeightFile heights = some_heights();
  const TableSource source{&heights, 2, "mean"};
  const Tables tables(source, TableNormalisation::none);
  CHECK_NOTHROW(read_power_spectra(tables.path(), source));
  const auto refused = [&](const HeightFile& input, int reduction, const std::string& level,
                           const std::string& part) {
    CHECK_ERROR(read_power_spectra(tables.path(), {&input, reduction, level}), Errc::bad_input,
                part);
  };
  refused(heights, 3, "mean", "tables.npy: tables of other heights: their parameters/reduce is 2");
  refused(heights, 2, "none", "parameters/level is \"mean\", the input's is \"none\"");
  refused({heights.field, "random", "another"}, 2, "mean", "input/sha256 is \"0123abc\"");
  const brdf::HeightArray& h = heights.field.heights_um();
  const auto with = [&](const brdf::HeightArray& values, double dx_um) -> HeightFile {
    return {brdf::HeightField(values, Length::um(dx_um), Length::um(0.13)), "", heights.sha256};
  };
  refused(with(h, 0.11), 2, "mean", "parameters/pixel_um");
  refused(with(h.leftCols(13), 0.1), 2, "mean", "parameters/columns is 14, the input's is 13");
  refused(with(h.topRows(8), 0.1), 2, "mean", "parameters/rows is 9, the input's is 8");
  refused(with(h + 0.1, 0.1), 2, "mean", "parameters/mid_range_um");
  const double middle = heights.field.mid_range_um();
  refused(with((h - middle) * 1.01 + middle, 0.1), 2, "mean", "range_um");
}

TEST_CASE("whatever stands in a sidecar is refused by place and value", "[power_spectra_file]") {
  const HeightFile heights = some_heights();
  const TableSource source{&heights, 1, "none"};
  const Tables tables(source, TableNormalisation::extrema);
  struct Change {
    std::string place, value, part;
  };
  for (const Change& change : {
           Change{"/parameters", "5", "has no parameters/reduce"},
           {"/parameters", "[]", "has no parameters/reduce"},
           {"/input", "\"x\"", "has no input/sha256"},
           {"/parameters/terms", "\"24\"", "parameters/terms is \"24\""},
           {"/parameters/terms", "24.0", "parameters/terms is 24.0"},
           {"/parameters/terms", "0", "from 1 to 2000"},
           {"/parameters/terms", "-24", "parameters/terms is -24"},
           {"/parameters/terms", "18446744073709551615", "from 1 to 2000"},
           {"/parameters/terms", "1e300", "from 1 to 2000"},
           {"/parameters/terms", "2000", "tables.npy: its shape is [24,9,8], by its sidecar"},
           {"/parameters/columns", "\"14\"", "parameters/columns is \"14\""},
           {"/parameters/columns", "1e18", "parameters/columns"},
           {"/parameters/pixel_um", "0.1", "parameters/pixel_um is 0.1"},
           {"/parameters/pixel_um", "[0.1]", "parameters/pixel_um is [0.1]"},
           {"/parameters/half_range_um", "null", "parameters/half_range_um is null"},
           {"/parameters/normalisation", "\"max\"", "\"none\" or \"extrema\""},
           {"/parameters/normalisation", "[\"none\"]", "\"none\" or \"extrema\""},
           {"/extrema", "{}", "each of 24 terms"},
           {"/extrema", "[1,2]", "each of 24 terms"},
           {"/extrema/3", "7", "has no extrema/3/re_min"},
           {"/extrema/3/im_min", "\"low\"", "extrema/3/im_min is \"low\""},
           {"/extrema/3/re_max", "127", "extrema/3/re_max is 127, must be a number from -126"},
           {"/extrema/3/re_max", "-126", "extrema/3/re_min is"},
           {"/output/sha256", "\"0123\"", "damaged or changed"},
           {"/output/sha256", "5", "has no output.sha256"},
           {"/parameters/level", "\"" + std::string(1000, 'x') + "\"", "xxx..."},
       }) {
    CAPTURE(change.place, change.value);
    Json sidecar = tables.sidecar();
    sidecar[Json::json_pointer(change.place)] = Json::parse(change.value);
    tables.replace_sidecar(sidecar.dump());
    CHECK_ERROR(read_power_spectra(tables.path(), source), Errc::bad_input, change.part);
  }
  for (const std::string text : {"", "{", "[]", "5", "{\"output\": 1e999}"}) {
    tables.replace_sidecar(text);
    CHECK_ERROR(read_power_spectra(tables.path(), source), Errc::bad_input, "tables.npy.json");
  }
  tables.replace_sidecar(std::string((std::size_t{1} << 24) + 1, ' '));
  CHECK_ERROR(read_power_spectra(tables.path(), source), Errc::bad_input, "at most 16777216");
  std::filesystem::remove(tables.path().string() + ".json");
  CHECK_ERROR(read_power_spectra(tables.path(), source), Errc::bad_input,
              "tables.npy.json: no such file");
}

TEST_CASE("tables renamed over others while they are read change nothing",
          "[power_spectra_file][invariant]") {
  const HeightFile heights = some_heights();
  const TableSource source{&heights, 1, "none"};
  const Tables tables(source, TableNormalisation::none);
  const auto read = read_power_spectra(tables.path(), source);
  evaluation::OutputFile other(tables.path());
  other.write("shorter");
  other.commit();
  CHECK(values_of(*read.spectra) == values_of(brdf::ComputedPowerSpectra(heights.field)));
  CHECK_ERROR(read_power_spectra(tables.path(), source), Errc::bad_input, "not NPY");
}

TEST_CASE("more than the disk has room for is refused with both numbers", "[output_file]") {
  const auto target = std::filesystem::temp_directory_path() / "tables.npy";
  CHECK_ERROR(evaluation::require_room(target, std::uintmax_t{1} << 62), Errc::cannot_write,
              "needs 4611686018427387904 bytes, the disk has room for");
  CHECK_NOTHROW(evaluation::require_room(target, 1));
  CHECK_NOTHROW(evaluation::require_room("tables.npy", 1));
}
