#include "evaluation/period/line_group.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <memory>
#include <optional>

#include "brdf/error.h"

namespace evaluation {
namespace {

using Complex = std::complex<double>;

/// Half of the window lies within the patch to 4 standard deviations: its transform is the
/// Gaussian's to 6e-5.
constexpr double group_share = 1.0 / 8;
/// Bins fitted around each line: to where a line has fallen to exp(-(3 / 1.27)^2 / 2) = 6 %.
constexpr double reach_bins = 3;
/// A line that moves farther than twice its own width fits something else.
constexpr double farthest_bins = 2.54;
/// Where the window stands beside the middle: half its standard deviation to each side.
constexpr double place_share = group_share / 2;
/// Of the four, at which a line must be seen again.
constexpr double least_places = 3;
constexpr int numbers_per_line = 4;  // frequency x, y in bins from the box's corner; amplitude

/// The spectrum on whole bins of a box of frequencies.
struct SpectrumBox {
  long first_col, first_row;
  Eigen::MatrixXcd bins;
  double window_x, window_y;  ///< 2 pi^2 s^2 in bins^-2
};

/// Weights, and exp(-2 pi i k x / L) of the bins first to first + count - 1.
Eigen::MatrixXcd waves(Eigen::Index pixels, long first, long count, double centre_pixels) {
  Eigen::MatrixXcd columns(pixels, count);
  const double length = static_cast<double>(pixels), half = (length - 1) / 2;
  for (Eigen::Index i = 0; i < pixels; ++i) {
    const double x = static_cast<double>(i) - half,
                 z = (x - centre_pixels) / (group_share * length);
    for (long k = 0; k < count; ++k)
      columns(i, k) = std::polar(std::exp(-0.5 * z * z),
                                 -2 * brdf::pi * static_cast<double>(first + k) * x / length);
  }
  return columns;
}

/// Phases are taken about the window's centre, so that amplitudes stay smooth over the bins.
void centre_phases(Eigen::MatrixXcd& bins, const SpectrumBox& box, double x, double y) {
  for (Eigen::Index j = 0; j < bins.rows(); ++j)
    for (Eigen::Index l = 0; l < bins.cols(); ++l)
      bins(j, l) *= std::polar(1.0, 2 * brdf::pi *
                                        (static_cast<double>(box.first_col + l) * x +
                                         static_cast<double>(box.first_row + j) * y));
}

SpectrumBox spectrum_box(const SurfaceWave& wave, const std::vector<Frequency>& lines,
                         const PatchWindow& window) {
  long lo_col = 1L << 40, hi_col = -lo_col, lo_row = lo_col, hi_row = hi_col;
  for (const Frequency& f : lines) {
    const double col = f.x_per_um * wave.width_um(), row = f.y_per_um * wave.height_um();
    lo_col = std::min(lo_col, std::lround(col - reach_bins));
    hi_col = std::max(hi_col, std::lround(col + reach_bins));
    lo_row = std::min(lo_row, std::lround(row - reach_bins));
    hi_row = std::max(hi_row, std::lround(row + reach_bins));
  }
  if (wave.rows() == 1) lo_row = hi_row = 0;
  SpectrumBox box{lo_col, lo_row, {}, 0, 0};
  const double cx = window.centre_x_um / wave.dx_um, cy = window.centre_y_um / wave.dy_um;
  const Eigen::MatrixXcd x = waves(wave.cols(), lo_col, hi_col - lo_col + 1, cx);
  const Eigen::MatrixXcd y = waves(wave.rows(), lo_row, hi_row - lo_row + 1, cy);
  const Eigen::MatrixXcd x0 = waves(wave.cols(), 0, 1, cx), y0 = waves(wave.rows(), 0, 1, cy);
  const auto transform = [&](const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b) {
    Eigen::MatrixXcd along(wave.rows(), b.cols());
    along.real() = wave.real.matrix() * b.real() - wave.imaginary.matrix() * b.imag();
    along.imag() = wave.real.matrix() * b.imag() + wave.imaginary.matrix() * b.real();
    return Eigen::MatrixXcd(a.transpose() * along);
  };
  const double sum = x0.real().sum() * y0.real().sum();
  const Complex mean = transform(y0, x0)(0, 0) / sum;
  box.bins = (transform(y, x) - mean * (y.colwise().sum().transpose() * x.colwise().sum())) / sum;
  centre_phases(box.bins, box, cx / static_cast<double>(wave.cols()),
                cy / static_cast<double>(wave.rows()));
  box.window_x = 2 * std::pow(brdf::pi * group_share, 2);
  box.window_y = wave.rows() == 1 ? 0 : box.window_x;
  return box;
}

/// The difference of one bin from the sum of all lines, real and imaginary.
struct BinResidual {
  double col, row;
  Complex value;
  double window_x, window_y;
  int lines;

  template <class T>
  bool operator()(T const* const* numbers, T* residual) const {
    T re(value.real()), im(value.imag());
    for (int k = 0; k < lines; ++k) {
      const T* line = numbers[0] + numbers_per_line * k;
      const T dx = T(col) - line[0], dy = T(row) - line[1];
      const T weight = ceres::exp(-(window_x * dx * dx + window_y * dy * dy));
      re -= weight * line[2];
      im -= weight * line[3];
    }
    residual[0] = re;
    residual[1] = im;
    return true;
  }
};

/// One line under a window, with the standard error of its period.
struct FittedLine {
  Frequency frequency;
  double std_nm;
};

/// All lines of a group; empty those that wandered off to fit something else.
using GroupFit = std::vector<std::optional<FittedLine>>;

/// Under the window neighbouring bins see the same noise: 1 / (2 pi^(1/2) s / L) bins an axis are
/// as good as one.
double bins_per_independent(bool has_rows) {
  const double one = 1 / (2 * std::sqrt(brdf::pi) * group_share);
  return has_rows ? one * one : one;
}

double std_nm_of(const Eigen::MatrixXd& covariance, int line, const Frequency& f, double width_um,
                 double height_um) {
  const double length = f.length_per_um();
  const Eigen::Vector2d gradient(f.x_per_um / length / width_um, f.y_per_um / length / height_um);
  const auto part = covariance.block<2, 2>(numbers_per_line * line, numbers_per_line * line);
  return f.period().nm() / length * std::sqrt(std::max(0.0, gradient.dot(part * gradient)));
}

std::optional<GroupFit> fit_group(const SurfaceWave& wave, const std::vector<Frequency>& starts,
                                  const PatchWindow& window) {
  const SpectrumBox box = spectrum_box(wave, starts, window);
  const int lines = static_cast<int>(starts.size()), numbers = numbers_per_line * lines;
  std::vector<double> x(static_cast<std::size_t>(numbers));
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const double col = starts[k].x_per_um * wave.width_um(),
                 row = starts[k].y_per_um * wave.height_um();
    const Complex nearest =
        box.bins(std::lround(row) - box.first_row, std::lround(col) - box.first_col);
    double* line = &x[k * numbers_per_line];
    line[0] = col;
    line[1] = row;
    line[2] = nearest.real();
    line[3] = nearest.imag();
  }
  ceres::Problem problem;
  for (Eigen::Index j = 0; j < box.bins.rows(); ++j)
    for (Eigen::Index l = 0; l < box.bins.cols(); ++l) {
      auto* cost = new ceres::DynamicAutoDiffCostFunction<BinResidual, 4>(new BinResidual{
          static_cast<double>(box.first_col + l), static_cast<double>(box.first_row + j),
          box.bins(j, l), box.window_x, box.window_y, lines});
      cost->AddParameterBlock(numbers);
      cost->SetNumResiduals(2);
      problem.AddResidualBlock(cost, nullptr, std::vector<double*>{x.data()});
    }
  if (wave.rows() == 1) {
    std::vector<int> fixed;
    for (int k = 0; k < lines; ++k) fixed.push_back(numbers_per_line * k + 1);
    problem.SetManifold(x.data(), new ceres::SubsetManifold(numbers, fixed));
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-14;
  options.parameter_tolerance = 1e-10;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (summary.termination_type != ceres::CONVERGENCE) return std::nullopt;

  ceres::Covariance::Options covariance_options;
  covariance_options.algorithm_type = ceres::DENSE_SVD;
  covariance_options.null_space_rank = -1;
  ceres::Covariance covariance(covariance_options);
  const std::vector<const double*> blocks{x.data()};
  if (!covariance.Compute(blocks, &problem)) return std::nullopt;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> c(numbers, numbers);
  covariance.GetCovarianceBlock(x.data(), x.data(), c.data());
  const double correlated = bins_per_independent(wave.rows() > 1);
  const double freedom =
      std::max(1.0, 2 * static_cast<double>(box.bins.size()) / correlated - numbers);
  const Eigen::MatrixXd scaled = c * (2 * summary.final_cost / freedom);
  GroupFit fit;
  for (int k = 0; k < lines; ++k) {
    const double* line = &x[static_cast<std::size_t>(numbers_per_line * k)];
    const Frequency f{line[0] / wave.width_um(), line[1] / wave.height_um()};
    const Frequency& start = starts[static_cast<std::size_t>(k)];
    const double wandered_bins = std::hypot((f.x_per_um - start.x_per_um) * wave.width_um(),
                                            (f.y_per_um - start.y_per_um) * wave.height_um());
    if (wandered_bins <= farthest_bins)
      fit.push_back(FittedLine{f, std_nm_of(scaled, k, f, wave.width_um(), wave.height_um())});
    else
      fit.push_back(std::nullopt);
  }
  return fit;
}

std::vector<PatchWindow> places_around(const SurfaceWave& wave) {
  std::vector<PatchWindow> places;
  for (const double sx : {-place_share, place_share})
    for (const double sy : {-place_share, place_share})
      places.push_back(
          {group_share, sx * wave.width_um(), wave.rows() == 1 ? 0 : sy * wave.height_um()});
  return places;
}

PeriodEstimate at_the_middle(const FittedLine& line) {
  PeriodEstimate one{};
  one.frequency = line.frequency;
  one.period_nm = line.frequency.period().nm();
  one.parts.fit_nm = line.std_nm;
  return one;
}

void add_place(PeriodEstimate& one, const PatchWindow& window, const Frequency& there) {
  one.by_window.push_back({window.centre_x_um, window.centre_y_um, there.period().nm()});
}

/// Makes the interval from the places; false where there are too few.
bool has_interval(PeriodEstimate& one) {
  const auto count = static_cast<double>(one.by_window.size());
  if (!(count >= least_places)) return false;
  double squares = 0;
  for (const LocalPeriod& local : one.by_window)
    squares += std::pow(local.period_nm - one.period_nm, 2);
  one.parts.window_nm = std::sqrt(squares / count);
  const double half = boost::math::quantile(boost::math::students_t(count), 0.975) *
                      std::hypot(one.parts.fit_nm, one.parts.window_nm);
  one.interval_nm = {one.period_nm - half, one.period_nm + half};
  return true;
}

/// A line that cannot be told from its neighbours by the fit: its maximum, window by window.
std::optional<PeriodEstimate> by_itself(const SurfaceWave& wave, const Frequency& start,
                                        const std::vector<PatchWindow>& places) {
  const auto middle = refined_line(wave, start, {group_share});
  if (!middle) return std::nullopt;
  PeriodEstimate one = at_the_middle({*middle, 0});
  for (const PatchWindow& window : places)
    if (const auto there = refined_line(wave, *middle, window)) add_place(one, window, *there);
  if (!has_interval(one)) return std::nullopt;
  return one;
}

}  // namespace

std::vector<std::optional<PeriodEstimate>> estimate_periods_together(
    const SurfaceWave& wave, const std::vector<Frequency>& starts) {
  std::vector<std::optional<PeriodEstimate>> estimates(starts.size());
  const std::vector<PatchWindow> places = places_around(wave);
  if (const auto middle = fit_group(wave, starts, {group_share})) {
    std::vector<Frequency> lines = starts;
    for (std::size_t k = 0; k < starts.size(); ++k)
      if ((*middle)[k]) {
        lines[k] = (*middle)[k]->frequency;
        estimates[k] = at_the_middle(*(*middle)[k]);
      }
    for (const PatchWindow& window : places)
      if (const auto there = fit_group(wave, lines, window))
        for (std::size_t k = 0; k < starts.size(); ++k)
          if (estimates[k] && (*there)[k]) add_place(*estimates[k], window, (*there)[k]->frequency);
  }
  for (std::size_t k = 0; k < starts.size(); ++k)
    if (!estimates[k] || !has_interval(*estimates[k]))
      estimates[k] = by_itself(wave, starts[k], places);
  return estimates;
}

}  // namespace evaluation
