#include <array>
#include <cmath>
#include <functional>

#include "brdf/gain.h"
#include "evaluation/self_check/checker.h"

namespace evaluation::self {
namespace {

using brdf::HeightArray;
using brdf::HeightField;
using brdf::Length;
using brdf::Query;
using brdf::Surface;
using brdf::SurfaceModel;

const std::vector<Query> anywhere{{0, 0, -21}, {3.1, -2, -17}, {-7, 5, -12}, {1.3, 0.2, -23}};

HeightField with_heights(const HeightField& field, HeightArray heights_um) {
  return {std::move(heights_um), Length::um(field.dx_um()), Length::um(field.dy_um())};
}

using Surfaces = std::vector<Surface> (*)(const Method&, const HeightField&);
using Expected = std::function<std::complex<double>(const Query&, std::complex<double>)>;

/// The amplitudes of a changed relief against what an identity makes of those of the relief.
/// surfaces: that the method is tried on. expected: from a query of the changed relief and the
/// amplitude before, at the same place of queries_before.
CheckRow identity(const char* check, const Method& method, Surfaces surfaces,
                  const HeightField& changed, const std::vector<Query>& queries,
                  const std::vector<Query>& queries_before, const Expected& expected) {
  CheckTally found = tally(check, method, "the tolerance asked for, of either amplitude");
  const HeightField field = relief();
  const std::vector<Surface> before = surfaces(method, field), after = surfaces(method, changed);
  for (std::size_t s = 0; s < before.size(); ++s) {
    const Amplitudes a = amplitudes(method, before[s], queries_before);
    const Amplitudes b = amplitudes(method, after[s], queries);
    for (std::size_t i = 0; i < a.size(); ++i)
      found.see(
          std::abs(b[i] - expected(queries[i], a[i])), 2 * tolerance,
          std::string(name_of(before[s].model)) + ", k u = " + brdf::text(queries[i].qx_per_um));
  }
  return found.row();
}

CheckRow constant_height(const Method& method) {
  constexpr double raised_um = 0.37;
  const HeightField field = relief();
  return identity("a constant height only turns the phase", method, patches,
                  with_heights(field, field.heights_um() + raised_um), anywhere, anywhere,
                  [](const Query& q, std::complex<double> a) {
                    return a * std::polar(1.0, q.c_per_um * raised_um);
                  });
}

/// Cyclic: at whole cycles of the tile.
CheckRow translation(const Method& method) {
  const HeightField field = relief();
  const Eigen::Index shift = 3, cols = field.cols();
  HeightArray heights_um(field.rows(), cols);
  for (Eigen::Index col = 0; col < cols; ++col)
    heights_um.col((col + shift) % cols) = field.heights_um().col(col);
  const std::vector<Query> queries = all_cycles(field, -19);
  const double moved_um = field.dx_um() * static_cast<double>(shift);
  return identity("a translation only turns the phase", method, tiles,
                  with_heights(field, heights_um), queries, queries,
                  [moved_um](const Query& q, std::complex<double> a) {
                    return a * std::polar(1.0, q.qx_per_um * moved_um);
                  });
}

CheckRow mirror_image(const Method& method) {
  const HeightField field = relief();
  std::vector<Query> mirrored = anywhere;
  for (Query& q : mirrored) q.qx_per_um = -q.qx_per_um;
  return identity("the mirror image has mirrored frequencies", method, patches,
                  with_heights(field, field.heights_um().rowwise().reverse()), anywhere, mirrored,
                  [](const Query&, std::complex<double> a) { return a; });
}

/// h = x tan: all of the light in the mirror direction about the tilted normal.
CheckRow tilted_plane(const Method& method) {
  CheckTally found =
      tally("a tilted plane is a tilted mirror", method, "the tolerance asked for, 1e-10");
  const double slope_x = 0.11, slope_y = -0.07;
  const brdf::Direction normal = brdf::Direction(-slope_x, -slope_y, 1).normalized();
  HeightArray heights_um(12, 16);
  const Length pixel = Length::um(0.1);
  for (Eigen::Index row = 0; row < heights_um.rows(); ++row)
    for (Eigen::Index col = 0; col < heights_um.cols(); ++col)
      heights_um(row, col) = pixel.um() * (slope_x * (static_cast<double>(col) - 7.5) +
                                           slope_y * (static_cast<double>(row) - 5.5));
  const HeightField field(heights_um, pixel, pixel);
  std::vector<Query> queries;
  for (const double theta_deg : {0.0, 20.0, 50.0}) {
    const brdf::Direction light =
        brdf::direction(brdf::Angle::deg(theta_deg), brdf::Angle::deg(30));
    queries.push_back(query(light, 2 * light.dot(normal) * normal - light, Length::nm(550)));
  }
  // The periodic model has no tilt: its copies lie beside each other as steps.
  for (const Surface& surface : patches(method, field)) {
    if (surface.model == SurfaceModel::periodic) continue;
    for (const std::complex<double>& a : amplitudes(method, surface, queries))
      found.see(std::abs(a - 1.0), tolerance, std::string(name_of(surface.model)));
  }
  return found.row();
}

/// The directions swapped: abs(a)^2 and f_r as before.
CheckRow reciprocity(const Method& method) {
  CheckTally found = tally("reciprocity of abs(a)^2 and of f_r", method,
                           "the sum of the directions is the same to the last bit, the factor of "
                           "f_r to a few: 1e-14 of its value at the peak");
  const HeightField field = relief();
  const Length wavelength = Length::nm(480);
  std::vector<std::pair<brdf::Direction, brdf::Direction>> pairs;
  for (const auto& [theta_i, theta_r, phi] :
       {std::array{75.0, -40.0, 10.0}, {20.0, 60.0, 130.0}, {5.0, -5.0, 0.0}})
    pairs.emplace_back(brdf::direction(brdf::Angle::deg(theta_i), {}),
                       brdf::direction(brdf::Angle::deg(theta_r), brdf::Angle::deg(phi)));
  std::vector<Query> there, back;
  for (const auto& [light, viewer] : pairs) {
    there.push_back(query(light, viewer, wavelength));
    back.push_back(query(viewer, light, wavelength));
  }
  for (const Surface& surface : patches(method, field)) {
    const double area_um2 = coherence_area_um2(surface);
    const Amplitudes a = amplitudes(method, surface, there), b = amplitudes(method, surface, back);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [light, viewer] = pairs[i];
      const double gain = brdf_gain(light, viewer, wavelength, area_um2);
      const double f_there = gain * std::norm(a[i]);
      const double f_back = brdf_gain(viewer, light, wavelength, area_um2) * std::norm(b[i]);
      const std::string where = std::string(name_of(surface.model)) + ", pair " + std::to_string(i);
      found.see(std::abs(std::norm(a[i]) - std::norm(b[i])), 1e-14, where);
      found.see(std::abs(f_there - f_back) / gain, 1e-14, where);
    }
  }
  return found.row();
}

}  // namespace

std::vector<CheckRow> identity_rows(const Method& method) {
  std::vector<CheckRow> rows{reciprocity(method), constant_height(method), translation(method),
                             mirror_image(method)};
  if (has(method, SurfaceModel::isolated) || has(method, SurfaceModel::replicated))
    rows.push_back(tilted_plane(method));
  return rows;
}

}  // namespace evaluation::self
