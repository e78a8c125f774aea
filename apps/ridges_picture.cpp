#include "apps/ridges_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/gnuplot.h"
#include "apps/response_map.h"

namespace apps {
namespace {

using evaluation::Ridge;
using Points = std::vector<std::pair<double, double>>;

/// What a key of three lines has room for; further ridges have their number alone.
constexpr std::size_t most_named = 12;

/// Told apart from each other and from the dark half of the map, where ridges' neighbours are.
constexpr const char* colours[] = {"#00e5ff", "#7cff4d", "#4d9dff",
                                   "#ff4dff", "#00c896", "#c9b3ff"};

std::string colour(std::size_t ridge) {
  return fmt::format("lc rgb '{}'", colours[ridge % std::size(colours)]);
}

/// Angle and wavelength of the points of a ridge that lie on the map.
Points curve(const RidgesPicture& picture, const Ridge& ridge) {
  const evaluation::Axis& theta = picture.response->theta_r_deg;
  Points points;
  for (const double lambda_nm : picture.response->lambda_nm.values) {
    const double sine =
        ridge.f_per_um * brdf::Length::nm(lambda_nm).um() - std::sin(picture.plane.theta_i.rad());
    if (!(std::abs(sine) <= 1)) continue;
    const double angle = picture.plane.light_side * brdf::Angle::rad(std::asin(sine)).deg();
    if (angle >= theta.front() && angle <= theta.back()) points.emplace_back(angle, lambda_nm);
  }
  return points;
}

/// The same with a gap where the ridge has no maximum.
Points present(const Points& curve, const Ridge& ridge) {
  Points points = curve;
  for (auto& [angle, lambda_nm] : points) {
    const double at = lambda_nm;
    if (std::ranges::none_of(ridge.spans, [at](const evaluation::WavelengthSpan& span) {
          return at >= span.first_nm && at <= span.last_nm;
        }))
      lambda_nm = std::numeric_limits<double>::quiet_NaN();
  }
  return points;
}

std::string name(std::size_t number, const Ridge& ridge) {
  const std::string order = ridge.order ? fmt::format("order {:+d}", *ridge.order) : "no order";
  return fmt::format("{}: {:.1f} nm, {}, {:.3g} %", number + 1, ridge.period_nm, order,
                     100 * ridge.relative);
}

void map_panel(Drawing& gp, const RidgesPicture& picture) {
  std::string command =
      plot_response_map(gp, *picture.response, picture.plane, picture.value_label);
  const std::vector<Ridge>& ridges = picture.found->ridges;
  for (std::size_t i = 0; i < ridges.size(); ++i) {
    const Points whole = curve(picture, ridges[i]);
    if (whole.empty()) continue;
    // From 1.5 to 4 pixels.
    const double width = 1.5 + 2.5 * ridges[i].relative;
    command += ", " + gp.series(whole) + " with lines lw 1 dt 3 " + colour(i) + " notitle, " +
               gp.series(present(whole, ridges[i])) +
               fmt::format(" with lines lw {:.2f} {} ", width, colour(i)) +
               (i < most_named ? "title " + quoted(name(i, ridges[i])) : "notitle");
    gp << fmt::format("set label '{}' at {:.17g},{:.17g} center front boxed\n", i + 1,
                      whole.back().first, whole.back().second);
  }
  gp << command << "\nunset label\n";
}

void mean_panel(Drawing& gp, const RidgesPicture& picture) {
  const evaluation::Ridges& found = *picture.found;
  Points mean, ridges;
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (std::size_t i = 0; i < found.mean.size(); ++i) {
    const bool is_drawn = found.mean[i] > 0;
    mean.emplace_back(found.f_per_um[i],
                      is_drawn ? found.mean[i] : std::numeric_limits<double>::quiet_NaN());
    if (is_drawn) least = std::min(least, found.mean[i]);
    most = std::max(most, found.mean[i]);
  }
  for (const Ridge& ridge : found.ridges) {
    ridges.emplace_back(ridge.f_per_um, ridge.strength);
    gp << fmt::format("set label '{}' at {:.17g},{:.17g} center front offset 0,0.8\n",
                      ridges.size(), ridge.f_per_um, ridge.strength);
  }
  gp << "set logscale y\nset format y '1e%T'\nset grid\n"
     << "set xlabel '(sin theta_i + sin theta_r) / wavelength [1/um]'\n"
     << "set ylabel 'mean over wavelengths'\n"
     << fmt::format("set xrange [{:.17g}:{:.17g}]\n", found.f_per_um.front(), found.f_per_um.back())
     // Six decades at most, with room for the numbers above.
     << fmt::format("set yrange [{:.6g}:{:.6g}]\n", std::max(least / 2, most * 1e-6), most * 8);
  gp << "plot " << gp.series(mean) << " with lines lw 1.5 lc rgb '#404040' notitle, "
     << gp.series(ridges) << " with points pt 7 ps 0.9 lc rgb '#c04000' notitle\n";
}

}  // namespace

std::string draw(const RidgesPicture& picture, PictureFormat format) {
  return draw({1200, 1150}, format, [&](Drawing& gp) {
    gp << dark_to_light;
    gp << "set key outside top center horizontal\nset tics out\n"
       << "set style textbox opaque fillcolor rgb '#ffffff' border lc rgb '#000000'\n";
    gp << "set multiplot\nset lmargin at screen 0.08\nset rmargin at screen 0.88\n";
    gp << "set origin 0,0.28\nset size 1,0.72\nset title " << quoted(picture.title) << "\n";
    map_panel(gp, picture);
    gp << "set origin 0,0\nset size 1,0.28\nunset title\nunset colorbox\nunset key\n";
    mean_panel(gp, picture);
    gp << "unset multiplot\n";
  });
}

}  // namespace apps
