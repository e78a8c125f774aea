#include "evaluation/audit.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <limits>

#include "brdf/synthetic_surface.h"

namespace {

using brdf::Angle;
using brdf::Length;

/// The right amplitude, but for one cell that is told by its query.
class WrongInOneCell final : public evaluation::Amplitude {
 public:
  WrongInOneCell(const evaluation::Amplitude& right, brdf::Query where, double error)
      : right_(right), where_(where), error_(error) {}
  void evaluate(std::span<const brdf::Query> queries,
                std::span<std::complex<double>> amplitudes) const override {
    right_.evaluate(queries, amplitudes);
    for (std::size_t i = 0; i < queries.size(); ++i)
      if (queries[i].qx_per_um == where_.qx_per_um && queries[i].c_per_um == where_.c_per_um)
        amplitudes[i] += error_;
  }
  brdf::PlanReport report() const override { return right_.report(); }

 private:
  const evaluation::Amplitude& right_;
  brdf::Query where_;
  double error_;
};

}  // namespace

TEST_CASE("an audit of every cell finds a single wrong one and says where it is", "[invariant]") {
  const auto field =
      brdf::synthetic_grating({brdf::Profile::blazed, Length::nm(2500), Length::nm(300)}, 7, 50,
                              Length::nm(100), Length::nm(400));
  const brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(2)),
                              brdf::SurfaceModel::isolated};
  const evaluation::SweepRequest request{Angle::deg(75),
                                         Angle::deg(0),
                                         Angle::deg(0),
                                         {{400, 500, 610.5}, 1},
                                         {{-60, -50, -40, -1}, 0}};
  const auto right = evaluation::method_named("direct").plan(surface, bounds_of(request, 1e-9), {});
  const brdf::Query where = queries_of_row(request, 1)[2];
  // The golden-ratio sequence visits 12 cells within 21 steps (the next Fibonacci number but one).
  const std::size_t enough = 21;

  const auto cells = evaluation::CellSelection::all(request);
  CHECK(audit(request, cells, surface, *right, enough, {}).worst_error == 0);
  const evaluation::Audit found =
      audit(request, cells, surface, WrongInOneCell(*right, where, 1e-3), enough, {2, {}});
  CHECK(std::abs(found.worst_error - 1e-3) <= 1e-15);
  CHECK(found.lambda_nm == 500);
  CHECK(found.theta_r_deg == -40);
  CHECK(found.cells == enough);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isinf(
      audit(request, cells, surface, WrongInOneCell(*right, where, nan), enough, {}).worst_error));
}
