// What reads bytes from outside: each a target that any bytes may be given to.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fuzz {

struct Target {
  std::string name;
  /// Reads the bytes, or refuses them by brdf::Error, which is caught. Anything else is a fault:
  /// another exception, a result that breaks its own limits, memory that is not its own.
  std::function<void(std::string_view bytes)> run;
};

/// A target for each format of height files that this build reads, by the name of its format, and
/// for the texts that commands take.
const std::vector<Target>& targets();

}  // namespace fuzz
