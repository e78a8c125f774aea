#include "evaluation/writers/npy_writer.h"

#include <algorithm>
#include <cctype>

#include "evaluation/npy.h"
#include "evaluation/sha256.h"

namespace evaluation {

namespace fs = std::filesystem;

bool has_extension(const fs::path& path, const std::string& extension) {
  return std::ranges::equal(path.extension().string(), extension, {},
                            [](unsigned char c) { return std::tolower(c); });
}

std::string to_npy(const brdf::HeightArray& matrix) {
  const std::vector<std::size_t> extents{static_cast<std::size_t>(matrix.rows()),
                                         static_cast<std::size_t>(matrix.cols())};
  return npy_header({NpyType::real, extents})
      .append(npy_bytes(std::span(matrix.data(), static_cast<std::size_t>(matrix.size()))));
}

NpyAxes::NpyAxes(const fs::path& matrix, const std::vector<std::string>& names) : names_(names) {
  for (const std::string& name : names)
    files_.emplace_back(fs::path(matrix).replace_extension(name + ".npy"));
}

Json NpyAxes::write(const std::vector<std::span<const double>>& axes) {
  Json json;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const std::string bytes =
        npy_header({NpyType::real, {axes[i].size()}}).append(npy_bytes(axes[i]));
    files_[i].write(bytes);
    json[names_[i]] = {{"file", files_[i].target().filename().string()},
                       {"sha256", sha256_hex(bytes)}};
  }
  return json;
}

std::vector<OutputFile*> NpyAxes::files() {
  std::vector<OutputFile*> files;
  for (OutputFile& file : files_) files.push_back(&file);
  return files;
}

}  // namespace evaluation
