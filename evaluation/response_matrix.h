// The response of a surface over wavelength and viewing angle, and its CSV forms.
#pragma once

#include <string>
#include <string_view>

#include "brdf/height_field.h"
#include "evaluation/axis.h"

namespace evaluation {

/// R(lambda_i, theta_j) (Thesis 2.3): one row per wavelength, one column per viewing angle.
struct ResponseMatrix {
  Axis lambda_nm;
  Axis theta_r_deg;          ///< signed, positive on the side of the azimuth phi_r
  brdf::HeightArray values;  ///< lambda_nm.size() x theta_r_deg.size()
};

enum class CsvLayout {
  matrix,      ///< header `lambda_nm`, then the angles; one row per wavelength
  long_table,  ///< lambda_nm,theta_r_deg,value
};

/// The CSV text of a response; numbers as short as reads back the same, axes as they were asked.
std::string to_csv(const ResponseMatrix& response, CsvLayout layout);

/// What a response that is read may hold.
enum class CsvContent {
  checked,     ///< finite values on axes that increase
  as_written,  ///< to be judged: values that are not finite and rows in any order, too
};

/// Reads either layout, told by the header.
///
/// Throws brdf::Error(Errc::bad_input) naming `name`, line, column and value for: a wrong header, a
/// number that is none, a row of another length, a wavelength that is not positive, an angle of 90
/// deg or more, a long table that is no full grid; and where the content is to be checked for a
/// value that is not finite and an axis that does not increase.
ResponseMatrix response_from_csv(std::string_view csv, const std::string& name,
                                 CsvContent content = CsvContent::checked);

}  // namespace evaluation
