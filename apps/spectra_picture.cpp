#include "apps/spectra_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "apps/gnuplot.h"

namespace apps {
namespace {

using brdf::Extrema;
using brdf::SpectrumExtrema;

/// The bins along one side of a spectrum, gathered into cells of a picture.
struct Side {
  static constexpr long most_cells = 1024;
  long count;
  double pixel_um;

  long bins_a_cell() const { return (count + most_cells - 1) / most_cells; }
  long cells() const { return (count + bins_a_cell() - 1) / bins_a_cell(); }
  /// Frequency 0 is in the middle.
  long first_bin(long cell) const { return cell * bins_a_cell() - count / 2; }
  long end_bin(long cell) const { return std::min(first_bin(cell + 1), count - count / 2); }

  double cycles_per_um(double bin) const { return bin / (static_cast<double>(count) * pixel_um); }
  double step() const { return cycles_per_um(static_cast<double>(bins_a_cell())); }
  /// The middle of the first cell.
  double front() const {
    return cycles_per_um(static_cast<double>(first_bin(0)) +
                         static_cast<double>(bins_a_cell() - 1) / 2);
  }
  std::string range() const {
    const double low = front() - step() / 2;
    return fmt::format("[{:.17g}:{:.17g}]", low, low + step() * static_cast<double>(cells()));
  }
};

double largest_in_cell(const brdf::HalfSpectrum& spectrum, const Side& x, const Side& y, long col,
                       long row) {
  double largest = 0;
  for (long j = y.first_bin(row); j < y.end_bin(row); ++j)
    for (long l = x.first_bin(col); l < x.end_bin(col); ++l)
      largest = std::max(largest, std::abs(spectrum.bin(j, l)));
  return largest;
}

using Rows = std::vector<std::vector<double>>;

Rows cells_of(const brdf::HalfSpectrum& spectrum, const Side& x, const Side& y) {
  Rows rows;
  for (long row = 0; row < y.cells(); ++row) {
    std::vector<double>& values = rows.emplace_back();
    for (long col = 0; col < x.cells(); ++col)
      values.push_back(largest_in_cell(spectrum, x, y, col, row));
  }
  return rows;
}

/// Linear to 1, then a unit a decade, for both signs.
double symmetric_log(double value) {
  return std::copysign(std::log10(1 + std::abs(value)), value);
}

/// Ticks at 0 and at the decades above 1 up to the largest value, for both signs.
std::string decade_ticks(double largest) {
  std::string ticks = "'0' 0";
  for (int decade = 1; decade <= static_cast<int>(std::ceil(std::log10(std::max(largest, 1.0))));
       ++decade) {
    const double at = symmetric_log(std::pow(10.0, decade));
    ticks += fmt::format(", '1e{0}' {1:.17g}, '-1e{0}' -{1:.17g}", decade, at);
  }
  return ticks;
}

double largest_extremum(std::span<const SpectrumExtrema> powers) {
  double largest = 0;
  for (const SpectrumExtrema& power : powers)
    for (const Extrema& part : {power.re, power.im})
      largest = std::max({largest, std::abs(part.min), std::abs(part.max)});
  return largest;
}

}  // namespace

std::string draw(const SpectrumPicture& picture, PictureFormat format) {
  return draw({1000, 900}, format, [&](Drawing& gp) {
    const Side x{picture.spectrum->cols, picture.dx_um}, y{picture.spectrum->rows, picture.dy_um};
    Rows rows = cells_of(*picture.spectrum, x, y);
    double largest = 0;
    for (const auto& row : rows) largest = std::max(largest, *std::ranges::max_element(row));
    const double floor = largest > 0 ? 1e-8 * largest : 1e-8;
    for (auto& row : rows)
      for (double& value : row) value = std::log10(std::max(value, floor));
    gp << dark_to_light << "set tics out\nset title "
       << quoted(fmt::format("{}, n = {}", picture.title, picture.power)) << "\n";
    gp << "set xrange " << x.range() << "\nset yrange " << y.range() << "\n";
    gp << "set xlabel 'frequency along x [cycles/um]'\n"
       << "set ylabel 'frequency along y [cycles/um]'\n"
       << "set cblabel 'log10 of |DFT of s^" << picture.power << "|, summed over the pixels'\n";
    gp << fmt::format("set cbrange [{:.17g}:{:.17g}]\n", std::log10(floor),
                      std::log10(1e8 * floor));
    // Equal scales while neither side becomes a strip.
    if (const double aspect = picture.dx_um / picture.dy_um; aspect > 0.25 && aspect < 4)
      gp << "set size ratio -1\n";
    gp << "plot " << gp.image(rows)
       << fmt::format(
              " origin=({:.17g},{:.17g}) dx={:.17g} dy={:.17g} with image "
              "notitle\n",
              x.front(), y.front(), x.step(), y.step());
  });
}

std::string draw(const ExtremaPicture& picture, PictureFormat format) {
  struct Curve {
    const char *name, *style;
    double (*value)(const SpectrumExtrema&);
  };
  static constexpr Curve curves[] = {
      {"largest Re", "lc rgb '#0072b2' pt 7", [](const SpectrumExtrema& e) { return e.re.max; }},
      {"smallest Re", "lc rgb '#56b4e9' pt 6", [](const SpectrumExtrema& e) { return e.re.min; }},
      {"largest Im", "lc rgb '#d55e00' pt 5", [](const SpectrumExtrema& e) { return e.im.max; }},
      {"smallest Im", "lc rgb '#e69f00' pt 4", [](const SpectrumExtrema& e) { return e.im.min; }}};
  return draw({1200, 700}, format, [&](Drawing& gp) {
    gp << "set key outside top center horizontal\nset tics out\nset grid\n";
    gp << "set title " << quoted(picture.title) << "\n";
    gp << "set xlabel 'power n'\nset ylabel \"extrema of DFT of s^n, summed over the pixels\\n"
       << "(logarithmic, linear from -1 to 1)\"\n";
    gp << fmt::format("set xrange [-0.5:{}.5]\n", picture.powers.size() - 1);
    if (picture.powers.size() <= 20) gp << "set xtics 1\n";
    const double largest = largest_extremum(picture.powers);
    gp << "set ytics (" << decade_ticks(largest) << ")\n";
    std::string command = "plot ";
    for (const Curve& curve : curves) {
      std::vector<std::pair<double, double>> points;
      for (const SpectrumExtrema& extrema : picture.powers)
        points.emplace_back(static_cast<double>(points.size()),
                            symmetric_log(curve.value(extrema)));
      command += (&curve == curves ? "" : ", ") + gp.series(points) +
                 " with linespoints lw 2 ps 0.9 " + curve.style + " title '" + curve.name + "'";
    }
    gp << command << "\n";
  });
}

}  // namespace apps
