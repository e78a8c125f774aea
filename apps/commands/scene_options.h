// The options that say what is looked at: the light, the viewing angles, the wavelengths.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "apps/console.h"
#include "brdf/height_field.h"
#include "evaluation/sweep_request.h"
#include "evaluation/writers/output_file.h"

namespace apps {

/// What the plane of incidence is laid along.
enum class Along {
  azimuth,  ///< phi_i
  grating,  ///< the grating vector of the strongest period of the heights
};

struct SceneOptions {
  std::optional<brdf::Angle> theta_i, phi_i;
  Along along = Along::azimuth;
  std::optional<brdf::Angle> phi_r;
  std::optional<evaluation::Axis> theta_r_deg, lambda_nm;

  void add_to(CLI::App* app);
  /// Refuses an angle of 90 deg or more and a wavelength that is not positive.
  evaluation::SweepRequest request() const;
  /// Lays the plane of incidence along the grating, where asked to. Throws Errc::not_attainable,
  /// naming the file, where the heights have no period.
  void turn(const brdf::HeightField& field, const std::string& file);
};

/// Light, angles and wavelengths, for sidecars.
evaluation::Json scene_json(const evaluation::SweepRequest& request);

/// Says which angles go past the Nyquist limit of a file's pixels.
void check_sampling(const evaluation::SweepRequest& request, const brdf::HeightField& field,
                    const std::string& file, Attainability attainability);

}  // namespace apps
