#include "apps/checks_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/gnuplot.h"

namespace apps {
namespace {

using evaluation::CheckRow;
using evaluation::Verdict;
using Points = std::vector<std::pair<double, double>>;

/// An error of 0 has its place at the left edge, one that is none at the right.
constexpr double lowest = 1e-18, highest = 1e2;

double place(double value) {
  return std::isnan(value) ? highest : std::clamp(value, lowest, highest);
}

/// One plot element.
struct Series {
  const char* style;
  const char* title;
  Points points;
};

}  // namespace

std::string draw(const ChecksPicture& picture, PictureFormat format) {
  const auto count = static_cast<int>(picture.rows.size());
  return draw({1300, 150 + 26 * count}, format, [&](Drawing& gp) {
    gp << "set title " << quoted(picture.title) << "\n";
    gp << "set key inside top right\nset tics out\nset grid x\n"
       << "set logscale x\nset format x '%.0e'\nset xlabel 'error, of the peak or relative'\n"
       << "set lmargin 62\n";
    gp << fmt::format("set xrange [{}:{}]\nset yrange [{}:-1]\n", lowest, highest, count);
    Series passed{"points pt 7 ps 1.1 lc rgb '#009e73'", "worst error", {}},
        failed{"points pt 7 ps 1.1 lc rgb '#d50000'", "worst error above its limit", {}},
        limits{"points pt 5 ps 0.9 lc rgb '#000000'", "limit", {}},
        refused{"points pt 12 ps 1.8 lw 2 lc rgb '#0072b2'", "refused, some cases or all", {}};
    for (int row = 0; row < count; ++row) {
      const CheckRow& check = picture.rows[static_cast<std::size_t>(row)];
      gp << fmt::format("set ytics {} (", row == 0 ? "" : "add")
         << quoted(check.subject + ", " + check.range) << " " << row << ")\n";
      if (!check.first_refusal.empty()) refused.points.emplace_back(10, row);
      if (check.verdict == Verdict::refused) continue;
      const bool ok = check.verdict == Verdict::passed;
      gp << fmt::format("set arrow from {0},{2} to {1},{2} nohead lw 3 lc rgb '{3}'\n",
                        place(check.worst), place(check.limit), row, ok ? "#80cfb9" : "#ea8080");
      (ok ? passed : failed).points.emplace_back(place(check.worst), row);
      limits.points.emplace_back(place(check.limit), row);
    }
    std::string command;
    for (const Series* one : {&passed, &failed, &limits, &refused}) {
      if (one->points.empty()) continue;
      command += (command.empty() ? "plot " : ", ") + gp.series(one->points) + " with " +
                 one->style + " title " + quoted(one->title);
    }
    gp << command << "\n";
  });
}

}  // namespace apps
