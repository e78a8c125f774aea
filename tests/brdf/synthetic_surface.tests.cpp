#include "brdf/synthetic_surface.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/is_error.h"
#include "tests/support/surfaces.h"

using brdf::Angle;
using brdf::CrossedLines;
using brdf::Disorder;
using brdf::DisorderKind;
using brdf::Edges;
using brdf::Errc;
using brdf::FingerRows;
using brdf::HeightArray;
using brdf::HeightField;
using brdf::Length;
using brdf::pi;
using brdf::Profile;
using brdf::ProfileParameters;
using brdf::SyntheticSurface;

namespace {

constexpr double period_um = 2.5, height_um = 0.2;
const Disorder tenth{.deviation = Length::um(period_um / 10)};
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

ProfileParameters grating(Profile profile, double duty = 0.5) {
  return {.profile = profile,
          .period = Length::um(period_um),
          .height = Length::um(height_um),
          .duty = duty};
}

/// Heights of 0.17 um x 0.4 um pixels.
HeightArray heights(const SyntheticSurface& surface, Eigen::Index rows = 31,
                    Eigen::Index cols = 41) {
  return brdf::synthetic_surface(surface, rows, cols, Length::um(0.17), Length::um(0.4))
      .heights_um();
}

double bump(double t) {
  return (1 + std::cos(2 * pi * t)) / 2;
}

/// Largest distance from a formula h(x, y) [um].
template <class Function>
double distance(const HeightArray& made, Function formula) {
  return (made - sampled(made.rows(), made.cols(), 0.17, 0.4, formula).heights_um())
      .abs()
      .maxCoeff();
}

// Positions up to 10 um, rounded in another order, on slopes up to pi height / period.
constexpr double rounding_um = 1e-14;

}  // namespace

TEST_CASE("a grating lies across its direction, from x towards y",
          "[synthetic_surface][invariant]") {
  const double cosine = std::sqrt(3) / 2, sine = 0.5;
  CHECK(distance(heights({.grating = grating(Profile::sinusoid), .direction = Angle::deg(30)}),
                 [&](double x, double y) {
                   return height_um * bump((x * cosine + y * sine) / period_um);
                 }) <= rounding_um);
}

TEST_CASE("a grating along y is one along x with the axes exchanged",
          "[synthetic_surface][invariant]") {
  for (const Profile profile : {Profile::blazed, Profile::lamellar}) {
    const auto square = [&](double direction_deg) {
      return brdf::synthetic_surface(
                 {.grating = grating(profile), .direction = Angle::deg(direction_deg)}, 31, 31,
                 Length::um(0.25), Length::um(0.25))
          .heights_um();
    };
    CHECK((square(90) == square(0).transpose()).all());
    CHECK((square(180) == square(0).rowwise().reverse()).all());
    CHECK((square(360) == square(0)).all());
  }
}

TEST_CASE("crossed lines multiply", "[synthetic_surface][invariant]") {
  const CrossedLines at_60{.period = Length::um(1.5), .angle = Angle::deg(60)};
  const double cosine = 0.5, sine = std::sqrt(3) / 2;
  CHECK(distance(heights({.grating = grating(Profile::sinusoid), .layout = at_60}),
                 [&](double x, double y) {
                   return height_um * bump(x / period_um) * bump((x * cosine + y * sine) / 1.5);
                 }) <= rounding_um);
}

TEST_CASE("crossed lamellar lines are pillars of the square of the duty",
          "[synthetic_surface][invariant]") {
  const HeightArray pillars =
      brdf::synthetic_surface({.grating = grating(Profile::lamellar, 0.28),
                               .layout = CrossedLines{.period = Length::um(1.25)}},
                              100, 100, Length::um(0.1), Length::um(0.05))
          .heights_um();
  CHECK((pillars == 0 || pillars == height_um).all());
  // 4 periods each way of 25 pixels, at t = 0.02 + 0.04 n: 7 of them are below the duty.
  CHECK((pillars > 0).count() == 28 * 28);
}

TEST_CASE("crossed lines are disordered by numbers of their own",
          "[synthetic_surface][invariant]") {
  SyntheticSurface surface{.grating = grating(Profile::sinusoid),
                           .layout = CrossedLines{.period = Length::um(3)},
                           .jitter = tenth};
  const HeightArray crossed = heights(surface);
  surface.layout = {};
  const HeightArray lines = heights(surface);
  const brdf::LinePlaces across(tenth, Length::um(3), 3, brdf::random_engine(1, 1));
  for (const Eigen::Index row : {0, 7, 15, 30}) {
    const double position = static_cast<double>(row - 15) * 0.4 / 3;
    const brdf::LinePlaces::Stretch stretch = across.at(position);
    CHECK((crossed.row(row) - lines.row(row) * bump((position - stretch.start) / stretch.width))
              .abs()
              .maxCoeff() <= rounding_um);
  }
}

TEST_CASE("fingers in order are a plain lattice", "[synthetic_surface][invariant]") {
  const SyntheticSurface fingers{.grating = grating(Profile::sinusoid),
                                 .layout = FingerRows{.width = Length::um(1.5)}};
  CHECK(distance(heights(fingers), [&](double x, double y) {
          return height_um * bump(x / period_um) * bump(y / 1.5);
        }) <= rounding_um);
  // Whatever the lines, the strips are round.
  SyntheticSurface blazed = fingers;
  blazed.grating.profile = Profile::blazed;
  blazed.grating.facing = brdf::Facing::minus_x;
  CHECK(distance(heights(blazed), [&](double x, double y) {
          return height_um * (x / period_um - std::floor(x / period_um)) * bump(y / 1.5);
        }) <= rounding_um);
}

TEST_CASE("each strip of fingers has lines of its own", "[synthetic_surface][invariant]") {
  SyntheticSurface fingers{.grating = grating(Profile::sinusoid),
                           .layout = FingerRows{.width = Length::um(2)},
                           .jitter = tenth};
  const HeightArray made = heights(fingers);  // 5 rows a strip, row 15 in the middle of strip 0
  for (const Eigen::Index ridge : {5, 10, 15, 20, 25}) {
    // One height along the strip times the bump across it.
    for (const Eigen::Index off : {-2, -1, 1, 2})
      CHECK((made.row(ridge + off) - made.row(ridge) * bump(0.2 * static_cast<double>(off)))
                .abs()
                .maxCoeff() <= rounding_um);
    if (ridge > 5)
      CHECK((made.row(ridge) - made.row(ridge - 5)).abs().maxCoeff() > 0.1 * height_um);
  }
  // Strip 0 is the grating of the same seed, strip n that of engine n.
  fingers.layout = {};
  CHECK((made.row(15) == heights(fingers).row(15)).all());
  const brdf::LinePlaces places(tenth, Length::um(period_um), 2, brdf::random_engine(1, 0, 2));
  const brdf::LinePlaces::Stretch stretch = places.at(0);
  CHECK(std::abs(made(25, 20) - height_um * bump(-stretch.start / stretch.width)) <= rounding_um);
}

TEST_CASE("in disorder a profile is drawn out from line to line",
          "[synthetic_surface][invariant]") {
  for (const DisorderKind kind : {DisorderKind::position, DisorderKind::spacing}) {
    const Disorder disorder{.deviation = Length::um(0.25), .kind = kind};
    const HeightArray made =
        heights({.grating = grating(Profile::blazed), .jitter = disorder, .seed = 7}, 1);
    const std::vector<double> lines =
        brdf::LinePlaces(disorder, Length::um(period_um), 2, brdf::random_engine(7, 0)).places();
    CHECK(distance(made, [&](double x, double) {
            std::size_t i = 0;
            while (lines[i + 1] <= x / period_um) ++i;
            return height_um * (lines[i + 1] - x / period_um) / (lines[i + 1] - lines[i]);
          }) <= rounding_um);
  }
}

TEST_CASE("a larger patch or finer pixels show the same disorder",
          "[synthetic_surface][invariant]") {
  for (const DisorderKind kind : {DisorderKind::position, DisorderKind::spacing}) {
    const SyntheticSurface surface{.grating = grating(Profile::sinusoid),
                                   .jitter = {.deviation = Length::um(0.25), .kind = kind}};
    const HeightArray small = heights(surface, 1, 41), large = heights(surface, 1, 141);
    CHECK((large.middleCols(50, 41) == small).all());
    const HeightArray fine =
        brdf::synthetic_surface(surface, 1, 123, Length::um(0.17 / 3), Length::um(0.4))
            .heights_um();
    for (Eigen::Index col = 0; col < 41; ++col)
      REQUIRE(std::abs(fine(0, 3 * col + 1) - small(0, col)) <= rounding_um);
  }
}

TEST_CASE("seeds differ, and the same seed repeats", "[synthetic_surface][invariant]") {
  SyntheticSurface surface{.grating = grating(Profile::sinusoid),
                           .layout = CrossedLines{.period = Length::um(3)},
                           .jitter = tenth,
                           .noise = Length::nm(1)};
  const HeightArray first = heights(surface);
  CHECK((heights(surface) == first).all());
  surface.seed = 2;
  CHECK((heights(surface) != first).all());
}

TEST_CASE("the second grating has the last rows", "[synthetic_surface][invariant]") {
  SyntheticSurface surface{
      .grating = grating(Profile::triangle),
      .second = {{.period = Length::um(1.5), .direction = Angle::deg(20), .share = 0.3}}};
  const HeightArray both = heights(surface);
  SyntheticSurface first = surface, second = surface;
  first.second.reset();
  second.second.reset();
  second.grating.period = Length::um(1.5);
  second.direction = Angle::deg(20);
  // 0.3 x 31 = 9.3 rows.
  CHECK((both.topRows(22) == heights(first).topRows(22)).all());
  CHECK((both.bottomRows(9) == heights(second).bottomRows(9)).all());
  // In disorder its lines are others than the first's.
  surface.second->period = Length::um(period_um);
  surface.second->direction = {};
  surface.jitter = tenth;
  const HeightArray jittered = heights(surface);
  CHECK((jittered.row(0) == jittered.row(21)).all());
  CHECK((jittered.row(22) == jittered.row(30)).all());
  CHECK((jittered.row(21) - jittered.row(22)).abs().maxCoeff() > 0.1 * height_um);
}

TEST_CASE("noise is added row by row, whatever lies below", "[synthetic_surface][oracle]") {
  for (const Profile profile : {Profile::flat, Profile::sinusoid})
    for (const Disorder& jitter : {Disorder{}, tenth}) {
      SyntheticSurface surface{.grating = grating(profile), .jitter = jitter};
      const HeightArray clean = heights(surface);
      surface.noise = Length::nm(3);
      const HeightArray noisy = heights(surface);
      brdf::RandomEngine engine = brdf::random_engine(1, 4);
      for (Eigen::Index row = 0; row < 31; ++row)
        for (Eigen::Index col = 0; col < 41; ++col)
          // The sum is rounded, then the difference.
          REQUIRE(std::abs(noisy(row, col) - clean(row, col) -
                           0.003 * brdf::random_normal(engine)) <= 1e-16);
    }
}

TEST_CASE("averaged heights are the means of a fine sampling", "[synthetic_surface][oracle]") {
  constexpr Eigen::Index fine = 2000, cols = 37;
  for (const Profile profile :
       {Profile::sinusoid, Profile::blazed, Profile::lamellar, Profile::triangle})
    for (const brdf::Facing facing : {brdf::Facing::plus_x, brdf::Facing::minus_x})
      for (const Disorder& jitter :
           {Disorder{}, tenth, Disorder{tenth.deviation, DisorderKind::spacing}})
        // A pixel of 4 um holds whole periods.
        for (const double pixel_um : {0.17, 4.0}) {
          SyntheticSurface surface{.grating = grating(profile, 0.3), .jitter = jitter};
          surface.grating.facing = facing;
          const HeightField sampled = brdf::synthetic_surface(
              surface, 1, fine * cols, Length::um(pixel_um / fine), Length::um(1));
          surface.edges = Edges::averaged;
          const HeightField averaged =
              brdf::synthetic_surface(surface, 2, cols, Length::um(pixel_um), Length::um(1));
          CAPTURE(profile, jitter.kind, pixel_um);
          for (Eigen::Index col = 0; col < cols; ++col) {
            const double mean = sampled.heights_um().middleCols(col * fine, fine).mean();
            // Each jump may be off by half a fine pixel; 4 um hold at most 6 jumps.
            const double edges = pixel_um > 1 ? 6 : 2;
            REQUIRE(std::abs(averaged.heights_um()(0, col) - mean) <=
                    height_um * edges * 0.5 / fine);
            REQUIRE(averaged.heights_um()(1, col) == averaged.heights_um()(0, col));
          }
        }
}

TEST_CASE("averaged over whole periods a lamellar grating is its duty",
          "[synthetic_surface][invariant]") {
  for (const double duty : {0.5, 0.3, 1 / 3.0})
    for (const Eigen::Index cols : {36, 37, 64, 1000}) {
      // 4 periods on pixels that no period is a multiple of.
      const HeightField field = brdf::synthetic_surface(
          {.grating = grating(Profile::lamellar, duty), .edges = Edges::averaged}, 1, cols,
          Length::um(4 * period_um / static_cast<double>(cols)), Length::um(1));
      CAPTURE(duty, cols);
      // A mean of numbers up to 1, each with a rounding of 1e-16 by the number of columns a period.
      CHECK(std::abs(field.heights_um().mean() / height_um - duty) <= 1e-14);
    }
}

TEST_CASE("averaged edges of other patterns than lines along x are refused",
          "[synthetic_surface][invariant]") {
  const SyntheticSurface averaged{.grating = grating(Profile::lamellar), .edges = Edges::averaged};
  SyntheticSurface turned = averaged, crossed = averaged, fingers = averaged, second = averaged;
  turned.direction = Angle::deg(10);
  crossed.layout = CrossedLines{.period = Length::um(1)};
  fingers.layout = FingerRows{.width = Length::um(1)};
  second.second = {.period = Length::um(1), .direction = Angle::deg(10)};
  for (const SyntheticSurface& surface : {turned, crossed, fingers, second})
    CHECK_ERROR(heights(surface), Errc::invalid_argument, "edges averaged");
  second.second->direction = {};
  CHECK_NOTHROW(heights(second));
}

TEST_CASE("values that make no surface are refused", "[synthetic_surface][invariant]") {
  const auto refused = [](const std::string& part, const auto& change) {
    SyntheticSurface surface{.grating = grating(Profile::sinusoid), .second = {{}}};
    surface.second->period = Length::um(1);
    change(surface);
    CHECK_ERROR(heights(surface), Errc::invalid_argument, part);
  };
  for (const auto& [bad_um, shown] :
       {std::pair<double, std::string>{0, "0"}, {-3, "-3"}, {not_a_number, "nan"}}) {
    const Length bad = Length::um(bad_um);
    refused("second grating: period " + shown, [&](auto& s) { s.second->period = bad; });
    refused("crossed period " + shown, [&](auto& s) { s.layout = CrossedLines{.period = bad}; });
    refused("width of the fingers " + shown, [&](auto& s) { s.layout = FingerRows{.width = bad}; });
    if (bad_um != 0) refused("noise " + shown, [&](auto& s) { s.noise = bad; });
  }
  for (const double share : {0.0, 1.0, -0.5, not_a_number})
    refused("second share " + brdf::text(share), [&](auto& s) { s.second->share = share; });
  for (const double angle_deg : {0.0, 180.0, -30.0, not_a_number})
    refused("crossed angle " + brdf::text(angle_deg), [&](auto& s) {
      s.layout = CrossedLines{.period = Length::um(1), .angle = Angle::deg(angle_deg)};
    });
  // A quarter of the smallest of the periods.
  refused("second grating: jitter 0.25 um", [](auto& s) { s.jitter = {Length::um(0.25)}; });
  refused("jitter 0.25 um", [](auto& s) {
    s.second.reset();
    s.layout = CrossedLines{.period = Length::um(1)};
    s.jitter = {Length::um(0.25)};
  });
  refused("fingers in", [](auto& s) { s.layout = FingerRows{.width = Length::um(1e-7)}; });
}
