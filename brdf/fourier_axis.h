// One axis of a surface on a frequency grid, from which any frequency can be interpolated.
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "brdf/fourier.h"
#include "brdf/interpolation_kernel.h"
#include "brdf/surface.h"
#include "brdf/window_cut.h"

namespace brdf {

/// What a FourierAxis is made for.
struct FourierAxisRequest {
  double lo_per_um, hi_per_um;  ///< frequencies that will be asked
  double tolerance;             ///< of the amplitude, from this axis
  double oversampling;          ///< wanted ratio of grid length to samples, > 1
};

/// Even samples about x = 0 of any origin, each of modulus at most its share of 1.
struct EvenSamples {
  std::size_t count;
  double pitch_um;
};

/// Transform of samples along one axis: a grid of frequencies and the kernel between its points.
///
/// For a sum over samples n at x_n with weights, A(q) = sum_n v_n e^{i q x_n} =~
/// e^{i q centre} sum_k psi(k - p) F_k, p = q / step. F is the FFT of v_n / psi^(x_n).
/// - isolated and replicated: the pixels of the patch, zero-padded, exponential-of-semicircle psi;
/// - periodic: the lines of the patch at q = 2 pi k / L with the window's own Gaussian as psi
///   (Thesis 1.33, 1.34), or, where that kernel is the wider one (a window much narrower than the
///   patch), the pixels under the window as above.
/// `error_bound` covers kernel, polynomials and cut window: sum_n w_n e(x_n), w_n the normalised
/// illumination, e the kernel's error of one sample.
class FourierAxis {
 public:
  FourierAxis(const Surface& surface, const SurfaceAxis& axis, const FourierAxisRequest& request)
      : pixels_(static_cast<std::size_t>(axis.count)) {
    if (surface.model == SurfaceModel::periodic)
      set_periodic(surface, axis, request);
    else
      set_samples(surface, axis, request, 0, axis.count - 1,
                  axis.pixel_um * (static_cast<double>(axis.count - 1) / 2));
    set_stored(request);
  }

  /// For samples that are given whole, window and all; prepared.
  FourierAxis(const EvenSamples& samples, const FourierAxisRequest& request)
      : pixels_(samples.count) {
    set_grid(samples.pitch_um, 0, static_cast<long>(samples.count) - 1, request.oversampling);
    centre_half_samples_ = static_cast<long>(samples.count) - 1;
    choose_kernel(request.tolerance, [&] {
      const std::vector<double> errors = kernel_.relative_errors(mesh_omegas());
      return *std::max_element(errors.begin(), errors.end());
    });
    set_stored(request);
    set_phases();
    weights_ = sample_transforms();
    for (double& weight : weights_) weight = 1 / weight;
    amplification_ = *std::max_element(weights_.begin(), weights_.end()) *
                     kernel_.transform({0.0})[0] * (1 + error_bound_);
  }

  const InterpolationKernel& kernel() const { return kernel_; }
  double error_bound() const { return error_bound_; }
  /// Bound on sum over taps of psi times the largest grid value, for samples of modulus 1.
  double amplification() const { return amplification_; }
  double oversampling() const {
    return static_cast<double>(length_) / static_cast<double>(samples_);
  }
  std::size_t length() const { return length_; }  ///< of the FFT
  long first() const { return first_; }           ///< first stored grid point
  /// F_{k + length} / F_k: at most one period is stored.
  double turn_sign() const { return centre_half_samples_ % 2 == 0 ? 1 : -1; }
  std::size_t stored() const { return static_cast<std::size_t>(last_ - first_ + 1); }
  /// Grid points per rad/um.
  double grid_per_frequency_um() const {
    return pixel_um_ * static_cast<double>(length_) / (2 * pi);
  }

  /// Prepares the weights; to be called once before `transform`.
  void prepare(const Surface& surface, const SurfaceAxis& axis) {
    set_phases();
    weights_.assign(samples_, 1 / static_cast<double>(pixels_));
    if (gaussian_) {
      for (double x = 0; x < 1; x += 1.0 / 64) {
        const std::vector<double> taps = kernel_.taps(x);
        amplification_ = std::max(amplification_, std::accumulate(taps.begin(), taps.end(), 0.0));
      }
      return;
    }
    const std::vector<double> transforms = sample_transforms();
    double sum = 0;
    for (std::size_t n = 0; n < samples_; ++n) {
      weights_[n] = sample_weight(surface, axis, n);
      sum += weights_[n];
    }
    double largest = 0;
    for (std::size_t n = 0; n < samples_; ++n) {
      weights_[n] /= sum * transforms[n];
      largest += weights_[n];
    }
    amplification_ = largest * kernel_.transform({0.0})[0] * (1 + error_bound_);
  }

  /// Calls store(slot, F_k) for each stored grid point; values: one per pixel.
  template <class Value, class Store>
  void transform(ComplexFourier1d& fourier, Value value, Store store) const {
    const std::span<std::complex<double>> data = fourier.data();
    std::fill(data.begin(), data.end(), 0.0);
    for (std::size_t n = 0; n < samples_; ++n) data[n % length_] += weights_[n] * value(source(n));
    fourier.transform();
    for (std::size_t slot = 0; slot < phases_.size(); ++slot)
      store(slot, data[bin(first_ + static_cast<long>(slot))] * phases_[slot]);
  }

 private:
  void set_stored(const FourierAxisRequest& request) {
    const double scale = grid_per_frequency_um();
    const double half_width = kernel_.width() / 2.0;
    first_ = static_cast<long>(std::ceil(request.lo_per_um * scale - half_width)) - 1;
    last_ = static_cast<long>(std::ceil(request.hi_per_um * scale - half_width)) + kernel_.width();
    last_ = std::min(last_, first_ + static_cast<long>(length_) + kernel_.width() - 2);
  }

  /// The kernel's transform at every sample.
  std::vector<double> sample_transforms() const {
    // The kernel is even: samples that lie symmetrically share their transform.
    const bool symmetric = centre_half_samples_ == static_cast<long>(samples_) - 1;
    std::vector<double> omegas;
    for (std::size_t n = 0; n < (symmetric ? (samples_ + 1) / 2 : samples_); ++n)
      omegas.push_back(omega(n));
    std::vector<double> transforms = kernel_.transform(omegas);
    for (std::size_t n = transforms.size(); n < samples_; ++n)
      transforms.push_back(transforms[samples_ - 1 - n]);
    return transforms;
  }

  std::size_t bin(long k) const {
    const long length = static_cast<long>(length_);
    return static_cast<std::size_t>(((k % length) + length) % length);
  }

  /// exp(-2 pi i k centre / length), reduced in whole half-samples before it meets pi.
  void set_phases() {
    const long turn = 2 * static_cast<long>(length_);
    for (long k = first_; k <= last_; ++k) {
      const long reduced = (k % turn) * (centre_half_samples_ % turn) % turn;
      phases_.push_back(
          std::polar(1.0, -2 * pi * static_cast<double>(reduced) / static_cast<double>(turn)));
    }
  }

  /// Sample n lies at (n - centre) pixels from the centre; its angle per grid point.
  double omega(std::size_t n) const {
    return 2 * pi * (static_cast<double>(n) - static_cast<double>(centre_half_samples_) / 2) /
           static_cast<double>(length_);
  }
  std::size_t source(std::size_t n) const {
    const long pixels = static_cast<long>(pixels_);
    return static_cast<std::size_t>(((first_sample_ + static_cast<long>(n)) % pixels + pixels) %
                                    pixels);
  }
  double sample_weight(const Surface& surface, const SurfaceAxis& axis, std::size_t n) const {
    return illumination(surface, axis.pixel_um * (static_cast<double>(first_sample_) +
                                                  static_cast<double>(n) - tile_origin_));
  }

  void set_periodic(const Surface& surface, const SurfaceAxis& axis,
                    const FourierAxisRequest& request) {
    const double length_um = axis.pixel_um * static_cast<double>(axis.count);
    const double sigma_bins = length_um * surface.window.sigma_f_per_um();
    // Left out on both sides: less than 2.6 exp(-width^2 / (8 sigma^2)) max(1, 2.6 sigma).
    const auto omitted = [&](int width) {
      double sum = 0;
      for (int n = 0; n < 40 * (1 + static_cast<int>(sigma_bins)); ++n) {
        const double d = (width / 2.0 + n) / sigma_bins;
        sum += (n == 0 ? 1 : 2) * std::exp(-0.5 * d * d);
      }
      return sum;
    };
    int width = 2;
    while (width < InterpolationKernel::max_width && !(omitted(width) <= request.tolerance))
      ++width;
    const WindowCut cut = cut_window(surface, axis, request.tolerance / 8);
    const double middle = axis.origin, samples = cut.samples;
    const bool narrow_window =
        2 * samples * request.oversampling <= 3 * static_cast<double>(axis.count);
    if (omitted(width) <= request.tolerance && (width <= 10 || !narrow_window)) {
      // Sum of the window over its integral: 1 unless it is about as narrow as a pixel.
      const double sum_per_integral = window_sums(surface, axis).g * axis.pixel_um /
                                      (surface.window.sigma_um() * std::sqrt(2 * pi));
      kernel_ = InterpolationKernel::gaussian(width, sigma_bins, 1 / sum_per_integral);
      error_bound_ = omitted(width) / sum_per_integral + 1e-15 * width;
      gaussian_ = true;
      pixel_um_ = axis.pixel_um;
      samples_ = length_ = pixels_;
      centre_half_samples_ = std::lround(2 * middle);
      return;
    }
    const long first = static_cast<long>(std::ceil(middle - samples));
    const long last = static_cast<long>(std::floor(middle + samples));
    FourierAxisRequest rest = request;
    rest.tolerance *= 0.75;
    set_samples(surface, axis, rest, first, last, axis.pixel_um * middle);
    error_bound_ += 2 * cut.share;
  }

  /// Samples `first` to `last` about centre_um (from pixel 0), with the narrowest good kernel.
  void set_samples(const Surface& surface, const SurfaceAxis& axis,
                   const FourierAxisRequest& request, long first, long last, double centre_um) {
    set_grid(axis.pixel_um, first, last, request.oversampling);
    centre_half_samples_ = std::lround(2 * centre_um / axis.pixel_um) - 2 * first;
    tile_origin_ = surface.model == SurfaceModel::replicated ? 0 : axis.origin;
    choose_kernel(request.tolerance, [&] { return mean_error(surface, axis); });
  }

  void set_grid(double pixel_um, long first, long last, double oversampling) {
    pixel_um_ = pixel_um;
    first_sample_ = first;
    samples_ = static_cast<std::size_t>(last - first + 1);
    length_ = fast_fourier_length(
        static_cast<std::size_t>(std::ceil(oversampling * static_cast<double>(samples_) + 1)));
  }

  template <class Error>
  void choose_kernel(double tolerance, Error error) {
    const double rate = pi * std::sqrt(1 - 1 / oversampling());
    int width = std::max(2, static_cast<int>(-std::log(tolerance) / rate) - 1);
    do {
      kernel_ = InterpolationKernel::semicircle(width, oversampling());
      error_bound_ = error();
    } while (!(error_bound_ <= tolerance) && ++width <= 17);  // rounding from there on
  }

  static constexpr int mesh = 24;

  /// From the centre to the farthest sample.
  std::vector<double> mesh_omegas() const {
    const double edge = std::max({std::abs(omega(0)), std::abs(omega(samples_ - 1)), 1e-300});
    std::vector<double> omegas;
    for (int m = 0; m <= mesh; ++m) omegas.push_back(edge * m / mesh);
    return omegas;
  }

  /// sum_n w_n e(omega_n), e the larger of those at the mesh points on both sides.
  double mean_error(const Surface& surface, const SurfaceAxis& axis) const {
    const std::vector<double> omegas = mesh_omegas(), errors = kernel_.relative_errors(omegas);
    const double edge = omegas.back();
    double sum = 0, total = 0;
    for (std::size_t n = 0; n < samples_; ++n) {
      const double weight = sample_weight(surface, axis, n);
      const auto m =
          static_cast<std::size_t>(std::min(std::abs(omega(n)) / edge * mesh, mesh - 1.0));
      sum += weight;
      total += weight * std::max(errors[m], errors[m + 1]);
    }
    return total / sum;
  }

  std::size_t pixels_, samples_ = 0, length_ = 0;
  long first_sample_ = 0, centre_half_samples_ = 0, first_ = 0, last_ = 0;
  double pixel_um_ = 0, tile_origin_ = 0, error_bound_ = 0, amplification_ = 1;
  bool gaussian_ = false;
  InterpolationKernel kernel_ = InterpolationKernel::semicircle(2, 2);
  std::vector<double> weights_;
  std::vector<std::complex<double>> phases_;
};

}  // namespace brdf
