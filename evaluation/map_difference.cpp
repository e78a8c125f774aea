#include "evaluation/map_difference.h"

#include <algorithm>
#include <string>
#include <vector>

#include "brdf/error.h"
#include "evaluation/exposure.h"

namespace evaluation {
namespace {

/// A sheet of 12 lights at 4096 x 4096 pixels.
constexpr std::size_t most_bytes = std::size_t{12} * 4096 * 4096 * 3 * sizeof(double);

std::string text_of(const std::vector<std::size_t>& extents) {
  std::string text;
  for (const std::size_t extent : extents)
    text += (text.empty() ? "" : " x ") + std::to_string(extent);
  return text;
}

}  // namespace

NpyFile read_map(const std::filesystem::path& path) {
  NpyFile map = read_npy(path, most_bytes);
  const std::vector<std::size_t>& extents = map.shape.extents;
  if (map.shape.type != NpyType::real || extents.size() != 4 || extents[3] != 3)
    throw brdf::Error(brdf::Errc::bad_input, path.string() + ": is no map: its shape is " +
                                                 text_of(extents) +
                                                 ", not lights x rows x columns x 3 of doubles");
  return map;
}

MapDifference map_difference(const NpyFile& map, const NpyFile& reference, double exposure) {
  const std::vector<std::size_t>& extents = map.shape.extents;
  if (extents != reference.shape.extents)
    throw brdf::Error(brdf::Errc::bad_input, "maps of " + text_of(extents) + " and of " +
                                                 text_of(reference.shape.extents) +
                                                 " numbers cannot be compared");
  MapDifference difference;
  std::vector<double> all;
  for (std::size_t pixel = 0; pixel < map.numbers.size() / 3; ++pixel) {
    const double *a = &map.numbers[3 * pixel], *b = &reference.numbers[3 * pixel];
    const auto is_dark = [](const double* c) { return c[0] == 0 && c[1] == 0 && c[2] == 0; };
    if (is_dark(a) && is_dark(b)) continue;  // outside the disk
    const double found = shown_difference({a[0], a[1], a[2]}, {b[0], b[1], b[2]}, exposure);
    all.push_back(found);
    difference.mean += found;
    if (found <= difference.worst) continue;
    difference.worst = found;
    difference.light = pixel / (extents[1] * extents[2]);
    difference.row = pixel / extents[2] % extents[1];
    difference.column = pixel % extents[2];
  }
  if (all.empty()) throw brdf::Error(brdf::Errc::bad_input, "neither map holds any light");
  difference.pixels = all.size();
  difference.mean /= static_cast<double>(all.size());
  const auto place = all.begin() + static_cast<std::ptrdiff_t>((all.size() - 1) * 99 / 100);
  std::nth_element(all.begin(), place, all.end());
  difference.percentile_99 = *place;
  return difference;
}

}  // namespace evaluation
