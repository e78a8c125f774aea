#include "apps/cut_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/gnuplot.h"

namespace apps {
namespace {

/// Told apart on white, also by readers who see fewer colours.
constexpr const char* colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                   "#000000", "#e69f00", "#56b4e9"};

double largest_value(const CutPicture& picture) {
  double largest = 0;
  for (const CutPicture::Curve& curve : picture.curves)
    for (const auto& [angle, value] : curve.points) largest = std::max(largest, value);
  return largest;
}

}  // namespace

std::string draw(const CutPicture& picture, PictureFormat format) {
  return draw({1200, 700}, format, [&](Drawing& gp) {
    gp << "set key outside top center horizontal\nset tics out\nset grid\n";
    gp << "set title " << quoted(picture.title) << "\n";
    gp << "set xlabel 'viewing angle theta_r [deg]'\nset ylabel " << quoted(picture.value_label)
       << "\n";
    const double largest = largest_value(picture);
    if (picture.scale == ValueScale::logarithmic && largest > 0)
      gp << fmt::format("set logscale y\nset format y '%.0e'\nset yrange [{:.17g}:{:.17g}]\n",
                        1e-6 * largest, 2 * largest);
    else
      gp << "set yrange [0:*]\n";
    std::string command = "plot ";
    for (std::size_t i = 0; i < picture.curves.size(); ++i) {
      const CutPicture::Curve& curve = picture.curves[i];
      command +=
          (i > 0 ? ", " : "") + gp.series(curve.points) +
          fmt::format(" with lines lw 2 lc rgb '{}' title ", colours[i % std::size(colours)]) +
          quoted(curve.name);
    }
    gp << command << "\n";
  });
}

}  // namespace apps
