#include "evaluation/period/pixel_beat.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "evaluation/period/lobe_basis.h"

namespace evaluation {
namespace {

constexpr int points = 97;         // over six half-widths of the lobe
constexpr int trials = 60;         // periods on either side
constexpr int places = 48;         // of the grating, over a period
constexpr double half_widths = 3;  // cells
constexpr int samples_of_pull = 512;
/// The error is of first order only, and the true period is found just as far off as its error: a
/// period counts that is no more than half as much again farther off.
constexpr double slack = 1.5;

/// g(x) h(x) / <z, z>: how an edge at x pulls, see the header.
class EdgePull {
 public:
  EdgePull(const WindowLobe& lobe, double k)
      : lobe_(lobe), step_um_(lobe.half_length_um() / samples_of_pull) {
    // An order whose neighbours are not the mirror.
    OrderCells cells{};
    cells.order = 3;
    const double half = std::min(half_widths * lobe.half_width_per_um(), k / 2);
    const Eigen::ArrayXd t = Eigen::ArrayXd::LinSpaced(points, -half, half);
    cells.q_per_um = 3 * k + t;
    cells.c_per_um = Eigen::ArrayXd::Zero(points);
    cells.power =
        Eigen::ArrayXd::Zero(points);  // as many as there are places; their values play no part
    const double step = 1e-3 * lobe.half_width_per_um();
    const Eigen::ArrayXd own = t.unaryExpr([&](double q) { return lobe(q); });
    const Eigen::ArrayXd slope =
        t.unaryExpr([&](double q) { return (lobe(q + step) - lobe(q - step)) / (2 * step); });
    const Eigen::MatrixXd taken = lobe_columns(cells, {0, 0}, lobe, k);
    const Eigen::VectorXd all = (own * slope).matrix();
    const Eigen::VectorXd z = all - taken * taken.colPivHouseholderQr().solve(all);
    for (int i = 0; i <= samples_of_pull + 1; ++i) {
      const double x_um = step_um_ * i;
      pull_.push_back(lobe.illumination(x_um) * (own * (t * x_um).sin()).matrix().dot(z) /
                      z.squaredNorm());
    }
  }

  /// h is odd, and linear between samples.
  double operator()(double x_um) const {
    const double at = std::abs(x_um) / step_um_;
    const auto i = std::min(static_cast<std::size_t>(at), pull_.size() - 2);
    const double value = std::lerp(pull_[i], pull_[i + 1], at - static_cast<double>(i));
    return std::copysign(1.0, x_um) * value;
  }

  /// The error of a period if all edges erred by half a pixel to the worst side.
  double bound(double pixel_um, double period_um) const {
    double moved = 0, lit = 0;
    for (double x_um = 0; x_um <= lobe_.half_length_um(); x_um += period_um) {
      moved += std::abs((*this)(x_um));
      lit += lobe_.illumination(x_um);
    }
    return lit > 0 ? pixel_um / 2 * moved / lit : 0;
  }

  /// Relative error of a period with an edge at place_um.
  double error(double pixel_um, double period_um, double place_um) const {
    const double end_um = lobe_.half_length_um();
    double moved = 0, lit = 0;
    for (double j = std::ceil((-end_um - place_um) / period_um);; ++j) {
      const double x_um = place_um + j * period_um;
      if (x_um > end_um) break;
      const double pixels = x_um / pixel_um;
      moved += (std::round(pixels) - pixels) * pixel_um * (*this)(x_um);
      lit += lobe_.illumination(x_um);
    }
    return lit > 0 ? moved / lit : 0;
  }

 private:
  const WindowLobe& lobe_;
  double step_um_;
  std::vector<double> pull_;
};

}  // namespace

double pixel_deviation(const WindowLobe& lobe, double pixel_um, double period_um) {
  const EdgePull pull(lobe, 2 * brdf::pi / period_um);
  const auto largest_error = [&](double period) {
    double largest = 0;
    for (int i = 0; i < places; ++i)
      largest = std::max(largest, std::abs(pull.error(pixel_um, period, period * i / places)));
    return largest;
  };
  const double farthest = slack * pull.bound(pixel_um, period_um);
  double largest = 0;
  for (int i = -trials; i <= trials; ++i) {
    const double apart = farthest * i / trials;
    const double error = largest_error(period_um * (1 + apart));
    if (std::abs(apart) <= slack * error) largest = std::max(largest, error);
  }
  return largest / std::sqrt(3.0);
}

}  // namespace evaluation
