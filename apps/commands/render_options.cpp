#include "apps/commands/render_options.h"

#include <Eigen/Geometry>
#include <array>

#include "apps/quantities.h"
#include "evaluation/readers/file_bytes.h"
#include "evaluation/sha256.h"

namespace apps {
namespace {

using brdf::Angle;
using brdf::Errc;
using brdf::Error;
using Eigen::Vector3d;
using evaluation::Camera;
using evaluation::Json;
using evaluation::Projection;

const Choices<Projection> projection_choices{{"orthographic", Projection::orthographic},
                                             {"perspective", Projection::perspective}};

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& what) {
  throw Error(Errc::invalid_argument, option + " " + text + ": " + what);
}

/// The parts of a text between commas, as many as there must be.
template <std::size_t N>
std::array<std::string, N> parts(const std::string& option, const std::string& text,
                                 const std::string& form) {
  std::array<std::string, N> parts;
  std::size_t part = 0;
  for (const char c : text)
    if (c != ',')
      parts[part] += c;
    else if (++part == N)
      break;
  if (part + 1 != N) refuse(option, text, "must be " + form);
  return parts;
}

std::pair<Angle, Angle> parse_light(const std::string& option, const std::string& text) {
  const auto [theta, phi] = parts<2>(option, text, "THETA,PHI");
  const std::pair<Angle, Angle> light{parse_angle(option, theta), parse_angle(option, phi)};
  if (!(std::abs(light.first.deg()) <= 180))
    refuse(option, text, "the angle from the viewing axis must be -180 to 180 deg");
  return light;
}

Vector3d parse_rotation(const std::string& option, const std::string& text) {
  const auto [x, y, z] = parts<3>(option, text, "AX,AY,AZ");
  return {parse_angle(option, x).deg(), parse_angle(option, y).deg(), parse_angle(option, z).deg()};
}

Vector3d parse_vector(const std::string& option, const std::string& text) {
  const auto [x, y, z] = parts<3>(option, text, "X,Y,Z");
  const Vector3d vector(parse_number(option, x), parse_number(option, y), parse_number(option, z));
  if (!(vector.stableNorm() > 0)) refuse(option, text, "a direction must not be 0");
  return vector.stableNormalized();
}

double parse_share(const std::string& option, const std::string& text) {
  const double share = parse_number(option, text);
  if (!(share >= 0 && share <= 1)) refuse(option, text, "must be 0 to 1");
  return share;
}

brdf::Rgb parse_rgb(const std::string& option, const std::string& text) {
  const auto [r, g, b] = parts<3>(option, text, "R,G,B, each 0 to 1");
  return {parse_share(option, r), parse_share(option, g), parse_share(option, b)};
}

std::string parse_shape(const std::string& option, const std::string& text) {
  if (text != "sphere" && text != "cylinder" && !text.ends_with(".obj"))
    refuse(option, text, "must be sphere, cylinder or a FILE.obj");
  return parse_path(option, text);
}

/// Turns about x, then y, then z, the axes of the camera.
Eigen::Matrix3d rotation_of(const Vector3d& deg) {
  const auto turn = [&](int axis) {
    return Eigen::AngleAxisd(Angle::deg(deg[axis]).rad(), Vector3d::Unit(axis));
  };
  return (turn(2) * turn(1) * turn(0)).toRotationMatrix();
}

Vector3d light_of(const std::pair<Angle, Angle>& light) {
  return Eigen::AngleAxisd(light.second.rad(), Vector3d::UnitZ()) *
         (Eigen::AngleAxisd(light.first.rad(), Vector3d::UnitY()) * Vector3d::UnitZ());
}

/// Largest text that is read.
constexpr std::uintmax_t largest_text = std::uintmax_t{1} << 31;

std::string read_scene_file(const std::string& file, std::vector<SceneFile>& files) {
  std::string bytes = evaluation::read_file_bytes(file, largest_text);
  files.push_back({file, evaluation::sha256_hex(bytes)});
  return bytes;
}

bool is_mesh(const std::string& shape) {
  return shape != "sphere" && shape != "cylinder";
}

evaluation::Shape read_shape(const RenderOptions& options, std::vector<SceneFile>& files) {
  if (options.shape == "sphere") return evaluation::Sphere{};
  if (options.shape == "cylinder") return evaluation::Cylinder{};
  evaluation::Mesh mesh =
      evaluation::decode_obj(read_scene_file(options.shape, files), options.shape);
  if (!options.direction_field.empty())
    set_field_tangents(mesh, read_scene_file(options.direction_field, files),
                       options.direction_field);
  else if (!options.along)
    set_texture_tangents(mesh, options.shape);
  if (!options.texture.empty() && mesh.texture == evaluation::TextureCoordinates::missing)
    throw Error(Errc::bad_input, options.shape +
                                     ": has faces without texture coordinates, which --texture "
                                     "needs; give --diffuse R,G,B or vt lines");
  return mesh;
}

Json rgb_json(const brdf::Rgb& rgb) {
  return {rgb.r, rgb.g, rgb.b};
}

Json vector_json(const Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

}  // namespace

evaluation::SurfaceGrid Scene::visible() const {
  evaluation::SurfaceGrid grid = visible_points(shape, camera, rotation);
  if (along)
    for (auto& point : grid.points)
      if (point) point->tangent = rotation * *along;
  return grid;
}

void RenderOptions::add_to(CLI::App* app) {
  add_parsed(app, "--shape", shape, parse_shape, "sphere, cylinder or a FILE.obj (default sphere)",
             "SHAPE");
  add_parsed(app, "--light", light, parse_light,
             "towards the light: angle from the viewing axis, azimuth from the right upwards",
             "THETA,PHI")
      ->required();
  CLI::Option* out = add_output(app, output, "PNG of 8 bits, sRGB");
  add_parsed(
      app, "--probe", probe,
      [](const std::string& option, const std::string& text) {
        parts<2>(option, text, "COLUMN,ROW from 0, at the upper left");
        return parse_count_pair(option, text, 0, Camera::max_side - 1);
      },
      "instead of a picture: what the pixel shows, as JSON", "COLUMN,ROW")
      ->excludes(out);
  add_parsed(
      app, "--size", size,
      [](const std::string& option, const std::string& text) {
        return parse_count_pair(option, text, 1, Camera::max_side);
      },
      "pixels, or columns,rows (default 512)", "N[,N]");
  add_choice(app, "--camera", projection, projection_choices,
             "how the shape is seen (default orthographic)");
  add_parsed(app, "--field-of-view", field_of_view, parse_angle,
             "of a perspective camera, across the shorter side (default 30deg)", "ANGLE");
  add_parsed(app, "--rotate", rotate_deg, parse_rotation,
             "turns the shape about x (right), then y (up), then z (to the viewer)", "AX,AY,AZ");
  add_parsed(app, "--orientation", orientation, parse_angle,
             "turns the patch about the normal (default 0deg)", "ANGLE");
  CLI::Option* vector = add_parsed(
      app, "--along", along,
      [](const std::string& option, const std::string& text) { return parse_vector(option, text); },
      "x of the patch: this vector, in the frame of the shape, projected on the surface", "X,Y,Z");
  add_parsed(app, "--direction-field", direction_field, parse_path,
             "x of the patch: text with a vector for each v line of the OBJ", "FILE")
      ->excludes(vector);
  exposure.add_to(app);
  CLI::Option* picture = add_parsed(app, "--texture", texture, parse_path,
                                    "diffuse colour of the surface: PNG over u, v", "FILE");
  add_parsed(app, "--diffuse", diffuse, parse_rgb, "diffuse colour of the surface, sRGB 0 to 1",
             "R,G,B")
      ->excludes(picture);
  add_parsed(app, "--blend", blend, parse_share,
             "share of the diffraction; the diffuse colour has the rest (default 1, or 0.5 beside "
             "one)",
             "SHARE");
  add_parsed(app, "--background", background, parse_rgb, "sRGB 0 to 1 (default black)", "R,G,B");
}

void RenderOptions::require_consistent() const {
  if (output.empty() && !probe)
    throw Error(Errc::invalid_argument, "--output is required, or --probe COLUMN,ROW");
  if (probe && exposure.asked_auto)
    throw Error(Errc::invalid_argument,
                "--exposure auto: needs all pixels; --probe takes a number, the exposure that the "
                "picture's sidecar states");
  if (probe && !(probe->first < size.first && probe->second < size.second))
    throw Error(Errc::invalid_argument, "--probe " + std::to_string(probe->first) + "," +
                                            std::to_string(probe->second) + ": lies outside of " +
                                            std::to_string(size.first) + " x " +
                                            std::to_string(size.second) + " pixels");
  if (!direction_field.empty() && !is_mesh(shape))
    throw Error(Errc::invalid_argument,
                "--direction-field " + direction_field + ": needs --shape FILE.obj, not " + shape);
  if (resolved_blend() < 1 && !diffuse && texture.empty())
    throw Error(Errc::invalid_argument, "--blend " + brdf::text(*blend) +
                                            ": needs a diffuse colour; give --diffuse or "
                                            "--texture");
}

std::vector<std::string> RenderOptions::inputs() const {
  std::vector<std::string> files;
  if (is_mesh(shape)) files.push_back(shape);
  for (const std::string& file : {direction_field, texture})
    if (!file.empty()) files.push_back(file);
  return files;
}

Scene RenderOptions::read() const {
  Scene scene{{},
              Camera(projection, size.first, size.second, field_of_view),
              rotation_of(rotate_deg),
              light_of(light),
              along,
              orientation,
              std::nullopt,
              {}};
  scene.shape = read_shape(*this, scene.files);
  if (!texture.empty())
    scene.texture = evaluation::decode_rgb_png(read_scene_file(texture, scene.files), texture);
  return scene;
}

Json RenderOptions::parameters() const {
  Json p{{"shape", shape},
         {"light_deg", {light.first.deg(), light.second.deg()}},
         {"size", {size.first, size.second}},
         {"camera", name_in(projection_choices, projection)}};
  if (projection == Projection::perspective) p["field_of_view_deg"] = field_of_view.deg();
  p["rotate_deg"] = vector_json(rotate_deg);
  p["orientation_deg"] = orientation.deg();
  if (along) p["along"] = vector_json(*along);
  if (!direction_field.empty()) p["direction_field"] = direction_field;
  if (!texture.empty()) p["texture"] = texture;
  if (diffuse) p["diffuse"] = rgb_json(*diffuse);
  p["blend"] = resolved_blend();
  p["background"] = rgb_json(background);
  return p;
}

}  // namespace apps
