#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

#include "evaluation/scene/shapes.h"
#include "tests/support/is_error.h"

namespace {

using namespace evaluation;
using brdf::Angle;
using brdf::Errc;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Positions are of order 1: some ten roundings.
constexpr double rounding = 1e-14;

Matrix3d tilted() {
  return (Eigen::AngleAxisd(0.5, Vector3d::UnitX()) * Eigen::AngleAxisd(-0.7, Vector3d::UnitY()))
      .toRotationMatrix();
}

/// A sphere of quads on the parallels and meridians of `Sphere`, as OBJ.
std::string sphere_obj(int columns, int rows) {
  std::string text;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const double u = double(i) / columns, v = double(j) / rows;
      const double a = 2 * brdf::pi * (u - 0.5), b = brdf::pi * (v - 0.5);
      text += "v " + brdf::text(std::cos(b) * std::sin(a)) + " " + brdf::text(std::sin(b)) + " " +
              brdf::text(std::cos(b) * std::cos(a)) + "\nvt " + brdf::text(u) + " " +
              brdf::text(v) + "\n";
    }
  const auto corner = [&](int i, int j) {
    const std::string n = std::to_string(j * (columns + 1) + i + 1);
    return " " + n + "/" + n;
  };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      text +=
          "f" + corner(i, j) + corner(i + 1, j) + corner(i + 1, j + 1) + corner(i, j + 1) + "\n";
  return text;
}

const std::string square =
    "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "f 1/1 2/2 3/3 4/4\n";

}  // namespace

TEST_CASE("normals of the sphere are those of its pixels", "[scene][oracle]") {
  const Camera camera(Projection::orthographic, 64, 64, {});
  const SurfaceGrid grid = visible_points(Sphere{}, camera, Matrix3d::Identity());
  for (const auto& [col, row] : {std::pair{32, 32}, {10, 20}, {50, 40}, {31, 5}}) {
    // 32 pixels are a radius of 1.1; z = sqrt(1 - x^2 - y^2).
    const double x = (col + 0.5 - 32) / 32 * 1.1, y = (32 - row - 0.5) / 32 * 1.1;
    const auto& point = grid.at(col, row);
    REQUIRE(point);
    CHECK((point->normal - Vector3d(x, y, std::sqrt(1 - x * x - y * y))).norm() <= rounding);
  }
  CHECK_FALSE(grid.at(0, 0));
}

TEST_CASE("frames are orthonormal, right-handed, and x runs along the parallels",
          "[scene][invariant]") {
  for (const Projection projection : {Projection::orthographic, Projection::perspective})
    for (const Shape& shape : {Shape(Sphere{}), Shape(Cylinder{})}) {
      const Camera camera(projection, 40, 30, Angle::deg(40));
      const Matrix3d rotation = tilted();
      const SurfaceGrid grid = visible_points(shape, camera, rotation);
      std::size_t seen = 0;
      for (const auto& point : grid.points) {
        if (!point) continue;
        ++seen;
        const auto frame = patch_frame(*point, Angle::deg(0));
        REQUIRE(frame);
        Matrix3d axes;
        axes << frame->x, frame->y, frame->z;
        CHECK((axes.transpose() * axes - Matrix3d::Identity()).norm() <= rounding);
        CHECK(std::abs(axes.determinant() - 1) <= rounding);
        // Along a parallel: orthogonal to the axis of the shape.
        CHECK(std::abs(frame->x.dot(rotation.col(1))) <= rounding);
        CHECK(frame->z.dot(camera.viewer(point->position)) >= -1e-7);
        const auto turned = patch_frame(*point, Angle::deg(90));
        REQUIRE(turned);
        CHECK((turned->x - frame->y).norm() <= rounding);
        CHECK((turned->y + frame->x).norm() <= rounding);
      }
      CHECK(seen > 200);
    }
}

TEST_CASE("a fine mesh of a sphere has the sphere's depths, normals and tangents",
          "[scene][oracle]") {
  Mesh mesh = decode_obj(sphere_obj(256, 128), "sphere.obj");
  set_texture_tangents(mesh, "sphere.obj");
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    const Camera camera(projection, 50, 50, Angle::deg(35));
    const SurfaceGrid drawn = visible_points(mesh, camera, tilted());
    const SurfaceGrid exact = visible_points(Sphere{}, camera, tilted());
    std::size_t compared = 0;
    for (std::size_t i = 0; i < drawn.points.size(); ++i) {
      if (!drawn.points[i] || !exact.points[i]) continue;
      const SurfacePoint &d = *drawn.points[i], &e = *exact.points[i];
      // Within 60 deg of the viewer; nearer the rim depth is steep. 256 facets around are 0.0245
      // rad wide: chords lie 0.0245^2 / 8 = 8e-5 below the sphere, 1.5e-4 along the ray at 60 deg.
      if (!(e.normal.dot(camera.viewer(e.position)) > 0.5)) continue;
      // Near the poles parallels turn within a facet; the seam has tangents of one side only.
      if (std::abs(e.texture.y() - 0.5) > 0.4 || std::abs(e.texture.x() - 0.5) > 0.49) continue;
      ++compared;
      CHECK((d.position - e.position).norm() <= 4e-4);
      CHECK((d.normal - e.normal).norm() <= 2e-3);
      CHECK((d.texture - e.texture).norm() <= 2e-3);
      const auto df = patch_frame(d, {}), ef = patch_frame(e, {});
      REQUIRE((df && ef));
      // Tangents of a vertex are means of facets half a facet apart: 0.0123 rad, of which one
      // side's split into triangles leaves up to a third.
      CHECK((df->x - ef->x).norm() <= 6e-3);
    }
    CHECK(compared > 400);
  }
}

TEST_CASE("texture coordinates of a tilted square are perspective-correct", "[scene][oracle]") {
  Mesh mesh = decode_obj(square, "square.obj");
  set_texture_tangents(mesh, "square.obj");
  const Camera camera(Projection::perspective, 64, 64, Angle::deg(50));
  const Matrix3d rotation = tilted();
  const SurfaceGrid grid = visible_points(mesh, camera, rotation);
  std::size_t seen = 0;
  for (int row = 0; row < 64; ++row)
    for (int col = 0; col < 64; ++col) {
      const auto& point = grid.at(col, row);
      if (!point) continue;
      ++seen;
      // The ray meets the plane z = 0 of the square; its corners lie at +-1 / sqrt(2).
      const Ray ray = camera.ray(col, row);
      const Vector3d n = rotation.col(2);
      const Vector3d p = ray.origin - n.dot(ray.origin) / n.dot(ray.direction) * ray.direction;
      const Vector3d local = rotation.transpose() * p;
      const Vector2d uv = (local.head<2>() * std::sqrt(2.0) + Vector2d::Ones()) / 2;
      CHECK((point->texture - uv).norm() <= 1e-13);
      CHECK((point->position - p).norm() <= 1e-13);
      CHECK((point->normal - n).norm() <= rounding);
      CHECK((patch_frame(*point, {})->x - rotation.col(0)).norm() <= rounding);
    }
  CHECK(seen > 400);
}

TEST_CASE("the nearer of two triangles is seen, in either order", "[scene]") {
  const std::string vertices =
      "v -1 -1 -0.2\nv 1 -1 -0.2\nv 0 1 -0.2\nv -1 -1 0.2\nv 1 -1 0.2\nv 0 1 0.2\n";
  for (const std::string faces : {"f 1 2 3\nf 4 5 6\n", "f 4 5 6\nf 1 2 3\n"}) {
    const Mesh mesh = decode_obj(vertices + faces, "two.obj");
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
      const Camera camera(projection, 9, 9, Angle::deg(30));
      const auto point = visible_points(mesh, camera, Matrix3d::Identity()).at(4, 4);
      REQUIRE(point);
      CHECK(point->position.z() > 0.1);
    }
  }
}

TEST_CASE("no pixel is lost between triangles that share an edge", "[scene][regression]") {
  const Mesh mesh = decode_obj(square, "square.obj");
  // 64 pixels: the diagonal runs through the centres of pixels.
  const SurfaceGrid grid =
      visible_points(mesh, Camera(Projection::orthographic, 64, 64, {}), Matrix3d::Identity());
  for (int i = 16; i < 48; ++i) {
    CHECK(grid.at(i, i));
    CHECK(grid.at(i, 63 - i));
  }
}

TEST_CASE("a patch without a direction has no frame", "[scene]") {
  SurfacePoint point{{0, 0, 1}, {0, 0, 1}, {0, 0, 5}, {0, 0}};
  CHECK_FALSE(patch_frame(point, {}));
  point.tangent = {0, 0, 0};
  CHECK_FALSE(patch_frame(point, {}));
  point.tangent = {std::nan(""), 0, 0};
  CHECK_FALSE(patch_frame(point, {}));
  point.tangent = {1, 0, 1};
  CHECK(patch_frame(point, {}));
  point.normal = {0, 0, 0};
  CHECK_FALSE(patch_frame(point, {}));
}

TEST_CASE("cameras that see nothing are refused", "[scene][refusal]") {
  const auto camera = [](int cols, int rows, double deg) {
    return Camera(Projection::perspective, cols, rows, Angle::deg(deg));
  };
  CHECK_ERROR(camera(0, 1, 30), Errc::invalid_argument, "0 pixels");
  CHECK_ERROR(camera(16385, 1, 30), Errc::invalid_argument, "16385");
  CHECK_ERROR(camera(16384, 16384, 30), Errc::invalid_argument, "16777216");
  CHECK_ERROR(camera(9, 9, 0), Errc::invalid_argument, "field of view");
  CHECK_ERROR(camera(9, 9, std::nan("")), Errc::invalid_argument, "field of view");
}
