// A file taken whole, with its hash.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace evaluation {

/// The bytes of a regular file. Throws Errc::bad_input where it is missing, no regular file, empty,
/// unreadable, or larger than `limit_bytes`.
std::string read_file_bytes(const std::filesystem::path& path,
                            std::uintmax_t limit_bytes = std::uintmax_t{1} << 32);

/// SHA-256 in lower-case hexadecimal.
std::string sha256_hex(std::string_view bytes);

}  // namespace evaluation
