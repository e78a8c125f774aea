// Lengths and angles with their unit in the name of every factory and accessor.
#pragma once

#include <compare>
#include <numbers>

namespace brdf {

inline constexpr double pi = std::numbers::pi;

/// A length; micrometres inside.
class Length {
 public:
  constexpr Length() = default;
  static constexpr Length m(double value) { return Length(value * 1e6); }
  static constexpr Length mm(double value) { return Length(value * 1e3); }
  static constexpr Length um(double value) { return Length(value); }
  static constexpr Length nm(double value) { return Length(value / 1e3); }

  constexpr double m() const { return um_ / 1e6; }
  constexpr double um() const { return um_; }
  constexpr double nm() const { return um_ * 1e3; }

  constexpr auto operator<=>(const Length&) const = default;

 private:
  explicit constexpr Length(double um) : um_(um) {}
  double um_ = 0;
};

/// A plane angle. Keeps both units, so that 30 degrees given are 30 degrees said again.
class Angle {
 public:
  constexpr Angle() = default;
  static constexpr Angle rad(double value) { return Angle(value, value * (180 / pi)); }
  static constexpr Angle deg(double value) { return Angle(value * (pi / 180), value); }

  constexpr double rad() const { return rad_; }
  constexpr double deg() const { return deg_; }

  constexpr bool operator==(const Angle& other) const { return rad_ == other.rad_; }
  constexpr auto operator<=>(const Angle& other) const { return rad_ <=> other.rad_; }

 private:
  constexpr Angle(double rad, double deg) : rad_(rad), deg_(deg) {}
  double rad_ = 0, deg_ = 0;
};

/// k = 2 pi / lambda [rad/um].
constexpr double wavenumber_per_um(Length wavelength) {
  return 2 * pi / wavelength.um();
}

}  // namespace brdf
