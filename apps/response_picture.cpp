#include "apps/response_picture.h"

#include <fmt/format.h>

#include <cmath>

#include "apps/gnuplot.h"
#include "apps/response_map.h"
#include "brdf/grating_equation.h"

namespace apps {
namespace {

using evaluation::Peak;

/// The angles of the fitted period, per wavelength where the order is visible.
std::vector<std::pair<double, double>> fitted_curve(const ResponsePicture& picture) {
  std::vector<std::pair<double, double>> curve;
  for (const double lambda_nm : picture.response->lambda_nm.values)
    if (const auto angle =
            brdf::viewing_angle(picture.order, brdf::Length::nm(picture.fit->period_nm),
                                brdf::Length::nm(lambda_nm), picture.plane.theta_i))
      curve.emplace_back(picture.plane.light_side * angle->deg(), lambda_nm);
  return curve;
}

void heat_map(Drawing& gp, const ResponsePicture& picture) {
  gp << plot_response_map(gp, *picture.response, picture.plane, picture.value_label);
  std::vector<std::pair<double, double>> points;
  for (const Peak& peak : picture.peaks)
    if (peak.theta_r_deg) points.emplace_back(*peak.theta_r_deg, peak.lambda_nm);
  if (!points.empty())
    gp << ", " << gp.series(points)
       << " with points pt 7 ps 0.35 lc rgb 'black' title 'peak of each wavelength'";
  if (picture.fit) {
    const auto curve = fitted_curve(picture);
    if (!curve.empty())
      gp << ", " << gp.series(curve) << " with lines lw 2 dt 2 lc rgb '#0060ff' title "
         << quoted(fmt::format("grating equation, order {:+d}, d = {:.2f} nm", picture.order,
                               picture.fit->period_nm));
  }
  gp << "\n";
}

/// Period of each peak, with the fit and its outliers.
void period_panel(Drawing& gp, const ResponsePicture& picture) {
  std::vector<std::pair<double, double>> periods;
  for (const Peak& peak : picture.peaks)
    if (peak.theta_r_deg)
      if (const auto d = period_nm(picture.plane, picture.order, peak.lambda_nm, *peak.theta_r_deg))
        periods.emplace_back(peak.lambda_nm, *d);
  const double d = picture.fit->period_nm, error = picture.fit->std_error_nm;
  gp << "set autoscale y\nset ylabel 'period of each peak [nm]'\nset xlabel 'wavelength [nm]'\n";
  set_range(gp, "xrange", picture.response->lambda_nm);
  gp << fmt::format("plot {:.17g} with lines lw 2 lc rgb '#0080c0' title ", d)
     << quoted(fmt::format("fit {:.2f} nm, standard error {:.2g} nm", d, error)) << ", "
     << gp.series(periods)
     << " with points pt 7 ps 0.5 lc rgb '#c04000' title 'period of each peak'\n";
}

}  // namespace

std::string draw(const ResponsePicture& picture, PictureFormat format) {
  const PictureSize size{1200, picture.fit ? 1150 : 800};
  return draw(size, format, [&](Drawing& gp) {
    gp << dark_to_light;
    gp << "set key outside top center horizontal\nset tics out\n";
    if (picture.fit) gp << "set multiplot\nset origin 0,0.3\nset size 1,0.7\n";
    gp << "set title " << quoted(picture.title) << "\n";
    heat_map(gp, picture);
    if (!picture.fit) return;
    gp << "set origin 0,0\nset size 1,0.3\nunset title\nunset colorbox\n";
    period_panel(gp, picture);
    gp << "unset multiplot\n";
  });
}

}  // namespace apps
