#include "evaluation/period/ridges.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "evaluation/period/ridge_candidates.h"
#include "evaluation/period/ridge_orders.h"
#include "evaluation/period/ridge_shape.h"
#include "evaluation/period/ridge_tracks.h"

namespace evaluation {
namespace {

/// Fewer cannot tell a ridge from a bright spot.
constexpr std::size_t least_wavelengths = 3;
constexpr double least_present = 0.2;
/// FWHM of a lobe of the window [sigma_f].
const double window_width_sigma_f = 2 * std::sqrt(std::log(2.0));

void require(bool holds, const std::string& what) {
  if (!holds) throw brdf::Error(brdf::Errc::invalid_argument, what);
}

void require_valid(const RidgeSearch& search) {
  require(search.order != 0, "order 0 is the mirror direction, which has no period");
  require(search.least_contrast > 1,
          "contrast " + brdf::text(search.least_contrast) + " must be > 1");
  const auto positive = [](const brdf::Length& period) {
    require(period.um() > 0, "period " + brdf::text(period.nm()) + " nm must be > 0");
  };
  if (search.period_guess) positive(*search.period_guess);
  if (search.period_range) {
    positive(search.period_range->first);
    positive(search.period_range->second);
  }
}

/// A ridge in the making.
struct Found {
  RidgeCandidate candidate;
  RidgeTrack track;
  std::optional<int> order;
};

bool is_seen(const FrequencyResponse& over, const Found& found, std::size_t row) {
  return over.seen[row].holds(found.candidate.point);
}

std::size_t members(const Found& found) {
  return static_cast<std::size_t>(std::ranges::count_if(
      found.track.members, [](const auto& member) { return member.has_value(); }));
}

/// Wavelengths in whose view a ridge lies: at the edge of a view its member may lie inside alone.
std::size_t seeing(const FrequencyResponse& over, const Found& found) {
  std::size_t count = 0;
  for (std::size_t row = 0; row < over.seen.size(); ++row)
    if (is_seen(over, found, row) || found.track.members[row]) ++count;
  return count;
}

/// Whether a wavelength has no maximum of `lost`, but power there that only rises to the member of
/// `other`.
bool merges(const FrequencyResponse& over, const Found& lost, const Found& other, std::size_t row) {
  if (!is_seen(over, lost, row) || lost.track.members[row] || !other.track.members[row])
    return false;
  const auto point = [&](double f) {
    const double at = std::round((f - over.first_per_um) / over.step_per_um);
    return static_cast<Eigen::Index>(std::clamp(at, 0.0, static_cast<double>(over.points() - 1)));
  };
  const Eigen::Index top = point(other.track.members[row]->f_per_um);
  Eigen::Index at = point(lost.track.f_per_um);
  const auto values = over.values.row(static_cast<Eigen::Index>(row));
  if (!(values(at) >= least_of_mean * lost.track.strength)) return false;
  for (const Eigen::Index step = at < top ? 1 : -1; at != top; at += step)
    if (!(values(at + step) >= values(at))) return false;
  return true;
}

/// Neighbours that merge, with the number of wavelengths; `found` by increasing f.
std::map<std::pair<std::size_t, std::size_t>, std::size_t> merged(const FrequencyResponse& over,
                                                                  const std::vector<Found>& found) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> pairs;
  for (std::size_t k = 1; k < found.size(); ++k)
    for (std::size_t i = 0; i < over.seen.size(); ++i)
      if (merges(over, found[k], found[k - 1], i) || merges(over, found[k - 1], found[k], i))
        ++pairs[{k - 1, k}];
  return pairs;
}

/// Per wavelength, the ridge with the brightest member among those of an order.
std::vector<std::optional<std::size_t>> brightest(const std::vector<Found>& found,
                                                  std::optional<int> order, std::size_t rows) {
  std::vector<std::optional<std::size_t>> track(rows);
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t k = 0; k < found.size(); ++k) {
      const auto& member = found[k].track.members[i];
      if (found[k].order == order && member &&
          (!track[i] || member->value > found[*track[i]].track.members[i]->value))
        track[i] = k;
    }
  return track;
}

std::size_t jumps(const std::vector<std::optional<std::size_t>>& track) {
  std::size_t count = 0;
  std::optional<std::size_t> last;
  for (const auto& ridge : track) {
    if (!ridge) continue;
    if (last && *last != *ridge) ++count;
    last = ridge;
  }
  return count;
}

std::vector<Found> found_ridges(const FrequencyResponse& over, const RidgeSearch& search) {
  std::vector<Found> found;
  std::vector<RidgeTrack> tracks;
  for (const RidgeCandidate& candidate : ridge_candidates(over, search.least_contrast)) {
    found.push_back({candidate, {}, {}});
    tracks.push_back(
        {over.frequency(static_cast<double>(candidate.point)), over.mean[candidate.point], {}});
  }
  assign_members(tracks, row_maxima(over, search.floor),
                 window_width_sigma_f * over.sigma_f_per_um);
  for (std::size_t k = 0; k < found.size(); ++k) found[k].track = std::move(tracks[k]);
  std::erase_if(found, [&](const Found& ridge) {
    const auto count = static_cast<double>(members(ridge));
    return !(count >= static_cast<double>(least_wavelengths) &&
             count >= least_present * static_cast<double>(seeing(over, ridge)));
  });
  return found;
}

double period_nm(const Found& found) {
  return std::abs(found.order.value_or(1) / found.track.f_per_um) * 1e3;
}

/// Numbers the ridges and drops those that are not asked for.
void keep_asked(std::vector<Found>& found, const RidgeSearch& search) {
  if (found.empty()) return;
  std::vector<RidgePlace> places;
  for (const Found& ridge : found) places.push_back({ridge.track.f_per_um, ridge.track.strength});
  const RidgeOrders numbered = number_ridges(places, search.order, search.period_guess);
  for (std::size_t k = 0; k < found.size(); ++k) found[k].order = numbered.orders[k];
  std::erase_if(found, [&](const Found& ridge) {
    if (search.order && search.period_guess && ridge.order != search.order) return true;
    const double period = period_nm(ridge);
    return search.period_range && !(period >= search.period_range->first.nm() &&
                                    period <= search.period_range->second.nm());
  });
}

Ridge described(const FrequencyResponse& over, const Found& found, const Axis& lambda_nm) {
  Ridge ridge{};
  ridge.f_per_um = found.track.f_per_um;
  ridge.f_spread_per_um = spread_per_um(found.track);
  ridge.order = found.order;
  ridge.period_nm = period_nm(found);
  ridge.strength = found.track.strength;
  ridge.contrast = found.candidate.contrast;
  ridge.width_per_um = width_per_um(over, found.candidate.point);
  ridge.spans = spans(found.track, lambda_nm);
  ridge.present = static_cast<double>(members(found)) / static_cast<double>(seeing(over, found));
  return ridge;
}

}  // namespace

Ridges find_ridges(const ResponseMatrix& response, const PlaneOfIncidence& plane,
                   const RidgeSearch& search) {
  require_valid(search);
  if (response.lambda_nm.size() < least_wavelengths)
    throw brdf::Error(brdf::Errc::not_attainable, "a ridge is what wavelengths have in common: " +
                                                      std::to_string(response.lambda_nm.size()) +
                                                      " of them, at least 3 needed");
  const FrequencyResponse over = over_frequency(response, plane, search.theta_r_deg);
  std::vector<Found> found = found_ridges(over, search);
  keep_asked(found, search);

  Ridges result;
  for (std::size_t j = 0; j < over.points(); ++j) {
    result.f_per_um.push_back(over.frequency(static_cast<double>(j)));
    result.mean.push_back(over.in_mirror(j) ? 0 : over.mean[j]);
  }
  std::vector<std::size_t> by_strength(found.size()), number(found.size());
  for (std::size_t k = 0; k < found.size(); ++k) by_strength[k] = k;
  std::ranges::stable_sort(by_strength, std::ranges::greater{},
                           [&](std::size_t k) { return found[k].track.strength; });
  for (const std::size_t k : by_strength) {
    number[k] = result.ridges.size();
    Ridge& ridge = result.ridges.emplace_back(described(over, found[k], response.lambda_nm));
    ridge.relative = ridge.strength / result.ridges.front().strength;
    if (ridge.width_per_um && plane.sigma_f_per_um)
      ridge.window_widths = *ridge.width_per_um / (window_width_sigma_f * *plane.sigma_f_per_um);
    const auto track = brightest(found, ridge.order, over.seen.size());
    ridge.brightest = static_cast<double>(std::ranges::count(track, std::optional(k))) /
                      static_cast<double>(seeing(over, found[k]));
    const auto same = [&](const OrderJumps& known) { return known.order == ridge.order; };
    if (ridge.order && std::ranges::none_of(result.jumps, same))
      result.jumps.push_back({*ridge.order, jumps(track)});
  }
  for (const auto& [pair, wavelengths] : merged(over, found)) {
    result.ridges[number[pair.first]].merged_with.push_back({number[pair.second], wavelengths});
    result.ridges[number[pair.second]].merged_with.push_back({number[pair.first], wavelengths});
  }
  return result;
}

}  // namespace evaluation
