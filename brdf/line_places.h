// Where the lines of a grating lie, in order or not.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "brdf/error.h"
#include "brdf/random_numbers.h"
#include "brdf/units.h"

namespace brdf {

/// What varies from line to line.
enum class DisorderKind {
  position,  ///< each line's own place: line i at i d + xi_i. First kind, the lattice is kept
  spacing,   ///< each distance: d + xi_i, so that places drift. Second kind, no lattice is left
};

/// xi_i: normal, mean 0, standard deviation `deviation` >= 0, independent.
struct Disorder {
  Length deviation = {};
  DisorderKind kind = DisorderKind::position;
};

/// Places of numbered lines, in periods, line 0 at or near 0.
///
/// Numbers are drawn for the lines 0, 1, -1, 2, -2, ... in turn: a line's place depends on the
/// engine and its number alone, not on how many lines there are. With varied spacings line 0 lies
/// at 0, and the number of line i > 0 belongs to the distance from line i - 1, of i < 0 to the
/// distance to line i + 1.
class LinePlaces {
 public:
  /// The stretch from a line to the next.
  struct Stretch {
    double start, width;
  };

  /// In order: a line at every whole number.
  LinePlaces() = default;

  /// In disorder: lines for the positions -reach to reach [periods].
  ///
  /// Throws Errc::invalid_argument for a deviation of a quarter of the period or more, where lines
  /// often cross; for two lines that cross nevertheless, or fall together; and for more than
  /// `max_lines`.
  LinePlaces(const Disorder& disorder, Length period, double reach, RandomEngine engine) {
    require_lines_apart(disorder, period);
    if (disorder.deviation.um() == 0) return;
    const double deviation = disorder.deviation.um() / period.um();
    if (!(2 * reach <= max_lines))
      throw Error(Errc::invalid_argument,
                  "jitter of " + text(std::ceil(2 * reach)) + " lines: at most " + text(max_lines));
    const bool drifts = disorder.kind == DisorderKind::spacing;
    std::vector<double> right, left;  // right: lines 0, 1, 2, ...; left: lines -1, -2, ...
    const double first = deviation * random_normal(engine);
    right.push_back(drifts ? 0 : first);
    // Fewer than 2 lines on a side would leave no stretch to begin with.
    while (left.empty() || right.back() <= reach || left.back() > -reach) {
      const auto number = static_cast<double>(right.size());
      const double to_right = deviation * random_normal(engine);
      const double to_left = deviation * random_normal(engine);
      right.push_back(drifts ? right.back() + 1 + to_right : number + to_right);
      const double leftmost = left.empty() ? right.front() : left.back();
      left.push_back(drifts ? leftmost - 1 - to_left : -number + to_left);
      require_order(right[right.size() - 2], right.back(), right.size() - 1, disorder);
      require_order(left.back(), leftmost, left.size(), disorder);
    }
    places_.assign(left.rbegin(), left.rend());
    places_.insert(places_.end(), right.begin(), right.end());
  }

  bool in_order() const { return places_.empty(); }

  /// The stretch that holds a position: start <= position < start + width.
  Stretch at(double position) const {
    if (in_order()) return {std::floor(position), 1};
    const auto next = std::upper_bound(places_.begin() + 1, places_.end() - 1, position);
    return {*(next - 1), *next - *(next - 1)};
  }

  /// The places of the lines that there are numbers for, rising; empty where in order.
  const std::vector<double>& places() const { return places_; }

  /// Refuses a deviation that is no number >= 0, or not below a quarter of the period.
  static void require_lines_apart(const Disorder& disorder, Length period) {
    const double deviation_um = disorder.deviation.um();
    if (!(deviation_um >= 0 && std::isfinite(deviation_um)))
      throw Error(Errc::invalid_argument, "jitter " + text(deviation_um) + " um must be >= 0");
    if (deviation_um > 0 && !(deviation_um < period.um() / 4))
      throw Error(Errc::invalid_argument, "jitter " + text(deviation_um) +
                                              " um must be below a quarter of the period " +
                                              text(period.um()) + " um, or lines cross");
  }

  /// 128 MB of places.
  static constexpr double max_lines = 1 << 24;

 private:
  static void require_order(double left, double right, std::size_t number,
                            const Disorder& disorder) {
    if (left < right) return;
    throw Error(Errc::invalid_argument,
                "jitter " + text(disorder.deviation.um()) + " um: two lines cross, " +
                    std::to_string(number) +
                    " lines from the middle; take a smaller one, or another seed");
  }

  std::vector<double> places_;
};

}  // namespace brdf
