// shedlight period: the period of a scan, or of a response.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "apps/commands/commands.h"
#include "apps/commands/response_period.h"
#include "apps/console.h"
#include "apps/options.h"
#include "apps/quantities.h"
#include "apps/surface_periods_picture.h"
#include "apps/surface_periods_report.h"
#include "brdf/levelling.h"

namespace apps {
namespace {

using evaluation::Json;
using evaluation::SurfacePeriod;

/// How far from the strongest period others are looked for, azimuth by azimuth.
constexpr double octave = 2;

struct PeriodOptions {
  std::string file;
  ResponsePeriodOptions response;
  HeightOptions heights;
  std::string picture, around;
  double around_step_deg = 1;
  bool json = false;
  /// Options that mean something for the one kind of file only.
  std::vector<const CLI::Option*> of_response, of_scan;
};

void require_none(const std::vector<const CLI::Option*>& options, const std::string& file,
                  const char* kind, const char* other) {
  for (const CLI::Option* option : options)
    if (option->count() > 0)
      throw brdf::Error(brdf::Errc::invalid_argument,
                        fmt::format("{} has no meaning for {}, {}; it goes with {}",
                                    option->get_name(), file, kind, other));
}

void run_on_scan(PeriodOptions options) {
  for (const std::string& written : {options.picture, options.around})
    if (!written.empty()) require_other_file(written, options.file);
  require_apart(options.picture, options.around);
  std::optional<PictureOutput> picture;
  std::optional<evaluation::OutputWithSidecar> around;
  if (!options.picture.empty()) picture.emplace(options.picture);
  if (!options.around.empty()) around.emplace(options.around);
  options.heights.file = options.file;
  const evaluation::HeightFile input = options.heights.read();
  const auto periods =
      brdf::at_place(options.file, [&] { return evaluation::surface_periods(input.field); });
  const auto measured = std::find_if(periods.begin(), periods.end(),
                                     [](const SurfacePeriod& one) { return one.heights; });
  if (measured == periods.end())
    throw brdf::Error(brdf::Errc::not_attainable,
                      fmt::format("{}: no period is given: {}", options.file, periods[0].reason));
  Json sidecar = sidecar_head("period", options.file, input.sha256);
  sidecar["parameters"] = options.heights.parameters(input.field);
  sidecar["result"] = to_json(periods);
  if (picture || around) {
    const auto by_azimuth = evaluation::periods_around(
        brdf::HeightSpectrum(brdf::levelled(input.field, brdf::Level::plane)),
        options.around_step_deg,
        {brdf::Length::nm(measured->heights->period_nm / octave),
         brdf::Length::nm(measured->heights->period_nm * octave)});
    if (around) around->commit(to_csv(by_azimuth), sidecar);
    if (picture)
      picture->commit(
          draw(
              SurfacePeriodsPicture{
                  &*measured, by_azimuth,
                  fmt::format("{}: period {:.2f} nm, 95 % {:.2f} to {:.2f} nm",
                              std::filesystem::path(options.file).filename().string(),
                              measured->heights->period_nm, measured->heights->interval_nm.lo,
                              measured->heights->interval_nm.hi)},
              picture->format),
          sidecar);
  }
  print(options.json ? evaluation::json_text(sidecar["result"]) : for_people(periods));
}

void run(const PeriodOptions& options) {
  if (evaluation::holds_heights(options.file)) {
    require_none(options.of_response, options.file, "a height field", "a response");
    return run_on_scan(options);
  }
  require_none(options.of_scan, options.file, "a response", "a height field");
  ResponsePeriodOptions response = options.response;
  response.response.file = options.file;
  const Json result = response_period(response);
  print(options.json ? evaluation::json_text(result) : response_period_text(result));
}

}  // namespace

void add_period(CLI::App& app) {
  auto options = std::make_shared<PeriodOptions>();
  CLI::App* period = app.add_subcommand("period", "Grating period of a scan, or of a response");
  period->footer(
      "Of a scan: the lines of its heights, their direction, and the lobes of the light that it\n"
      "would send to either side. Of a response with its sidecar: all lobes at once (--by lobes);\n"
      "without one, or with --by peaks: the brightest angles, whose standard error holds neither\n"
      "their bias nor the drift of a scan. Exit 5 without a number where the data cannot tell.\n"
      "Examples:\n"
      "  shedlight period scan.png --width 65um --height-range 434.7nm --plot period.png\n"
      "  shedlight period R.csv --order 1 --json");
  add_parsed(period, "file", options->file, parse_path, "height field, or CSV written by sweep",
             "FILE")
      ->required();
  const auto added_by = [period](const std::function<void()>& add) {
    const std::vector<CLI::Option*> before = period->get_options();
    add();
    std::vector<const CLI::Option*> added;
    for (const CLI::Option* option : period->get_options())
      if (std::find(before.begin(), before.end(), option) == before.end()) added.push_back(option);
    return added;
  };
  options->of_response = added_by([&] { options->response.add_to(period); });
  options->of_scan = added_by([&] {
    options->heights.add_preparation_to(period);
    add_parsed(period, "--plot", options->picture, parse_path,
               "PNG, SVG or PDF: lines, sub-patches, window positions, light, azimuths", "FILE");
    add_parsed(period, "--around", options->around, parse_path,
               "CSV: the period that a plane of incidence meets, azimuth by azimuth", "FILE");
    add_parsed(
        period, "--around-step", options->around_step_deg,
        [](const std::string& option, const std::string& text) {
          const double step = parse_angle(option, text).deg();
          if (!(step >= 0.01 && step <= 90))
            throw brdf::Error(brdf::Errc::invalid_argument,
                              option + " " + text + ": must lie between 0.01 and 90 deg");
          return step;
        },
        "of the azimuth (default 1deg)", "ANGLE");
  });
  period->add_flag("--json", options->json, "as JSON");
  period->callback([options] { run(*options); });
}

}  // namespace apps
