// libFuzzer on one of the targets: SHEDLIGHT_FUZZ=png shedlight_fuzz [options of libFuzzer] CORPUS.
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

#include "tests/fuzz/targets.h"

namespace {

const fuzz::Target& chosen_target() {
  const char* wanted = std::getenv("SHEDLIGHT_FUZZ");
  for (const fuzz::Target& target : fuzz::targets())
    if (wanted != nullptr && target.name == wanted) return target;
  // The list for scripts/fuzz. libFuzzer takes an orderly exit for a fault of the target.
  for (const fuzz::Target& target : fuzz::targets()) std::cout << target.name << "\n";
  std::cout << std::flush;
  std::_Exit(wanted == nullptr ? 0 : 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Target& target = chosen_target();
  target.run({reinterpret_cast<const char*>(data), size});
  return 0;
}
