#include "evaluation/readers/file_bytes.h"

#include <fstream>
#include <system_error>

#include "brdf/error.h"

namespace evaluation {

namespace fs = std::filesystem;

std::string read_file_bytes(const fs::path& path, std::uintmax_t limit_bytes) {
  const auto refuse = [&](const std::string& what) {
    throw brdf::Error(brdf::Errc::bad_input, path.string() + ": " + what);
  };
  std::error_code ec;
  const fs::file_status status = fs::status(path, ec);
  if (!fs::exists(status)) refuse("no such file");
  if (!fs::is_regular_file(status)) refuse("is not a regular file");
  const std::uintmax_t size = fs::file_size(path, ec);
  if (ec) refuse("cannot be read: " + ec.message());
  if (size == 0) refuse("file is empty");
  if (size > limit_bytes)
    refuse(std::to_string(size) + " bytes, at most " + std::to_string(limit_bytes) + " are read");
  std::ifstream file(path, std::ios::binary);
  std::string bytes(size, '\0');
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size))) refuse("cannot be read");
  return bytes;
}

}  // namespace evaluation
