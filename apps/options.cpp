#include "apps/options.h"

#include <filesystem>
#include <limits>

#include "apps/quantities.h"
#include "apps/version.h"
#include "brdf/error.h"

namespace apps {

namespace fs = std::filesystem;
using brdf::Errc;
using brdf::Error;

const Choices<brdf::Level> level_choices{
    {"none", brdf::Level::none}, {"mean", brdf::Level::mean}, {"plane", brdf::Level::plane}};

const Choices<evaluation::MissingHeights> missing_choices{
    {"refuse", evaluation::MissingHeights::refuse},
    {"neighbours", evaluation::MissingHeights::neighbours}};

std::string parse_path(const std::string& option, const std::string& text) {
  if (text.empty()) throw Error(Errc::invalid_argument, option + ": the file name is empty");
  if (text.front() == '-')
    throw Error(Errc::invalid_argument, option + " " + text +
                                            ": looks like an option, not a file (a file of that "
                                            "name is written ./" +
                                            text + ")");
  return text;
}

void HeightOptions::add_to(CLI::App* app) {
  add_parsed(app, "file", file, parse_path, "height field, of a format that --version lists",
             "FILE")
      ->required();
  add_preparation_to(app);
}

void HeightOptions::add_preparation_to(CLI::App* app) {
  evaluation::HeightScale& scale = choice.scale;
  CLI::Option* width =
      add_parsed(app, "--width", scale.width, parse_length, "columns x pixel, e.g. 65um", "LENGTH");
  add_parsed(app, "--pixel", scale.pixel, parse_length_pair, "pixel, or pixel along x,y",
             "LENGTH[,LENGTH]")
      ->excludes(width);
  add_parsed(app, "--height-range", scale.height_range, parse_length,
             "height of the full-scale code of an integer image, e.g. 818.69nm", "LENGTH");
  add_parsed(app, "--height-unit", scale.height_unit, parse_length,
             "length of one unit of floating-point heights, e.g. 1nm", "LENGTH");
  add_parsed(
      app, "--channel", choice.channel,
      [](const std::string&, const std::string& text) { return text; },
      "title or number of the channel, where a file holds several", "NAME");
  add_choice(app, "--missing", choice.missing, missing_choices,
             "pixels that the file masks or that are not a number (default refuse)");
  add_parsed(app, "--max-pixels", choice.max_pixels,
             count_between(1, std::numeric_limits<int>::max()),
             "refuse files of more pixels (default 2^28)", "N");
  add_parsed(app, "--reduce", reduction, count_between(1, 1 << 14),
             "average N x N blocks of pixels", "N");
  add_choice(app, "--level", level, level_choices,
             "what is subtracted from the heights (default none)");
}

std::string HeightOptions::level_name() const {
  return name_in(level_choices, level.value_or(brdf::Level::none));
}

evaluation::Json HeightOptions::parameters(const brdf::HeightField& field) const {
  evaluation::Json json{{"columns", field.cols()},
                        {"rows", field.rows()},
                        {"pixel_um", {field.dx_um(), field.dy_um()}},
                        {"reduce", reduction},
                        {"level", level_name()}};
  const evaluation::HeightScale& scale = choice.scale;
  if (scale.height_range) json["height_range_nm"] = scale.height_range->nm();
  if (choice.channel) json["channel"] = *choice.channel;
  if (choice.missing != evaluation::MissingHeights::refuse)
    json["missing"] = name_in(missing_choices, choice.missing);
  return json;
}

evaluation::HeightFile HeightOptions::read() const {
  const auto positive = [](const char* option, const std::optional<brdf::Length>& length) {
    if (length && !(length->um() > 0))
      throw Error(Errc::invalid_argument,
                  std::string(option) + " " + brdf::text(length->um()) + "um: must be > 0");
  };
  const evaluation::HeightScale& scale = choice.scale;
  positive("--width", scale.width);
  positive("--height-range", scale.height_range);
  positive("--height-unit", scale.height_unit);
  evaluation::HeightFile input = evaluation::read_heights(file, choice);
  input.field =
      brdf::levelled(brdf::reduced(input.field, reduction), level.value_or(brdf::Level::none));
  return input;
}

void require_not_given(std::initializer_list<Given> options, const std::string& what) {
  for (const auto& [is_given, option] : options)
    if (is_given)
      throw Error(Errc::invalid_argument, std::string(option) + " has no meaning for " + what);
}

CLI::Option* add_output(CLI::App* app, std::string& output, const std::string& help) {
  return add_parsed(app, "-o,--output", output, parse_path, help, "FILE");
}

void require_other_file(const std::string& output, const std::string& input) {
  std::error_code ec;
  for (const fs::path& written : {fs::path(output), evaluation::sidecar_path(output)})
    for (const fs::path& read : {fs::path(input), evaluation::sidecar_path(input)})
      if (fs::exists(written, ec) && fs::equivalent(written, read, ec))
        throw Error(Errc::invalid_argument, "output " + written.string() +
                                                " is the input, or belongs to it; give another "
                                                "name");
}

void require_apart(const std::string& output, const std::string& picture) {
  if (!output.empty() && fs::weakly_canonical(output) == fs::weakly_canonical(picture))
    throw Error(Errc::invalid_argument, "--plot " + picture + " is the output; give another name");
}

evaluation::Json sidecar_head(const std::string& command, const std::string& input,
                              const std::string& input_sha256) {
  evaluation::Json head;
  head["shedlight"] = {{"version", version}, {"commit", commit}};
  head["command"] = command;
  if (!input.empty()) head["input"] = {{"file", input}, {"sha256", input_sha256}};
  return head;
}

evaluation::Json axis_json(const evaluation::Axis& axis) {
  evaluation::Json json{{"first", axis.front()}, {"last", axis.back()}, {"count", axis.size()}};
  if (axis.size() > 1)
    json["step"] = (axis.back() - axis.front()) / static_cast<double>(axis.size() - 1);
  return json;
}

}  // namespace apps
