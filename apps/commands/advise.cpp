// shedlight advise: what a scene requires of the model.
#include <fmt/format.h>

#include <memory>

#include "apps/advice_report.h"
#include "apps/commands/commands.h"
#include "apps/commands/illuminated_options.h"
#include "apps/commands/scene_options.h"
#include "apps/console.h"
#include "apps/memory_limit.h"
#include "apps/quantities.h"

namespace apps {
namespace {

using evaluation::AxisOrigin;
using evaluation::Json;

/// As sweep's.
constexpr double default_tolerance = 1e-6;
/// A finger's width at arm's length: what is told apart at a glance. The eye's best is 1/60 deg.
constexpr brdf::Angle default_resolution = brdf::Angle::deg(1);

struct AdviseOptions {
  HeightOptions heights;
  std::optional<brdf::Angle> theta_i;
  brdf::Angle phi_i;
  double tolerance = default_tolerance;
  brdf::Angle resolution = default_resolution;
  IlluminatedOptions illuminated;
  std::optional<evaluation::Axis> theta_r_deg, lambda_nm;
  std::optional<std::size_t> memory_limit;
  bool json = false;
};

/// All viewing angles but the horizon, where a step of 1 deg is enough to find those that are
/// sampled; visible light.
const std::string all_angles = "-89:89:1deg", visible_light = "380:780:5nm";

AxisOrigin origin_of(const std::optional<evaluation::Axis>& axis) {
  return axis ? AxisOrigin::asked : AxisOrigin::assumed;
}

evaluation::AdviceScene scene_of(AdviseOptions& options, const brdf::HeightField& field) {
  options.illuminated.resolve(evaluation::method_named("auto"));
  return {options.illuminated.surface(field, brdf::Origin::patch_centre),
          {*options.theta_i, options.phi_i, options.phi_i,
           options.lambda_nm.value_or(parse_length_axis("--lambda", visible_light)),
           options.theta_r_deg.value_or(parse_angle_axis("--theta-r", all_angles))},
          origin_of(options.theta_r_deg),
          origin_of(options.lambda_nm),
          options.tolerance,
          options.resolution};
}

/// A word as a shell reads it.
std::string shell_word(const std::string& word) {
  const std::string plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string um(brdf::Length length) {
  return brdf::text(length.um()) + "um";
}

std::string range_text(const evaluation::Axis& axis, double step, const char* unit) {
  if (axis.size() < 2) return brdf::text(axis.front()) + unit;
  // The last value is a sum of steps: ten digits leave its rounding out.
  return fmt::format("{}:{:.10g}:{:.10g}{}", brdf::text(axis.front()), axis.back(), step, unit);
}

/// The sweep that the advice recommends, a word or an option with its value at a time.
std::vector<std::string> command_words(const AdviseOptions& options,
                                       const evaluation::AdviceScene& scene,
                                       const evaluation::Advice& advice) {
  const evaluation::MethodAdvice& method = advice.method;
  const evaluation::HeightScale& scale = options.heights.choice.scale;
  std::vector<std::string> words{"shedlight sweep", shell_word(options.heights.file)};
  const auto option = [&](const std::string& name, const std::string& value) {
    words.push_back(name + " " + value);
  };
  if (scale.width) option("--width", um(*scale.width));
  if (scale.pixel) option("--pixel", um(scale.pixel->first) + "," + um(scale.pixel->second));
  if (scale.height_range) option("--height-range", um(*scale.height_range));
  if (scale.height_unit) option("--height-unit", um(*scale.height_unit));
  const evaluation::HeightChoice& choice = options.heights.choice;
  if (choice.channel) option("--channel", shell_word(*choice.channel));
  if (choice.missing != evaluation::MissingHeights::refuse)
    option("--missing", name_in(missing_choices, choice.missing));
  if (options.heights.reduction > 1) option("--reduce", std::to_string(options.heights.reduction));
  const brdf::Level asked = options.heights.level.value_or(brdf::Level::none);
  const brdf::Level level = method.level == brdf::Level::plane ? method.level : asked;
  if (level != brdf::Level::none) option("--level", name_in(level_choices, level));
  option("--theta-i", brdf::text(scene.request.theta_i.deg()) + "deg");
  option("--phi-i", brdf::text(scene.request.phi_i.deg()) + "deg");
  option("--theta-r", range_text(method.request.theta_r_deg, advice.steps.theta_deg, "deg"));
  option("--lambda", range_text(method.request.lambda_nm, advice.steps.lambda_nm, "nm"));
  if (method.optics == evaluation::OpticsVerdict::geometric) {
    option("--method", "microfacet");
    return words;
  }
  if (scene.surface.model == brdf::SurfaceModel::replicated)
    option("--replicas", fmt::format("{},{}", scene.surface.replicas.x, scene.surface.replicas.y));
  else
    option("--sigma", um(brdf::Length::um(scene.surface.window.sigma_um())));
  option("--surface", std::string(evaluation::name_of(scene.surface.model)));
  option("--tolerance", brdf::text(method.tolerance));
  return words;
}

/// Words in lines of at most 100 columns, continued as a shell continues them.
std::string wrapped(const std::vector<std::string>& words) {
  constexpr std::size_t columns = 98;  // and " \"
  std::string text, line;
  for (const std::string& word : words) {
    if (!line.empty() && line.size() + 1 + word.size() > columns) {
      text += line + " \\\n";
      line = "   ";
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return text + line + "\n";
}

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
  return line;
}

void run(AdviseOptions options) {
  const evaluation::HeightFile input = options.heights.read();
  const evaluation::AdviceScene scene = scene_of(options, input.field);
  require_memory({options.heights.file, "the advice", evaluation::advice_bytes(input.field),
                  "--reduce needs less"},
                 options.memory_limit);
  const evaluation::Advice advice =
      brdf::at_place(options.heights.file, [&] { return evaluation::advise(scene); });
  const std::vector<Section> sections = sections_of(advice, scene);
  const std::vector<std::string> command = command_words(options, scene, advice);
  if (!options.json) {
    print(page(sections) + wrapped(command));
    return;
  }
  Json all{{"file", options.heights.file}, {"sha256", input.sha256}};
  all["scene"] = options.heights.parameters(input.field);
  all["scene"].update(scene_json(scene.request));
  all["scene"].update(illuminated_json(scene.surface));
  all.update(json(sections));
  all["command"] = joined(command);
  print(evaluation::json_text(all));
}

}  // namespace

void add_advise(CLI::App& app) {
  auto options = std::make_shared<AdviseOptions>();
  CLI::App* advise = app.add_subcommand("advise", "Say what a scene requires of the model");
  advise->footer(
      "Every line says why; the last is the sweep to run. docs/advise.md explains each.\n"
      "Example:\n"
      "  shedlight advise scan.png --width 65um --height-range 818.69nm --theta-i 75deg \\\n"
      "    --phi-i 90deg");
  options->heights.add_to(advise);
  add_parsed(advise, "--theta-i", options->theta_i, parse_angle, "angle of incidence", "ANGLE")
      ->required();
  add_parsed(advise, "--phi-i", options->phi_i, parse_angle,
             "azimuth of the light, and of the plane the viewer moves in (default 0deg)", "ANGLE");
  add_parsed(advise, "--theta-r", options->theta_r_deg, parse_angle_axis,
             "viewing angles, positive on the light's side (default -89 to 89 deg)",
             "START:STOP:STEP");
  add_parsed(advise, "--lambda", options->lambda_nm, parse_length_axis,
             "wavelengths (default 380 to 780 nm)", "START:STOP:STEP");
  options->illuminated.add_to(advise);
  add_parsed(advise, "--tolerance", options->tolerance, parse_number,
             "largest error of the amplitude, flat patch's peak = 1 (default 1e-6)", "NUMBER");
  add_parsed(advise, "--resolution", options->resolution, parse_angle,
             "directions that the viewer tells apart (default 1deg)", "ANGLE");
  add_memory_limit(advise, options->memory_limit);
  advise->add_flag("--json", options->json, "as JSON");
  advise->callback([options] { run(*options); });
}

}  // namespace apps
