// The header of a Surface Data File.
#pragma once

#include <cstdint>
#include <string>

#include "evaluation/readers/file_source.h"

namespace evaluation::detail {

/// The fields that are read, the same in text and binary.
struct SdfHeader {
  std::uint64_t cols = 0, rows = 0;
  double x_scale_m = 0, y_scale_m = 0, z_scale_m = 0;
  std::uint64_t compression = 0, data_type = 0, check_type = 0;
  std::uint64_t size = 0;  ///< of the header: the data begin behind it
};

/// Throws Errc::bad_input for a header that does not end within the head of the file, a field that
/// is missing or no number, a scale that is not positive.
SdfHeader read_sdf_header(const FileSource& source);

/// Whether a file begins as text.
bool is_sdf_text(std::string_view head);

}  // namespace evaluation::detail
