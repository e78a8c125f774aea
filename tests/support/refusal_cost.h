// What a refused file may cost.
#pragma once

#include <cstddef>

#if defined(__SANITIZE_ADDRESS__)
#define SHEDLIGHT_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SHEDLIGHT_ADDRESS_SANITIZER 1
#endif
#endif

/// Of the processor, which a busy machine does not stretch.
constexpr double most_seconds = 1;
/// Above what was there. AddressSanitizer marks an eighth of what is reserved, and keeps what was
/// freed: it, not the reader, would be measured.
#ifdef SHEDLIGHT_ADDRESS_SANITIZER
constexpr std::size_t most_bytes = std::size_t{1} << 30;
#else
constexpr std::size_t most_bytes = std::size_t{64} << 20;
#endif
