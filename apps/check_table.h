// Tables of checks: for people, as CSV and as JSON.
#pragma once

#include <string>
#include <vector>

#include "evaluation/checks.h"
#include "evaluation/writers/output_file.h"

namespace apps {

/// A line per check in aligned columns, then a line of totals.
std::string table_for_people(const std::vector<evaluation::CheckRow>& rows);

/// All columns: subject,range,unit,worst,where,limit,reason,first_refusal,verdict. Texts are
/// quoted; a number that there is none of is left empty.
std::string table_csv(const std::vector<evaluation::CheckRow>& rows);

/// An array of objects with the same names.
evaluation::Json table_json(const std::vector<evaluation::CheckRow>& rows);

}  // namespace apps
