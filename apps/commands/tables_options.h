// The option of `shedlight sweep` that takes tables made by `shedlight precompute`.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "apps/options.h"
#include "brdf/power_spectra.h"
#include "evaluation/power_spectra_file.h"

namespace apps {

/// The heights that tables are of. Refers to the input.
evaluation::TableSource table_source(const HeightOptions& heights,
                                     const evaluation::HeightFile& input);

struct TablesOptions {
  std::string file;

  void add_to(CLI::App* sweep);
  bool given() const { return !file.empty(); }
  /// Refuses an output that is the tables, or their sidecar.
  void require_consistent(const std::string& output) const;
  /// The tables, which must be of these heights; null where none are given.
  std::shared_ptr<const brdf::PowerSpectra> read(const HeightOptions& heights,
                                                 const evaluation::HeightFile& input);
  /// For the sidecar, once they are read.
  evaluation::Json parameters() const { return {{"file", file}, {"sha256", sha256_}}; }

 private:
  std::string sha256_;
};

}  // namespace apps
