// The real scans that have an oracle: their scales, and sums made in another language.
#pragma once

#include <catch2/catch.hpp>
#include <complex>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "evaluation/readers/height_reader.h"
#include "tests/support/amplitudes.h"
#include "tests/support/oracle_table.h"

/// One direction and wavelength of a scan, and its amplitude, right to about 1e-13.
struct ScanCase {
  double sigma_um;
  brdf::Query query;
  std::complex<double> amplitude;
};

/// direct_real_scans.csv by file; its columns are
/// file,sigma_um,theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,lambda_nm,re,im
inline std::map<std::string, std::vector<ScanCase>> scan_cases() {
  using brdf::Angle;
  std::map<std::string, std::vector<ScanCase>> by_file;
  for (const OracleRow& row : oracle_table("direct_real_scans.csv")) {
    REQUIRE(row.size() == 9);
    std::vector<double> v;
    for (std::size_t i = 1; i < row.size(); ++i) v.push_back(number(row[i]));
    by_file[row[0]].push_back(
        {v[0],
         query(brdf::direction(Angle::deg(v[1]), Angle::deg(v[2])),
               brdf::direction(Angle::deg(v[3]), Angle::deg(v[4])), brdf::Length::nm(v[5])),
         {v[6], v[7]}});
  }
  return by_file;
}

inline std::vector<brdf::Query> queries_of(const std::vector<ScanCase>& cases) {
  std::vector<brdf::Query> queries;
  for (const ScanCase& c : cases) queries.push_back(c.query);
  return queries;
}

/// A scan with the scale that its maker states where the file does not.
inline evaluation::HeightFile read_scan(const std::filesystem::path& folder,
                                        const std::string& name) {
  using brdf::Length;
  evaluation::HeightChoice choice;
  evaluation::HeightScale& scale = choice.scale;
  if (name == "xenopeltis_65um.png") {
    scale.width = Length::um(65);
    scale.height_range = Length::nm(818.69);
  } else if (name == "elaphe_65um.png") {
    scale.pixel = {Length::um(0.048828125), Length::um(0.048828125)};
    scale.height_range = Length::nm(434.7);
  }
  return evaluation::read_heights(folder / name, choice);
}
