// shedlight info: what a height file holds.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "apps/commands/commands.h"
#include "apps/console.h"
#include "apps/options.h"

namespace apps {
namespace {

struct InfoOptions {
  HeightOptions heights;
  bool json = false;
};

evaluation::Json describe(const InfoOptions& options) {
  const evaluation::HeightFile input = options.heights.read();
  const brdf::HeightField& field = input.field;
  const double mean_um = field.heights_um().mean();
  const double rms_um = std::sqrt((field.heights_um() - mean_um).square().mean());
  const Eigen::Vector2d slopes = brdf::plane_slopes(field);
  evaluation::Json info;
  info["file"] = options.heights.file;
  info["format"] = input.format;
  info["sha256"] = input.sha256;
  info["channel"] = input.channel;
  info["channels"] = evaluation::Json::array();
  for (const evaluation::HeightChannel& channel : input.channels)
    info["channels"].push_back({{"title", channel.title}, {"unit", channel.unit}});
  info["unit_um"] = input.unit.um();
  info["missing_filled"] = input.filled;
  info["columns"] = field.cols();
  info["rows"] = field.rows();
  info["pixel_um"] = {field.dx_um(), field.dy_um()};
  info["size_um"] = {field.width_um(), field.height_um()};
  info["height_min_um"] = field.min_um();
  info["height_max_um"] = field.max_um();
  info["height_mean_um"] = mean_um;
  info["height_rms_um"] = rms_um;
  info["height_step_um"] = field.height_step_um();
  info["tilt_deg"] = {brdf::Angle::rad(std::atan(slopes.x())).deg(),
                      brdf::Angle::rad(std::atan(slopes.y())).deg()};
  info["shortest_wavelength_um_for_all_directions"] = 4 * std::max(field.dx_um(), field.dy_um());
  return info;
}

/// The title of what was read, and all channels where there are several.
std::string channel_line(const evaluation::Json& info) {
  std::vector<evaluation::HeightChannel> channels;
  for (const evaluation::Json& channel : info["channels"])
    channels.push_back({channel["title"].get<std::string>(), channel["unit"].get<std::string>()});
  const std::string title = info["channel"].get<std::string>();
  if (title.empty() && channels.size() < 2) return {};
  return fmt::format("channel   {}{}\n", title.empty() ? "without a title" : title,
                     channels.size() < 2 ? "" : " of " + evaluation::listed(channels));
}

std::string for_people(const evaluation::Json& info) {
  const auto number = [&](const char* key) { return info[key].get<double>(); };
  const auto pair = [&](const char* key, const char* separator, int digits) {
    return fmt::format("{:.{}g}{}{:.{}g}", info[key][0].get<double>(), digits, separator,
                       info[key][1].get<double>(), digits);
  };
  return fmt::format(
      "file      {}\n"
      "format    {}\n"
      "{}"
      "unit      a stored 1 is {:.6g} nm; {} missing pixels filled\n"
      "pixels    {} x {} (columns x rows)\n"
      "pixel     {} um (x, y)\n"
      "size      {} um\n"
      "heights   {:.6g} to {:.6g} um, peak to valley {:.6g}, RMS about the mean {:.4g}\n"
      "code step {:.4g} nm between neighbouring stored heights\n"
      "tilt      {} deg (x, y) of the least-squares plane\n"
      "sampling  all directions from {:.4g} nm on (pixel < lambda / 4); less far from the normal "
      "reach shorter\n",
      info["file"].get<std::string>(), info["format"].get<std::string>(), channel_line(info),
      brdf::Length::um(number("unit_um")).nm(), info["missing_filled"].get<std::size_t>(),
      info["columns"].get<long>(), info["rows"].get<long>(), pair("pixel_um", ", ", 8),
      pair("size_um", " x ", 8), number("height_min_um"), number("height_max_um"),
      number("height_max_um") - number("height_min_um"), number("height_rms_um"),
      brdf::Length::um(number("height_step_um")).nm(), pair("tilt_deg", ", ", 4),
      brdf::Length::um(number("shortest_wavelength_um_for_all_directions")).nm());
}

}  // namespace

void add_info(CLI::App& app) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* info = app.add_subcommand("info", "Say what a height file holds");
  info->footer("Example:\n  shedlight info scan.png --width 65um --height-range 818.69nm");
  options->heights.add_to(info);
  info->add_flag("--json", options->json, "as JSON");
  info->callback([options] {
    const evaluation::Json description = describe(*options);
    print(options->json ? evaluation::json_text(description) : for_people(description));
  });
}

}  // namespace apps
