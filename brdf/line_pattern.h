// Patterns of lines on a plane: straight, crossed, or in rows of fingers, each in order or not.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "brdf/line_places.h"
#include "brdf/synthetic_profile.h"

namespace brdf {

struct StraightLines {};

/// A second set of lines of the same profile: p1 p2, pillars where the profile is lamellar.
struct CrossedLines {
  Length period = {};
  Angle angle =
      Angle::deg(90);  ///< from the first grating vector to the second, inside (0, 180 deg)
};

/// Strips along the grating vector, each with its own disorder: p1 (1 + cos(2 pi v / width)) / 2 at
/// the distance v across them; a strip's ridge runs through the origin.
struct FingerRows {
  Length width = {};
};

using Layout = std::variant<StraightLines, CrossedLines, FingerRows>;

/// Half of the sides of a patch whose middle is the origin [um].
struct HalfExtent {
  double x_um, y_um;
};

/// Parallel lines on a plane.
class Ruling {
 public:
  /// direction: azimuth of the grating vector, from +x towards +y. A component of the unit vector
  /// that is 0 but for the rounding of the angle, up to 1e-15, is 0.
  Ruling(const ProfileParameters& profile, Angle direction)
      : profile_(profile),
        x_(rounded(std::cos(direction.rad()))),
        y_(rounded(std::sin(direction.rad()))) {}

  /// Distance from the origin along the grating vector, in periods.
  double position(double x_um, double y_um) const {
    return (x_um * x_ + y_um * y_) / profile_.period.um();
  }
  /// The largest position on a patch.
  double reach(const HalfExtent& half) const {
    return (half.x_um * std::abs(x_) + half.y_um * std::abs(y_)) / profile_.period.um();
  }
  /// Places of the lines on a patch.
  LinePlaces places(const Disorder& disorder, const HalfExtent& half, RandomEngine engine) const {
    return LinePlaces(disorder, profile_.period, reach(half), engine);
  }

  /// Height [0, 1] at a position: the profile, drawn out from each line to the next.
  double height(const LinePlaces& places, double position) const {
    if (places.in_order()) return profile_height(profile_, position);
    const LinePlaces::Stretch stretch = places.at(position);
    return profile_height(profile_, (position - stretch.start) / stretch.width);
  }

  /// Mean of the heights over the positions from `first` to `last` > first, exact but for rounding
  /// of some 1e-16 / (last - first): integral of the profile over each stretch times its width.
  double mean_height(const LinePlaces& places, double first, double last) const {
    const LinePlaces::Stretch a = places.at(first), b = places.at(last);
    const double before_first = a.width * profile_integral(profile_, (first - a.start) / a.width);
    const double before_last = b.width * profile_integral(profile_, (last - b.start) / b.width);
    return ((b.start - a.start) * profile_integral(profile_, 1) + before_last - before_first) /
           (last - first);
  }

  bool is_along_x() const { return x_ == 1; }
  bool is_constant_along_y() const { return y_ == 0; }
  const ProfileParameters& profile() const { return profile_; }

 private:
  static double rounded(double component) { return std::abs(component) <= 1e-15 ? 0 : component; }

  ProfileParameters profile_;
  double x_, y_;
};

/// The numbers that a pattern's disorder is drawn from: engines of the parts `part` (lines, with
/// the number of the strip as index) and `part` + 1 (crossed lines).
struct DisorderSource {
  Disorder disorder = {};
  std::uint64_t seed = 1;
  std::uint32_t part = 0;
};

/// The heights [0, 1] of a layout of lines over a patch.
class LinePattern {
 public:
  /// Throws what LinePlaces throws; Errc::invalid_argument for a crossed period or a width that is
  /// not positive, a crossed angle outside (0, 180 deg), and for more than LinePlaces::max_lines in
  /// all the strips.
  LinePattern(const ProfileParameters& profile, Angle direction, const Layout& layout,
              const DisorderSource& source, const HalfExtent& half)
      : lines_(profile, direction) {
    const auto places = [&](std::int64_t strip) {
      return lines_.places(source.disorder, half, random_engine(source.seed, source.part, strip));
    };
    if (const auto* rows = std::get_if<FingerRows>(&layout)) {
      across_.emplace(crossing(profile, Profile::sinusoid, rows->width, "width of the fingers"),
                      turned(direction, Angle::deg(90)));
      const double strips = 2 * std::floor(across_->reach(half) + 0.5) + 1;
      if (!(strips * (2 * lines_.reach(half) + 1) <= LinePlaces::max_lines))
        throw Error(Errc::invalid_argument, "fingers in " + text(strips) + " strips: at most " +
                                                text(LinePlaces::max_lines) + " in all");
      middle_strip_ = static_cast<std::int64_t>(strips / 2);
      for (std::int64_t strip = -middle_strip_; strip <= middle_strip_; ++strip)
        strips_.push_back(places(strip));
      return;
    }
    strips_.push_back(places(0));
    if (const auto* crossed = std::get_if<CrossedLines>(&layout)) {
      if (!(crossed->angle.deg() > 0 && crossed->angle.deg() < 180))
        throw Error(Errc::invalid_argument, "crossed angle " + text(crossed->angle.deg()) +
                                                " deg must lie between 0 and 180 deg");
      across_.emplace(crossing(profile, profile.profile, crossed->period, "crossed period"),
                      turned(direction, crossed->angle));
      across_places_ =
          across_->places(source.disorder, half, random_engine(source.seed, source.part + 1));
    }
  }

  double height(double x_um, double y_um) const {
    const double position = lines_.position(x_um, y_um);
    if (!across_) return lines_.height(strips_.front(), position);
    const double across = across_->position(x_um, y_um);
    return lines_.height(strip_at(across), position) * across_->height(across_places_, across);
  }

  /// Mean of the heights over x, for straight lines along x alone.
  double mean_height(double first_x_um, double last_x_um) const {
    return lines_.mean_height(strips_.front(), lines_.position(first_x_um, 0),
                              lines_.position(last_x_um, 0));
  }

  bool is_straight() const { return !across_; }
  const Ruling& lines() const { return lines_; }

 private:
  static Angle turned(Angle direction, Angle by) { return Angle::rad(direction.rad() + by.rad()); }

  static ProfileParameters crossing(ProfileParameters profile, Profile shape, Length period,
                                    const char* what) {
    if (!(period.um() > 0 && std::isfinite(period.um())))
      throw Error(Errc::invalid_argument, what + (" " + text(period.um())) + " um must be > 0");
    profile.profile = shape;
    profile.period = period;
    return profile;
  }

  const LinePlaces& strip_at(double across) const {
    const auto strip = static_cast<std::int64_t>(std::floor(across + 0.5));
    return strips_[static_cast<std::size_t>(std::clamp(strip, -middle_strip_, middle_strip_) +
                                            middle_strip_)];
  }

  Ruling lines_;
  std::optional<Ruling> across_;
  LinePlaces across_places_;        ///< fingers: the strips lie in order
  std::vector<LinePlaces> strips_;  ///< places of the lines; one element but for fingers
  std::int64_t middle_strip_ = 0;
};

}  // namespace brdf
