#include "apps/quantities.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "brdf/error.h"
#include "evaluation/lengths.h"

namespace apps {
namespace {

using brdf::Angle;
using brdf::Length;

/// Largest count on an axis: more is a slip of the step, not a request.
constexpr std::int64_t max_axis_count = 10'000'000;

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& what) {
  throw brdf::Error(brdf::Errc::invalid_argument, option + " " + text + ": " + what);
}

/// A number and the unit behind it.
struct Quantity {
  std::string_view number, unit;
  double value;
};

std::optional<Quantity> split(std::string_view text) {
  Quantity quantity{};
  const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), quantity.value);
  if (ec != std::errc{} || !std::isfinite(quantity.value)) return std::nullopt;
  const auto length = static_cast<std::size_t>(end - text.data());
  quantity.number = text.substr(0, length);
  quantity.unit = text.substr(length);
  return quantity;
}

Quantity split(const std::string& option, const std::string& text, const std::string& units) {
  const std::optional<Quantity> quantity = split(text);
  if (!quantity)
    refuse(option, text,
           units.empty() ? "is not a finite number"
                         : "is not a finite number with a unit (" + units + ")");
  if (units.empty() && !quantity->unit.empty())
    refuse(option, text, "takes a number without a unit");
  if (!units.empty() && quantity->unit.empty())
    refuse(option, text, "has no unit; give one of " + units);
  return *quantity;
}

[[noreturn]] void refuse_unit(const std::string& option, const std::string& text,
                              std::string_view unit, const std::string& units) {
  refuse(option, text, "unknown unit \"" + std::string(unit) + "\"; give one of " + units);
}

struct NamedFactor {
  std::string_view name;
  double factor;
};

/// A quantity in the first unit of a table.
template <std::size_t N>
double in_first_unit(const std::string& option, const std::string& text,
                     const NamedFactor (&table)[N]) {
  std::string units;
  for (const NamedFactor& row : table) units.append(units.empty() ? "" : ", ").append(row.name);
  const Quantity quantity = split(option, text, units);
  for (const NamedFactor& row : table)
    if (row.name == quantity.unit) return quantity.value * row.factor;
  refuse_unit(option, text, quantity.unit, units);
}

constexpr std::string_view angle_units = "deg, rad";

std::vector<std::string> parts(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

/// The parts of "a,b" or "a,a" for "a".
std::pair<std::string, std::string> pair_of(const std::string& option, const std::string& text) {
  const std::vector<std::string> both = parts(text, ',');
  if (both.size() > 2) refuse(option, text, "takes one value, or two with a comma between");
  return {both.front(), both.back()};
}

/// Gives each part of "a:b:cUNIT" the unit of the last where it has none.
std::vector<std::string> with_common_unit(const std::string& option, const std::string& text) {
  std::vector<std::string> pieces = parts(text, ':');
  const std::optional<Quantity> last = split(pieces.back());
  if (!last) refuse(option, text, "\"" + pieces.back() + "\" is not a finite number with a unit");
  for (std::string& piece : pieces) {
    const std::optional<Quantity> quantity = split(piece);
    if (!quantity) refuse(option, text, "\"" + piece + "\" is not a finite number");
    if (quantity->unit.empty()) piece += last->unit;
  }
  return pieces;
}

/// A decimal number mantissa * 10^exponent, exactly as written.
struct Decimal {
  std::int64_t mantissa;
  int exponent;
};

Decimal decimal(const std::string& option, const std::string& text, std::string_view number) {
  Decimal result{0, 0};
  const std::size_t e = number.find_first_of("eE");
  std::string digits(number.substr(0, e));
  if (e != std::string_view::npos) {
    std::string_view exponent = number.substr(e + 1);
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    std::from_chars(exponent.data(), exponent.data() + exponent.size(), result.exponent);
  }
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    result.exponent -= static_cast<int>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  const auto [end, ec] =
      std::from_chars(digits.data(), digits.data() + digits.size(), result.mantissa);
  if (ec != std::errc{}) refuse(option, text, "has too many digits for a range");
  return result;
}

/// mantissa of a decimal at a lower exponent.
std::int64_t mantissa_at(const std::string& option, const std::string& text, Decimal d,
                         int exponent) {
  // Below 2^53 whole numbers are exact in double, and so is the division in `values`.
  constexpr std::int64_t limit = std::int64_t{1} << 53;
  for (; d.exponent > exponent && std::abs(d.mantissa) < limit; --d.exponent) d.mantissa *= 10;
  if (d.mantissa != 0 && (d.exponent != exponent || std::abs(d.mantissa) >= limit))
    refuse(option, text, "has too many digits for a range");
  return d.mantissa;
}

struct RangeSteps {
  std::string start, stop, step;
};

/// The three parts with their units; one value is a range of one.
RangeSteps range_steps(const std::string& option, const std::string& text) {
  const std::vector<std::string> pieces = with_common_unit(option, text);
  if (pieces.size() == 1) return {pieces[0], pieces[0], ""};
  if (pieces.size() != 3) refuse(option, text, "takes start:stop:step with a unit, or one value");
  return {pieces[0], pieces[1], pieces[2]};
}

void require_steps(const std::string& option, const std::string& text, double start, double stop,
                   double step) {
  if (!(step > 0)) refuse(option, text, "the step must be > 0");
  if (!(stop >= start)) refuse(option, text, "the stop must not lie below the start");
  if (!((stop - start) / step < static_cast<double>(max_axis_count)))
    refuse(option, text, "has more than " + std::to_string(max_axis_count) + " values");
}

/// An axis of exact decimals. power_of_ten(unit): from the unit to that of the axis.
template <class PowerOfTen>
evaluation::Axis decimal_axis(const std::string& option, const std::string& text,
                              PowerOfTen power_of_ten) {
  const RangeSteps steps = range_steps(option, text);
  const auto decimal_of = [&](const std::string& part) {
    const Quantity quantity = *split(part);
    Decimal d = decimal(option, text, quantity.number);
    d.exponent += power_of_ten(quantity.unit);
    return d;
  };
  const Decimal start = decimal_of(steps.start), stop = decimal_of(steps.stop);
  const Decimal step = steps.step.empty() ? Decimal{1, start.exponent} : decimal_of(steps.step);
  const int exponent = std::min({start.exponent, stop.exponent, step.exponent, 0});
  if (exponent < -22) refuse(option, text, "has too many digits for a range");
  const std::int64_t first = mantissa_at(option, text, start, exponent);
  const std::int64_t last = mantissa_at(option, text, stop, exponent);
  const std::int64_t stride = mantissa_at(option, text, step, exponent);
  require_steps(option, text, static_cast<double>(first), static_cast<double>(last),
                static_cast<double>(stride));

  evaluation::Axis axis;
  axis.decimals = -exponent;
  const double divisor = std::pow(10.0, -exponent);  // exact up to 10^22
  for (std::int64_t mantissa = first; mantissa <= last; mantissa += stride)
    axis.values.push_back(static_cast<double>(mantissa) / divisor);
  return axis;
}

evaluation::Axis radian_axis(const std::string& option, const std::string& text) {
  const RangeSteps steps = range_steps(option, text);
  const double start = parse_angle(option, steps.start).rad();
  const double stop = parse_angle(option, steps.stop).rad();
  const double step = steps.step.empty() ? 1.0 : parse_angle(option, steps.step).rad();
  require_steps(option, text, start, stop, step);
  evaluation::Axis axis;
  const auto count = static_cast<std::int64_t>(std::floor((stop - start) / step + 1e-9)) + 1;
  for (std::int64_t i = 0; i < count; ++i)
    axis.values.push_back(Angle::rad(start + static_cast<double>(i) * step).deg());
  return axis;
}

template <class Parse>
auto interval(const std::string& option, const std::string& text, Parse parse) {
  const std::vector<std::string> ends = with_common_unit(option, text);
  if (ends.size() != 2) refuse(option, text, "takes low:high with a unit");
  const auto lo = parse(option, ends[0]), hi = parse(option, ends[1]);
  if (!(lo < hi)) refuse(option, text, "the first value must be the smaller one");
  return std::pair(lo, hi);
}

}  // namespace

Length parse_length(const std::string& option, const std::string& text) {
  const std::string units = evaluation::length_unit_names();
  const Quantity quantity = split(option, text, units);
  const std::optional<int> exponent = evaluation::length_unit_exponent(quantity.unit);
  if (!exponent) refuse_unit(option, text, quantity.unit, units);
  if (*exponent == -9) return Length::nm(quantity.value);
  return Length::um(quantity.value * evaluation::length_unit(quantity.unit)->um());
}

Angle parse_angle(const std::string& option, const std::string& text) {
  const Quantity quantity = split(option, text, std::string(angle_units));
  if (quantity.unit == "deg") return Angle::deg(quantity.value);
  if (quantity.unit == "rad") return Angle::rad(quantity.value);
  refuse_unit(option, text, quantity.unit, std::string(angle_units));
}

std::size_t parse_bytes(const std::string& option, const std::string& text) {
  static constexpr NamedFactor units[] = {
      {"B", 1},        {"kB", 1e3},        {"MB", 1e6},          {"GB", 1e9},
      {"KiB", 1024.0}, {"MiB", 1048576.0}, {"GiB", 1073741824.0}};
  const double bytes = in_first_unit(option, text, units);
  if (!(bytes >= 1 && bytes < 1e18)) refuse(option, text, "must lie between 1 B and 1e9 GB");
  return static_cast<std::size_t>(bytes);
}

std::chrono::duration<double> parse_duration(const std::string& option, const std::string& text) {
  static constexpr NamedFactor units[] = {{"s", 1}, {"ms", 1e-3}, {"min", 60}, {"h", 3600}};
  const double seconds = in_first_unit(option, text, units);
  if (!(seconds > 0 && seconds <= 3.2e7)) refuse(option, text, "must be > 0s and at most a year");
  return std::chrono::duration<double>(seconds);
}

int parse_count(const std::string& option, const std::string& text, int lo, int hi) {
  int value = 0;
  const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (ec != std::errc{} || end != text.data() + text.size() || value < lo || value > hi)
    refuse(option, text,
           "must be a whole number from " + std::to_string(lo) + " to " + std::to_string(hi));
  return value;
}

double parse_number(const std::string& option, const std::string& text) {
  return split(option, text, "").value;
}

std::pair<Length, Length> parse_length_pair(const std::string& option, const std::string& text) {
  const auto [x, y] = pair_of(option, text);
  return {parse_length(option, x), parse_length(option, y)};
}

std::pair<int, int> parse_count_pair(const std::string& option, const std::string& text, int lo,
                                     int hi) {
  const auto [x, y] = pair_of(option, text);
  return {parse_count(option, x, lo, hi), parse_count(option, y, lo, hi)};
}

std::pair<Length, Length> parse_length_interval(const std::string& option,
                                                const std::string& text) {
  return interval(option, text, parse_length);
}

std::pair<Angle, Angle> parse_angle_interval(const std::string& option, const std::string& text) {
  return interval(option, text, parse_angle);
}

evaluation::Axis parse_length_axis(const std::string& option, const std::string& text) {
  parse_length(option, range_steps(option, text).start);  // refuses a missing or unknown unit
  return decimal_axis(option, text, [&](std::string_view unit) {
    const std::optional<int> exponent = evaluation::length_unit_exponent(unit);
    if (!exponent) refuse_unit(option, text, unit, evaluation::length_unit_names());
    return *exponent + 9;
  });
}

evaluation::Axis parse_angle_axis(const std::string& option, const std::string& text) {
  const std::string start = range_steps(option, text).start;
  parse_angle(option, start);
  if (split(start)->unit == "rad") return radian_axis(option, text);
  return decimal_axis(option, text, [&](std::string_view unit) {
    if (unit != "deg") refuse(option, text, "takes one unit for all three values");
    return 0;
  });
}

}  // namespace apps
