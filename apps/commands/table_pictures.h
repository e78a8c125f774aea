// A folder of pictures of tables.
#pragma once

#include <deque>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "apps/spectra_picture.h"
#include "brdf/height_field.h"
#include "evaluation/writers/output_file.h"

namespace apps {

/// Draws the first powers and, at the end, the extrema of all. Nothing is in the folder before the
/// outputs are put in place; a folder made for the pictures is removed where it does not come to
/// that.
class TablePictures {
 public:
  /// The files that there will be: extrema.png and power_N.png of at most 8 powers.
  static std::vector<std::filesystem::path> files(const std::filesystem::path& folder, int terms);

  /// Makes the folder where there is none, and opens the files. Throws Errc::cannot_write.
  TablePictures(const std::filesystem::path& folder, int terms);

  /// Draws a power if it is one of those drawn. Throws Errc::cannot_write.
  void see(int power, const brdf::HalfSpectrum& spectrum, const brdf::HeightField& field,
           const std::string& title);
  /// Draws the extrema; file and hash of every picture, for the sidecar.
  evaluation::Json finish(std::span<const brdf::SpectrumExtrema> powers, const std::string& title);
  /// What is to be put in place.
  std::vector<evaluation::OutputFile*> outputs();

 private:
  /// Made where there is none; removed at the end if it was made and is empty.
  struct Folder {
    explicit Folder(const std::filesystem::path& folder);
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder();
    std::filesystem::path path;
    bool made;
  };

  void write(std::size_t number, const std::string& png);

  Folder folder_;
  std::vector<std::filesystem::path> files_;
  std::deque<evaluation::OutputFile> outputs_;
  evaluation::Json described_;
};

}  // namespace apps
