// The one exception type of the library, and the numbers inside its messages.
#pragma once

#include <array>
#include <charconv>
#include <stdexcept>
#include <string>

// Under it NaN and infinity pass every check, and sums are taken in an order of the compiler's own.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "shedlight must not be compiled with -ffast-math or -ffinite-math-only"
#endif

namespace brdf {

/// What went wrong, for a caller to act on.
enum class Errc {
  invalid_argument,  ///< a parameter outside its legal range, or a combination that has no meaning
  bad_input,         ///< a file or data set that cannot be used
  cannot_write,      ///< an output that cannot be written
  not_attainable,    ///< the accuracy or the physics asked for cannot be had
  over_limit,        ///< more memory or time than allowed
};

class Error : public std::runtime_error {
 public:
  Error(Errc code, const std::string& message) : std::runtime_error(message), code_(code) {}
  Errc code() const noexcept { return code_; }

 private:
  Errc code_;
};

/// Runs `work`; an error that it throws gets the place it happened at in front.
template <class Work>
decltype(auto) at_place(const std::string& place, Work work) {
  try {
    return work();
  } catch (const Error& error) {
    throw Error(error.code(), place + ": " + error.what());
  }
}

/// The shortest decimal text that reads back as the same double; independent of the locale.
inline std::string text(double value) {
  std::array<char, 32> buffer{};
  const auto [end, ec] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return ec == std::errc{} ? std::string(buffer.data(), end) : std::string("?");
}

}  // namespace brdf
