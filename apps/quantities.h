// Numbers with their unit, as they stand on the command line.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <utility>

#include "brdf/units.h"
#include "evaluation/axis.h"

namespace apps {

// Each takes the option's name for its message and throws brdf::Error(Errc::invalid_argument): a
// number without a unit, with the units it could have; what is no finite number; an unknown unit.

brdf::Length parse_length(const std::string& option, const std::string& text);
brdf::Angle parse_angle(const std::string& option, const std::string& text);
/// "4GB", "500MB", "2GiB" in bytes.
std::size_t parse_bytes(const std::string& option, const std::string& text);
/// "90s", "5min", "2h".
std::chrono::duration<double> parse_duration(const std::string& option, const std::string& text);
/// A whole number from lo to hi, without a unit.
int parse_count(const std::string& option, const std::string& text, int lo, int hi);
/// The same as a parser of an option.
inline auto count_between(int lo, int hi) {
  return [lo, hi](const std::string& option, const std::string& text) {
    return parse_count(option, text, lo, hi);
  };
}
/// A number without a unit.
double parse_number(const std::string& option, const std::string& text);

/// "100nm" or "100nm,200nm": the same twice, or one along x and one along y.
std::pair<brdf::Length, brdf::Length> parse_length_pair(const std::string& option,
                                                        const std::string& text);
/// "650" or "650,325".
std::pair<int, int> parse_count_pair(const std::string& option, const std::string& text, int lo,
                                     int hi);

/// An inclusive interval "1.1um:1.3um" or "1.1:1.3um", in the unit of the named type.
std::pair<brdf::Length, brdf::Length> parse_length_interval(const std::string& option,
                                                            const std::string& text);
std::pair<brdf::Angle, brdf::Angle> parse_angle_interval(const std::string& option,
                                                         const std::string& text);

// Ranges start:stop:step, or one value. One unit at the end serves all; the count is
// floor((stop - start) / step + 1e-9) + 1. Values are the nearest doubles to the decimals meant:
// 380.1, not 380.10000000000002.

/// In nanometres.
evaluation::Axis parse_length_axis(const std::string& option, const std::string& text);
/// In degrees.
evaluation::Axis parse_angle_axis(const std::string& option, const std::string& text);

}  // namespace apps
