#include "evaluation/period/pixel_beat.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "evaluation/period/lobe_basis.h"

namespace evaluation {
namespace {

constexpr int harmonics = 24;      // the sum over those left out is below 2 % of the whole
constexpr int points = 97;         // over six half-widths of the lobe
constexpr int trials = 60;         // periods on either side
constexpr double half_widths = 3;  // cells, and copies that draw the period
constexpr double deviations = 2;

/// rho(s), see the header.
class CopyPull {
 public:
  CopyPull(const WindowLobe& lobe, double k) : lobe_(lobe) {
    // An order whose neighbours are not the mirror.
    cells_.order = 3;
    const double half = std::min(half_widths * lobe.half_width_per_um(), k / 2);
    offset_ = Eigen::ArrayXd::LinSpaced(points, -half, half);
    cells_.q_per_um = 3 * k + offset_;
    cells_.c_per_um = Eigen::ArrayXd::Zero(points);
    cells_.c_low_per_um = cells_.c_high_per_um = 0;
    const double step = 1e-3 * lobe.half_width_per_um();
    own_ = offset_.unaryExpr([&](double t) { return lobe(t); });
    const Eigen::ArrayXd slope =
        offset_.unaryExpr([&](double t) { return (lobe(t + step) - lobe(t - step)) / (2 * step); });
    const Eigen::MatrixXd taken = lobe_columns(cells_, {0, 0}, lobe, k);
    const Eigen::VectorXd all = (own_ * slope).matrix();
    z_ = all - taken * taken.colPivHouseholderQr().solve(all);
    squares_ = z_.squaredNorm();
  }

  double operator()(double s_per_um) const {
    const Eigen::ArrayXd copy = offset_.unaryExpr([&](double t) { return lobe_(t - s_per_um); });
    return (own_ * copy).matrix().dot(z_) / squares_;
  }

 private:
  const WindowLobe& lobe_;
  OrderCells cells_{};
  Eigen::ArrayXd offset_, own_;
  Eigen::VectorXd z_;
  double squares_;
};

double deviation_at(const CopyPull& pull, double pixel_um, double period_um) {
  const double k = 2 * brdf::pi / period_um;
  double variance = 0;
  for (int m = 1; m <= harmonics; ++m) {
    const double beat = m * period_um / pixel_um;
    const double delta = beat - std::round(beat);
    const double other = delta - std::copysign(1.0, delta);
    for (const double apart : {delta, other}) {
      const double moved = pixel_um * pull(apart * k) / (m * period_um * k);
      variance += 2 * moved * moved;
    }
  }
  return std::sqrt(variance);
}

}  // namespace

double pixel_deviation(const WindowLobe& lobe, double pixel_um, double period_um) {
  const double k = 2 * brdf::pi / period_um;
  const CopyPull pull(lobe, k);
  // A copy within the lobe's cells: delta K < 3 half-widths.
  const double farthest =
      std::min(0.5, half_widths * lobe.half_width_per_um() / k) * pixel_um / period_um;
  double largest = 0;
  for (int i = -trials; i <= trials; ++i) {
    const double apart = farthest * i / trials;
    const double deviation = deviation_at(pull, pixel_um, period_um * (1 + apart));
    if (std::abs(apart) <= deviations * deviation) largest = std::max(largest, deviation);
  }
  return largest;
}

}  // namespace evaluation
