// A file taken whole.
#pragma once

#include <filesystem>
#include <string>

namespace evaluation {

/// The bytes of a regular file. Throws Errc::bad_input where it is missing, no regular file, empty,
/// unreadable, or larger than `limit_bytes`.
std::string read_file_bytes(const std::filesystem::path& path,
                            std::uintmax_t limit_bytes = std::uintmax_t{1} << 32);

}  // namespace evaluation
