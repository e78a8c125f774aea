// A folder for the files of one test.
#pragma once

#include <fstream>
#include <stdexcept>

#include "evaluation/private_folder.h"

/// A folder of its own, removed at the end with all that is in it.
class TemporaryFolder : public evaluation::PrivateFolder {
 public:
  /// Writes a file, over an older one; returns its path.
  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream file(*this / name, std::ios::binary);
    file << bytes;
    if (!file.flush()) throw std::runtime_error("cannot write " + (*this / name).string());
    return *this / name;
  }
};
