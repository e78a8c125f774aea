// shedlight ridges: all ridges of a response, over all wavelengths at once.
#include "evaluation/period/ridges.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "apps/commands/commands.h"
#include "apps/console.h"
#include "apps/options.h"
#include "apps/quantities.h"
#include "apps/response_input.h"
#include "apps/ridges_picture.h"

namespace apps {
namespace {

using evaluation::Json;
using evaluation::Ridge;

struct RidgesOptions {
  ResponseOptions response;
  const CLI::Option* order = nullptr;
  double least_contrast = evaluation::RidgeSearch{}.least_contrast;
  std::string output, picture;
  bool json = false;
};

evaluation::RidgeSearch search_for(const RidgesOptions& options, const ResponseInput& input) {
  evaluation::RidgeSearch search;
  if (options.order->count() > 0) search.order = input.search.order;
  search.period_guess = input.search.period_guess;
  search.period_range = input.search.period_range;
  search.theta_r_deg = input.search.theta_r_deg;
  search.floor = input.search.floor;
  search.least_contrast = options.least_contrast;
  return search;
}

Json parameters(const evaluation::RidgeSearch& search, const ResponseInput& input) {
  Json p = input.parameters();
  for (const char* of_peaks : {"order", "side", "refine"}) p.erase(of_peaks);
  if (search.order) p["order"] = *search.order;
  p["least_contrast"] = search.least_contrast;
  return p;
}

template <class T>
Json json_of(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json json_of(const evaluation::Ridges& found) {
  Json ridges = Json::array(), jumps = Json::array();
  for (const Ridge& ridge : found.ridges) {
    Json spans = Json::array(), merged = Json::array();
    for (const auto& span : ridge.spans) spans.push_back({span.first_nm, span.last_nm});
    for (const auto& merge : ridge.merged_with)
      merged.push_back({{"number", merge.with + 1}, {"wavelengths", merge.wavelengths}});
    Json row{{"number", ridges.size() + 1}, {"order", json_of(ridge.order)}};
    row["side"] = evaluation::side_of(ridge.f_per_um > 0 ? 1 : -1);
    row["period_nm"] = ridge.period_nm;
    row["f_per_um"] = ridge.f_per_um;
    row["f_spread_per_um"] = ridge.f_spread_per_um;
    row["strength"] = ridge.strength;
    row["relative"] = ridge.relative;
    row["contrast"] = ridge.contrast;  // null where infinite
    row["width_per_um"] = json_of(ridge.width_per_um);
    row["window_widths"] = json_of(ridge.window_widths);
    row["present"] = ridge.present;
    row["brightest"] = ridge.brightest;
    row["spans_nm"] = std::move(spans);
    row["merged_with"] = std::move(merged);
    ridges.push_back(std::move(row));
  }
  for (const auto& order : found.jumps)
    jumps.push_back({{"order", order.order}, {"jumps", order.jumps}});
  return {{"ridges", std::move(ridges)}, {"brightest_track", std::move(jumps)}};
}

std::string line(std::size_t number, const Ridge& ridge) {
  const std::string order = ridge.order ? fmt::format("{:+d}", *ridge.order) : "?";
  const std::string width = ridge.window_widths
                                ? fmt::format("{:.2f} x window", *ridge.window_widths)
                            : ridge.width_per_um ? fmt::format("{:.4f} 1/um", *ridge.width_per_um)
                                                 : "unresolved";
  std::string text = fmt::format(
      "{:2}  order {:>2}, {:<19}  {:9.2f} nm  strength {:5.1f} %  width {:<13}  {:g} to {:g} nm, "
      "{:.0f} %",
      number, order, evaluation::side_of(ridge.f_per_um > 0 ? 1 : -1), ridge.period_nm,
      100 * ridge.relative, width, ridge.spans.front().first_nm, ridge.spans.back().last_nm,
      100 * ridge.present);
  for (const auto& merge : ridge.merged_with)
    text += fmt::format(", merges with {} at {} wavelengths", merge.with + 1, merge.wavelengths);
  return text + "\n";
}

std::string for_people(const evaluation::Ridges& found) {
  std::string text;
  for (std::size_t i = 0; i < found.ridges.size(); ++i) text += line(i + 1, found.ridges[i]);
  for (const auto& order : found.jumps) {
    const auto of_order = [&](const Ridge& ridge) { return ridge.order == order.order; };
    if (std::ranges::count_if(found.ridges, of_order) < 2) continue;
    text += fmt::format("the brightest angle of order {:+d} changes its ridge {} times\n",
                        order.order, order.jumps);
  }
  return text;
}

void run(const RidgesOptions& options) {
  std::optional<evaluation::OutputWithSidecar> output;
  std::optional<PictureOutput> picture;
  for (const std::string& written : {options.output, options.picture})
    if (!written.empty()) require_other_file(written, options.response.file);
  require_apart(options.output, options.picture);
  if (!options.output.empty()) output.emplace(options.output);
  if (!options.picture.empty()) picture.emplace(options.picture);
  const ResponseInput input = options.response.read();
  const evaluation::RidgeSearch search = search_for(options, input);
  const evaluation::Ridges found = brdf::at_place(
      options.response.file, [&] { return find_ridges(input.response, input.plane, search); });
  if (found.ridges.empty())
    throw brdf::Error(
        brdf::Errc::not_attainable,
        fmt::format("{}: no ridge that was asked for stands {} times above the background",
                    options.response.file, brdf::text(search.least_contrast)));
  Json sidecar = sidecar_head("ridges", options.response.file, input.sha256);
  sidecar["parameters"] = parameters(search, input);
  if (output) output->commit(to_csv(found.ridges), sidecar);
  if (picture)
    picture->commit(
        draw(RidgesPicture{&input.response, input.plane, &found,
                           picture_title(input, options.response.file), value_label(input.sidecar)},
             picture->format),
        sidecar);
  print(options.json ? evaluation::json_text(json_of(found)) : for_people(found));
}

}  // namespace

void add_ridges(CLI::App& app) {
  auto options = std::make_shared<RidgesOptions>();
  CLI::App* ridges = app.add_subcommand(
      "ridges", "All ridges of a response over all wavelengths, with period and strength");
  ridges->footer(
      "Each line: number by strength, order, side, period, strength in the strongest's, full "
      "width\n"
      "at half maximum, first and last wavelength with a maximum and the share of those between.\n"
      "Without --order and --period-guess the strongest ridges tell which is order 1.\n"
      "Example:\n  shedlight ridges R.csv -o ridges.csv --plot ridges.png");
  options->response.add_to(ridges);
  ridges->remove_option(ridges->get_option("--refine"));
  options->order = ridges->get_option("--order")->description(
      "order of the strongest ridge; with --period-guess only ridges of this order");
  ridges->get_option("--period-guess")->description("period whose orders the ridges are");
  ridges->get_option("--period-range")->description("only ridges with such a period");
  add_parsed(ridges, "--contrast", options->least_contrast, parse_number,
             "times the background that a ridge must stand (default 10)", "NUMBER");
  add_output(ridges, options->output, "CSV file with all that is known of each ridge");
  add_parsed(ridges, "--plot", options->picture, parse_path,
             "PNG, SVG or PDF: heat map with the ridges, and the mean over the wavelengths",
             "FILE");
  ridges->add_flag("--json", options->json, "as JSON");
  ridges->callback([options] { run(*options); });
}

}  // namespace apps
