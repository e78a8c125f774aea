#include "evaluation/period/surface_periods.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "brdf/error.h"
#include "brdf/height_spectrum.h"
#include "brdf/levelling.h"
#include "evaluation/period/line_group.h"

namespace evaluation {
namespace {

constexpr double first_lambda_um = 0.38, last_lambda_um = 0.78;
constexpr int lambdas = 9;
constexpr std::size_t brightest = 3;
/// sin of the steepest incidence that an order is looked for at.
constexpr double steepest_sine = 0.98;
constexpr double least_lattice_deg = 20;

Frequency frequency_of(const HeightPeriod& period) {
  const double f = 1 / period.period.um(), azimuth = period.azimuth.rad();
  return {f * std::cos(azimuth), f * std::sin(azimuth)};
}

/// Distance in bins of the patch, of two gratings whichever way their vectors point.
double apart_bins(const brdf::HeightField& field, const Frequency& a, const Frequency& b) {
  const auto bins = [&](double sign) {
    return std::hypot((a.x_per_um - sign * b.x_per_um) * field.width_um(),
                      (a.y_per_um - sign * b.y_per_um) * field.height_um());
  };
  return std::min(bins(1), bins(-1));
}

/// Weights of an axis under the window of `refined_line`, sum 1: a profile that ends within a
/// period, such as a blaze's, does not pass for a tilt then.
Eigen::ArrayXd axis_weights(const Eigen::ArrayXd& place_um, double length_um) {
  const Eigen::ArrayXd weight =
      (-0.5 * (place_um / (PatchWindow{}.share * length_um)).square()).exp();
  return weight / weight.sum();
}

double slope(const Eigen::ArrayXd& weight, const Eigen::ArrayXd& place_um,
             const Eigen::ArrayXd& profile_um) {
  if (place_um.size() < 2) return 0;
  return (weight * place_um * profile_um).sum() / (weight * place_um.square()).sum();
}

/// The heights less a plane. A tilt sends the light of all orders aside, that of +m and -m to
/// opposite sides of where their period puts them.
brdf::HeightField without_tilt(const brdf::HeightField& field) {
  const auto places = [](Eigen::Index count, double pixel_um) {
    const double half = static_cast<double>(count - 1) / 2;
    return Eigen::ArrayXd(pixel_um * Eigen::ArrayXd::LinSpaced(count, -half, half));
  };
  const Eigen::ArrayXd x = places(field.cols(), field.dx_um());
  const Eigen::ArrayXd y = places(field.rows(), field.dy_um());
  const Eigen::ArrayXd across = axis_weights(x, field.width_um());
  const Eigen::ArrayXd down = axis_weights(y, field.height_um());
  const auto h = field.heights_um().matrix();
  const double along_x = slope(across, x, (h.transpose() * down.matrix()).array());
  const double along_y = slope(down, y, (h * across.matrix()).array());
  brdf::HeightArray heights_um = field.heights_um();
  heights_um.rowwise() -= along_x * x.transpose();
  heights_um.colwise() -= along_y * y;
  return brdf::HeightField(std::move(heights_um), brdf::Length::um(field.dx_um()),
                           brdf::Length::um(field.dy_um()));
}

/// Chains of periods close to one another, as indices.
std::vector<std::vector<std::size_t>> groups_of(const brdf::HeightField& field,
                                                const std::vector<Frequency>& lines) {
  std::vector<std::size_t> group(lines.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (apart_bins(field, lines[i], lines[j]) <= group_bins)
        std::replace(group.begin(), group.end(), std::max(group[i], group[j]),
                     std::min(group[i], group[j]));
  std::vector<std::vector<std::size_t>> chains(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) chains[group[i]].push_back(i);
  std::erase_if(chains, [](const auto& chain) { return chain.empty(); });
  return chains;
}

std::vector<std::optional<PeriodEstimate>> estimates_of(const SurfaceWave& wave,
                                                        const std::vector<Frequency>& starts) {
  if (starts.size() == 1) return {estimate_period(wave, starts.front())};
  return estimate_periods_together(wave, starts);
}

/// A wavelength, the light it makes of the surface, and how bright the weaker of the first order
/// and of the mirror lobe, which its phases are counted from, is.
struct Light {
  double lambda_nm, c_per_um, brightness;
};

std::vector<Light> brightest_light(const brdf::HeightField& field, const Frequency& line) {
  std::vector<Light> all;
  for (int i = 0; i < lambdas; ++i) {
    const double lambda_um = std::lerp(first_lambda_um, last_lambda_um, i / (lambdas - 1.0));
    const double sine = lambda_um * line.length_per_um() / 2;
    if (!(sine <= steepest_sine)) continue;
    const double c = -2 * (2 * brdf::pi / lambda_um) * std::sqrt(1 - sine * sine);
    const SurfaceWave wave = light_wave(field, c);
    const double mirror = std::hypot(wave.real.mean(), wave.imaginary.mean());
    all.push_back({brdf::Length::um(lambda_um).nm(), c,
                   std::min(mirror, std::abs(line_amplitude(wave, line)))});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Light& a, const Light& b) { return a.brightness > b.brightness; });
  all.resize(std::min(all.size(), brightest));
  return all;
}

/// Means over the wavelengths: they see the same lines, so that intervals do not shrink.
std::vector<std::optional<LightPeriod>> light_periods(const brdf::HeightField& field,
                                                      const std::vector<Frequency>& lines) {
  std::vector<LightPeriod> sums(lines.size(), LightPeriod{0, {0, 0}, {}});
  for (const Light& light : brightest_light(field, lines.front())) {
    std::vector<std::optional<PeriodEstimate>> estimates;
    try {
      estimates = estimates_of(light_wave(field, light.c_per_um), lines);
    } catch (const brdf::Error& error) {
      if (error.code() != brdf::Errc::not_attainable) throw;
      continue;
    }
    for (std::size_t k = 0; k < lines.size(); ++k) {
      if (!estimates[k]) continue;
      sums[k].period_nm += estimates[k]->period_nm;
      sums[k].interval_nm.lo += estimates[k]->interval_nm.lo;
      sums[k].interval_nm.hi += estimates[k]->interval_nm.hi;
      sums[k].lambdas_nm.push_back(light.lambda_nm);
    }
  }
  std::vector<std::optional<LightPeriod>> means(lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto count = static_cast<double>(sums[k].lambdas_nm.size());
    if (count == 0) continue;
    means[k] = LightPeriod{sums[k].period_nm / count,
                           {sums[k].interval_nm.lo / count, sums[k].interval_nm.hi / count},
                           sums[k].lambdas_nm};
  }
  return means;
}

/// The heights are taken as they are: what follows does not see a plane, and a surface that repeats
/// itself exactly would no longer do so less the plane through it.
void measure(const brdf::HeightField& field, const brdf::HeightField& untilted,
             const std::vector<Frequency>& lines, const std::vector<std::size_t>& group,
             std::vector<SurfacePeriod>& periods) {
  std::vector<Frequency> starts, mirrored;
  for (const std::size_t i : group) {
    // All on one side: whichever way their vectors were told.
    const Frequency f = lines[i];
    const Frequency first = starts.empty() ? f : starts.front();
    starts.push_back(f.x_per_um * first.x_per_um + f.y_per_um * first.y_per_um < 0 ? -f : f);
    mirrored.push_back(-starts.back());
  }
  try {
    const auto heights = estimates_of(height_wave(field), starts);
    const auto left = light_periods(untilted, starts), right = light_periods(untilted, mirrored);
    for (std::size_t k = 0; k < group.size(); ++k) {
      SurfacePeriod& one = periods[group[k]];
      one.heights = heights[k];
      if (!heights[k])
        one.reason = "it changes with the place of the window by more than a line's width";
      one.left = left[k];
      one.right = right[k];
    }
  } catch (const brdf::Error& error) {
    if (error.code() != brdf::Errc::not_attainable) throw;
    for (const std::size_t i : group) periods[i].reason = error.what();
  }
}

/// The maxima of the spectrum that are no harmonics.
std::vector<HeightPeriod> fundamentals(const brdf::HeightField& field, std::size_t most) {
  const brdf::HeightField level = brdf::levelled(field, brdf::Level::plane);
  std::vector<HeightPeriod> found = dominant_periods(brdf::HeightSpectrum(level), most);
  std::erase_if(found, [](const HeightPeriod& one) { return one.harmonic.has_value(); });
  if (found.empty())
    throw brdf::Error(brdf::Errc::not_attainable,
                      "no period: nothing in the spectrum of the heights stands above its "
                      "surroundings (a rough surface, or lines in all directions)");
  return found;
}

}  // namespace

bool SurfacePeriod::agree() const {
  std::vector<Interval> all;
  if (heights) all.push_back(heights->interval_nm);
  for (const auto& light : {left, right})
    if (light) all.push_back(light->interval_nm);
  for (const Interval& a : all)
    for (const Interval& b : all)
      if (!a.overlaps(b)) return false;
  return all.size() > 1;
}

std::vector<SurfacePeriod> surface_periods(const brdf::HeightField& field, std::size_t most) {
  std::vector<SurfacePeriod> periods;
  std::vector<Frequency> lines;
  for (const HeightPeriod& found : fundamentals(field, most)) {
    periods.push_back({found, {}, {}, {}, {}, false});
    lines.push_back(frequency_of(found));
  }
  const brdf::HeightField untilted = without_tilt(field);
  for (const auto& group : groups_of(field, lines)) {
    for (const std::size_t i : group) periods[i].in_group = group.size() > 1;
    measure(field, untilted, lines, group, periods);
  }
  return periods;
}

brdf::Angle grating_azimuth(const brdf::HeightField& field) {
  const Frequency start = frequency_of(fundamentals(field, 1).front());
  return refined_line(height_wave(field), start).value_or(start).azimuth();
}

std::optional<std::pair<std::size_t, std::size_t>> lattice_of(
    const std::vector<SurfacePeriod>& periods) {
  for (std::size_t i = 0; i < periods.size(); ++i) {
    if (!periods[i].heights) continue;
    for (std::size_t j = i + 1; j < periods.size(); ++j) {
      if (!periods[j].heights) continue;
      const double apart = std::abs(
          std::remainder(periods[i].found.azimuth.deg() - periods[j].found.azimuth.deg(), 180.0));
      if (apart >= least_lattice_deg) return std::pair(i, j);
    }
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace evaluation
