#include "evaluation/axis.h"

#include <array>
#include <charconv>

#include "brdf/error.h"

namespace evaluation {

std::string number_text(double value, int decimals) {
  if (decimals == Axis::shortest) return brdf::text(value);
  std::array<char, 400> buffer{};  // 309 digits before the point at most
  const auto [end, ec] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                       std::chars_format::fixed, decimals);
  return ec == std::errc{} ? std::string(buffer.data(), end) : brdf::text(value);
}

}  // namespace evaluation
