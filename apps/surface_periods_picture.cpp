#include "apps/surface_periods_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/gnuplot.h"

namespace apps {
namespace {

using evaluation::Interval;
using evaluation::LightPeriod;
using evaluation::LocalPeriod;
using evaluation::PeriodEstimate;
using Points = std::vector<std::pair<double, double>>;

/// How far each line lies from its place in an even lattice of the period found [nm].
void lines_panel(Drawing& gp, const PeriodEstimate& estimate) {
  const auto& phases = estimate.phases;
  const std::size_t count = phases.size();
  const double carrier_nm = estimate.period_nm;
  double mean = 0, line_mean = 0;
  for (std::size_t i = 0; i < count; ++i) {
    mean += phases.phase_rad[i] / static_cast<double>(count);
    line_mean += phases.line[i] / static_cast<double>(count);
  }
  double along = 0, squares = 0;
  for (std::size_t i = 0; i < count; ++i) {
    along += (phases.line[i] - line_mean) * (phases.phase_rad[i] - mean);
    squares += (phases.line[i] - line_mean) * (phases.line[i] - line_mean);
  }
  Points places;
  for (std::size_t i = 0; i < count; ++i)
    places.emplace_back(phases.line[i], -carrier_nm / (2 * brdf::pi) *
                                            (phases.phase_rad[i] - mean -
                                             along / squares * (phases.line[i] - line_mean)));
  gp << "set xlabel 'line, counted from the middle of the patch'\n"
     << "set ylabel 'off an even lattice [nm]'\nset grid\n"
     << "plot 0 with lines lw 1 lc rgb '#808080' notitle, " << gp.series(places)
     << " with linespoints pt 7 ps 0.7 lc rgb '#0060a0' title "
     << quoted(
            fmt::format("{} lines; drifting with probability {:.2f}", count, estimate.drift_share))
     << "\n";
}

/// What the period is in parts of the patch and by light, beside its interval.
void parts_panel(Drawing& gp, const SurfacePeriodsPicture& picture) {
  const PeriodEstimate& estimate = *picture.period->heights;
  Points patches, windows, light;
  std::string bars, tics;
  int row = 0;
  double lo = estimate.interval_nm.lo, hi = estimate.interval_nm.hi;
  const auto add = [&](Points& points, const std::string& name, double period_nm) {
    points.emplace_back(period_nm, row);
    lo = std::min(lo, period_nm);
    hi = std::max(hi, period_nm);
    tics += (tics.empty() ? "" : ", ") + quoted(name) + fmt::format(" {}", row);
    ++row;
  };
  const auto add_bar = [&](const Interval& interval, int at) {
    bars += fmt::format(
        "set arrow from {:.17g},{} to {:.17g},{} heads size screen 0.005,90 lw 2 lc rgb "
        "'#606060'\n",
        interval.lo, at, interval.hi, at);
    lo = std::min(lo, interval.lo);
    hi = std::max(hi, interval.hi);
  };
  Points heights;
  add_bar(estimate.interval_nm, row);
  add(heights, "heights, interval", estimate.period_nm);
  const std::pair<const char*, const std::optional<LightPeriod>*> sides[]{
      {"light from the left", &picture.period->left},
      {"light from the right", &picture.period->right}};
  for (const auto& side : sides)
    if (*side.second) {
      add_bar((*side.second)->interval_nm, row);
      add(light, side.first, (*side.second)->period_nm);
    }
  const auto place = [](const LocalPeriod& one) {
    return fmt::format("({:.2g}, {:.2g}) um", one.x_um, one.y_um);
  };
  for (const LocalPeriod& one : estimate.by_patch)
    add(patches, "sub-patch at " + place(one), one.period_nm);
  for (const LocalPeriod& one : estimate.by_window)
    add(windows, "window at " + place(one), one.period_nm);
  const double room = 0.05 * (hi - lo) + 1e-9 * hi;
  gp << fmt::format("set xrange [{:.17g}:{:.17g}]\nset yrange [{}:-1]\n", lo - room, hi + room, row)
     << "set ytics (" << tics << ")\nset xlabel 'period [nm]'\nunset ylabel\nset grid x\n"
     << bars;
  std::string command;
  const auto plot = [&](const Points& points, const char* style, const char* name) {
    if (points.empty()) return;
    command += (command.empty() ? "plot " : ", ") + gp.series(points) + " with points " + style +
               " title " + quoted(name);
  };
  plot(heights, "pt 7 ps 1.4 lc rgb '#d50000'", "heights");
  plot(light, "pt 5 ps 1.2 lc rgb '#0072b2'", "light");
  plot(patches, "pt 9 ps 1.2 lc rgb '#009e73'", "sub-patches");
  plot(windows, "pt 13 ps 1.2 lc rgb '#cc79a7'", "window positions");
  gp << command << "\nunset arrow\nset ytics auto\n";
}

void around_panel(Drawing& gp, const SurfacePeriodsPicture& picture) {
  double deepest = 0;
  for (const auto& one : picture.around) deepest = std::max(deepest, one.depth_nm);
  Points strong, weak;
  for (const auto& one : picture.around)
    (one.depth_nm >= 0.3 * deepest ? strong : weak).emplace_back(one.azimuth_deg, one.period_nm);
  gp << "set xrange [-90:90]\nset xtics 30\nset autoscale y\nset grid\n"
     << "set xlabel 'azimuth of the plane of incidence [deg]'\nset ylabel 'period met [nm]'\n";
  std::string command;
  if (!weak.empty())
    command =
        "plot " + gp.series(weak) + " with points pt 6 ps 0.5 lc rgb '#a0a0a0' title 'weaker'";
  if (!strong.empty())
    command += (command.empty() ? "plot " : ", ") + gp.series(strong) +
               " with points pt 7 ps 0.9 lc rgb '#d50000' title 'at least 30 % of the deepest'";
  gp << command << "\n";
}

}  // namespace

std::string draw(const SurfacePeriodsPicture& picture, PictureFormat format) {
  const PeriodEstimate& estimate = *picture.period->heights;
  const bool has_lines = estimate.lines > 0;
  return draw({1100, has_lines ? 1200 : 850}, format, [&](Drawing& gp) {
    gp << "set key outside top center horizontal\nset tics out\nset multiplot\n"
       << "set lmargin at screen 0.3\nset rmargin at screen 0.96\n";
    const double third = has_lines ? 0.3 : 0.0, rest = (1 - third) / 2;
    gp << fmt::format("set origin 0,{}\nset size 1,{}\nset title ", 1 - rest, rest)
       << quoted(picture.title) << "\n";
    parts_panel(gp, picture);
    gp << "unset title\nset autoscale x\nset autoscale y\n";
    if (has_lines) {
      gp << fmt::format("set origin 0,{}\nset size 1,{}\n", rest, third);
      lines_panel(gp, estimate);
    }
    gp << fmt::format("set origin 0,0\nset size 1,{}\n", rest);
    around_panel(gp, picture);
    gp << "unset multiplot\n";
  });
}

}  // namespace apps
