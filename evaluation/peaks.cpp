#include "evaluation/peaks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brdf/grating_equation.h"

namespace evaluation {
namespace {

using brdf::Angle;
using brdf::Length;

struct Interval {
  double lo, hi;

  Interval intersected(Interval other) const {
    return {std::max(lo, other.lo), std::min(hi, other.hi)};
  }
};

/// The spatial frequencies (sin theta_i + sin theta_r) / lambda [1/um] where an order is looked
/// for.
Interval frequencies_per_um(const PlaneOfIncidence& plane, const PeakSearch& search) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const double m = search.order;
  Interval window{-inf, inf};
  if (search.order != 0) {
    const double mirror = mirror_radius_sigma_f * plane.sigma_f_per_um.value_or(0);
    window = m > 0 ? Interval{mirror, inf} : Interval{-inf, -mirror};
  }
  if (search.period_guess) {
    const double d = search.period_guess->um();
    window = window.intersected({(m - 0.5) / d, (m + 0.5) / d});
  }
  if (search.period_range) {
    const auto [shortest, longest] = *search.period_range;
    const auto [lo, hi] = std::minmax({m / shortest.um(), m / longest.um()});
    window = window.intersected({lo, hi});
  }
  return window;
}

/// Angle at the vertex of the parabola through three cells around the brightest one.
double refined_deg(const ResponseMatrix& response, Eigen::Index row, Eigen::Index top) {
  double x[3], y[3];
  for (int i = 0; i < 3; ++i) {
    const Eigen::Index column = top + i - 1;
    x[i] = std::sin(Angle::deg(response.theta_r_deg[static_cast<std::size_t>(column)]).rad());
    y[i] = response.values(row, column);
  }
  if (std::min({y[0], y[1], y[2]}) > 0)
    for (double& value : y) value = std::log(value);
  const double left = x[1] - x[0], right = x[2] - x[1];
  const double rise = (y[1] - y[0]) / left, fall = (y[1] - y[2]) / right;
  // Newton's form about the middle; both slopes are >= 0 at a maximum.
  const double curvature = rise + fall;
  if (!(curvature > 0)) return response.theta_r_deg[static_cast<std::size_t>(top)];
  const double vertex = x[1] + (rise * right - fall * left) / (2 * curvature);
  return Angle::rad(std::asin(std::clamp(vertex, x[0], x[2]))).deg();
}

void require_positive(const std::optional<Length>& period, const char* what) {
  if (period && !(period->um() > 0))
    throw brdf::Error(brdf::Errc::invalid_argument,
                      std::string(what) + " " + brdf::text(period->nm()) + " nm must be > 0");
}

}  // namespace

double PlaneOfIncidence::sines(double theta_r_deg) const {
  return std::sin(theta_i.rad()) + light_side * std::sin(Angle::deg(theta_r_deg).rad());
}

PlaneOfIncidence plane_of_incidence(Angle theta_i, Angle phi_i, Angle phi_r) {
  const double apart = std::abs(std::remainder(phi_r.deg() - phi_i.deg(), 360.0));
  constexpr double tolerance_deg = 1e-9;
  if (apart <= tolerance_deg) return {theta_i, 1, {}};
  if (180 - apart <= tolerance_deg) return {theta_i, -1, {}};
  throw brdf::Error(brdf::Errc::invalid_argument,
                    "the grating equation needs the viewer in the plane of incidence: phi_r " +
                        brdf::text(phi_r.deg()) + " deg must equal phi_i " +
                        brdf::text(phi_i.deg()) + " deg, or be opposite to it");
}

std::vector<Peak> find_peaks(const ResponseMatrix& response, const PlaneOfIncidence& plane,
                             const PeakSearch& search) {
  require_positive(search.period_guess, "period guess");
  if (search.period_range) {
    require_positive(search.period_range->first, "period");
    require_positive(search.period_range->second, "period");
  }
  const Interval window = frequencies_per_um(plane, search);
  const Axis& theta = response.theta_r_deg;
  std::vector<Peak> peaks;
  for (std::size_t i = 0; i < response.lambda_nm.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double lambda_um = Length::nm(response.lambda_nm[i]).um();
    Peak peak{response.lambda_nm[i], std::nullopt};
    std::optional<Eigen::Index> first, last, top;
    for (std::size_t j = 0; j < theta.size(); ++j) {
      const double frequency = plane.sines(theta[j]) / lambda_um;
      if (!(frequency >= window.lo && frequency <= window.hi)) continue;
      if (search.theta_r_deg &&
          !(theta[j] >= search.theta_r_deg->first && theta[j] <= search.theta_r_deg->second))
        continue;
      const auto column = static_cast<Eigen::Index>(j);
      if (!first) first = column;
      last = column;
      if (!top || response.values(row, column) > response.values(row, *top)) top = column;
    }
    if (top && *top > *first && *top < *last &&
        response.values(row, *top) > response.values(row, *last) &&
        response.values(row, *top) > search.floor) {
      const auto column = static_cast<std::size_t>(*top);
      peak.value = response.values(row, *top);
      peak.grid_theta_r_deg = theta[column];
      peak.theta_r_deg =
          search.refinement == Refinement::grid ? theta[column] : refined_deg(response, row, *top);
    }
    peaks.push_back(peak);
  }
  return peaks;
}

std::optional<double> period_nm(const PlaneOfIncidence& plane, int order, double lambda_nm,
                                double theta_r_deg) {
  const std::optional<Length> period = brdf::period_from_angle(
      order, Length::nm(lambda_nm), plane.theta_i, Angle::deg(plane.light_side * theta_r_deg));
  if (!period) return std::nullopt;
  return period->nm();
}

std::string to_csv(const std::vector<Peak>& peaks, const PlaneOfIncidence& plane, int order,
                   const ResponseMatrix& response) {
  std::string csv = "lambda_nm,order,theta_peak_deg,value,period_nm\n";
  for (const Peak& peak : peaks) {
    csv.append(number_text(peak.lambda_nm, response.lambda_nm.decimals)).append(",");
    csv.append(std::to_string(order)).append(",");
    if (peak.theta_r_deg) {
      const std::optional<double> period =
          period_nm(plane, order, peak.lambda_nm, *peak.theta_r_deg);
      csv.append(number_text(*peak.theta_r_deg)).append(",");
      csv.append(number_text(peak.value)).append(",");
      if (period) csv.append(number_text(*period));
    } else {
      csv.append(",,");
    }
    csv.append("\n");
  }
  return csv;
}

}  // namespace evaluation
