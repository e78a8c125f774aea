#include "evaluation/bake.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "evaluation/parallel.h"

namespace evaluation {
namespace {

/// Below lie 3 % of Z and 0.2 % of Y: what they add to the finest speckle is below any tolerance
/// that a table is made for.
constexpr auto shortest = brdf::Length::nm(420);
/// Points for half the shortest period; six taps then interpolate what is left of it.
constexpr double oversampling = 1.5;
/// The same around the mirror direction, where a lobe stands beside light a thousand times weaker.
constexpr double centre_oversampling = 5;
/// Points of a ring that are evaluated at once.
constexpr std::size_t batch_points = 16;

}  // namespace

brdf::VolumeShape volume_shape(const brdf::InterferenceReach& reach, double tolerance) {
  const brdf::SpectralBand band;
  const double k = brdf::wavenumber_per_um(shortest);
  const double alias_rad = brdf::BandQuadratures(band, 1).alias(tolerance / 2);
  // Phases per unit of r, and per unit of ln r, that are left.
  const double per_r = k * reach.lateral_um, per_log_r = k * alias_rad / band.k_half_per_um();
  const double vertical_rad = brdf::wavenumber_per_um(shortest) * reach.vertical_um;
  return {brdf::pi / (centre_oversampling * per_r), brdf::pi / (oversampling * per_log_r),
          2 * oversampling * per_r,
          brdf::BandQuadratures::polynomial_count(vertical_rad, tolerance)};
}

std::vector<Eigen::Vector3d> volume_corners(const brdf::VolumeGrid& grid) {
  const double r = grid.radius(grid.rings() - 1);
  return {{-r, 0, -2}, {r, 0, 0}, {0, -r, -2}, {0, r, 0}};
}

std::vector<float> bake(const brdf::VolumeGrid& grid, const ScatteringColours& colours,
                        const RunLimits& limits, const Progress& progress) {
  const int terms = grid.shape().terms;
  const auto count = static_cast<std::size_t>(terms);
  std::vector<double> cosines;  // [term][node] of the cosine transform
  for (int n = 0; n < terms; ++n)
    for (int j = 0; j < terms; ++j)
      cosines.push_back((n == 0 ? 1.0 : 2.0) / terms * std::cos(brdf::pi * n * (j + 0.5) / terms));
  struct Batch {
    int ring;
    std::size_t first, points;
  };
  std::vector<Batch> batches;
  for (int ring = 0; ring < grid.rings(); ++ring) {
    const auto angles = static_cast<std::size_t>(grid.angles(ring));
    for (std::size_t first = 0; first < angles; first += batch_points)
      batches.push_back({ring, first, std::min(batch_points, angles - first)});
  }
  std::vector<float> numbers(grid.size());
  std::size_t done = 0;
  std::mutex progress_mutex;
  const auto compute = [&](const Batch& batch, std::span<float> chunk) {
    std::vector<Eigen::Vector3d> scattering;
    for (std::size_t point = 0; point < batch.points; ++point) {
      const double phi =
          2 * brdf::pi * static_cast<double>(batch.first + point) / grid.angles(batch.ring);
      const double radius = grid.radius(batch.ring);
      for (int j = 0; j < terms; ++j)
        scattering.emplace_back(radius * std::cos(phi), radius * std::sin(phi),
                                std::cos(brdf::pi * (j + 0.5) / terms) - 1);
    }
    std::vector<brdf::Xyz> values(scattering.size());
    colours.evaluate(scattering, values);
    float* to = chunk.data();
    for (std::size_t point = 0; point < batch.points; ++point)
      for (std::size_t n = 0; n < count; ++n) {
        brdf::Xyz sum;
        for (std::size_t j = 0; j < count; ++j)
          sum = sum + cosines[n * count + j] * values[point * count + j];
        for (const double value : {sum.x, sum.y, sum.z}) *to++ = static_cast<float>(value);
      }
  };
  if (limits.chunks != nullptr)
    limits.chunks->open(batches.size(), batch_points * count * 3 * sizeof(float));
  parallel_for(batches.size(), limits.threads, [&](std::size_t i) {
    limits.check_time();
    const Batch& batch = batches[i];
    const std::span chunk(&numbers[(grid.first(batch.ring) + batch.first) * count * 3],
                          batch.points * count * 3);
    once(limits.chunks, i, chunk, [&] { compute(batch, chunk); });
    if (progress) {
      const std::scoped_lock lock(progress_mutex);
      progress(static_cast<double>(++done) / static_cast<double>(batches.size()));
    }
  });
  return numbers;
}

std::vector<Eigen::Vector3d> spread_scattering(int count) {
  // Golden-ratio sequences of four dimensions: the root of x^5 = x + 1 gives the steps
  // (Roberts 2018).
  constexpr double root = 1.1673039782614187;
  std::vector<Eigen::Vector3d> scattering;
  for (int i = 1; i <= count; ++i) {
    double place[4];
    for (int d = 0; d < 4; ++d) {
      const double turns = i / std::pow(root, d + 1);
      place[d] = turns - std::floor(turns);
    }
    // Even over the hemispheres' projections.
    const auto direction = [](double radius_squared, double turn) {
      return brdf::direction(brdf::Angle::rad(std::asin(0.999 * std::sqrt(radius_squared))),
                             brdf::Angle::rad(2 * brdf::pi * turn));
    };
    scattering.push_back(
        brdf::scattering_vector(direction(place[0], place[1]), direction(place[2], place[3])));
  }
  return scattering;
}

VolumeError volume_error(const brdf::ColourVolume& volume,
                         std::span<const Eigen::Vector3d> scattering,
                         std::span<const brdf::Xyz> exact, const LocalBrightness& brightness) {
  VolumeError error;
  constexpr int around = 9;
  for (std::size_t i = 0; i < scattering.size(); ++i) {
    const Eigen::Vector3d& s = scattering[i];
    double mean = 0;
    for (int j = 0; j < around; ++j) {
      const double turn =
          (j - around / 2) * brightness.lobe / std::max(brightness.lobe, std::hypot(s.x(), s.y()));
      const double cosine = std::cos(turn), sine = std::sin(turn);
      mean +=
          volume(s.x() * cosine - s.y() * sine, s.x() * sine + s.y() * cosine, s.z()).y / around;
    }
    const double part =
        std::abs(volume(s.x(), s.y(), s.z()).y - exact[i].y) / std::max(mean, brightness.darkest);
    error.rms += part * part / static_cast<double>(scattering.size());
    error.worst = std::max(error.worst, part);
  }
  error.rms = std::sqrt(error.rms);
  return error;
}

}  // namespace evaluation
