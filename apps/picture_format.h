// What kind of picture a file name asks for.
#pragma once

#include <string>

#include "evaluation/writers/output_file.h"

namespace apps {

enum class PictureFormat { png, svg, pdf };

/// By the extension; PNG without one. Throws Errc::invalid_argument for any other.
PictureFormat picture_format(const std::string& file);

/// A picture that is to be drawn, with its sidecar.
struct PictureOutput : evaluation::OutputWithSidecar {
  /// Throws Errc::cannot_write, and as `picture_format`.
  explicit PictureOutput(const std::string& file)
      : OutputWithSidecar(file), format(picture_format(file)) {}

  PictureFormat format;
};

}  // namespace apps
