// A measured patch, ready to give colours.
#pragma once

#include <memory>
#include <optional>

#include "brdf/surface.h"
#include "evaluation/methods.h"
#include "evaluation/readers/height_reader.h"
#include "evaluation/spectral_colours.h"
#include "evaluation/writers/output_file.h"

namespace apps {

/// What the colours of a patch refer to, kept together in one place.
struct PatchColours {
  explicit PatchColours(evaluation::HeightFile file) : input(std::move(file)) {}
  PatchColours(const PatchColours&) = delete;
  PatchColours& operator=(const PatchColours&) = delete;

  evaluation::HeightFile input;
  std::optional<brdf::Surface> surface;
  std::unique_ptr<evaluation::Amplitude> amplitude;
  std::optional<evaluation::SpectralPower> colours;
  evaluation::Json parameters;  ///< of heights, illumination, method and wavelengths
};

}  // namespace apps
