// One axis of a surface on a frequency grid, from which any frequency can be interpolated.
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "brdf/fourier.h"
#include "brdf/kernel_choice.h"
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
    const long last = static_cast<long>(samples.count) - 1;
    set_grid(samples.pitch_um, 0, last, last, request.oversampling);
    chosen_ = choose_semicircle(edge(), oversampling(), request.tolerance,
                                [](const std::vector<double>& errors) {
                                  return *std::max_element(errors.begin(), errors.end());
                                });
    set_stored(request);
    set_phases();
    weights_ = sample_transforms();
    for (double& weight : weights_) weight = 1 / weight;
    amplification_ = *std::max_element(weights_.begin(), weights_.end()) * chosen_.transform(0) *
                     (1 + chosen_.error_bound);
  }

  const InterpolationKernel& kernel() const { return chosen_.kernel; }
  double error_bound() const { return chosen_.error_bound; }
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

  /// Sets the weights; to be called once before `transform`.
  void prepare() {
    set_phases();
    if (gaussian_) {
      weights_.assign(samples_, 1 / static_cast<double>(pixels_));
      for (double x = 0; x < 1; x += 1.0 / 64) {
        const std::vector<double> taps = chosen_.kernel.taps(x);
        amplification_ = std::max(amplification_, std::accumulate(taps.begin(), taps.end(), 0.0));
      }
      return;
    }
    const std::vector<double> transforms = sample_transforms();
    const double sum = std::accumulate(weights_.begin(), weights_.end(), 0.0);
    double largest = 0;
    for (std::size_t n = 0; n < samples_; ++n) {
      weights_[n] /= sum * transforms[n];
      largest += weights_[n];
    }
    amplification_ = largest * chosen_.transform(0) * (1 + chosen_.error_bound);
  }

  /// Calls store(slot, F_k) for each stored grid point; values: one per pixel.
  template <class Value, class Store>
  void transform(ComplexFourier1d& fourier, Value value, Store store) const {
    const std::span<std::complex<double>> data = fourier.data();
    std::fill(data.begin(), data.end(), 0.0);
    const auto step = [](std::size_t& index, std::size_t period) {
      if (++index == period) index = 0;
    };
    std::size_t pixel = wrapped(first_sample_, pixels_), to = 0;
    for (std::size_t n = 0; n < samples_; ++n, step(pixel, pixels_), step(to, length_))
      data[to] += weights_[n] * value(pixel);
    fourier.transform();
    std::size_t bin = wrapped(first_, length_);
    for (std::size_t slot = 0; slot < phases_.size(); ++slot, step(bin, length_))
      store(slot, data[bin] * phases_[slot]);
  }

 private:
  void set_stored(const FourierAxisRequest& request) {
    const double scale = grid_per_frequency_um();
    const double half_width = chosen_.kernel.width() / 2.0;
    first_ = static_cast<long>(std::ceil(request.lo_per_um * scale - half_width)) - 1;
    last_ = static_cast<long>(std::ceil(request.hi_per_um * scale - half_width)) +
            chosen_.kernel.width();
    last_ = std::min(last_, first_ + static_cast<long>(length_) + chosen_.kernel.width() - 2);
  }

  std::vector<double> sample_transforms() const {
    std::vector<double> transforms;
    for (std::size_t n = 0; n < samples_; ++n) transforms.push_back(chosen_.transform(omega(n)));
    return transforms;
  }

  static std::size_t wrapped(long index, std::size_t period) {
    const long length = static_cast<long>(period), remainder = index % length;
    return static_cast<std::size_t>(remainder < 0 ? remainder + length : remainder);
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
  /// The largest angle per grid point.
  double edge() const {
    return std::max({std::abs(omega(0)), std::abs(omega(samples_ - 1)), 1e-300});
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
    const double middle = axis.origin;
    std::optional<WindowCut> cut;
    if (!(omitted(width) <= request.tolerance) || width > 10)
      cut = cut_window(surface, axis, request.tolerance / 8);
    const bool narrow_window =
        cut && 2 * cut->samples * request.oversampling <= 3 * static_cast<double>(axis.count);
    if (omitted(width) <= request.tolerance && !narrow_window) {
      // Sum of the window over its integral: 1 unless it is about as narrow as a pixel.
      const double sum_per_integral = window_sums(surface, axis).g * axis.pixel_um /
                                      (surface.window.sigma_um() * std::sqrt(2 * pi));
      chosen_.error_bound = omitted(width) / sum_per_integral + 1e-15 * width;
      chosen_.kernel =
          InterpolationKernel::gaussian(width, sigma_bins, 1 / sum_per_integral)
              .shortened(2, detail::shortening_share(request.tolerance, chosen_.error_bound));
      chosen_.error_bound += chosen_.kernel.shortening_error();
      gaussian_ = true;
      pixel_um_ = axis.pixel_um;
      samples_ = length_ = pixels_;
      centre_half_samples_ = std::lround(2 * middle);
      return;
    }
    const long first = static_cast<long>(std::ceil(middle - cut->samples));
    const long last = static_cast<long>(std::floor(middle + cut->samples));
    FourierAxisRequest rest = request;
    rest.tolerance *= 0.75;
    set_samples(surface, axis, rest, first, last, axis.pixel_um * middle);
    chosen_.error_bound += 2 * cut->share;
  }

  /// Samples `first` to `last` about centre_um (from pixel 0), with the narrowest good kernel.
  void set_samples(const Surface& surface, const SurfaceAxis& axis,
                   const FourierAxisRequest& request, long first, long last, double centre_um) {
    set_grid(axis.pixel_um, first, last, std::lround(2 * centre_um / axis.pixel_um) - 2 * first,
             request.oversampling);
    tile_origin_ = surface.model == SurfaceModel::replicated ? 0 : axis.origin;
    for (std::size_t n = 0; n < samples_; ++n) weights_.push_back(sample_weight(surface, axis, n));
    const std::vector<double> shares = mesh_shares();
    // The mean over the samples, each with the larger error at the mesh points on both sides.
    chosen_ = choose_semicircle(edge(), oversampling(), request.tolerance,
                                [&](const std::vector<double>& errors) {
                                  double mean = 0;
                                  for (std::size_t m = 0; m < shares.size(); ++m)
                                    mean += shares[m] * std::max(errors[m], errors[m + 1]);
                                  return mean;
                                });
  }

  void set_grid(double pixel_um, long first, long last, long centre_half_samples,
                double oversampling) {
    pixel_um_ = pixel_um;
    first_sample_ = first;
    samples_ = static_cast<std::size_t>(last - first + 1);
    length_ = fast_fourier_length(
        static_cast<std::size_t>(std::ceil(oversampling * static_cast<double>(samples_) + 1)));
    centre_half_samples_ = centre_half_samples;
  }

  /// The illumination between each mesh point and the next, of sum 1.
  std::vector<double> mesh_shares() const {
    std::vector<double> shares(kernel_mesh, 0.0);
    const double sum = std::accumulate(weights_.begin(), weights_.end(), 0.0);
    for (std::size_t n = 0; n < samples_; ++n)
      shares[static_cast<std::size_t>(std::min(std::abs(omega(n)) / edge() * kernel_mesh,
                                               kernel_mesh - 1.0))] += weights_[n] / sum;
    return shares;
  }

  std::size_t pixels_, samples_ = 0, length_ = 0;
  long first_sample_ = 0, centre_half_samples_ = 0, first_ = 0, last_ = 0;
  double pixel_um_ = 0, tile_origin_ = 0, amplification_ = 1;
  bool gaussian_ = false;
  ChosenKernel chosen_{InterpolationKernel::semicircle(2, 2), 0, 1, {}};
  std::vector<double> weights_;
  std::vector<std::complex<double>> phases_;
};

}  // namespace brdf
