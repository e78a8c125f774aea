#include "evaluation/sweep.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "brdf/direct_sum.h"
#include "brdf/synthetic_surface.h"
#include "evaluation/diffraction.h"
#include "evaluation/kernels/phase_sum.h"

namespace {

using brdf::Angle;
using brdf::Length;
using evaluation::CellSelection;
using evaluation::Diffraction;
using evaluation::SweepRequest;

brdf::HeightField small_blaze() {
  return brdf::synthetic_grating({brdf::Profile::blazed, Length::nm(2500), Length::nm(300)}, 7, 50,
                                 Length::nm(100), Length::nm(400));
}

SweepRequest small_request() {
  SweepRequest request{Angle::deg(75),
                       Angle::deg(20),
                       Angle::deg(20),
                       {{400, 500, 610.5}, 1},
                       {{-60, -50, -40, -1, 30}, 0}};
  return request;
}

struct Prepared {
  brdf::HeightField field = small_blaze();
  brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(2)), brdf::SurfaceModel::periodic};
  std::unique_ptr<evaluation::Amplitude> plan(const SweepRequest& request, const char* method) {
    return evaluation::method_named(method).plan(surface, bounds_of(request, 1e-9), {});
  }
};

bool same_bits(const brdf::HeightArray& a, const brdf::HeightArray& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

}  // namespace

TEST_CASE("a cell of the sweep is the gain times the power of its own query", "[invariant]") {
  Prepared prepared;
  const SweepRequest request = small_request();
  const auto plan = prepared.plan(request, "direct");
  const double area_um2 = coherence_area_um2(prepared.surface);
  for (const auto quantity : {brdf::Quantity::power, brdf::Quantity::relative, brdf::Quantity::brdf,
                              brdf::Quantity::radiance}) {
    const auto response = sweep(request, Diffraction(*plan, {quantity, area_um2}), {});
    for (const std::size_t row : {0u, 2u})
      for (const std::size_t column : {0u, 4u}) {
        const auto wi = brdf::direction(Angle::deg(75), Angle::deg(20));
        const auto wr = brdf::direction(Angle::deg(request.theta_r_deg[column]), Angle::deg(20));
        const double k = brdf::wavenumber_per_um(Length::nm(request.lambda_nm[row]));
        const Eigen::Vector3d q = k * brdf::scattering_vector(wi, wr);
        const std::vector<brdf::Query> one{{q.x(), q.y(), q.z()}};
        std::vector<std::complex<double>> a(1);
        brdf::DirectSum(evaluation::vectorised_phase_kernels())
            .plan(prepared.surface, bounds_of(one, 1e-9))
            .evaluate(one, a);
        double expected = std::norm(a[0]);
        if (quantity == brdf::Quantity::relative) expected *= brdf::relative_gain(wi, wr);
        if (quantity == brdf::Quantity::brdf)
          expected *= brdf::brdf_gain(wi, wr, Length::nm(request.lambda_nm[row]), area_um2);
        if (quantity == brdf::Quantity::radiance)
          expected *= brdf::radiance_gain(wi, wr, Length::nm(request.lambda_nm[row]), area_um2);
        const double value =
            response.values(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
        // The same operations in the same order, but for contraction: a few roundings.
        CHECK(std::abs(value - expected) <= 1e-14 * expected);
      }
  }
}

TEST_CASE("the sweep is bit-identical for any number of threads", "[invariant]") {
  Prepared prepared;
  const SweepRequest request = small_request();
  for (const char* method : {"direct", "taylor", "auto", "chebyshev"}) {
    CAPTURE(method);
    const auto plan = prepared.plan(request, method);
    evaluation::RunLimits limits;
    const auto one = sweep(request, Diffraction(*plan, {}), limits);
    for (const int threads : {2, 3, 16}) {
      limits.threads = threads;
      CHECK(same_bits(one.values, sweep(request, Diffraction(*plan, {}), limits).values));
    }
  }
}

TEST_CASE("the bounds of a request hold every one of its queries", "[invariant]") {
  for (const double phi : {0.0, 20.0, 90.0, 200.0}) {
    SweepRequest request = small_request();
    request.phi_i = Angle::deg(phi);
    request.phi_r = Angle::deg(phi + 77);
    const brdf::QueryBounds bounds = bounds_of(request, 1e-6);
    CHECK(bounds.count == 15);
    for (std::size_t row = 0; row < 3; ++row)
      for (const brdf::Query& q : queries_of_row(request, row)) {
        CHECK((q.qx_per_um >= bounds.lo.qx_per_um && q.qx_per_um <= bounds.hi.qx_per_um));
        CHECK((q.qy_per_um >= bounds.lo.qy_per_um && q.qy_per_um <= bounds.hi.qy_per_um));
        CHECK((q.c_per_um >= bounds.lo.c_per_um && q.c_per_um <= bounds.hi.c_per_um));
      }
  }
}

TEST_CASE("azimuths of 0 and 90 deg keep the other frequency at exactly zero", "[invariant]") {
  for (const double phi : {0.0, 90.0, 180.0, 270.0}) {
    CAPTURE(phi);
    SweepRequest request = small_request();
    request.phi_i = request.phi_r = Angle::deg(phi);
    const brdf::QueryBounds bounds = bounds_of(request, 1e-6);
    const bool along_x = std::fmod(phi, 180) == 0;
    CHECK((along_x ? bounds.lo.qy_per_um : bounds.lo.qx_per_um) == 0);
    CHECK((along_x ? bounds.hi.qy_per_um : bounds.hi.qx_per_um) == 0);
  }
}

TEST_CASE("the sources' evaluator takes c = -k at every angle", "[erratum]") {
  SweepRequest request = small_request();
  request.depth = evaluation::DepthFrequency::unit_w;
  const double k = brdf::wavenumber_per_um(Length::nm(400));
  for (const brdf::Query& q : queries_of_row(request, 0)) CHECK(q.c_per_um == -k);
}

TEST_CASE("a sweep past its time limit is refused and one before it is not", "[invariant]") {
  Prepared prepared;
  const SweepRequest request = small_request();
  const auto plan = prepared.plan(request, "direct");
  evaluation::RunLimits limits;
  const auto now = std::chrono::steady_clock::now();
  limits.time = {now - std::chrono::seconds(2), std::chrono::seconds(1)};
  CHECK_THROWS_WITH(sweep(request, Diffraction(*plan, {}), limits), Catch::Contains("time limit"));
  limits.time = {now, std::chrono::hours(1)};
  CHECK_NOTHROW(sweep(request, Diffraction(*plan, {}), limits));
}

TEST_CASE("directions and wavelengths outside their range are refused by name", "[invariant]") {
  const auto refusal = [](auto change) {
    SweepRequest request = small_request();
    change(request);
    try {
      require_valid(request);
    } catch (const brdf::Error& error) {
      CHECK(error.code() == brdf::Errc::invalid_argument);
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refusal([](SweepRequest&) {}).empty());
  CHECK(refusal([](SweepRequest& r) { r.theta_i = Angle::deg(90); }).find("90") !=
        std::string::npos);
  CHECK(refusal([](SweepRequest& r) { r.theta_r_deg.values.back() = 90; }).find("viewing") !=
        std::string::npos);
  CHECK(refusal([](SweepRequest& r) { r.lambda_nm.values.front() = 0; }).find("wavelength") !=
        std::string::npos);
}

TEST_CASE("angles past the Nyquist limit are told with the safe ones", "[invariant]") {
  SweepRequest request = small_request();
  request.phi_i = request.phi_r = Angle::deg(0);
  // Pixel 0.1 um at 400 nm: safe where |sin 75 + sin theta| <= 2, everywhere.
  CHECK_FALSE(nyquist_excess(request, small_blaze()));
  // Pixel 0.15 um: safe where the sum of sines is at most 0.4 / 0.3, theta_r up to 21.6 deg.
  const auto coarse = brdf::synthetic_grating({brdf::Profile::flat, {}, {}}, 3, 30, Length::nm(150),
                                              Length::nm(150));
  const auto excess = nyquist_excess(request, coarse);
  REQUIRE(excess);
  REQUIRE(excess->safe_deg);
  CHECK(*excess->safe_deg == std::pair(-60.0, -1.0));
  CHECK(excess->lambda_nm == 400);
}

TEST_CASE("in the plane of incidence, and there only, the queries lie on the line told",
          "[invariant]") {
  for (const double turn : {0.0, 180.0, -180.0}) {
    SweepRequest request = small_request();
    request.phi_r = Angle::deg(20 + turn);
    const brdf::QueryBounds bounds = bounds_of(request, 1e-6);
    REQUIRE(bounds.line);
    CHECK(std::abs(std::hypot(bounds.line->cos_azimuth, bounds.line->sin_azimuth) - 1) <= 4e-16);
    for (const brdf::Query& q : queries_of_row(request, 1)) {
      const double off =
          q.qx_per_um * bounds.line->sin_azimuth - q.qy_per_um * bounds.line->cos_azimuth;
      // The rounding of q itself, up to 25 rad/um, and of the line.
      CHECK(std::abs(off) <= 2e-14);
    }
  }
  SweepRequest request = small_request();
  request.phi_r = Angle::deg(20.001);
  CHECK_FALSE(bounds_of(request, 1e-6).line);
  request.theta_i = Angle::deg(0);
  CHECK(bounds_of(request, 1e-6).line);
}

TEST_CASE("selected cells have the bits of the full sweep, the others are 0", "[invariant]") {
  Prepared prepared;
  SweepRequest request = small_request();
  request.phi_i = request.phi_r = Angle::deg(0);
  request.theta_r_deg.values.clear();
  for (int i = 0; i < 300; ++i) request.theta_r_deg.values.push_back(-80 + 0.5 * i);
  const brdf::OrderBands bands(prepared.surface, {Length::nm(2500)}, 2);
  const auto cells = CellSelection::within(bands, request);
  std::vector<std::vector<bool>> selected(3, std::vector<bool>(300, false));
  for (std::size_t i = 0; i < cells.size(); ++i) selected[cells[i].row][cells[i].column] = true;
  for (const char* method : {"direct", "taylor", "auto", "chebyshev"}) {
    CAPTURE(method);
    const auto plan = prepared.plan(request, method);
    const Diffraction diffraction(*plan, {});
    const auto full = sweep(request, diffraction, {});
    const auto some = sweep(request, diffraction, cells, {2, {}});
    std::size_t zeros = 0, equal = 0;
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 300; ++column) {
        const auto i = static_cast<Eigen::Index>(row), j = static_cast<Eigen::Index>(column);
        if (selected[row][column])
          equal += some.values(i, j) == full.values(i, j);
        else
          zeros += some.values(i, j) == 0;
      }
    CHECK(equal == cells.size());
    CHECK(zeros == request.cells() - cells.size());
  }
}

TEST_CASE("the selection is that of the bands, cell by cell", "[invariant]") {
  Prepared prepared;
  const SweepRequest request = small_request();
  const brdf::OrderBands bands(prepared.surface, {Length::nm(2500), {}, Angle::deg(20)}, 0.5);
  const auto cells = CellSelection::within(bands, request);
  std::size_t next = 0;
  for (std::size_t row = 0; row < 3; ++row) {
    const auto queries = queries_of_row(request, row);
    for (std::size_t column = 0; column < queries.size(); ++column) {
      if (!bands.contains(queries[column])) continue;
      REQUIRE(next < cells.size());
      CHECK(cells[next].row == row);
      CHECK(cells[next].column == column);
      ++next;
    }
  }
  CHECK(next == cells.size());
  CHECK(next > 0);
  CHECK(next < request.cells());
  CHECK(CellSelection::all(request).size() == request.cells());
}
