// A response read back for evaluation: the CSV, what its sidecar says, and what the user overrides.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "evaluation/peaks.h"
#include "evaluation/period_fit.h"
#include "evaluation/writers/output_file.h"

namespace apps {

/// A response as it lies on disk, with its sidecar; that is null where there is none.
struct ResponseFile {
  evaluation::ResponseMatrix response;
  std::string sha256;
  evaluation::Json sidecar;
};

/// Throws Errc::bad_input for a file that is no response, or a sidecar that is not its own.
ResponseFile read_response(const std::string& file);

/// A response, its plane of incidence and where to look for peaks.
struct ResponseInput {
  evaluation::ResponseMatrix response;
  evaluation::PlaneOfIncidence plane;
  evaluation::PeakSearch search;
  evaluation::Json sidecar;  ///< null where there is none
  std::string sha256;

  std::vector<evaluation::Peak> peaks() const { return find_peaks(response, plane, search); }
  /// The rounding of the peaks' angles: the grid's step, or 0 where they are refined.
  double angle_step_deg() const;
  /// What was resolved, for the sidecar of what is made from it.
  evaluation::Json parameters() const;
};

/// A number of a sidecar by its JSON pointer; empty where it is missing or no number.
std::optional<double> sidecar_number(const evaluation::Json& sidecar, const std::string& pointer);

/// A text of a sidecar by its JSON pointer; `otherwise` where it is missing or no text.
std::string sidecar_text(const evaluation::Json& sidecar, const std::string& pointer,
                         const std::string& otherwise);

/// What the values of a response are, by its sidecar, for the axis of a picture.
std::string value_label(const evaluation::Json& sidecar);

/// The height field that a response is of, or the response's file, and the light.
std::string picture_title(const ResponseInput& input, const std::string& file);

/// The options that `peaks`, `period`, `plot` and `ridges` share.
struct ResponseOptions {
  std::string file;
  std::optional<brdf::Angle> theta_i, phi_i, phi_r;
  std::optional<brdf::Length> sigma;
  std::optional<std::pair<brdf::Angle, brdf::Angle>> window;
  std::optional<evaluation::Refinement> refinement;
  evaluation::PeakSearch search;

  void add_to(CLI::App* app);
  /// All but the file.
  void add_settings_to(CLI::App* app);
  /// Throws Errc::bad_input naming the option where neither it nor the sidecar gives a value.
  ResponseInput read() const;
};

}  // namespace apps
