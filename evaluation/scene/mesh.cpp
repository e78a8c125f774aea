#include "evaluation/scene/mesh.h"

#include <Eigen/Geometry>

#include "brdf/error.h"
#include "evaluation/scene/number_lines.h"

namespace evaluation {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw brdf::Error(brdf::Errc::bad_input, name + ": " + what);
}

}  // namespace

void set_texture_tangents(Mesh& mesh, const std::string& name) {
  if (mesh.texture == TextureCoordinates::missing)
    refuse(name,
           "has faces without texture coordinates, so the patch has no direction there; give "
           "--along X,Y,Z or --direction-field FILE, or vt lines");
  for (MeshVertex& vertex : mesh.vertices) vertex.tangent.setZero();
  for (const auto& [i, j, k] : mesh.triangles) {
    const MeshVertex &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
    const Eigen::Vector3d p = b.position - a.position, q = c.position - a.position;
    const Eigen::Vector2d s = b.texture - a.texture, t = c.texture - a.texture;
    // dP/du = (t.v p - s.v q) / det; its length does not matter, its sign does.
    const double det = s.x() * t.y() - t.x() * s.y();
    const Eigen::Vector3d along = (t.y() * p - s.y() * q).stableNormalized();
    if (!(std::abs(det) > 0)) continue;
    const Eigen::Vector3d weighted = std::copysign(p.cross(q).norm(), det) * along;
    for (const std::size_t corner : {i, j, k}) mesh.vertices[corner].tangent += weighted;
  }
}

void set_field_tangents(Mesh& mesh, std::string_view text, const std::string& name) {
  std::vector<Eigen::Vector3d> field;
  for_each_line(text, [&](std::string_view line, std::size_t number) {
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty()) return;
    const std::string place = "line " + std::to_string(number);
    if (words.size() != 3)
      refuse(name, place + " has " + std::to_string(words.size()) + " words; a vector is x y z");
    if (field.size() == mesh.sources)
      refuse(name, place + " is past the " + std::to_string(mesh.sources) +
                       " vertices of the mesh; one vector per v line");
    Eigen::Vector3d vector;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::optional<double> value = finite_number(words[i]);
      if (!value)
        refuse(name,
               place + ": \"" + std::string(words[i].substr(0, 40)) + "\" is not a finite number");
      vector[static_cast<Eigen::Index>(i)] = *value;
    }
    if (!(vector.stableNorm() > 0)) refuse(name, place + ": the vector has length 0");
    field.push_back(vector.stableNormalized());
  });
  if (field.size() != mesh.sources)
    refuse(name, "has " + std::to_string(field.size()) + " vectors; the mesh has " +
                     std::to_string(mesh.sources) + " vertices (v lines)");
  for (MeshVertex& vertex : mesh.vertices) vertex.tangent = field[vertex.source];
}

}  // namespace evaluation
