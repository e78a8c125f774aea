#include "evaluation/scene/shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace evaluation {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

SurfacePoint turned(const SurfacePoint& point, const Eigen::Matrix3d& rotation) {
  return {rotation * point.position, rotation * point.normal, rotation * point.tangent,
          point.texture};
}

/// intersect: the first point of a ray, in the shape's frame.
template <class Intersect>
SurfaceGrid cast_rays(const Camera& camera, const Eigen::Matrix3d& rotation, Intersect intersect) {
  SurfaceGrid grid(camera.cols(), camera.rows());
  for (int row = 0; row < grid.rows; ++row)
    for (int col = 0; col < grid.cols; ++col) {
      const Ray ray = camera.ray(col, row);
      const std::optional<SurfacePoint> point =
          intersect(Ray{rotation.transpose() * ray.origin, rotation.transpose() * ray.direction});
      if (point) grid.points[grid.index(col, row)] = turned(*point, rotation);
    }
  return grid;
}

/// Smaller root of a t^2 + 2 b t + c, where a line of |direction| part a > 0 enters; none where it
/// misses.
std::optional<double> entry(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (!(a > 0 && discriminant >= 0)) return std::nullopt;
  return (-b - std::sqrt(discriminant)) / a;
}

/// Azimuth about y from +z towards +x; 0 on the axis.
double azimuth(const Vector3d& p) {
  return std::atan2(p.x(), p.z());
}

Vector3d around(double azimuth) {
  return {std::cos(azimuth), 0, -std::sin(azimuth)};
}

double u_of(double azimuth) {
  return 0.5 + azimuth / (2 * brdf::pi);
}

SurfaceGrid points_of(const Sphere&, const Camera& camera, const Eigen::Matrix3d& rotation) {
  return cast_rays(camera, rotation, [](const Ray& ray) -> std::optional<SurfacePoint> {
    const std::optional<double> t =
        entry(1, ray.origin.dot(ray.direction), ray.origin.squaredNorm() - 1);
    if (!t) return std::nullopt;
    const Vector3d p = (ray.origin + *t * ray.direction).normalized();
    const double a = azimuth(p);
    return SurfacePoint{
        p, p, around(a),
        Vector2d(u_of(a), 0.5 + std::asin(std::clamp(p.y(), -1.0, 1.0)) / brdf::pi)};
  });
}

SurfaceGrid points_of(const Cylinder&, const Camera& camera, const Eigen::Matrix3d& rotation) {
  return cast_rays(camera, rotation, [](const Ray& ray) -> std::optional<SurfacePoint> {
    const Vector2d o(ray.origin.x(), ray.origin.z()), d(ray.direction.x(), ray.direction.z());
    const std::optional<double> t =
        entry(d.squaredNorm(), o.dot(d), o.squaredNorm() - Cylinder::radius * Cylinder::radius);
    if (!t) return std::nullopt;
    const Vector3d p = ray.origin + *t * ray.direction;
    if (!(std::abs(p.y()) <= Cylinder::half_height)) return std::nullopt;
    const double a = azimuth(p);
    return SurfacePoint{p, Vector3d(p.x(), 0, p.z()).normalized(), around(a),
                        Vector2d(u_of(a), 0.5 + p.y() / (2 * Cylinder::half_height))};
  });
}

/// Twice the signed area of a, b, p. Exactly the opposite for b, a: neighbours agree on which side
/// of their common edge a pixel lies.
double edge(const Vector2d& a, const Vector2d& b, const Vector2d& p) {
  if (b.x() < a.x() || (b.x() == a.x() && b.y() < a.y())) return -edge(b, a, p);
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

/// The vertex stage's output.
struct Corner {
  SurfacePoint point;
  Projected on_picture;
};

/// First and last index of the pixels whose centres lie in [lo, hi].
std::pair<int, int> pixel_range(double lo, double hi, int count) {
  return {std::max(0, static_cast<int>(std::ceil(std::max(lo, 0.0) - 0.5))),
          static_cast<int>(std::floor(std::min(hi, count + 1.0) - 0.5))};
}

/// a_0, a_1, a_2 weighted.
template <class Value>
Value mixed(const Vector3d& weights, const Value& a, const Value& b, const Value& c) {
  return weights[0] * a + weights[1] * b + weights[2] * c;
}

class Rasteriser {
 public:
  Rasteriser(int cols, int rows)
      : grid_(cols, rows), depth_(grid_.points.size(), -std::numeric_limits<double>::infinity()) {}

  void draw(const Corner& a, const Corner& b, const Corner& c) {
    const Vector2d &pa = a.on_picture.pixel, &pb = b.on_picture.pixel, &pc = c.on_picture.pixel;
    const double area = edge(pa, pb, pc);
    if (!(std::abs(area) > 0)) return;
    const auto [left, right] = pixel_range(std::min({pa.x(), pb.x(), pc.x()}),
                                           std::max({pa.x(), pb.x(), pc.x()}), grid_.cols);
    const auto [top, bottom] = pixel_range(std::min({pa.y(), pb.y(), pc.y()}),
                                           std::max({pa.y(), pb.y(), pc.y()}), grid_.rows);
    for (int row = top; row <= std::min(bottom, grid_.rows - 1); ++row)
      for (int col = left; col <= std::min(right, grid_.cols - 1); ++col) {
        const Vector2d p(col + 0.5, row + 0.5);
        const Vector3d b_on_picture =
            Vector3d(edge(pb, pc, p), edge(pc, pa, p), edge(pa, pb, p)) / area;
        if (b_on_picture.minCoeff() >= 0) shade(b_on_picture, grid_.index(col, row), a, b, c);
      }
  }

  SurfaceGrid grid() && { return std::move(grid_); }

 private:
  /// The fragment stage's input, where it is nearer than what is there.
  void shade(const Vector3d& on_picture, std::size_t index, const Corner& a, const Corner& b,
             const Corner& c) {
    Vector3d weights =
        on_picture.cwiseQuotient(Vector3d(a.on_picture.w, b.on_picture.w, c.on_picture.w));
    weights /= weights.sum();
    const Vector3d position = mixed(weights, a.point.position, b.point.position, c.point.position);
    if (!(position.z() > depth_[index])) return;
    depth_[index] = position.z();
    grid_.points[index] = SurfacePoint{
        position, mixed(weights, a.point.normal, b.point.normal, c.point.normal).stableNormalized(),
        mixed(weights, a.point.tangent, b.point.tangent, c.point.tangent),
        mixed(weights, a.point.texture, b.point.texture, c.point.texture)};
  }

  SurfaceGrid grid_;
  std::vector<double> depth_;
};

SurfaceGrid points_of(const Mesh& mesh, const Camera& camera, const Eigen::Matrix3d& rotation) {
  std::vector<Corner> corners;
  corners.reserve(mesh.vertices.size());
  for (const MeshVertex& vertex : mesh.vertices) {
    const SurfacePoint point =
        turned({vertex.position, vertex.normal, vertex.tangent.stableNormalized(), vertex.texture},
               rotation);
    corners.push_back({point, camera.project(point.position)});
  }
  Rasteriser rasteriser(camera.cols(), camera.rows());
  for (const auto& [i, j, k] : mesh.triangles) rasteriser.draw(corners[i], corners[j], corners[k]);
  return std::move(rasteriser).grid();
}

}  // namespace

SurfaceGrid visible_points(const Shape& shape, const Camera& camera,
                           const Eigen::Matrix3d& rotation) {
  return std::visit([&](const auto& s) { return points_of(s, camera, rotation); }, shape);
}

}  // namespace evaluation
