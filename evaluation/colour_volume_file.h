// Colour volumes on disk.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "brdf/colour_volume.h"
#include "evaluation/writers/output_file.h"

namespace evaluation {

/// What a sidecar says of the grid, and back.
Json volume_json(const brdf::VolumeShape& shape);

/// A volume read back, with its sidecar.
struct ColourVolumeFile {
  brdf::VolumeGrid grid;
  std::vector<float> numbers;
  std::string sha256;
  Json sidecar;
};

/// Sizes are held against the file before memory is taken.
///
/// Throws Errc::bad_input naming file and value: no volume, no sidecar or not its own, another
/// shape than it says, a number that is not finite; Errc::over_limit above `limit_bytes`.
ColourVolumeFile read_colour_volume(const std::filesystem::path& path, std::size_t limit_bytes);

/// What stands before the numbers.
std::string colour_volume_header(const brdf::VolumeGrid& grid);

}  // namespace evaluation
