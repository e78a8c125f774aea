// Prints how right the periods are that are fitted to responses of known gratings, and whether
// their intervals hold the truth: the joint fit, and beside it the sources' estimator.
//
//   shedlight_period_study         a table of every case as CSV, then the summary in Markdown
//   shedlight_period_study brief   the summary alone
//   shedlight_period_study fresh   the same with other periods and depths, which the method was
//                                  not made on
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/stopwatch.h"
#include "brdf/synthetic_surface.h"
#include "evaluation/diffraction.h"
#include "evaluation/parallel.h"
#include "evaluation/period/joint_fit.h"
#include "evaluation/period/period_uncertainty.h"
#include "evaluation/period_fit.h"
#include "evaluation/sweep.h"

namespace {

using brdf::Angle;
using brdf::Length;

constexpr double pixel_um = 0.1;
// 65 um across.
constexpr Eigen::Index rows = 8, columns = 650;
/// Of the amplitude: far below what the fit tells apart.
constexpr double tolerance = 1e-9;
/// None is a multiple of the pixel or divides the patch.
constexpr double periods_um[] = {0.8137, 0.9371, 1.0913, 1.2377, 1.4442, 1.6283,
                                 1.9127, 2.3329, 2.7561, 3.3737, 4.1319, 4.8763};
constexpr double depths_nm[] = {20, 60, 150, 300, 500, 700};
constexpr double angles_deg[] = {0, 30, 75};
constexpr double sigmas_um[] = {2, 5, 16.25};

enum class Kind { sinusoid, smoothed_blaze, blaze, lamellar };
constexpr Kind kinds[] = {Kind::sinusoid, Kind::smoothed_blaze, Kind::blaze, Kind::lamellar};

std::string_view name_of(Kind kind) {
  switch (kind) {
    case Kind::sinusoid:
      return "sinusoid";
    case Kind::smoothed_blaze:
      return "smoothed blaze";
    case Kind::blaze:
      return "blaze";
    case Kind::lamellar:
      return "lamellar";
  }
  return "?";
}

struct Case {
  Kind kind;
  double period_um, depth_nm, theta_i_deg, sigma_um, start;
};

struct Outcome {
  Case of{};
  bool refused = true;
  std::string refusal;
  evaluation::JointFit fit{};
  bool peaks = false;
  evaluation::PeriodSpread spread{};
  double seconds = 0;

  double truth_nm() const { return 1e3 * of.period_um; }
  double error() const { return fit.period_nm / truth_nm() - 1; }
  double width() const { return (fit.high_nm - fit.low_nm) / truth_nm(); }
  bool holds() const { return fit.low_nm <= truth_nm() && truth_nm() <= fit.high_nm; }
  /// The interval without what the pixels might do: of a profile without edges.
  double half_width_without_pixel() const {
    const auto& u = fit.uncertainty_nm;
    const double blocks = 7;  // degrees of freedom as in the fit
    return evaluation::half_interval(
               evaluation::combined({{u.fit, std::max(1.0, (blocks + 1) * fit.orders - 1)},
                                     {u.orders, std::max(1.0, fit.orders - 1.0)},
                                     {u.blocks, blocks},
                                     {u.model, 2}})) /
           truth_nm();
  }
  double sources_error() const { return std::abs(spread.mean_nm / truth_nm() - 1); }
};

brdf::HeightField grating(const Case& c) {
  if (c.kind != Kind::smoothed_blaze) {
    const brdf::Profile profile = c.kind == Kind::sinusoid ? brdf::Profile::sinusoid
                                  : c.kind == Kind::blaze  ? brdf::Profile::blazed
                                                           : brdf::Profile::lamellar;
    return brdf::synthetic_grating({.profile = profile,
                                    .period = Length::um(c.period_um),
                                    .height = Length::nm(c.depth_nm),
                                    .duty = 0.4},
                                   rows, columns, Length::um(pixel_um), Length::um(pixel_um));
  }
  // The Fourier series of a falling sawtooth, cut after three harmonics.
  brdf::HeightArray heights_um(rows, columns);
  for (Eigen::Index col = 0; col < columns; ++col) {
    const double t = (static_cast<double>(col) - (columns - 1) / 2.0) * pixel_um / c.period_um;
    double height = 0.5;
    for (int m = 1; m <= 3; ++m) height += std::sin(2 * brdf::pi * m * t) / (brdf::pi * m);
    heights_um.col(col) = 1e-3 * c.depth_nm * height;
  }
  return brdf::HeightField(std::move(heights_um), Length::um(pixel_um), Length::um(pixel_um));
}

Outcome run(const Case& c) {
  const brdf::HeightField field = grating(c);
  const brdf::Surface surface{&field, brdf::GaussianWindow(Length::um(c.sigma_um)),
                              brdf::SurfaceModel::isolated};
  evaluation::SweepRequest request{Angle::deg(c.theta_i_deg), {}, {}, {}, {}};
  for (int nm = 380; nm <= 780; nm += 10) request.lambda_nm.values.push_back(nm);
  for (int i = 0; i <= 1600; ++i) request.theta_r_deg.values.push_back(-80 + 0.1 * i);
  const auto plan =
      evaluation::method_named("chebyshev").plan(surface, bounds_of(request, tolerance), {});
  const evaluation::Optics optics;
  const auto response = sweep(request, evaluation::Diffraction(*plan, optics), {1, {}});

  Outcome outcome;
  outcome.of = c;
  const evaluation::JointScene scene{
      request.theta_i, request.phi_i,  request.phi_r,   optics,          request.depth,
      surface.model,   surface.window, x_axis(surface), y_axis(surface), tolerance * tolerance};
  const benchmarks::Stopwatch watch;
  try {
    outcome.fit = fit_period_jointly(response, scene, Length::um(c.period_um * c.start));
    outcome.refused = false;
  } catch (const brdf::Error& error) {
    outcome.refusal = error.what();
  }
  outcome.seconds = watch.seconds();
  const evaluation::PlaneOfIncidence plane{request.theta_i, 1, surface.window.sigma_f_per_um()};
  evaluation::PeakSearch search;
  search.period_guess = Length::um(c.period_um);  // more than the sources had
  search.refinement = evaluation::Refinement::grid;
  try {
    outcome.spread = period_spread(find_peaks(response, plane, search), plane, search.order);
    outcome.peaks = true;
  } catch (const brdf::Error&) {
  }
  return outcome;
}

/// factor: of all periods. turn: where the depths and starts begin to take turns.
std::vector<Case> cases(double factor, std::size_t turn) {
  std::vector<Case> all;
  for (const Kind kind : kinds)
    for (const double period : periods_um)
      for (const double theta : angles_deg) {
        // Depths and starts take turns; all windows see the same grating.
        const double depth = depths_nm[turn % std::size(depths_nm)];
        const double start = 1 + 0.01 * (static_cast<double>(turn * 7 % 5) - 2) / 2;
        turn += 5 + (theta == 75 ? 1 : 0);
        for (const double sigma : sigmas_um)
          all.push_back({kind, factor * period, depth, theta, sigma, start});
      }
  return all;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

void print(const Outcome& o) {
  std::printf("%s,%g,%g,%g,%g,", std::string(name_of(o.of.kind)).c_str(), o.of.period_um,
              o.of.depth_nm, o.of.theta_i_deg, o.of.sigma_um);
  if (o.refused) {
    std::printf("refused: %s\n", o.refusal.c_str());
    return;
  }
  const auto& u = o.fit.uncertainty_nm;
  const double nm = o.truth_nm();
  std::printf("%.2e,%.2e,%s,%d,%.3f,%.4f,%.1e,%.1e,%.1e,%.1e,%.1e,", o.error(), o.width(),
              o.holds() ? "yes" : "NO", o.fit.orders, o.fit.relative_width, o.fit.explained,
              u.fit / nm, u.orders / nm, u.blocks / nm, u.pixel / nm, u.model / nm);
  if (o.peaks)
    std::printf("%.2e,%.2e,", o.spread.mean_nm / nm - 1, o.spread.std_nm / nm);
  else
    std::printf(",,");
  std::printf("%.2f\n", o.seconds);
}

bool is_smooth(const Outcome& o) {
  return o.of.kind == Kind::sinusoid || o.of.kind == Kind::smoothed_blaze;
}

/// Whether what the fit says of itself holds where no edge is sampled.
void without_pixel(const std::vector<Outcome>& outcomes) {
  std::vector<double> widths;
  std::size_t held = 0;
  for (const Outcome& o : outcomes) {
    if (o.refused || !is_smooth(o)) continue;
    widths.push_back(2 * o.half_width_without_pixel());
    held += std::abs(o.error()) <= o.half_width_without_pixel() ? 1 : 0;
  }
  std::printf(
      "\nSmooth profiles, the pixel's part left out of the interval: %.1f %% of %zu hold the "
      "truth, median full width %.1e.\n",
      100.0 * static_cast<double>(held) / static_cast<double>(widths.size()), widths.size(),
      median(widths));
}

/// One line of the summary for the outcomes that `belongs` takes.
template <class Belongs>
void summarise(const char* what, const std::vector<Outcome>& outcomes, Belongs belongs) {
  std::vector<double> errors, widths, theirs, seconds;
  std::size_t held = 0, refused = 0, all = 0, covered = 0;
  for (const Outcome& o : outcomes) {
    if (!belongs(o)) continue;
    ++all;
    if (o.peaks) {
      theirs.push_back(o.sources_error());
      covered += o.sources_error() * o.truth_nm() <= 2 * o.spread.std_nm ? 1 : 0;
    }
    if (o.refused) {
      ++refused;
      continue;
    }
    errors.push_back(std::abs(o.error()));
    widths.push_back(o.width());
    seconds.push_back(o.seconds);
    held += o.holds() ? 1 : 0;
  }
  std::printf("| %s | %zu | %zu | %.1f %% | %.1e | %.1e | %.1e | %.1f %% | %.2f |\n", what, all,
              refused, 100.0 * static_cast<double>(held) / static_cast<double>(errors.size()),
              median(errors), median(widths), median(theirs),
              100.0 * static_cast<double>(covered) / static_cast<double>(theirs.size()),
              median(seconds));
}

}  // namespace

int main(int argc, char** argv) {
  const bool brief = argc > 1 && std::string_view(argv[1]) == "brief";
  const bool fresh = argc > 1 && std::string_view(argv[1]) == "fresh";
  const std::vector<Case> all = fresh ? cases(1.01931, 3) : cases(1, 0);
  std::vector<Outcome> outcomes(all.size());
  evaluation::parallel_for(all.size(), 2, [&](std::size_t i) { outcomes[i] = run(all[i]); });
  if (!brief) {
    std::puts(
        "profile,period_um,depth_nm,theta_i_deg,sigma_um,error,width,holds,orders,lobe,explained,"
        "fit,orders_spread,blocks,pixel,model,sources_error,sources_std,seconds");
    for (const Outcome& o : outcomes) print(o);
    std::puts("");
  }
  std::puts(
      "| cases | number | refused | intervals that hold the truth | median error | median full "
      "width | sources: median error | sources: within 2 std | median seconds |\n"
      "|---|---|---|---|---|---|---|---|---|");
  const auto any = [](const Outcome&) { return true; };
  summarise("all", outcomes, any);
  summarise("sigma 16.25 um, d <= 2.5 um", outcomes,
            [](const Outcome& o) { return o.of.sigma_um == 16.25 && o.of.period_um <= 2.5; });
  for (const double sigma : sigmas_um)
    summarise(("sigma " + brdf::text(sigma) + " um").c_str(), outcomes,
              [&](const Outcome& o) { return o.of.sigma_um == sigma; });
  for (const Kind kind : kinds)
    summarise(std::string(name_of(kind)).c_str(), outcomes,
              [&](const Outcome& o) { return o.of.kind == kind; });
  for (const double theta : angles_deg)
    summarise(("theta_i " + brdf::text(theta) + " deg").c_str(), outcomes,
              [&](const Outcome& o) { return o.of.theta_i_deg == theta; });
  without_pixel(outcomes);
}
