#include "apps/tradeoff_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "apps/gnuplot.h"

namespace apps {
namespace {

using evaluation::TradeoffRow;
using Points = std::vector<std::pair<double, double>>;

/// How a kind of row is drawn. The sources' own settings come last and carry their names.
struct Style {
  const char *name, *points;
  bool (*has)(const TradeoffRow&);
};

bool is_plain(const TradeoffRow& row, const char* method) {
  return row.trial.method == method && row.trial.sources.empty() && !row.trial.lambda_step_nm &&
         row.trial.cells == evaluation::Cells::all;
}

const Style styles[] = {{"direct sum", "pt 5 ps 1.5 lc rgb '#444444'",
                         [](const TradeoffRow& row) { return is_plain(row, "direct"); }},
                        {"auto", "pt 6 ps 1.9 lc rgb '#56b4e9'",
                         [](const TradeoffRow& row) { return is_plain(row, "auto"); }},
                        {"chebyshev", "pt 7 ps 1.2 lc rgb '#0072b2'",
                         [](const TradeoffRow& row) { return is_plain(row, "chebyshev"); }},
                        {"taylor", "pt 9 ps 1.4 lc rgb '#d55e00'",
                         [](const TradeoffRow& row) { return is_plain(row, "taylor"); }},
                        {"pq", "pt 11 ps 1.4 lc rgb '#009e73'",
                         [](const TradeoffRow& row) { return is_plain(row, "pq"); }},
                        {"coarser wavelengths", "pt 1 ps 1.3 lw 2 lc rgb '#cc79a7'",
                         [](const TradeoffRow& row) {
                           return row.trial.sources.empty() && row.trial.lambda_step_nm.has_value();
                         }},
                        {"orders only", "pt 2 ps 1.3 lw 2 lc rgb '#888800'",
                         [](const TradeoffRow& row) {
                           return row.trial.sources.empty() &&
                                  row.trial.cells == evaluation::Cells::orders;
                         }},
                        {"settings of the sources", "pt 13 ps 1.9 lc rgb '#aa0022'",
                         [](const TradeoffRow& row) { return !row.trial.sources.empty(); }}};

/// Errors below rounding are drawn at it.
double drawn_error(const TradeoffRow& row) {
  return std::max(row.errors.worst, 1e-17);
}

std::pair<double, double> point(const TradeoffRow& row) {
  return {row.time.total_s(), drawn_error(row)};
}

/// One surface model of the rows.
struct Panel {
  brdf::SurfaceModel model;
  std::vector<const TradeoffRow*> rows;
  std::vector<const TradeoffRow*> chosen;

  std::string title() const {
    std::string title = "surface " + std::string(evaluation::name_of(model));
    std::vector<std::pair<int, int>> copies;
    for (const TradeoffRow* row : rows) {
      const std::pair found(row->trial.replicas.x, row->trial.replicas.y);
      if (std::ranges::find(copies, found) == copies.end()) copies.push_back(found);
    }
    if (model == brdf::SurfaceModel::replicated)
      title += fmt::format(", {} x {} copies", copies.front().first, copies.front().second);
    return title;
  }

  /// From the left to the right, as a stair down.
  Points frontier() const {
    Points points;
    for (const TradeoffRow* row : rows)
      if (row->on_frontier) points.push_back(point(*row));
    std::ranges::sort(points);
    return points;
  }
};

std::vector<Panel> panels_of(const TradeoffPicture& picture) {
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < picture.rows.size(); ++i) {
    const TradeoffRow& row = picture.rows[i];
    if (panels.empty() || panels.back().model != row.trial.model)
      panels.push_back({row.trial.model, {}, {}});
    Panel& panel = panels.back();
    // Other numbers of copies are another surface: they stand in the table.
    const bool other_surface =
        !panel.rows.empty() && !(panel.rows.front()->trial.replicas == row.trial.replicas);
    if (!row.refused.empty() || other_surface) continue;
    panel.rows.push_back(&row);
    if (std::ranges::find(picture.chosen, i) != picture.chosen.end()) panel.chosen.push_back(&row);
  }
  return panels;
}

/// Whole decades around all rows, so that the panels compare at a glance.
std::string decades(double lo, double hi) {
  return fmt::format("[{:g}:{:g}]", std::pow(10.0, std::floor(std::log10(lo) - 0.05)),
                     std::pow(10.0, std::ceil(std::log10(hi) + 0.05)));
}

void set_ranges(Drawing& gp, const std::vector<Panel>& panels) {
  double least_s = 1e30, most_s = 0, least = 1e30, most = 0;
  for (const Panel& panel : panels)
    for (const TradeoffRow* row : panel.rows) {
      const auto [seconds, error] = point(*row);
      least_s = std::min(least_s, seconds);
      most_s = std::max(most_s, seconds);
      least = std::min(least, error);
      if (std::isfinite(error)) most = std::max(most, error);
    }
  gp << "set xrange " << decades(least_s, most_s) << "\nset yrange " << decades(least, most)
     << "\n";
}

/// The names of the sources' settings in a column right of them, each tied to its point: side by
/// side they would overlap.
void name_sources(Drawing& gp, const Panel& panel) {
  std::vector<const TradeoffRow*> rows;
  double right_s = 0;
  for (const TradeoffRow* row : panel.rows)
    if (!row->trial.sources.empty()) {
      rows.push_back(row);
      right_s = std::max(right_s, row->time.total_s());
    }
  std::ranges::sort(rows, std::greater(), [](const TradeoffRow* row) { return drawn_error(*row); });
  constexpr double line = 5;  // a factor of the error that leaves room for a name
  double error = std::numeric_limits<double>::infinity();
  for (const TradeoffRow* row : rows) {
    error = std::min(drawn_error(*row) * line, error / line);
    gp << fmt::format("set arrow from {:.6g},{:.6g} to {:.6g},{:.6g} nohead lc rgb '#aa0022'\n",
                      row->time.total_s(), drawn_error(*row), 3 * right_s, error);
    gp << "set label " << quoted(row->trial.sources)
       << fmt::format(" at {:.6g},{:.6g} font ',10' tc rgb '#aa0022' front offset 0.3,0\n",
                      3 * right_s, error);
  }
}

/// What the points are, once for all panels, in a strip below them.
void draw_key(Drawing& gp, const std::vector<Panel>& panels) {
  std::string entries = "keyentry with lines lw 2 lc rgb '#000000' title 'frontier'";
  bool has_chosen = false;
  for (const Panel& panel : panels) has_chosen = has_chosen || !panel.chosen.empty();
  for (const Style& style : styles) {
    const auto has = [&](const Panel& panel) {
      return std::ranges::any_of(panel.rows,
                                 [&](const TradeoffRow* row) { return style.has(*row); });
    };
    if (std::ranges::any_of(panels, has))
      entries +=
          std::string(", keyentry with points ") + style.points + " title '" + style.name + "'";
  }
  if (has_chosen)
    entries +=
        ", keyentry with points pt 6 ps 2.5 lw 2.5 lc rgb '#e600ac' title 'within the "
        "budget'";
  gp << "unset label\nunset arrow\nunset title\nunset xlabel\nunset ylabel\nunset tics\n"
     << "unset border\nunset grid\nunset logscale\n"
     << "set lmargin at screen 0.02\nset rmargin at screen 0.98\n"
     << "set bmargin at screen 0.0\nset tmargin at screen 0.13\n"
     << "set key inside center horizontal\nplot [0:1] [0:1] -1 notitle, " << entries << "\n";
}

void draw_panel(Drawing& gp, const Panel& panel) {
  gp << "unset label\nunset arrow\nset title " << quoted(panel.title()) << "\n";
  name_sources(gp, panel);
  std::string command =
      "plot " + gp.series(panel.frontier()) + " with steps lw 2 lc rgb '#000000' notitle";
  for (const Style& style : styles) {
    Points points;
    for (const TradeoffRow* row : panel.rows)
      if (style.has(*row)) points.push_back(point(*row));
    if (points.empty()) continue;
    command += ", " + gp.series(points) + " with points " + style.points + " notitle";
  }
  Points chosen;
  for (const TradeoffRow* row : panel.chosen) chosen.push_back(point(*row));
  if (!chosen.empty())
    command += ", " + gp.series(chosen) + " with points pt 6 ps 3 lw 2.5 lc rgb '#e600ac' notitle";
  gp << command << "\n";
}

}  // namespace

std::string draw(const TradeoffPicture& picture, PictureFormat format) {
  const std::vector<Panel> panels = panels_of(picture);
  const auto count = static_cast<double>(panels.size());
  const int width = panels.size() == 1 ? 900 : 580 * static_cast<int>(panels.size());
  return draw({width, 680}, format, [&](Drawing& gp) {
    gp << "set multiplot title " << quoted(picture.title) << " font ',14'\n";
    gp << "set logscale xy\nset format xy '1e%T'\nset tics out\nset grid\n"
       << "unset key\n";
    gp << "set xlabel 'seconds to plan and evaluate all cells'\n"
       << "set ylabel 'worst error of the amplitude (flat patch = 1)' offset 0.5,0\n";
    set_ranges(gp, panels);
    for (std::size_t i = 0; i < panels.size(); ++i) {
      const double left = static_cast<double>(i) / count;
      gp << fmt::format(
          "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n"
          "set tmargin at screen 0.88\nset bmargin at screen 0.25\n",
          left + 105.0 / width, left + 1 / count - 28.0 / width);
      draw_panel(gp, panels[i]);
      gp << "unset ylabel\n";
    }
    draw_key(gp, panels);
    gp << "unset multiplot\n";
  });
}

}  // namespace apps
