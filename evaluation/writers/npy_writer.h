// Matrices as NPY files, with their axes beside them.
#pragma once

#include <array>
#include <deque>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "brdf/height_field.h"
#include "evaluation/writers/output_file.h"

namespace evaluation {

/// A name of a file's kind, ".npy" or another, whatever its case of letters.
bool has_extension(const std::filesystem::path& path, const std::string& extension);

/// The bytes of a matrix: "<f8", rows and columns.
std::string to_npy(const brdf::HeightArray& matrix);

/// The axes of a matrix, `R.lambda_nm.npy` and `R.theta_r_deg.npy` beside `R.npy`.
class NpyAxes {
 public:
  /// Opens the files, so that what cannot be written is known. Throws Errc::cannot_write.
  NpyAxes(const std::filesystem::path& matrix, const std::vector<std::string>& names);

  /// Writes them, in the order of their names; for the sidecar: name, file, hash.
  Json write(const std::vector<std::span<const double>>& axes);
  /// To be put in place together with the matrix.
  std::vector<OutputFile*> files();

 private:
  std::vector<std::string> names_;
  std::deque<OutputFile> files_;
};

}  // namespace evaluation
