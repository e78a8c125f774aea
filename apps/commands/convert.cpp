// shedlight convert: a height file of any format, in one of ours.
#include <array>
#include <memory>

#include "apps/commands/commands.h"
#include "apps/options.h"
#include "evaluation/writers/gsf_writer.h"
#include "evaluation/writers/npy_writer.h"
#include "evaluation/writers/text_writer.h"

namespace apps {
namespace {

using evaluation::HeightFile;
using evaluation::Json;

struct Options {
  HeightOptions heights;
  std::string output;
};

struct OutputFormat {
  const char* extension;
  const char* unit;  ///< of the heights in it
  std::string (*bytes)(const HeightFile& input);
};

constexpr const char* npy = ".npy";

constexpr std::array formats{OutputFormat{".gsf", "m, 32 bit",
                                          [](const HeightFile& input) {
                                            return evaluation::to_gsf(input.field, input.channel);
                                          }},
                             OutputFormat{npy, "um",
                                          [](const HeightFile& input) {
                                            return evaluation::to_npy(input.field.heights_um());
                                          }},
                             OutputFormat{".txt", "um", [](const HeightFile& input) {
                                            return evaluation::to_text(input.field, input.channel);
                                          }}};

const OutputFormat& format_of(const std::string& output) {
  for (const OutputFormat& format : formats)
    if (evaluation::has_extension(output, format.extension)) return format;
  throw brdf::Error(brdf::Errc::invalid_argument,
                    "--output " + output + ": the name must end in .gsf, .npy or .txt");
}

/// Places of the pixel centres; the middle is 0, as everywhere.
std::vector<double> centres_um(Eigen::Index count, double pixel_um) {
  std::vector<double> places;
  for (Eigen::Index i = 0; i < count; ++i)
    places.push_back((static_cast<double>(i) - static_cast<double>(count - 1) / 2) * pixel_um);
  return places;
}

void run(const Options& options) {
  const OutputFormat& format = format_of(options.output);
  require_other_file(options.output, options.heights.file);
  evaluation::OutputWithSidecar output(options.output);
  std::optional<evaluation::NpyAxes> axes;
  if (format.extension == npy)
    axes.emplace(options.output, std::vector<std::string>{"x_um", "y_um"});
  const HeightFile input = options.heights.read();
  const brdf::HeightField& field = input.field;
  Json sidecar = sidecar_head("convert", options.heights.file, input.sha256);
  sidecar["parameters"] = options.heights.parameters(field);
  sidecar["parameters"]["height_unit"] = format.unit;
  sidecar["parameters"]["missing_filled"] = input.filled;
  const std::string bytes = format.bytes(input);
  if (axes) {
    const auto x = centres_um(field.cols(), field.dx_um()),
               y = centres_um(field.rows(), field.dy_um());
    sidecar["axes"] = axes->write({x, y});
  }
  output.commit(bytes, std::move(sidecar),
                axes ? axes->files() : std::vector<evaluation::OutputFile*>{});
}

}  // namespace

void add_convert(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* convert = app.add_subcommand("convert", "Write a height file as GSF, NPY or text");
  convert->footer(
      "The name of the output says the format: .gsf (metres, 32 bit), .npy (um, 64 bit, with\n"
      "FILE.x_um.npy and FILE.y_um.npy beside it), .txt (um, all digits, Gwyddion's header).\n"
      "Example:\n"
      "  shedlight convert scan.gwy --channel Height --level plane -o scan.gsf");
  options->heights.add_to(convert);
  add_output(convert, options->output, "the file: .gsf, .npy or .txt")->required();
  convert->callback([options] { run(*options); });
}

}  // namespace apps
