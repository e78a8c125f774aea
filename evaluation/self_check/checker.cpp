#include "evaluation/self_check/checker.h"

#include "evaluation/self_check.h"

namespace evaluation {
namespace self {

using brdf::HeightArray;
using brdf::HeightField;
using brdf::Length;
using brdf::Query;
using brdf::Surface;
using brdf::SurfaceModel;

std::vector<Surface> tiles(const Method& method, const HeightField& field) {
  const brdf::GaussianWindow wide(Length::um(2 * std::max(field.width_um(), field.height_um())));
  std::vector<Surface> surfaces;
  for (const SurfaceModel model : {SurfaceModel::replicated, SurfaceModel::periodic})
    if (has(method, model)) surfaces.push_back({&field, wide, model});
  return surfaces;
}

std::vector<Surface> patches(const Method& method, const HeightField& field) {
  const brdf::GaussianWindow window(Length::um(field.width_um() / 4));
  std::vector<Surface> surfaces;
  for (const SurfaceModel model : method.models) surfaces.push_back({&field, window, model});
  return surfaces;
}

HeightField relief() {
  HeightArray heights_um(5, 8);
  for (Eigen::Index row = 0; row < heights_um.rows(); ++row)
    for (Eigen::Index col = 0; col < heights_um.cols(); ++col)
      heights_um(row, col) = 0.2 + 0.2 * std::sin(1.0 + 2.3 * static_cast<double>(col) +
                                                  0.7 * static_cast<double>(row * row));
  return {std::move(heights_um), Length::um(0.15), Length::um(0.2)};
}

HeightField one_period(const brdf::ProfileParameters& profile, Eigen::Index pixels) {
  HeightArray heights_um(1, pixels);
  for (Eigen::Index j = 0; j < pixels; ++j)
    heights_um(0, j) =
        profile.height.um() *
        brdf::profile_height(profile, static_cast<double>(j) / static_cast<double>(pixels));
  return {std::move(heights_um), Length::um(profile.period.um() / static_cast<double>(pixels)),
          Length::um(1)};
}

Query at_cycles(const HeightField& field, int x, int y, double c_per_um) {
  return {2 * brdf::pi * x / field.width_um(), 2 * brdf::pi * y / field.height_um(), c_per_um};
}

std::vector<Query> all_cycles(const HeightField& field, double c_per_um) {
  std::vector<Query> queries;
  for (int y = 0; y < field.rows(); ++y)
    for (int x = 0; x < field.cols(); ++x)
      queries.push_back(at_cycles(field, x - static_cast<int>(field.cols() / 2),
                                  y - static_cast<int>(field.rows() / 2), c_per_um));
  return queries;
}

}  // namespace self

std::vector<CheckRow> self_check(const Method& method) {
  std::vector<CheckRow> rows;
  for (const auto& part :
       {self::closed_form_rows(method), self::energy_rows(method), self::identity_rows(method)})
    rows.insert(rows.end(), part.begin(), part.end());
  return rows;
}

std::vector<CheckRow> self_check() {
  std::vector<CheckRow> rows;
  for (const Method& method : methods())
    for (CheckRow& row : self_check(method)) rows.push_back(std::move(row));
  return rows;
}

}  // namespace evaluation
