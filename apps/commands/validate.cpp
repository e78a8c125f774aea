// shedlight validate: two responses held against each other, or the program against closed forms.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "apps/check_table.h"
#include "apps/colour_warnings.h"
#include "apps/commands/commands.h"
#include "apps/console.h"
#include "apps/exit_codes.h"
#include "apps/options.h"
#include "apps/quantities.h"
#include "evaluation/map_difference.h"
#include "evaluation/npy.h"
#include "evaluation/readers/file_bytes.h"
#include "evaluation/response_difference.h"
#include "evaluation/self_check.h"

namespace apps {
namespace {

struct ValidateOptions {
  std::string file, reference;
  std::optional<double> max_error;
  std::optional<double> exposure;
  bool self = false;
  bool json = false;
};

evaluation::ResponseMatrix read(const std::string& file, evaluation::CsvContent content) {
  return evaluation::response_from_csv(evaluation::read_file_bytes(file), file, content);
}

/// Throws where the axes hold other values than the reference's; says where they hold them in
/// another order.
void require_same_axis(const ValidateOptions& options, const evaluation::Axis& axis,
                       const evaluation::Axis& reference, const std::string& name) {
  const auto misplaced = brdf::at_place(options.file + " and " + options.reference, [&] {
    return evaluation::out_of_order(axis, reference, name);
  });
  if (!misplaced) return;
  print(fmt::format("FAILED: {} {} stands where {} has {}\n", name, misplaced->found,
                    options.reference, misplaced->expected));
  throw ValidationFailed{};
}

std::string verdict(double worst, double allowed) {
  return worst <= allowed ? "passed" : "FAILED";
}

/// Maps: how different their colours look.
void run_maps(const ValidateOptions& options) {
  if (!options.exposure)
    throw brdf::Error(brdf::Errc::invalid_argument,
                      "maps are compared as they are shown: give --exposure, as their sidecars "
                      "state it");
  const evaluation::MapDifference found =
      map_difference(evaluation::read_map(options.file), evaluation::read_map(options.reference),
                     *options.exposure);
  print(fmt::format(
      "{}: CIEDE2000 at exposure {:.6g}: worst {:.3g} in light {}, row {}, column "
      "{}; mean {:.3g}, 99 % below {:.3g}, of {} pixels; allowed {:.3g}\n",
      verdict(found.worst, *options.max_error), *options.exposure, found.worst, found.light,
      found.row, found.column, found.mean, found.percentile_99, found.pixels, *options.max_error));
  if (!(found.worst <= *options.max_error)) throw ValidationFailed{};
}

/// The program itself.
void run_self(const ValidateOptions& options) {
  require_not_given({{!options.file.empty(), "response"},
                     {!options.reference.empty(), "reference"},
                     {options.max_error.has_value(), "--max-error"},
                     {options.exposure.has_value(), "--exposure"}},
                    "--self");
  const std::vector<evaluation::CheckRow> rows = evaluation::self_check();
  print(options.json ? evaluation::json_text(table_json(rows)) : table_for_people(rows));
  if (!all_hold(rows)) throw ValidationFailed{};
}

void require_given(const ValidateOptions& options) {
  const auto require = [](bool given, const char* what) {
    if (!given)
      throw brdf::Error(brdf::Errc::invalid_argument,
                        std::string(what) + " is required, or --self (see --help)");
  };
  require(!options.file.empty(), "response");
  require(!options.reference.empty(), "reference");
  require(options.max_error.has_value(), "--max-error");
  require_not_given({{options.json, "--json"}}, "responses and maps; it goes with --self");
}

void run(const ValidateOptions& options) {
  if (options.self) return run_self(options);
  require_given(options);
  if (!(*options.max_error >= 0))
    throw brdf::Error(brdf::Errc::invalid_argument,
                      "--max-error " + brdf::text(*options.max_error) + ": must be >= 0");
  if (evaluation::is_npy(options.file) && evaluation::is_npy(options.reference))
    return run_maps(options);
  if (options.exposure)
    throw brdf::Error(brdf::Errc::invalid_argument,
                      "--exposure has no meaning for responses; it goes with the NPY of maps");
  const auto response = read(options.file, evaluation::CsvContent::as_written);
  const auto reference = read(options.reference, evaluation::CsvContent::checked);
  require_same_axis(options, response.lambda_nm, reference.lambda_nm, "lambda_nm");
  require_same_axis(options, response.theta_r_deg, reference.theta_r_deg, "theta_r_deg");
  const evaluation::ResponseDifference found = response_difference(response, reference);
  const double worst = found.worst;
  const std::size_t row = found.row, column = found.column;
  const auto value = [row, column](const evaluation::ResponseMatrix& of) {
    return of.values(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
  };
  print(fmt::format(
      "{}: largest difference {:.3g} at {} nm, {} deg ({:.6g} against {:.6g}); "
      "allowed {:.3g}\n",
      verdict(worst, *options.max_error), worst, reference.lambda_nm[row],
      reference.theta_r_deg[column], value(response), value(reference), *options.max_error));
  if (!(worst <= *options.max_error)) throw ValidationFailed{};
}

}  // namespace

void add_validate(CLI::App& app) {
  auto options = std::make_shared<ValidateOptions>();
  CLI::App* validate =
      app.add_subcommand("validate",
                         "Compare two responses, or two maps; exit 1 where they differ "
                         "too much. --self: the program with closed forms");
  validate->footer(
      "Maps, the NPY files of map, are compared by CIEDE2000 at the exposure they are shown at.\n"
      "Example:\n"
      "  shedlight validate taylor.csv direct.csv --max-error 1e-6\n"
      "  shedlight validate baked.npy map.npy --exposure 6460 --max-error 3\n"
      "  shedlight validate --self");
  add_parsed(validate, "response", options->file, parse_path,
             "CSV of sweep or NPY of map, to be judged", "FILE");
  add_parsed(validate, "reference", options->reference, parse_path, "what to judge it by", "FILE");
  add_parsed(validate, "--max-error", options->max_error, parse_number,
             "largest difference allowed in any cell, or CIEDE2000 in any pixel", "NUMBER");
  add_parsed(validate, "--exposure", options->exposure, parse_exposure,
             "maps: factor of the light that they are shown at", "NUMBER");
  validate->add_flag("--self", options->self,
                     "check the program against closed forms and identities instead");
  validate->add_flag("--json", options->json, "with --self: the table as JSON");
  validate->callback([options] { run(*options); });
}

}  // namespace apps
