// shedlight: the command line.
#include <CLI/CLI.hpp>
#include <new>
#include <sstream>
#include <string>

#include "apps/commands/commands.h"
#include "apps/console.h"
#include "apps/exit_codes.h"
#include "apps/process.h"
#include "apps/version.h"
#include "brdf/error.h"
#include "evaluation/readers/height_formats.h"

namespace {

/// CLI11 says "a subcommand is required" whatever the first word was: name it instead.
void require_known_command(const CLI::App& app, int argc, char** argv) {
  const auto refuse = [&](const std::string& what) {
    std::string names;
    for (const CLI::App* command : app.get_subcommands({}))
      names += (names.empty() ? "" : ", ") + command->get_name();
    throw brdf::Error(brdf::Errc::invalid_argument,
                      what + "; subcommands are " + names + " (see --help)");
  };
  if (argc < 2) refuse("no subcommand given");
  const std::string first = argv[1];
  if (first == "--help" || first == "-h" || first == "--version") return;
  if (first.starts_with("-")) refuse("unknown option " + first + " before the subcommand");
  for (const CLI::App* command : app.get_subcommands({}))
    if (command->get_name() == first) return;
  refuse("unknown subcommand " + first);
}

/// The version, and the height files that this build reads.
std::string version_text() {
  std::string read, missing;
  for (const evaluation::HeightFormat& format : evaluation::height_formats()) {
    std::string& list = format.is_built_in ? read : missing;
    list.append(list.empty() ? "" : ", ").append(format.name);
    if (!format.is_built_in) list.append(" (made without ").append(format.library).append(")");
  }
  return std::string("shedlight ") + apps::version + " (" + apps::commit + ")\nreads " + read +
         ", and what gwyddion converts" + (missing.empty() ? "" : "\nnot read: " + missing);
}

int run(int argc, char** argv) {
  CLI::App app{"Diffraction from measured and synthetic gratings: response, peaks, period."};
  app.name("shedlight");
  app.set_version_flag("--version", version_text());
  app.footer(
      "Example:\n"
      "  shedlight synth blazed --period 2500nm --height 200nm --size 65um --pixels 650 -o g.gsf\n"
      "  shedlight sweep g.gsf --theta-i 75deg --theta-r -55:-40:0.05deg --lambda 380:780:5nm "
      "-o R.csv\n"
      "  shedlight period R.csv --order 1");
  app.require_subcommand(1);
  apps::add_synth(app);
  apps::add_info(app);
  apps::add_convert(app);
  apps::add_advise(app);
  apps::add_precompute(app);
  apps::add_sweep(app);
  apps::add_peaks(app);
  apps::add_period(app);
  apps::add_ridges(app);
  apps::add_plot(app);
  apps::add_colour(app);
  apps::add_map(app);
  apps::add_bake(app);
  apps::add_render(app);
  apps::add_albedo(app);
  apps::add_tradeoff(app);
  apps::add_stability(app);
  apps::add_validate(app);
  apps::add_completion(app);
  apps::add_manual(app);
  require_known_command(app, argc, argv);
  try {
    app.parse(argc, argv);
    return apps::exit_done;
  } catch (const CLI::Success& asked) {  // --help, --version
    std::ostringstream text;
    app.exit(asked, text, text);
    apps::print(text.str());
    return apps::exit_done;
  } catch (const CLI::ParseError& error) {
    apps::message(std::string(error.what()) + " (see --help)");
    return apps::exit_usage;
  }
}

}  // namespace

int main(int argc, char** argv) {
  apps::prepare_process();
  try {
    return run(argc, argv);
  } catch (const apps::ValidationFailed&) {
    return apps::exit_validation_failed;
  } catch (const brdf::Error& error) {
    apps::message(error.what());
    return apps::exit_code(error.code());
  } catch (const std::bad_alloc&) {
    apps::message("out of memory; --reduce or a smaller range needs less");
    return apps::exit_over_limit;
  } catch (const std::exception& error) {
    apps::message(std::string("internal error: ") + error.what());
    return apps::exit_internal;
  }
}
