#include "apps/commands/synth_options.h"

#include <fmt/format.h>

#include <limits>
#include <variant>

#include "apps/options.h"
#include "apps/quantities.h"

namespace apps {
namespace {

using brdf::DisorderKind;
using brdf::Edges;
using brdf::Facing;
using brdf::Profile;

const Choices<Shape> shape_choices{{"blazed", Shape::blazed},     {"sinusoid", Shape::sinusoid},
                                   {"lamellar", Shape::lamellar}, {"triangle", Shape::triangle},
                                   {"fingers", Shape::fingers},   {"flat", Shape::flat}};
const Choices<Facing> facing_choices{{"+x", Facing::plus_x}, {"-x", Facing::minus_x}};
const Choices<DisorderKind> kind_choices{{"position", DisorderKind::position},
                                         {"spacing", DisorderKind::spacing}};
const Choices<Edges> edges_choices{{"sampled", Edges::sampled}, {"averaged", Edges::averaged}};

Profile profile_of(Shape shape) {
  switch (shape) {
    case Shape::blazed:
      return Profile::blazed;
    case Shape::lamellar:
      return Profile::lamellar;
    case Shape::triangle:
      return Profile::triangle;
    case Shape::sinusoid:
    case Shape::fingers:
      return Profile::sinusoid;
    case Shape::flat:
      return Profile::flat;
  }
  return Profile::flat;
}

}  // namespace

void SynthOptions::add_to(CLI::App* synth) {
  add_choice(synth, "profile", shape, shape_choices, "shape")->required();
  add_lines_to(synth);
  add_disorder_to(synth);
}

void SynthOptions::add_lines_to(CLI::App* synth) {
  add_parsed(synth, "--period", period, parse_length, "period along the grating vector", "LENGTH");
  add_parsed(synth, "--height", height, parse_length, "peak to valley", "LENGTH");
  add_parsed(synth, "--duty", duty, parse_number,
             "lamellar: part of the period that is high (default 0.5)", "FRACTION");
  add_choice(synth, "--facing", facing, facing_choices,
             "blazed: the direction in which it falls (default +x)");
  add_parsed(synth, "--direction", direction, parse_angle,
             "azimuth of the grating vector, from x towards y (default 0deg)", "ANGLE");
  add_parsed(synth, "--crossed-period", crossed_period, parse_length,
             "period of a second set of lines that multiplies the first; fingers: width of a strip",
             "LENGTH");
  add_parsed(synth, "--crossed-angle", crossed_angle, parse_angle,
             "from the first grating vector to that of the crossed lines (default 90deg)", "ANGLE");
  add_parsed(synth, "--second-period", second_period, parse_length,
             "period of another grating in the rows with the largest y", "LENGTH");
  add_parsed(synth, "--second-direction", second_direction, parse_angle,
             "azimuth of its grating vector (default: the first's)", "ANGLE");
  add_parsed(synth, "--second-share", second_share, parse_number,
             "its part of the rows (default 0.5)", "FRACTION");
  add_choice(synth, "--edges", edges, edges_choices,
             "heights at the pixel centres, or means over the pixel in x, for straight lines along "
             "x (default sampled)");
}

void SynthOptions::add_disorder_to(CLI::App* synth) {
  add_parsed(synth, "--jitter", jitter, parse_length,
             "standard deviation of the places of the lines, or of their distances", "LENGTH");
  add_choice(synth, "--jitter-kind", jitter_kind, kind_choices,
             "what varies: each place, about a lattice, or each distance (default position)");
  add_parsed(synth, "--noise", noise, parse_length,
             "standard deviation of a height added to every pixel", "LENGTH");
  add_parsed(synth, "--seed", seed, count_between(0, std::numeric_limits<int>::max()),
             "of the random numbers (default 1)", "N");
}

std::string SynthOptions::shape_name() const {
  return name_in(shape_choices, shape);
}

void SynthOptions::require_consistent() const {
  const std::string profile = fmt::format("a {} profile", shape_name());
  const auto require = [&](bool given, const char* option) {
    if (given) return;
    throw brdf::Error(brdf::Errc::invalid_argument, fmt::format("{} needs {}", profile, option));
  };
  if (shape == Shape::flat) {
    require_not_given({{period.has_value(), "--period"},
                       {height.has_value(), "--height"},
                       {direction.has_value(), "--direction"},
                       {crossed_period.has_value(), "--crossed-period"},
                       {crossed_angle.has_value(), "--crossed-angle"},
                       {jitter.has_value(), "--jitter"},
                       {jitter_kind.has_value(), "--jitter-kind"},
                       {second_period.has_value(), "--second-period"},
                       {second_direction.has_value(), "--second-direction"},
                       {second_share.has_value(), "--second-share"},
                       {edges.has_value(), "--edges"}},
                      profile);
  } else {
    require(period.has_value(), "--period");
    require(height.has_value(), "--height");
  }
  if (shape != Shape::lamellar) require_not_given({{duty.has_value(), "--duty"}}, profile);
  if (shape != Shape::blazed) require_not_given({{facing.has_value(), "--facing"}}, profile);
  if (shape == Shape::fingers) {
    require(crossed_period.has_value(), "--crossed-period, the width of a strip");
    require_not_given({{crossed_angle.has_value(), "--crossed-angle"}}, profile);
  }
  if (!crossed_period)
    require_not_given({{crossed_angle.has_value(), "--crossed-angle"}},
                      "lines without --crossed-period");
  if (!jitter)
    require_not_given({{jitter_kind.has_value(), "--jitter-kind"}}, "lines without --jitter");
  if (!second_period)
    require_not_given({{second_direction.has_value(), "--second-direction"},
                       {second_share.has_value(), "--second-share"}},
                      "one grating, without --second-period");
  if (!is_random())
    require_not_given({{seed.has_value(), "--seed"}},
                      "a surface without --jitter or --noise, where nothing is random");
}

brdf::SyntheticSurface SynthOptions::surface() const {
  require_consistent();
  brdf::SyntheticSurface made;
  made.grating.profile = profile_of(shape);
  made.grating.period = period.value_or(made.grating.period);
  made.grating.height = height.value_or(made.grating.height);
  made.grating.duty = duty.value_or(made.grating.duty);
  made.grating.facing = facing.value_or(made.grating.facing);
  made.direction = direction.value_or(made.direction);
  if (shape == Shape::fingers)
    made.layout = brdf::FingerRows{*crossed_period};
  else if (crossed_period)
    made.layout =
        brdf::CrossedLines{*crossed_period, crossed_angle.value_or(brdf::CrossedLines{}.angle)};
  made.jitter.deviation = jitter.value_or(made.jitter.deviation);
  made.jitter.kind = jitter_kind.value_or(made.jitter.kind);
  if (second_period)
    made.second = brdf::SecondPopulation{*second_period, second_direction.value_or(made.direction),
                                         second_share.value_or(brdf::SecondPopulation{}.share)};
  made.noise = noise.value_or(made.noise);
  made.edges = edges.value_or(made.edges);
  if (seed) made.seed = static_cast<std::uint64_t>(*seed);
  return made;
}

evaluation::Json SynthOptions::parameters() const {
  const brdf::SyntheticSurface made = surface();
  evaluation::Json json{{"profile", shape_name()}};
  if (shape != Shape::flat) {
    json["period_nm"] = made.grating.period.nm();
    json["peak_to_valley_nm"] = made.grating.height.nm();
    json["direction_deg"] = made.direction.deg();
    json["edges"] = name_in(edges_choices, made.edges);
  }
  if (shape == Shape::lamellar) json["duty"] = made.grating.duty;
  if (shape == Shape::blazed) json["falls_towards"] = name_in(facing_choices, made.grating.facing);
  if (crossed_period) json["crossed_period_nm"] = crossed_period->nm();
  if (const auto* crossed = std::get_if<brdf::CrossedLines>(&made.layout))
    json["crossed_angle_deg"] = crossed->angle.deg();
  if (jitter) {
    json["jitter_nm"] = jitter->nm();
    json["jitter_kind"] = name_in(kind_choices, made.jitter.kind);
  }
  if (made.second) {
    json["second_period_nm"] = made.second->period.nm();
    json["second_direction_deg"] = made.second->direction.deg();
    json["second_share"] = made.second->share;
  }
  if (noise) json["noise_nm"] = noise->nm();
  if (is_random()) {
    json["seed"] = made.seed;
    json["generator"] = "mt19937_64, AS241";
  }
  return json;
}

}  // namespace apps
