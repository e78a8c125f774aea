#include "apps/picture_format.h"

#include <algorithm>
#include <filesystem>

#include "brdf/error.h"

namespace apps {

PictureFormat picture_format(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  if (extension.empty() || extension == ".png") return PictureFormat::png;
  if (extension == ".svg") return PictureFormat::svg;
  if (extension == ".pdf") return PictureFormat::pdf;
  throw brdf::Error(brdf::Errc::invalid_argument,
                    file + ": a picture is drawn as .png, .svg or .pdf");
}

}  // namespace apps
