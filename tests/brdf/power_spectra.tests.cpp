#include "brdf/power_spectra.h"

#include <catch2/catch.hpp>

#include "brdf/pq_series.h"
#include "brdf/taylor_series.h"
#include "tests/support/amplitudes.h"
#include "tests/support/is_error.h"
#include "tests/support/random_inputs.h"
#include "tests/support/surfaces.h"
#include "tests/support/worst_error.h"

using brdf::BinInterpolation;
using brdf::ComputedPowerSpectra;
using brdf::Errc;
using brdf::HalfSpectrum;
using brdf::HeightField;
using brdf::Length;
using brdf::pi;
using brdf::PowerSpectra;
using brdf::PowerSpectraShape;
using brdf::PqSeries;
using brdf::Query;
using brdf::StoredPowerSpectra;
using brdf::Surface;
using brdf::SurfaceModel;
using brdf::TaylorSeries;
using Complex = std::complex<double>;

namespace {

HeightField rough(const Grid& grid = {9, 14, 0.1, 0.13}) {
  Uniform uniform(221);
  return random_heights(uniform, grid, -0.1, 0.3);
}

std::shared_ptr<const PowerSpectra> stored(const HeightField& field, int terms) {
  return std::make_shared<StoredPowerSpectra>(brdf::stored_power_spectra(field, terms));
}

/// F(j, l) of s^n by its definition, in extended precision.
Complex by_definition(const HeightField& field, int power, long j, long l) {
  std::complex<long double> sum = 0;
  for (Eigen::Index r = 0; r < field.rows(); ++r)
    for (Eigen::Index c = 0; c < field.cols(); ++c) {
      const long double half = field.half_range_um();
      const long double s =
          half > 0
              ? (field.heights_um()(r, c) - static_cast<long double>(field.mid_range_um())) / half
              : 0;
      const long double turns =
          static_cast<long double>(j * r % field.rows()) / static_cast<long double>(field.rows()) +
          static_cast<long double>(l * c % field.cols()) / static_cast<long double>(field.cols());
      sum += std::pow(s, static_cast<long double>(power)) *
             std::polar(1.0L, 2 * 3.141592653589793238463L * turns);
    }
  return Complex(sum);
}

std::vector<Query> some_queries(double qy_lo, double qy_hi) {
  Uniform uniform(222);
  std::vector<Query> queries;
  for (int i = 0; i < 30; ++i)
    queries.push_back({uniform(-20, 20), uniform(qy_lo, qy_hi), uniform(-30, -5)});
  return queries;
}

}  // namespace

TEST_CASE("a spectrum is the transform of the power of the scaled height, at any bin",
          "[power_spectra][oracle]") {
  for (const Grid& grid :
       {Grid{9, 14, 0.1, 0.1}, {6, 7, 0.1, 0.1}, {1, 8, 0.1, 0.1}, {5, 1, 0.1, 0.1}}) {
    const HeightField field = rough(grid);
    const ComputedPowerSpectra computed(field);
    const StoredPowerSpectra kept = brdf::stored_power_spectra(field, 5);
    for (const PowerSpectra* spectra :
         {static_cast<const PowerSpectra*>(&computed), static_cast<const PowerSpectra*>(&kept)}) {
      int seen = 0;
      WorstError error;
      spectra->visit(5, [&](int power, const HalfSpectrum& spectrum) {
        CHECK(power == seen++);
        for (const long j : {0, 1, 4, -3, 17})
          for (const long l : {0, 1, 6, 7, 9, -2, -15, 30})
            error.see(std::abs(spectrum.bin(j, l) - by_definition(field, power, j, l)));
      });
      CHECK(seen == 5);
      // Sums of up to 126 values of at most 1: their rounding, times a few layers of the transform.
      CHECK(error.value() <= 1e-13);
    }
  }
}

TEST_CASE("the powers of a flat field are 1, 0, 0, ...", "[power_spectra][crossover]") {
  const HeightField flat = sampled(4, 5, 0.1, 0.1, [](double, double) { return 0.7; });
  ComputedPowerSpectra(flat).visit(3, [](int power, const HalfSpectrum& spectrum) {
    CHECK(spectrum.bin(0, 0) == Complex(power == 0 ? 20 : 0, 0));
    CHECK(std::abs(spectrum.bin(1, 2)) <= 1e-15);  // 20 ones that cancel, one rounding each layer
  });
}

TEST_CASE("a plan from kept spectra is the plan from the heights, to the last bit",
          "[power_spectra][invariant]") {
  const HeightField field = rough();
  const auto spectra = stored(field, 40);  // more than are used
  for (const auto& [qy_lo, qy_hi] : {std::pair{-10.0, 10.0}, {0.0, 0.0}}) {
    const std::vector<Query> queries = some_queries(qy_lo, qy_hi);
    const Surface periodic{&field, brdf::GaussianWindow(Length::um(0.35)), SurfaceModel::periodic};
    const Surface copies{
        &field, periodic.window, SurfaceModel::replicated, brdf::Origin::patch_centre, {3, 4}};
    for (const std::optional<int> terms : {std::optional<int>(25), std::optional<int>()}) {
      CHECK(amplitudes(TaylorSeries({.terms = terms, .radius_sigma_f = 7.0, .spectra = spectra}),
                       periodic, queries,
                       1e-9) == amplitudes(TaylorSeries({.terms = terms, .radius_sigma_f = 7.0}),
                                           periodic, queries, 1e-9));
      for (const auto interpolation : {BinInterpolation::linear, BinInterpolation::exact})
        CHECK(amplitudes(PqSeries({terms, interpolation, spectra}), copies, queries, 1e-9) ==
              amplitudes(PqSeries({terms, interpolation}), copies, queries, 1e-9));
    }
  }
}

TEST_CASE("kept spectra leave out the transforms of a plan", "[power_spectra][invariant]") {
  const HeightField field = rough();
  const Surface copies{&field, brdf::GaussianWindow(Length::um(1)), SurfaceModel::replicated};
  const brdf::QueryBounds bounds{{-5, -5, -30}, {5, 5, -10}, 9, 1e-6};
  CHECK(PqSeries{}.bytes(copies, bounds) ==
        PqSeries({.spectra = stored(field, 60)}).bytes(copies, bounds) +
            brdf::RealFourier2d::bytes(9, 14));
}

TEST_CASE("too few kept terms are refused with both numbers", "[power_spectra][invariant]") {
  const HeightField field = rough();
  const Surface periodic{&field, brdf::GaussianWindow(Length::um(0.35)), SurfaceModel::periodic};
  const Surface copies{&field, periodic.window, SurfaceModel::replicated};
  const brdf::QueryBounds bounds{{-5, -5, -30}, {5, 5, -10}, 9, 1e-6};
  const auto spectra = stored(field, 12);
  CHECK_ERROR(
      TaylorSeries({.terms = 13, .radius_sigma_f = {}, .spectra = spectra}).plan(periodic, bounds),
      Errc::not_attainable, "12 terms, the series needs 13");
  CHECK_ERROR(PqSeries({.terms = 13, .spectra = spectra}).plan(copies, bounds),
              Errc::not_attainable, "12 terms, the series needs 13");
  CHECK_NOTHROW(PqSeries({.terms = 12, .spectra = spectra}).plan(copies, bounds));
  // c r = 6 at the most: 1e-6 needs more than 12 terms.
  const int needed = PqSeries{}.terms(copies, bounds);
  CHECK_ERROR(PqSeries({.spectra = spectra}).plan(copies, bounds), Errc::not_attainable,
              "needs " + std::to_string(needed));
}

TEST_CASE("spectra of another surface are refused by what differs", "[power_spectra][invariant]") {
  const HeightField field = rough();
  const PowerSpectraShape own{9, 14, field.mid_range_um(), field.half_range_um(), 4};
  const auto refused = [&](PowerSpectraShape shape, const std::string& part) {
    const StoredPowerSpectra other(shape, std::vector<Complex>(shape.size()));
    CHECK_ERROR(brdf::require_match(other, field, 4), Errc::bad_input, part);
  };
  CHECK_NOTHROW(
      brdf::require_match(StoredPowerSpectra(own, std::vector<Complex>(own.size())), field, 4));
  PowerSpectraShape shape = own;
  shape.rows = 10;
  refused(shape, "grid is 10 x 14, the heights' 9 x 14");
  shape = own;
  shape.cols = 15;  // the same number of stored columns
  refused(shape, "grid is 9 x 15");
  for (const double bad : {0.25, std::nan("")}) {
    shape = own;
    shape.mid_range_um = bad;
    refused(shape, "mid-range");
    shape = own;
    shape.half_range_um = bad;
    refused(shape, "half range");
  }
}

TEST_CASE("an array that is not the shape's is refused", "[power_spectra][invariant]") {
  const PowerSpectraShape shape{4, 5, 0, 1, 2};
  CHECK(shape.size() == 2 * 4 * 3);
  for (const std::size_t size : {std::size_t{0}, shape.size() - 1, shape.size() + 1})
    CHECK_ERROR(StoredPowerSpectra(shape, std::vector<Complex>(size)), Errc::bad_input,
                "hold " + std::to_string(size) + " values");
  for (const PowerSpectraShape& none :
       {PowerSpectraShape{0, 5, 0, 1, 2}, {4, -5, 0, 1, 2}, {4, 5, 0, 1, 0}})
    CHECK_ERROR(StoredPowerSpectra(none, {}), Errc::bad_input, "must be >= 1");
  CHECK_ERROR(brdf::stored_power_spectra(rough(), 0), Errc::invalid_argument, "terms 0");
}
