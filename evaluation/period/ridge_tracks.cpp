#include "evaluation/period/ridge_tracks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace evaluation {
namespace {

using Members =
    std::vector<std::optional<std::size_t>>;  ///< per ridge, a maximum of one wavelength

/// How far from each ridge its maxima may lie.
std::vector<double> reaches(const std::vector<RidgeTrack>& tracks, double reach_per_um) {
  std::vector<double> reach(tracks.size(), reach_per_um);
  for (std::size_t k = 1; k < tracks.size(); ++k) {
    const double half = (tracks[k].f_per_um - tracks[k - 1].f_per_um) / 2;
    reach[k] = std::min(reach[k], half);
    reach[k - 1] = std::min(reach[k - 1], half);
  }
  return reach;
}

/// What it is worth to give a maximum to a ridge; not positive where it may not be.
double worth(const RowMaximum& maximum, const RidgeTrack& track, double reach) {
  if (!(maximum.value >= least_of_mean * track.strength && reach > 0)) return 0;
  const double apart = (maximum.f_per_um - track.f_per_um) / reach;
  return 1 - apart * apart;
}

/// The best assignment of one wavelength.
Members assigned(const std::vector<RowMaximum>& maxima, const std::vector<RidgeTrack>& tracks,
                 const std::vector<double>& reach) {
  const std::size_t n = maxima.size(), ridges = tracks.size();
  // best(i, k): of the first i maxima and the first k ridges.
  std::vector<double> best((n + 1) * (ridges + 1), 0);
  const auto at = [ridges](std::size_t i, std::size_t k) { return i * (ridges + 1) + k; };
  for (std::size_t i = 1; i <= n; ++i)
    for (std::size_t k = 1; k <= ridges; ++k)
      best[at(i, k)] =
          std::max({best[at(i - 1, k)], best[at(i, k - 1)],
                    best[at(i - 1, k - 1)] + worth(maxima[i - 1], tracks[k - 1], reach[k - 1])});
  Members members(ridges);
  for (std::size_t i = n, k = ridges; i > 0 && k > 0;) {
    if (best[at(i, k)] == best[at(i - 1, k)]) {
      --i;
    } else if (best[at(i, k)] == best[at(i, k - 1)]) {
      --k;
    } else {
      members[--k] = --i;
    }
  }
  return members;
}

/// The members' median, weighted with their power; where there are none the ridge stays.
double weighted_median(const RidgeTrack& track) {
  std::vector<RowMaximum> members;
  double half = 0;
  for (const auto& member : track.members)
    if (member) {
      members.push_back(*member);
      half += member->value / 2;
    }
  std::ranges::sort(members, {}, &RowMaximum::f_per_um);
  double sum = 0;
  for (const RowMaximum& member : members)
    if ((sum += member.value) >= half) return member.f_per_um;
  return track.f_per_um;
}

}  // namespace

std::vector<std::vector<RowMaximum>> row_maxima(const FrequencyResponse& over, double floor) {
  std::vector<std::vector<RowMaximum>> maxima(over.seen.size());
  for (std::size_t i = 0; i < maxima.size(); ++i) {
    const SeenPoints seen = over.seen[i];
    for (std::size_t j = seen.begin + 1; j + 1 < seen.end; ++j) {
      const auto value = [&](std::size_t point) {
        return over.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(point));
      };
      const double before = value(j - 1), middle = value(j), after = value(j + 1);
      if (!(middle > before && middle >= after) || over.in_mirror(j)) continue;
      if (!(middle * over.gain[i] > floor)) continue;
      double offset = 0;
      if (before > 0 && after > 0) {
        const double rise = std::log(middle / before), fall = std::log(middle / after);
        offset = (rise - fall) / (2 * (rise + fall));  // rise > 0, fall >= 0
      }
      maxima[i].push_back({over.frequency(static_cast<double>(j) + offset), middle});
    }
  }
  return maxima;
}

void assign_members(std::vector<RidgeTrack>& tracks,
                    const std::vector<std::vector<RowMaximum>>& maxima, double reach_per_um) {
  // Medians of finite sets of members: each round repeats an earlier one or gains; skins take 3.
  constexpr int most_rounds = 50;
  std::vector<Members> before;
  for (int round = 0; round < most_rounds; ++round) {
    const std::vector<double> reach = reaches(tracks, reach_per_um);
    std::vector<Members> now;
    for (const auto& row : maxima) now.push_back(assigned(row, tracks, reach));
    if (now == before) return;
    for (std::size_t k = 0; k < tracks.size(); ++k) {
      tracks[k].members.assign(maxima.size(), std::nullopt);
      for (std::size_t i = 0; i < maxima.size(); ++i)
        if (now[i][k]) tracks[k].members[i] = maxima[i][*now[i][k]];
      tracks[k].f_per_um = weighted_median(tracks[k]);
    }
    before = std::move(now);
  }
}

}  // namespace evaluation
