#include "evaluation/dominant_periods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace evaluation {
namespace {

using brdf::HeightSpectrum;

constexpr double least_share = 0.002;
constexpr double dominant_share = 0.5;
/// Of the strongest period's power: the rest is detail of its shape, such as the sums and
/// differences of a lattice's two periods.
constexpr double least_of_strongest = 0.05;
constexpr double least_contrast = 30;
/// What a maximum needs whose direction has too few bins to tell it from a streak: more than one
/// of the first cycles of a rough surface holds.
constexpr double share_without_strip = 0.2;
/// Bins that belong to a line itself: under the window, 0.95 bins wide, its power has fallen to
/// 5e-5 at 3 bins.
constexpr double lobe_bins = 3;
/// Half of the width of the strip along a direction: one bin wide, as a streak is.
constexpr double strip_bins = 0.5;
/// A median of fewer says little.
constexpr std::size_t least_bins = 8;
/// How far a harmonic may lie from the multiple: a line's width.
constexpr double harmonic_bins = 1;
/// Amplitudes of the harmonics of a jump fall as 1 / m; one above the Nyquist limit that turns up
/// folded is taken for it where it does too, with room for several that fold onto each other.
constexpr double folded_harmonic_room = 2;

/// A place in the spectrum in cycles across the patch, column and row.
struct Cycles {
  double l, j;
  double length() const { return std::hypot(l, j); }
};
double distance(const Cycles& a, const Cycles& b) {
  return std::hypot(a.l - b.l, a.j - b.j);
}

struct Maximum {
  Cycles at;
  double power;
};

/// The row index as a signed frequency.
long signed_row(const HeightSpectrum& spectrum, long j) {
  return j <= spectrum.rows() / 2 ? j : j - spectrum.rows();
}

/// Calls f(l, j) for the bins of half of the spectrum; the other half mirrors it.
template <class Function>
void for_half_of_bins(const HeightSpectrum& spectrum, Function f) {
  for (long row = 0; row < spectrum.rows(); ++row) {
    const long j = signed_row(spectrum, row);
    for (long l = j > 0 ? 0 : 1; l <= spectrum.cols() / 2; ++l) f(l, j);
  }
}

/// Distance of the vertex of the parabola through three logarithms, and how much higher it is.
struct Vertex {
  double offset = 0, rise = 0;
};
Vertex vertex(double before, double middle, double after) {
  const double curvature = before - 2 * middle + after;
  if (!(curvature < 0 && std::isfinite(curvature))) return {};
  const double offset = std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5);
  return {offset, -0.25 * (before - after) * offset};
}

Maximum refined(const HeightSpectrum& spectrum, long l, long j) {
  const auto log_power = [&](long dl, long dj) { return std::log(spectrum.power(j + dj, l + dl)); };
  const double middle = log_power(0, 0);
  const Vertex x = vertex(log_power(-1, 0), middle, log_power(1, 0));
  const Vertex y = vertex(log_power(0, -1), middle, log_power(0, 1));
  return {{static_cast<double>(l) + x.offset, static_cast<double>(j) + y.offset},
          std::exp(middle + x.rise + y.rise)};
}

double share(const HeightSpectrum& spectrum, double power) {
  const double amplitude_um = spectrum.amplitude_um(power);
  return amplitude_um * amplitude_um / 2 / spectrum.variance_um2();
}

/// Local maxima with a share worth looking at, strongest first.
std::vector<Maximum> maxima(const HeightSpectrum& spectrum) {
  std::vector<Maximum> found;
  for_half_of_bins(spectrum, [&](long l, long j) {
    const double power = spectrum.power(j, l);
    const Cycles at{static_cast<double>(l), static_cast<double>(j)};
    if (!(at.length() >= least_cycles && share(spectrum, power) >= least_share)) return;
    for (long dj = -1; dj <= 1; ++dj)
      for (long dl = -1; dl <= 1; ++dl)
        if (spectrum.power(j + dj, l + dl) > power) return;
    found.push_back(refined(spectrum, l, j));
  });
  std::sort(found.begin(), found.end(),
            [](const Maximum& a, const Maximum& b) { return a.power > b.power; });
  return found;
}

/// Mean power of an exponential distribution, from the median. Empty of too few bins.
std::optional<double> background(std::vector<double>& powers) {
  if (powers.size() < least_bins) return std::nullopt;
  const auto middle = powers.begin() + static_cast<std::ptrdiff_t>(powers.size() / 2);
  std::nth_element(powers.begin(), middle, powers.end());
  return *middle / std::log(2.0);
}

/// What surrounds a maximum: the higher of the backgrounds an octave below and above it.
struct Surroundings {
  std::optional<double> ring;   ///< in all directions; empty where either side has too few bins
  std::optional<double> strip;  ///< in its own; empty where both sides have
};

Surroundings surroundings(const HeightSpectrum& spectrum, const Maximum& maximum) {
  const Cycles& at = maximum.at;
  const double width = spectrum.width_um(), height = spectrum.height_um();
  const double frequency = std::hypot(at.l / width, at.j / height);
  std::array<std::vector<double>, 2> ring, strip;  // below, above
  for_half_of_bins(spectrum, [&](long l, long j) {
    const Cycles bin{static_cast<double>(l), static_cast<double>(j)};
    const double ratio = std::hypot(bin.l / width, bin.j / height) / frequency;
    if (!(ratio >= 0.5 && ratio <= 2)) return;
    if (distance(bin, at) <= lobe_bins || distance({-bin.l, -bin.j}, at) <= lobe_bins) return;
    const std::size_t side = ratio < 1 ? 0 : 1;
    const double power = spectrum.power(j, l);
    ring[side].push_back(power);
    if (std::abs(bin.l * at.j - bin.j * at.l) <= strip_bins * at.length())
      strip[side].push_back(power);
  });
  Surroundings around;
  const auto ring_below = background(ring[0]), ring_above = background(ring[1]);
  if (ring_below && ring_above) around.ring = std::max(*ring_below, *ring_above);
  around.strip = std::max(background(strip[0]), background(strip[1]));  // an empty one is less
  return around;
}

/// Power over the higher of the backgrounds; infinite where there is none, NaN never.
double contrast(const Maximum& maximum, const Surroundings& around) {
  const auto highest = std::max(around.ring, around.strip);
  return highest && *highest > 0 ? maximum.power / *highest
                                 : std::numeric_limits<double>::infinity();
}

bool is_period(double share, double contrast, const Surroundings& around) {
  if (share >= dominant_share) return true;
  return around.ring && contrast >= least_contrast &&
         (around.strip || share >= share_without_strip);
}

/// Distance from a place on the grid of bins, or from its mirror image.
double folded_distance(const HeightSpectrum& spectrum, const Cycles& a, const Cycles& b) {
  const auto folded = [](double bins, long count) {
    return std::remainder(bins, static_cast<double>(count));
  };
  const auto apart = [&](double sign) {
    return std::hypot(folded(a.l - sign * b.l, spectrum.cols()),
                      folded(a.j - sign * b.j, spectrum.rows()));
  };
  return std::min(apart(1), apart(-1));
}

std::optional<Harmonic> harmonic_of(const HeightSpectrum& spectrum, const Maximum& maximum,
                                    const std::vector<Maximum>& found,
                                    const std::vector<HeightPeriod>& periods) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (periods[i].harmonic) continue;
    const Cycles& base = found[i].at;
    const double ratio = std::sqrt(found[i].power / maximum.power);
    const double highest =
        std::max(std::round(maximum.at.length() / base.length()), folded_harmonic_room * ratio);
    for (int m = 2; m <= highest; ++m)
      if (folded_distance(spectrum, maximum.at, {m * base.l, m * base.j}) <= harmonic_bins)
        return Harmonic{i, m};
  }
  return std::nullopt;
}

brdf::Angle azimuth(double fx, double fy) {
  double degrees = brdf::Angle::rad(std::atan2(fy, fx)).deg();
  if (degrees > 90) degrees -= 180;
  if (degrees <= -90) degrees += 180;
  return brdf::Angle::deg(degrees + 0.0);  // no -0
}

}  // namespace

std::vector<HeightPeriod> dominant_periods(const HeightSpectrum& spectrum, std::size_t most) {
  std::vector<HeightPeriod> periods;
  std::vector<Maximum> found;
  std::size_t harmonics = 0;
  if (!(spectrum.variance_um2() > 0)) return periods;
  for (const Maximum& maximum : maxima(spectrum)) {
    const double part = share(spectrum, maximum.power);
    const auto harmonic = harmonic_of(spectrum, maximum, found, periods);
    if ((harmonic ? harmonics : periods.size() - harmonics) >= most) continue;
    const Surroundings around = surroundings(spectrum, maximum);
    const double clear = contrast(maximum, around);
    if (!harmonic && !is_period(part, clear, around)) continue;
    if (!harmonic && !found.empty() && maximum.power < least_of_strongest * found.front().power)
      continue;
    const double fx = maximum.at.l / spectrum.width_um(), fy = maximum.at.j / spectrum.height_um();
    periods.push_back({brdf::Length::um(1 / std::hypot(fx, fy)), azimuth(fx, fy),
                       2 * spectrum.amplitude_um(maximum.power), part, clear, harmonic});
    found.push_back(maximum);
    if (harmonic) ++harmonics;
  }
  return periods;
}

}  // namespace evaluation
