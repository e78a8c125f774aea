#include "evaluation/lengths.h"

#include <cmath>

namespace evaluation {
namespace {

struct Unit {
  std::string_view name;
  int exponent;  ///< power of ten from metres
};

constexpr Unit units[] = {{"pm", -12}, {"nm", -9}, {"um", -6}, {"mm", -3}, {"cm", -2}, {"m", 0}};
// The micro sign and the Greek letter mu in UTF-8, the sign in Latin-1.
constexpr Unit aliases[] = {{"\xC2\xB5m", -6}, {"\xCE\xBCm", -6}, {"\xB5m", -6}};

}  // namespace

std::optional<int> length_unit_exponent(std::string_view name) {
  for (const Unit& unit : units)
    if (unit.name == name) return unit.exponent;
  for (const Unit& unit : aliases)
    if (unit.name == name) return unit.exponent;
  return std::nullopt;
}

std::optional<brdf::Length> length_unit(std::string_view name) {
  const std::optional<int> exponent = length_unit_exponent(name);
  if (!exponent) return std::nullopt;
  const int from_um = *exponent + 6;
  // Powers of ten up to 10^22 are exact in double; their inverses are not.
  return brdf::Length::um(from_um >= 0 ? std::pow(10.0, from_um) : 1 / std::pow(10.0, -from_um));
}

std::string length_unit_names() {
  std::string names;
  for (const Unit& unit : units) names.append(names.empty() ? "" : ", ").append(unit.name);
  return names;
}

}  // namespace evaluation
