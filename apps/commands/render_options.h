// The options of render: shape, camera, light, and how its colours become a picture.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>

#include "apps/exposure.h"
#include "apps/options.h"
#include "evaluation/rgb_image.h"
#include "evaluation/scene/shapes.h"

namespace apps {

/// A file of the scene and its hash.
struct SceneFile {
  std::string file, sha256;

  evaluation::Json json() const { return {{"file", file}, {"sha256", sha256}}; }
};

/// The scene, with its files read.
struct Scene {
  evaluation::Shape shape;
  evaluation::Camera camera;
  Eigen::Matrix3d rotation;              ///< of the shape
  Eigen::Vector3d light;                 ///< unit vector towards the light, in the camera's frame
  std::optional<Eigen::Vector3d> along;  ///< direction of the patch's x, in the shape's frame
  brdf::Angle orientation;
  std::optional<evaluation::RgbImage> texture;
  std::vector<SceneFile> files;

  /// What the camera sees.
  evaluation::SurfaceGrid visible() const;
};

struct RenderOptions {
  std::string output;
  std::string shape = "sphere";
  std::pair<brdf::Angle, brdf::Angle> light;
  std::pair<int, int> size{512, 512};
  evaluation::Projection projection = evaluation::Projection::orthographic;
  brdf::Angle field_of_view = brdf::Angle::deg(30), orientation;
  Eigen::Vector3d rotate_deg = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> along;
  std::string direction_field, texture;
  std::optional<brdf::Rgb> diffuse;  ///< encoded sRGB
  brdf::Rgb background;              ///< encoded sRGB
  std::optional<double> blend;
  Exposure exposure;
  std::optional<std::pair<int, int>> probe;

  void add_to(CLI::App* app);
  /// Throws Errc::invalid_argument where options contradict each other.
  void require_consistent() const;
  /// Share of the diffraction, 0 to 1: 1, or 0.5 beside a diffuse colour, unless given.
  double resolved_blend() const { return blend.value_or(diffuse || !texture.empty() ? 0.5 : 1.0); }
  /// All files that are read, but for the surface itself.
  std::vector<std::string> inputs() const;
  Scene read() const;
  evaluation::Json parameters() const;
};

}  // namespace apps
