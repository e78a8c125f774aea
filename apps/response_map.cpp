#include "apps/response_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace apps {
namespace {

/// The heat map on a logarithmic scale: four decades below the maximum, darker cells at its end.
std::vector<std::vector<double>> logarithmic(const evaluation::ResponseMatrix& response,
                                             double floor) {
  std::vector<std::vector<double>> rows;
  for (const auto& row : response.values.rowwise()) {
    std::vector<double>& values = rows.emplace_back();
    for (const double value : row) values.push_back(std::log10(std::max(value, floor)));
  }
  return rows;
}

}  // namespace

std::string plot_response_map(Drawing& gp, const evaluation::ResponseMatrix& response,
                              const evaluation::PlaneOfIncidence& plane,
                              const std::string& value_label) {
  const double brightest = response.values.maxCoeff();
  const double floor = brightest > 0 ? brightest * 1e-4 : 1e-300;
  const auto [x0, dx] = grid(response.theta_r_deg);
  const auto [y0, dy] = grid(response.lambda_nm);
  set_range(gp, "xrange", response.theta_r_deg);
  set_range(gp, "yrange", response.lambda_nm);
  gp << "set xlabel 'viewing angle theta_r [deg], positive on the "
     << (plane.light_side > 0 ? "light''s side" : "side opposite to the light")
     << "'\nset ylabel 'wavelength [nm]'\n";
  gp << "set cblabel " << quoted("log10 of " + value_label) << "\n";
  gp << fmt::format("set cbrange [{:.17g}:{:.17g}]\n", std::log10(floor),
                    std::log10(std::max(brightest, floor * 10)));
  return "plot " + gp.image(logarithmic(response, floor)) +
         fmt::format(" origin=({:.17g},{:.17g}) dx={:.17g} dy={:.17g} with image notitle", x0, y0,
                     dx, dy);
}

}  // namespace apps
