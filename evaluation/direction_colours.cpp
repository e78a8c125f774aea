#include "evaluation/direction_colours.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "evaluation/parallel.h"
#include "evaluation/pixel_blocks.h"

namespace evaluation {
namespace {

/// A block of pixels: their queries read one part of a table, and are enough to sort.
constexpr std::size_t batch_pairs = block_side * block_side;

void require_finite(const brdf::Xyz& colour, const DirectionPair& pair) {
  if (std::isfinite(colour.x) && std::isfinite(colour.y) && std::isfinite(colour.z)) return;
  throw brdf::Error(brdf::Errc::not_attainable,
                    "the colour at direction (" + brdf::text(pair.omega_r.x()) + ", " +
                        brdf::text(pair.omega_r.y()) + ", " + brdf::text(pair.omega_r.z()) +
                        ") is not finite: the method has lost all accuracy");
}

}  // namespace

std::vector<brdf::Xyz> colours_of(std::span<const DirectionPair> pairs,
                                  const DirectionColours& surface, const RunLimits& limits,
                                  const Progress& progress) {
  std::vector<brdf::Xyz> colours(pairs.size());
  const std::size_t batches = (pairs.size() + batch_pairs - 1) / batch_pairs;
  std::size_t done = 0;
  std::mutex progress_mutex;
  if (limits.chunks != nullptr) limits.chunks->open(batches, batch_pairs * sizeof(brdf::Xyz));
  parallel_for(batches, limits.threads, [&](std::size_t batch) {
    limits.check_time();
    const std::size_t first = batch * batch_pairs,
                      count = std::min(batch_pairs, pairs.size() - first);
    const auto some = pairs.subspan(first, count);
    const auto result = std::span(colours).subspan(first, count);
    once(limits.chunks, batch, result, [&] {
      surface.evaluate(some, result);
      for (std::size_t j = 0; j < count; ++j) require_finite(result[j], some[j]);
    });
    if (progress) {
      const std::scoped_lock lock(progress_mutex);
      progress(static_cast<double>(++done) / static_cast<double>(batches));
    }
  });
  return colours;
}

}  // namespace evaluation
