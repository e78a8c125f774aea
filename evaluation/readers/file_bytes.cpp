#include "evaluation/readers/file_bytes.h"

#include <utility>

#include "brdf/error.h"
#include "evaluation/readers/file_source.h"

namespace evaluation {

std::string read_file_bytes(const std::filesystem::path& path, std::uintmax_t limit_bytes) {
  FileSource source(path);
  if (source.size() > limit_bytes)
    throw brdf::Error(brdf::Errc::bad_input, source.name() + ": " + std::to_string(source.size()) +
                                                 " bytes, at most " + std::to_string(limit_bytes) +
                                                 " are read");
  return std::move(source).take();
}

}  // namespace evaluation
