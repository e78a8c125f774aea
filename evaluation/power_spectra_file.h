// Tables of a Taylor series on disk: an NPY file and its sidecar.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "brdf/power_spectra.h"
#include "brdf/spectrum_extrema.h"
#include "evaluation/table_sidecar.h"
#include "evaluation/writers/output_file.h"

namespace evaluation {

/// Writes tables power by power: complex128 [terms][rows][columns / 2 + 1] of what HalfSpectrum
/// reads, the transforms of s^n, s = (h - mid range) / half range.
class PowerSpectraWriter {
 public:
  /// Writes the header. Refers to the output.
  PowerSpectraWriter(OutputWithSidecar& output, const TableSource& source, int terms,
                     TableNormalisation normalisation);

  /// Writes the next power. Throws Errc::cannot_write.
  void write(const brdf::HalfSpectrum& spectrum);
  /// Of the powers written so far.
  std::span<const brdf::SpectrumExtrema> extrema() const { return extrema_; }
  /// Puts tables and sidecar in place; `parameters`, and with the extrema's normalisation `extrema`
  /// and `error`, are added to the sidecar. beside: finished files that belong to them.
  Json commit(Json sidecar, std::vector<OutputFile*> beside = {});

  /// Bytes of the file.
  static std::size_t file_bytes(const brdf::PowerSpectraShape& shape);

 private:
  OutputWithSidecar* output_;
  Json parameters_;
  TableNormalisation normalisation_;
  double pixels_;
  std::vector<brdf::SpectrumExtrema> extrema_;
};

/// Tables that were read.
struct PowerSpectraFile {
  std::shared_ptr<const brdf::PowerSpectra> spectra;  ///< reads one power at a time from the file
  std::string sha256;                                 ///< of the tables
};

/// Opens tables and holds them against their sidecar and against the heights that they shall be of.
/// Values normalised by their extrema are rescaled as they are read (Errata E24).
///
/// Throws Errc::bad_input, one line naming the file and what differs: no NPY file, no sidecar, a
/// shape, a type or a number in the sidecar that cannot be, tables of other heights, a hash that is
/// not the file's.
PowerSpectraFile read_power_spectra(const std::filesystem::path& path, const TableSource& source);

}  // namespace evaluation
