// What the sidecar of tables of a Taylor series says.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/power_spectra.h"
#include "brdf/spectrum_extrema.h"
#include "evaluation/npy.h"
#include "evaluation/readers/height_reader.h"
#include "evaluation/writers/output_file.h"

namespace evaluation {

/// How the values of tables are stored.
enum class TableNormalisation {
  none,     ///< as they are
  extrema,  ///< each power's real and imaginary parts scaled to [0, 1], as the sources do
};

std::string_view name_of(TableNormalisation normalisation);

/// The heights that tables are made of, and how they were prepared. Refers to the input.
struct TableSource {
  const HeightFile* input;  ///< reduced and levelled
  int reduction;
  std::string level;
};

/// What tables and heights must have in common beside the input, by name, what the user sets before
/// what follows from it.
Json heights_json(const TableSource& source);
Json extrema_json(const brdf::SpectrumExtrema& extrema);

/// The shape of the array in the file, and the pixels of its grid.
NpyShape npy_shape(const brdf::PowerSpectraShape& shape);
double pixels_of(const brdf::PowerSpectraShape& shape);

/// The sidecar of tables as it is found: anything may stand in it. All throw Errc::bad_input with
/// one line that names the file, the value and what it must be.
class TableSidecar {
 public:
  /// Reads it.
  explicit TableSidecar(const std::filesystem::path& tables);

  void require_source(const TableSource& source) const;
  int terms() const;
  TableNormalisation normalisation() const;
  /// One for each term.
  std::vector<brdf::SpectrumExtrema> extrema(const brdf::PowerSpectraShape& shape) const;
  void require_shape(const NpyShape& found, const brdf::PowerSpectraShape& shape) const;
  void require_hash(const std::string& sha256) const;

 private:
  const Json& at(const std::string& place) const;
  brdf::Extrema part(const std::string& place, double largest) const;
  [[noreturn]] void refuse_value(const std::string& place, const std::string& must) const;

  std::filesystem::path tables_, path_;
  Json json_;
};

}  // namespace evaluation
