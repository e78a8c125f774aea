// A folder for files that nobody else is to see.
#pragma once

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>

#include "brdf/error.h"

namespace evaluation {

/// A folder among the temporary ones that only its owner enters, removed at the end with all that
/// is in it.
class PrivateFolder {
 public:
  /// Throws Errc::cannot_write where it cannot be made.
  PrivateFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "shedlight-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw brdf::Error(brdf::Errc::cannot_write,
                        name + ": cannot be made: " + std::strerror(errno));
    path_ = name;
  }
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  ~PrivateFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace evaluation
