#include "evaluation/period/ridge_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace evaluation {
namespace {

/// Points a sigma_f: the parabola through three logarithms of a lobe then has its vertex inside.
constexpr double points_per_sigma_f = 6;
/// What coarse cells beside fine ones may cost in memory.
constexpr double most_points_per_cell = 8;
/// FWHM of the power exp(-f^2 / sigma_f^2) of a lobe, in sigma_f: 2 sqrt(ln 2).
const double lobe_fwhm_sigma_f = 2 * std::sqrt(std::log(2.0));

/// 2 g(2 sigma) / (2 pi integral of g) sigma / sigma_f, and a half more.
constexpr double cut_window_sidelobe = 1.0 / 6;
/// 1 / (pi L) of an evenly lit length L, whose lobe is 0.886 / L wide.
constexpr double even_light_sidelobe = 0.6;

/// One wavelength as a piecewise linear function of f, with its integral.
class Row {
 public:
  void add(double f, double value) {
    f_.push_back(f);
    value_.push_back(value);
  }
  /// Brings f into increasing order and integrates.
  void finish() {
    if (f_.size() > 1 && f_.front() > f_.back()) {
      std::ranges::reverse(f_);
      std::ranges::reverse(value_);
    }
    integral_.assign(f_.size(), 0);
    for (std::size_t i = 1; i < f_.size(); ++i)
      integral_[i] = integral_[i - 1] + (value_[i] + value_[i - 1]) / 2 * (f_[i] - f_[i - 1]);
  }

  std::size_t size() const { return f_.size(); }
  const std::vector<double>& f() const { return f_; }
  double mean(double lo, double hi) const { return (integral(hi) - integral(lo)) / (hi - lo); }

  /// Full width at half maximum of the brightest lobe; infinite where an edge cuts it.
  double brightest_width() const {
    const std::size_t top =
        static_cast<std::size_t>(std::ranges::max_element(value_) - value_.begin());
    std::size_t left = top, right = top;
    while (left > 0 && value_[left] > value_[top] / 2) --left;
    while (right + 1 < size() && value_[right] > value_[top] / 2) ++right;
    if (!(value_[left] <= value_[top] / 2 && value_[right] <= value_[top] / 2) || left == right)
      return std::numeric_limits<double>::infinity();
    const auto crossing = [&](std::size_t low, std::size_t high) {
      const double part = (value_[top] / 2 - value_[low]) / (value_[high] - value_[low]);
      return f_[low] + part * (f_[high] - f_[low]);
    };
    return crossing(right, right - 1) - crossing(left, left + 1);
  }

 private:
  double integral(double f) const {
    const auto after = std::upper_bound(f_.begin() + 1, f_.end() - 1, f);
    const std::size_t i = static_cast<std::size_t>(after - f_.begin());
    const double part = (f - f_[i - 1]) / (f_[i] - f_[i - 1]);
    const double value = value_[i - 1] + part * (value_[i] - value_[i - 1]);
    return integral_[i - 1] + (value_[i - 1] + value) / 2 * (f - f_[i - 1]);
  }

  std::vector<double> f_, value_, integral_;
};

std::vector<Row> rows_of(const ResponseMatrix& response, const PlaneOfIncidence& plane,
                         const std::optional<std::pair<double, double>>& theta_r_deg) {
  std::vector<Row> rows(response.lambda_nm.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double lambda_um = brdf::Length::nm(response.lambda_nm[i]).um();
    for (std::size_t j = 0; j < response.theta_r_deg.size(); ++j) {
      const double theta = response.theta_r_deg[j];
      if (theta_r_deg && !(theta >= theta_r_deg->first && theta <= theta_r_deg->second)) continue;
      const double value =
          response.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      if (!std::isfinite(value))
        throw brdf::Error(brdf::Errc::bad_input, "response at " +
                                                     brdf::text(response.lambda_nm[i]) + " nm, " +
                                                     brdf::text(theta) + " deg must be finite");
      rows[i].add(plane.sines(theta) / lambda_um, value);
    }
    rows[i].finish();
  }
  return rows;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double median_spacing(const std::vector<Row>& rows) {
  std::vector<double> spacings;
  for (const Row& row : rows)
    for (std::size_t j = 1; j < row.size(); ++j) spacings.push_back(row.f()[j] - row.f()[j - 1]);
  return median(spacings);
}

double lobe_sigma_f(const std::vector<Row>& rows) {
  std::vector<double> widths;
  for (const Row& row : rows) widths.push_back(row.brightest_width());
  return median(widths) / lobe_fwhm_sigma_f;
}

void set_axis(FrequencyResponse& over, const std::vector<Row>& rows,
              const PlaneOfIncidence& plane) {
  double lo = std::numeric_limits<double>::infinity(), hi = -lo;
  for (const Row& row : rows) {
    lo = std::min(lo, row.f().front());
    hi = std::max(hi, row.f().back());
  }
  const double cells = median_spacing(rows);
  const double least = (hi - lo) / (most_points_per_cell * static_cast<double>(rows[0].size()));
  const double estimate = plane.sigma_f_per_um.value_or(lobe_sigma_f(rows));
  over.step_per_um = std::max(cells, least);
  if (std::isfinite(estimate))
    over.step_per_um = std::max(over.step_per_um, estimate / points_per_sigma_f);
  over.sigma_f_per_um = plane.sigma_f_per_um.value_or(
      std::isfinite(estimate) ? std::max(estimate, over.step_per_um) : over.step_per_um);
  over.sidelobe = plane.sigma_f_per_um ? cut_window_sidelobe : even_light_sidelobe;
  over.first_per_um = lo + over.step_per_um / 2;
  const auto points = static_cast<std::size_t>(std::floor((hi - lo) / over.step_per_um));
  over.mean.assign(points, 0);
  over.rows.assign(points, 0);
}

void resample(FrequencyResponse& over, const std::vector<Row>& rows) {
  over.values.setZero(static_cast<Eigen::Index>(rows.size()),
                      static_cast<Eigen::Index>(over.points()));
  over.seen.assign(rows.size(), {});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < over.points(); ++j) {
      const double f = over.frequency(static_cast<double>(j)), half = over.step_per_um / 2;
      if (!(f - half >= rows[i].f().front() && f + half <= rows[i].f().back())) continue;
      SeenPoints& seen = over.seen[i];
      if (seen.end == 0) seen.begin = j;
      seen.end = j + 1;
      // The interpolated mean of values that are not negative is so but for rounding.
      over.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          std::max(rows[i].mean(f - half, f + half), 0.0);
    }
  }
}

/// S(f) for the gains as they are.
void take_mean(FrequencyResponse& over) {
  std::ranges::fill(over.mean, 0);
  std::ranges::fill(over.rows, 0);
  for (std::size_t i = 0; i < over.seen.size(); ++i)
    for (std::size_t j = over.seen[i].begin; j < over.seen[i].end; ++j) {
      over.mean[j] +=
          over.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) / over.gain[i];
      ++over.rows[j];
    }
  for (std::size_t j = 0; j < over.points(); ++j)
    if (over.rows[j] > 0) over.mean[j] /= static_cast<double>(over.rows[j]);
}

/// Power of a wavelength over that of S where it looks; the largest change of a gain.
double take_gains(FrequencyResponse& over) {
  double change = 0;
  for (std::size_t i = 0; i < over.seen.size(); ++i) {
    double power = 0, expected = 0;
    for (std::size_t j = over.seen[i].begin; j < over.seen[i].end; ++j) {
      if (over.in_mirror(j)) continue;
      power += over.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      expected += over.mean[j];
    }
    if (!(power > 0 && expected > 0)) {  // a dark wavelength says nothing
      over.seen[i] = {};
      continue;
    }
    change = std::max(change, std::abs(power / expected / over.gain[i] - 1));
    over.gain[i] = power / expected;
  }
  return change;
}

}  // namespace

bool FrequencyResponse::in_mirror(std::size_t point) const {
  return std::abs(frequency(static_cast<double>(point))) < mirror_radius_sigma_f * sigma_f_per_um;
}

FrequencyResponse over_frequency(const ResponseMatrix& response, const PlaneOfIncidence& plane,
                                 const std::optional<std::pair<double, double>>& theta_r_deg) {
  const std::vector<Row> rows = rows_of(response, plane, theta_r_deg);
  FrequencyResponse over{};
  if (rows.empty() || rows[0].size() < 3) return over;
  set_axis(over, rows, plane);
  resample(over, rows);
  over.gain.assign(rows.size(), 1);
  // Gains are compared with strengths to a thousandth at best; the iteration halves its error or
  // better, unless wavelengths share no frequency, where nothing is left to compare.
  constexpr double enough = 1e-6;
  constexpr int most = 100;
  for (int i = 0; i < most; ++i) {
    take_mean(over);
    if (take_gains(over) <= enough) break;
  }
  take_mean(over);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t j = 0; j < over.points(); ++j)
    if (over.rows[j] > 0 && !over.in_mirror(j)) {
      sum += over.mean[j];
      ++count;
    }
  if (!(sum > 0)) return FrequencyResponse{};
  const double scale = sum / static_cast<double>(count);
  for (double& value : over.mean) value /= scale;
  for (std::size_t i = 0; i < over.gain.size(); ++i) {
    over.gain[i] *= scale;
    over.values.row(static_cast<Eigen::Index>(i)) /= over.gain[i];
  }
  return over;
}

}  // namespace evaluation
