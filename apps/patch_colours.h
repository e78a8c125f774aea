// A measured patch and what its colours need.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "apps/commands/illuminated_options.h"
#include "evaluation/methods.h"
#include "evaluation/readers/height_reader.h"
#include "evaluation/spectral_colours.h"
#include "evaluation/writers/output_file.h"

namespace apps {

/// What the colours of a patch refer to, kept together in one place.
struct PatchColours {
  /// illuminated: resolved.
  PatchColours(evaluation::HeightFile file, const IlluminatedOptions& illuminated)
      : input(std::move(file)),
        surface(illuminated.surface(input.field, brdf::Origin::patch_centre)) {}
  PatchColours(const PatchColours&) = delete;
  PatchColours& operator=(const PatchColours&) = delete;

  evaluation::HeightFile input;
  brdf::Surface surface;
  // Once it is made ready:
  std::unique_ptr<evaluation::Amplitude> amplitude;
  std::optional<evaluation::SpectralPower> colours;
  evaluation::Json parameters;  ///< of heights, illumination, method and wavelengths
};

}  // namespace apps
