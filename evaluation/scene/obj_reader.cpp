#include <tiny_obj_loader.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <sstream>

#include "brdf/error.h"
#include "evaluation/scene/mesh.h"
#include "evaluation/scene/number_lines.h"

namespace evaluation {
namespace {

/// Far beyond any model, and far from where squares overflow.
constexpr double largest_number = 1e30;

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw brdf::Error(brdf::Errc::bad_input, name + ": " + what);
}

/// tinyobjloader reads what is no number as 0: such lines are refused before it sees them.
void require_numbers(std::string_view text, const std::string& name) {
  for_each_line(text, [&](std::string_view line, std::size_t number) {
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty()) return;
    const std::string_view kind = words.front();
    const std::size_t least = kind == "vt" ? 1 : kind == "v" || kind == "vn" ? 3 : 0;
    if (least == 0) return;
    const std::string place = "line " + std::to_string(number) + ": " + std::string(kind);
    if (words.size() - 1 < least)
      refuse(name, place + " has " + std::to_string(words.size() - 1) + " numbers and needs " +
                       std::to_string(least));
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::optional<double> value = finite_number(words[i]);
      if (!(value && std::abs(*value) <= largest_number))
        refuse(name, place + " has \"" + std::string(words[i].substr(0, 40)) +
                         "\", which is no number up to 1e30");
    }
  });
}

/// One corner of a face: indices from 0, -1 where there is none.
using Corner = std::array<long, 3>;

struct Contents {
  std::string name;
  std::vector<Eigen::Vector3d> positions, normals;
  std::vector<Eigen::Vector2d> textures;
  std::vector<std::array<Corner, 3>> triangles;
  std::size_t faces = 0;

  template <class Values>
  long index(int given, const Values& values, const char* kind) const {
    const long count = static_cast<long>(values.size());
    const long i = given > 0 ? given - 1 : count + given;
    if (given == 0 || i < 0 || i >= count)
      refuse(name, "face " + std::to_string(faces) + ": " + kind + " " + std::to_string(given) +
                       " is not among the " + std::to_string(count) + " before it");
    return i;
  }

  Corner corner(const tinyobj::index_t& given) const {
    return {index(given.vertex_index, positions, "vertex"),
            given.texcoord_index == 0 ? -1
                                      : index(given.texcoord_index, textures, "texture coordinate"),
            given.normal_index == 0 ? -1 : index(given.normal_index, normals, "normal")};
  }

  void require_room(std::size_t count, const char* what) const {
    if (count >= max_mesh_size)
      refuse(name, "more than " + std::to_string(max_mesh_size) + " " + what);
  }

  void add_face(const tinyobj::index_t* indices, int count) {
    ++faces;
    if (count < 3)
      refuse(name, "face " + std::to_string(faces) + " has " + std::to_string(count) +
                       " corners and needs 3");
    const Corner first = corner(indices[0]);
    Corner last = corner(indices[1]);
    for (int i = 2; i < count; ++i) {
      const Corner next = corner(indices[i]);
      require_room(triangles.size(), "triangles");
      triangles.push_back({first, last, next});
      last = next;
    }
  }
};

Contents parsed(const std::string& text, const std::string& name) {
  Contents contents;
  contents.name = name;
  tinyobj::callback_t callbacks;
  static constexpr auto to = [](void* data) -> Contents& { return *static_cast<Contents*>(data); };
  callbacks.vertex_cb = [](void* data, double x, double y, double z, double) {
    to(data).require_room(to(data).positions.size(), "vertices");
    to(data).positions.emplace_back(x, y, z);
  };
  callbacks.normal_cb = [](void* data, double x, double y, double z) {
    to(data).normals.emplace_back(x, y, z);
  };
  callbacks.texcoord_cb = [](void* data, double u, double v, double) {
    to(data).textures.emplace_back(u, v);
  };
  callbacks.index_cb = [](void* data, tinyobj::index_t* indices, int count) {
    to(data).add_face(indices, count);
  };
  std::istringstream stream(text);
  std::string warnings, errors;
  if (!tinyobj::LoadObjWithCallback(stream, callbacks, &contents, nullptr, &warnings, &errors))
    refuse(name, "OBJ: " + errors.substr(0, errors.find('\n')));
  if (contents.triangles.empty()) refuse(name, "has no faces");
  return contents;
}

/// Into the unit sphere.
void fit(Contents& contents) {
  Eigen::AlignedBox3d box;
  for (const auto& triangle : contents.triangles)
    for (const Corner& corner : triangle)
      box.extend(contents.positions[static_cast<std::size_t>(corner[0])]);
  const Eigen::Vector3d centre = (box.min() + box.max()) / 2;
  double radius = 0;
  for (const auto& triangle : contents.triangles)
    for (const Corner& corner : triangle)
      radius = std::max(radius,
                        (contents.positions[static_cast<std::size_t>(corner[0])] - centre).norm());
  if (!(radius > 0)) refuse(contents.name, "all corners of its faces are one point");
  for (Eigen::Vector3d& position : contents.positions) position = (position - centre) / radius;
}

/// For each position the sum of (b - a) cross (c - a) over its triangles: twice their areas times
/// their normals.
std::vector<Eigen::Vector3d> summed_normals(const Contents& contents) {
  std::vector<Eigen::Vector3d> sums(contents.positions.size(), Eigen::Vector3d::Zero());
  double largest = 0;
  for (const auto& triangle : contents.triangles) {
    const auto at = [&](std::size_t i) { return static_cast<std::size_t>(triangle[i][0]); };
    const Eigen::Vector3d& a = contents.positions[at(0)];
    const Eigen::Vector3d area =
        (contents.positions[at(1)] - a).cross(contents.positions[at(2)] - a);
    largest = std::max(largest, area.norm());
    for (const std::size_t i : {0u, 1u, 2u}) sums[at(i)] += area;
  }
  if (!(largest > 0)) refuse(contents.name, "all of its triangles have area 0");
  return sums;
}

}  // namespace

Mesh decode_obj(const std::string& text, const std::string& name) {
  require_numbers(text, name);
  Contents contents = parsed(text, name);
  fit(contents);
  const std::vector<Eigen::Vector3d> sums = summed_normals(contents);

  Mesh mesh;
  mesh.sources = contents.positions.size();
  mesh.texture = TextureCoordinates::given;
  std::map<Corner, std::size_t> known;
  const auto vertex = [&](const Corner& corner) {
    const auto [entry, is_new] = known.try_emplace(corner, mesh.vertices.size());
    if (!is_new) return entry->second;
    const auto source = static_cast<std::size_t>(corner[0]);
    Eigen::Vector2d texture = Eigen::Vector2d::Zero();
    if (corner[1] < 0)
      mesh.texture = TextureCoordinates::missing;
    else
      texture = contents.textures[static_cast<std::size_t>(corner[1])];
    const Eigen::Vector3d normal =
        corner[2] < 0 ? sums[source] : contents.normals[static_cast<std::size_t>(corner[2])];
    mesh.vertices.push_back({contents.positions[source], normal.stableNormalized(),
                             Eigen::Vector3d::Zero(), texture, source});
    return entry->second;
  };
  mesh.triangles.reserve(contents.triangles.size());
  for (const auto& [a, b, c] : contents.triangles) {
    const std::size_t first = vertex(a), second = vertex(b);
    mesh.triangles.push_back({first, second, vertex(c)});
  }
  return mesh;
}

}  // namespace evaluation
