#include "apps/commands/tables_options.h"

namespace apps {

evaluation::TableSource table_source(const HeightOptions& heights,
                                     const evaluation::HeightFile& input) {
  return {&input, heights.reduction, heights.level_name()};
}

void TablesOptions::add_to(CLI::App* sweep) {
  add_parsed(sweep, "--tables", file, parse_path,
             "taylor, pq: tables of these heights, made by precompute (default: computed)", "FILE");
}

void TablesOptions::require_consistent(const std::string& output) const {
  if (given() && !output.empty()) require_other_file(output, file);
}

std::shared_ptr<const brdf::PowerSpectra> TablesOptions::read(const HeightOptions& heights,
                                                              const evaluation::HeightFile& input) {
  if (!given()) return nullptr;
  evaluation::PowerSpectraFile tables =
      evaluation::read_power_spectra(file, table_source(heights, input));
  sha256_ = tables.sha256;
  return tables.spectra;
}

}  // namespace apps
