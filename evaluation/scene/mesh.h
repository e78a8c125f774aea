// Triangle meshes with normals and tangents, from OBJ files.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace evaluation {

struct MeshVertex {
  Eigen::Vector3d position, normal, tangent;  ///< normal and tangent zero where there is none
  Eigen::Vector2d texture;
  std::size_t source;  ///< which `v` line of the file, from 0
};

enum class TextureCoordinates { given, missing };

/// Vertices are those of the file's corners that differ in position, texture or normal.
struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::size_t sources = 0;                                   ///< count of `v` lines
  TextureCoordinates texture = TextureCoordinates::missing;  ///< given: at every corner
};

/// Most vertices, and most triangles, that are read.
inline constexpr std::size_t max_mesh_size = std::size_t{1} << 24;

/// A mesh from the text of a Wavefront OBJ, moved and scaled so that its bounding box is about the
/// origin and its farthest vertex at distance 1. Polygons are cut into fans from their first
/// corner, which is right for convex ones. Normals that the file lacks are the sum of the
/// triangles around a vertex, weighted by area. Tangents are left zero. Materials are ignored.
///
/// Throws Errc::bad_input naming `name` and the line or face: a number that is not finite or
/// beyond 1e30, an index that no earlier line has, fewer than 3 corners, no triangle of any
/// extent, more than max_mesh_size vertices or triangles.
Mesh decode_obj(const std::string& text, const std::string& name);

/// Tangents dP/du from the texture coordinates: for each triangle the solution of
/// edge_j = du_j dP/du + dv_j dP/dv, summed over the triangles of a vertex with their area on the
/// surface as weight. Triangles without area or without extent in u, v add nothing.
///
/// Throws Errc::bad_input naming `name` where texture coordinates are missing.
void set_texture_tangents(Mesh& mesh, const std::string& name);

/// Tangents from a direction field, the vector of its own `v` line for each vertex.
///
/// text: x y z on a line for each `v` line in their order; empty lines and # comments are skipped.
/// Throws Errc::bad_input naming `name` and the line: another count of numbers or of vectors, what
/// is not finite, a vector of length 0.
void set_field_tangents(Mesh& mesh, std::string_view text, const std::string& name);

}  // namespace evaluation
