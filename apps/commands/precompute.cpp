// shedlight precompute: the tables of a Taylor series, once and for all sweeps of a height field.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "apps/commands/commands.h"
#include "apps/commands/table_pictures.h"
#include "apps/commands/tables_options.h"
#include "apps/console.h"
#include "apps/memory_limit.h"
#include "apps/options.h"
#include "apps/quantities.h"
#include "brdf/taylor_bounds.h"
#include "evaluation/power_spectra_file.h"

namespace apps {
namespace {

namespace fs = std::filesystem;
using evaluation::Json;
using evaluation::PowerSpectraWriter;
using evaluation::TableNormalisation;

const Choices<TableNormalisation> normalisation_choices{{"none", TableNormalisation::none},
                                                        {"extrema", TableNormalisation::extrema}};

struct PrecomputeOptions {
  HeightOptions heights;
  int terms = 0;
  TableNormalisation normalisation = TableNormalisation::none;
  std::string output, pictures;
  std::optional<std::size_t> memory_limit;
};

/// The same for every way to write a path, also of a file that is not there yet.
fs::path resolved(const fs::path& path) {
  return fs::weakly_canonical(fs::absolute(path));
}

/// Refuses files that are in each other's way before any of them is opened.
void require_other_files(const PrecomputeOptions& options) {
  require_other_file(options.output, options.heights.file);
  if (options.pictures.empty()) return;
  for (const fs::path& picture : TablePictures::files(options.pictures, options.terms)) {
    require_other_file(picture.string(), options.heights.file);
    for (const fs::path& output :
         {fs::path(options.output), evaluation::sidecar_path(options.output)})
      if (resolved(picture) == resolved(output))
        throw brdf::Error(brdf::Errc::invalid_argument,
                          "output " + output.string() + " is one of the pictures as well");
  }
}

void require_limits(const PrecomputeOptions& options, const brdf::HeightField& field) {
  const brdf::ComputedPowerSpectra spectra(field);
  brdf::PowerSpectraShape shape = spectra.shape();
  shape.terms = options.terms;
  const std::size_t on_disk = PowerSpectraWriter::file_bytes(shape);
  require_memory(
      {options.heights.file, "a transform",
       spectra.visit_bytes() + static_cast<std::size_t>(field.heights_um().size()) * sizeof(double),
       fmt::format("--reduce needs less (the tables take {:.3g} MB on disk)",
                   static_cast<double>(on_disk) / 1e6)},
      options.memory_limit);
  evaluation::require_room(options.output, on_disk);
}

void run(const PrecomputeOptions& options) {
  require_other_files(options);
  evaluation::OutputWithSidecar output(options.output);
  std::optional<TablePictures> pictures;
  if (!options.pictures.empty()) pictures.emplace(options.pictures, options.terms);
  const evaluation::HeightFile input = options.heights.read();
  require_limits(options, input.field);

  const std::string title = fmt::format("{}, s = (h - {:.6g} um) / {:.6g} um",
                                        fs::path(options.heights.file).filename().string(),
                                        input.field.mid_range_um(), input.field.half_range_um());
  PowerSpectraWriter writer(output, table_source(options.heights, input), options.terms,
                            options.normalisation);
  const evaluation::Progress progress = progress_line("precompute");
  brdf::ComputedPowerSpectra(input.field)
      .visit(options.terms, [&](int power, const brdf::HalfSpectrum& spectrum) {
        writer.write(spectrum);
        if (pictures) pictures->see(power, spectrum, input.field, title);
        if (progress) progress((power + 1.0) / options.terms);
      });
  Json sidecar = sidecar_head("precompute", options.heights.file, input.sha256);
  if (pictures) sidecar["pictures"] = pictures->finish(writer.extrema(), title);
  writer.commit(std::move(sidecar),
                pictures ? pictures->outputs() : std::vector<evaluation::OutputFile*>{});
}

}  // namespace

void add_precompute(CLI::App& app) {
  auto options = std::make_shared<PrecomputeOptions>();
  CLI::App* precompute = app.add_subcommand(
      "precompute", "Tables of the Taylor series, for sweeps with taylor or pq, as an NPY file");
  precompute->footer(
      "The file takes terms x rows x (columns / 2 + 1) x 16 bytes: 102 MB for 30 terms of\n"
      "650 x 650 pixels. In memory there is one transform at a time. How many terms a sweep needs\n"
      "is said by its --method taylor --explain.\n"
      "Example:\n"
      "  shedlight precompute scan.png --width 65um --height-range 818.69nm --terms 36 \\\n"
      "    -o tables.npy\n"
      "  shedlight sweep scan.png --width 65um --height-range 818.69nm --theta-i 75deg \\\n"
      "    --theta-r -50:-25:0.05deg --lambda 380:780:1nm --tables tables.npy -o R.csv");
  options->heights.add_to(precompute);
  add_parsed(precompute, "--terms", options->terms, count_between(1, brdf::max_taylor_terms),
             "number of tables, powers 0 to N-1", "N")
      ->required();
  add_choice(precompute, "--normalise", options->normalisation, normalisation_choices,
             "extrema: real and imaginary part of each table scaled to [0, 1], as the sources do "
             "(default none)");
  add_parsed(precompute, "--pictures", options->pictures, parse_path,
             "folder for pictures of the extrema and of the first 8 tables", "FOLDER");
  add_output(precompute, options->output, "NPY file, with its sidecar FILE.json")->required();
  add_memory_limit(precompute, options->memory_limit);
  precompute->callback([options] { run(*options); });
}

}  // namespace apps
