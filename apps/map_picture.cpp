#include "apps/map_picture.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "apps/gnuplot.h"

namespace apps {
namespace {

constexpr int panels_per_row = 3;

/// A line as two vectors, in the disk's coordinates.
struct Chord {
  double x0, y0, x1, y1;
};

std::string arrow(const Chord& chord, const std::string& style) {
  return fmt::format("set arrow from {:.6g},{:.6g} to {:.6g},{:.6g} nohead front {}\n", chord.x0,
                     chord.y0, chord.x1, chord.y1, style);
}

/// Where the directions of an order meet the disk: omega_r . g = m lambda / d - omega_i . g.
std::optional<Chord> chord(const OrderArcs& arcs, int order, brdf::Length wavelength,
                           const MapPanel& panel) {
  const double cosine = std::cos(arcs.azimuth.rad()), sine = std::sin(arcs.azimuth.rad());
  const double place =
      order * wavelength.um() / arcs.period.um() -
      std::sin(panel.theta_i.rad()) * std::cos(panel.phi_i.rad() - arcs.azimuth.rad());
  if (!(std::abs(place) < 0.995)) return std::nullopt;
  const double half = std::sqrt(1 - place * place);
  return Chord{place * cosine + half * sine, place * sine - half * cosine,
               place * cosine - half * sine, place * sine + half * cosine};
}

void draw_arcs(Drawing& gp, const OrderArcs& arcs, const MapPanel& panel) {
  const std::pair<double, const char*> lines[] = {
      {450, "#5080ff"}, {550, "#40d040"}, {650, "#ff5040"}};
  const int last = static_cast<int>(2 * arcs.period.um() / 0.45) + 1;
  for (int order = -last; order <= last; ++order) {
    if (order == 0) continue;  // the mirror direction, at all wavelengths
    for (const auto& [nm, colour] : lines) {
      const auto found = chord(arcs, order, brdf::Length::nm(nm), panel);
      if (!found) continue;
      gp << arrow(*found, fmt::format("lw 1 dt 3 lc rgb '{}'", colour));
      if (nm == 550)
        gp << fmt::format(
            "set label {} at {:.6g},{:.6g} center front tc rgb '#207020' font ',11'\n",
            quoted(fmt::format("{:+d}", order)), 1.06 * found->x1, 1.06 * found->y1);
    }
  }
}

void draw_frame(Drawing& gp) {
  for (const int theta : {30, 60, 90}) {
    const double radius = std::sin(theta * brdf::pi / 180);
    gp << fmt::format("set object circle at 0,0 size {:.6g} front fs empty border rgb '{}' lw 1\n",
                      radius, theta == 90 ? "#404040" : "#909090");
    gp << fmt::format("set label {} at {:.6g},{:.6g} center front tc rgb '#b0b0b0' font ',10'\n",
                      quoted(theta == 90 ? "" : fmt::format("{}°", theta)), 0.707 * radius,
                      0.707 * radius);
  }
}

void draw_panel(Drawing& gp, const MapPicture& picture, const MapPanel& panel,
                const std::string& file) {
  const double x = std::sin(panel.theta_i.rad()) * std::cos(panel.phi_i.rad()),
               y = std::sin(panel.theta_i.rad()) * std::sin(panel.phi_i.rad());
  const double cosine = std::cos(panel.phi_i.rad()), sine = std::sin(panel.phi_i.rad());
  gp << "unset object\nunset arrow\nunset label\n";
  draw_frame(gp);
  // The plane of incidence: its two ends, so that the picture under it stays whole.
  for (const double side : {-1.0, 1.0})
    gp << arrow({side * cosine, side * sine, side * 1.12 * cosine, side * 1.12 * sine},
                "lw 2 lc rgb '#404040'");
  if (picture.mirror_radius)
    gp << fmt::format(
        "set object circle at {:.6g},{:.6g} size {:.6g} front fs empty border rgb '#ffffff' lw 1\n",
        -x, -y, *picture.mirror_radius);
  if (picture.arcs) draw_arcs(gp, *picture.arcs, panel);
  gp << "set title "
     << quoted(fmt::format("light {:.4g}° from the normal, azimuth {:.4g}°", panel.theta_i.deg(),
                           panel.phi_i.deg()))
     << "\n";
  gp << "set xlabel " << quoted("sin θ_r cos φ_r") << R"(."\n".)" << quoted(panel.caption) << "\n";
  const double pixel = 2.0 / picture.size;
  gp << "plot " << file
     << fmt::format(
            " binary array=({0},{0}) format='%uchar%uchar%uchar%uchar' origin=({1:.9g},{1:.9g}) "
            "dx={2:.9g} dy={2:.9g} with rgbalpha notitle, ",
            picture.size, -1 + pixel / 2, pixel);
  gp << fmt::format(
      "'-' with points pt 7 ps 1.6 lc rgb '#ffd000' title 'light', "
      "'-' with points pt 2 ps 1.4 lw 2 lc rgb '#00d0ff' title 'mirror direction', "
      "NaN with lines lw 2 lc rgb '#404040' title 'plane of incidence'");
  if (picture.arcs)
    gp << ", NaN with lines dt 3 lc rgb '#40a040' title "
       << quoted(fmt::format("orders of {:.6g} nm at 450, 550, 650 nm", picture.arcs->period.nm()));
  gp << fmt::format("\n{0:.6g} {1:.6g}\ne\n{2:.6g} {3:.6g}\ne\n", x, y, -x, -y);
}

}  // namespace

std::string draw(const MapPicture& picture, PictureFormat format) {
  const int count = static_cast<int>(picture.panels.size());
  const int columns = std::min(count, panels_per_row), rows = (count + columns - 1) / columns;
  const PictureSize panel{picture.size + 160, picture.size + 220};
  const PictureSize size{columns * panel.width, rows * panel.height + 40};
  return draw(size, format, [&](Drawing& gp) {
    gp << fmt::format("set multiplot layout {},{} title ", rows, columns) << quoted(picture.title)
       << " font ',15'\n";
    gp << "set size ratio -1\nset xrange [-1.15:1.15]\nset yrange [-1.15:1.15]\n"
          "set xtics -1,0.5,1\nset ytics -1,0.5,1\nset tics out\nset border 3\nset xtics nomirror\n"
          "set ytics nomirror\nset ylabel 'sin θ_r sin φ_r' offset 1\n"
          "set key at screen 0.5,0.02 center bottom horizontal maxrows 1 font ',11'\n"
          "set key outside below center horizontal\n";
    for (std::size_t i = 0; i < picture.panels.size(); ++i) {
      const MapPanel& each = picture.panels[i];
      const std::string file =
          gp.file({reinterpret_cast<const char*>(each.rgba.data()), each.rgba.size()});
      draw_panel(gp, picture, each, file);
    }
    gp << "unset multiplot\n";
  });
}

}  // namespace apps
