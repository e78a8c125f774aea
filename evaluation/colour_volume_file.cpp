#include "evaluation/colour_volume_file.h"

#include <cmath>

#include "evaluation/npy.h"

namespace evaluation {
namespace {

using brdf::Errc;
using brdf::Error;

NpyShape npy_shape(const brdf::VolumeGrid& grid) {
  return {NpyType::single, {grid.points(), static_cast<std::size_t>(grid.shape().terms), 3}};
}

brdf::VolumeShape shape_of(const Json& sidecar) {
  const auto number = [&](const char* key) {
    const Json::json_pointer place(std::string("/volume/") + key);
    if (!sidecar.contains(place) || !sidecar.at(place).is_number())
      throw Error(Errc::bad_input, std::string("has no number volume.") + key +
                                       ": it is not the sidecar of a volume made by bake");
    return sidecar.at(place).get<double>();
  };
  const double terms = number("terms");
  // Before it is an int: anything may stand there.
  if (!(terms >= 1 && terms <= 256 && terms == std::floor(terms)))
    throw Error(Errc::bad_input,
                "volume: terms " + brdf::text(terms) + " must be a whole number from 1 to 256");
  return {number("centre_step"), number("relative_step"), number("angles_per_r"),
          static_cast<int>(terms)};
}

/// What no grid has is the fault of the file here, not of an argument.
brdf::VolumeGrid grid_of(const Json& sidecar, const std::string& name) {
  try {
    return brdf::VolumeGrid(shape_of(sidecar));
  } catch (const Error& error) {
    throw Error(Errc::bad_input, name + ": " + error.what());
  }
}

}  // namespace

Json volume_json(const brdf::VolumeShape& shape) {
  return {{"centre_step", shape.centre_step},
          {"relative_step", shape.relative_step},
          {"angles_per_r", shape.angles_per_r},
          {"terms", shape.terms},
          {"layout", "[point][Chebyshev term in w + 1][X, Y, Z]"}};
}

ColourVolumeFile read_colour_volume(const std::filesystem::path& path, std::size_t limit_bytes) {
  const NpyReader reader(path);
  const std::string sha256 = reader.sha256();
  Json sidecar = read_sidecar(path, sha256);
  const std::string sidecar_name = sidecar_path(path).string();
  if (sidecar.is_null())
    throw Error(Errc::bad_input,
                sidecar_name + ": no such file, and without it nothing says what the volume is of");
  brdf::VolumeGrid grid = grid_of(sidecar, sidecar_name);
  const NpyShape expected = npy_shape(grid);
  if (reader.shape().type != expected.type || reader.shape().extents != expected.extents)
    throw Error(Errc::bad_input, path.string() + ": its shape is not that of its sidecar, " +
                                     std::to_string(grid.points()) + " x " +
                                     std::to_string(grid.shape().terms) + " x 3");
  if (reader.size() > limit_bytes / sizeof(float))
    throw Error(Errc::over_limit, path.string() + ": " + std::to_string(reader.size() * 4) +
                                      " bytes, at most " + std::to_string(limit_bytes) +
                                      " are read");
  std::vector<float> numbers(reader.size());
  reader.read(0, std::span(numbers));
  return {std::move(grid), std::move(numbers), sha256, std::move(sidecar)};
}

std::string colour_volume_header(const brdf::VolumeGrid& grid) {
  return npy_header(npy_shape(grid));
}

}  // namespace evaluation
