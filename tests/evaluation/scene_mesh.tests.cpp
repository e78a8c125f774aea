#include <catch2/catch.hpp>
#include <cmath>

#include "evaluation/scene/mesh.h"
#include "tests/support/is_error.h"

namespace {

using namespace evaluation;
using brdf::Errc;

const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string mapped = vertices + "vt 0 0\nvt 0 1\nvt -1 0\nf 1/1 2/2 3/3\n";

Mesh decoded(const std::string& text) {
  return decode_obj(text, "x.obj");
}

}  // namespace

TEST_CASE("a mesh is fitted into the unit sphere about the origin", "[scene][mesh]") {
  const Mesh mesh = decoded("v 10 10 5\nv 30 10 5\nv 30 30 5\nv 10 30 5\nf 1 2 3 -1\n");
  CHECK(mesh.triangles.size() == 2);
  CHECK(mesh.texture == TextureCoordinates::missing);
  for (const MeshVertex& vertex : mesh.vertices) {
    CHECK(std::abs(vertex.position.norm() - 1) <= 1e-15);
    CHECK((vertex.normal - Eigen::Vector3d::UnitZ()).norm() <= 1e-15);
  }
}

TEST_CASE("tangents run along u", "[scene][mesh]") {
  // u = -y, v = x: dP/du = -y.
  Mesh mesh = decoded(mapped);
  set_texture_tangents(mesh, "x.obj");
  for (const MeshVertex& vertex : mesh.vertices)
    CHECK((vertex.tangent.normalized() + Eigen::Vector3d::UnitY()).norm() <= 1e-15);
  // Mirrored, u = -x and v = y: dP/du = -x.
  Mesh mirrored = decoded(vertices + "vt 0 0\nvt -1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
  set_texture_tangents(mirrored, "x.obj");
  for (const MeshVertex& vertex : mirrored.vertices)
    CHECK((vertex.tangent.normalized() + Eigen::Vector3d::UnitX()).norm() <= 1e-15);
  Mesh bare = decoded(vertices + "f 1 2 3\n");
  CHECK_ERROR(set_texture_tangents(bare, "x.obj"), Errc::bad_input, "--along");
}

TEST_CASE("a direction field has one vector for each vertex", "[scene][mesh][refusal]") {
  Mesh mesh = decoded(mapped);
  set_field_tangents(mesh, "# field\n0 0 2\r\n1 0 0\n\n0 1 0\n", "f.txt");
  CHECK(mesh.vertices[0].tangent == Eigen::Vector3d::UnitZ());
  CHECK(mesh.vertices[2].tangent == Eigen::Vector3d::UnitY());
  CHECK_ERROR(set_field_tangents(mesh, "0 0 1\n1 0 0\n", "f.txt"), Errc::bad_input, "2 vectors");
  CHECK_ERROR(set_field_tangents(mesh, "0 0 1\n1 0 0\n1 0 0\n1 0 0\n", "f.txt"), Errc::bad_input,
              "line 4");
  CHECK_ERROR(set_field_tangents(mesh, "0 0 nan\n", "f.txt"), Errc::bad_input, "line 1: \"nan\"");
  CHECK_ERROR(set_field_tangents(mesh, "0 0\n", "f.txt"), Errc::bad_input, "2 words");
  CHECK_ERROR(set_field_tangents(mesh, "1 0 0\n0 0 0\n", "f.txt"), Errc::bad_input, "length 0");
}

TEST_CASE("damaged OBJ files are refused with their place", "[scene][mesh][refusal]") {
  const auto refused = [](const std::string& text, const std::string& named) {
    INFO(text);
    CHECK_ERROR(decoded(text), Errc::bad_input, "x.obj: ");
    CHECK_ERROR(decoded(text), Errc::bad_input, named);
  };
  refused("v nan 0 0\n", "line 1: v has \"nan\"");
  refused(vertices + "v 1 inf 0\nf 1 2 4\n", "line 4");
  refused("v 0 0 1e31\n", "1e31");
  refused("v 0 0 1e999\n", "1e999");
  refused("v 0 0 one\n", "\"one\"");
  refused("v 0 0\n", "2 numbers");
  refused("vn 0 0\n", "needs 3");
  refused(vertices + "vt nan 0\nf 1/1 2/1 3/1\n", "vt has \"nan\"");
  refused(vertices + "f 1 2 4\n", "face 1: vertex 4");
  refused(vertices + "f 1 2 0\n", "face 1: vertex 0");
  refused(vertices + "f 1 2 -4\n", "vertex -4");
  refused(vertices + "f 1 2 2147483647\n", "vertex 2147483647");
  refused(vertices + "f 1/1 2/1 3/1\n", "texture coordinate 1");
  refused(vertices + "f 1//1 2//1 3//1\n", "normal 1");
  refused(vertices + "f 1 2\n", "2 corners");
  refused(vertices + "f a b c\n", "vertex 0");
  refused(vertices, "no faces");
  refused("\n", "no faces");
  refused("v 1 1 1\nf 1 1 1\n", "one point");
  refused("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "area 0");
}

TEST_CASE("degenerate triangles beside good ones do no harm", "[scene][mesh]") {
  Mesh mesh = decoded(mapped + "f 1/1 1/1 2/2\nf 1/1 2/1 3/1\n");
  set_texture_tangents(mesh, "x.obj");
  CHECK(mesh.triangles.size() == 3);
  for (const MeshVertex& vertex : mesh.vertices) {
    CHECK(vertex.normal.allFinite());
    CHECK(vertex.tangent.allFinite());
  }
}
