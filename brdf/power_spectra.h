// The transforms that a Taylor series is made of, computed when needed or kept from before.
#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brdf/fourier.h"
#include "brdf/height_field.h"

namespace brdf {

/// Whose transforms they are, and how many: what a file of them must say.
struct PowerSpectraShape {
  Eigen::Index rows, cols;
  double mid_range_um, half_range_um;
  int terms;  ///< powers 0 to terms - 1

  Eigen::Index half_cols() const { return cols / 2 + 1; }
  /// Complex numbers in all half spectra together.
  std::size_t size() const {
    return static_cast<std::size_t>(terms) * static_cast<std::size_t>(rows * half_cols());
  }
};

/// The transforms of s^n, n = 0, 1, ..., of the heights scaled to [-1, 1],
/// s = (h - mid range) / half range (0 for a flat field): F{h^n} of Thesis 1.32 in the form that
/// stays in range.
class PowerSpectra {
 public:
  using Visit = std::function<void(int power, const HalfSpectrum& spectrum)>;

  virtual ~PowerSpectra() = default;
  virtual PowerSpectraShape shape() const = 0;
  /// Visits the powers 0 to terms - 1 in this order, terms <= shape().terms. What is visited is
  /// valid during the visit only, so that a source need not hold more than one power at a time.
  virtual void visit(int terms, const Visit& visit) const = 0;
  /// Bytes that a visit takes beside what is held anyway.
  virtual std::size_t visit_bytes() const = 0;
  /// Bound on what keeping has changed in a value, over the number of pixels (the largest value).
  virtual double value_error() const { return 0; }
};

/// Computes each transform when it is asked for. Refers to heights that must outlive it.
class ComputedPowerSpectra final : public PowerSpectra {
 public:
  explicit ComputedPowerSpectra(const HeightField& field) : field_(&field) {}

  /// As many terms as are wanted.
  PowerSpectraShape shape() const override {
    return {field_->rows(), field_->cols(), field_->mid_range_um(), field_->half_range_um(),
            std::numeric_limits<int>::max()};
  }

  void visit(int terms, const Visit& visit) const override {
    RealFourier2d fourier(static_cast<int>(field_->rows()), static_cast<int>(field_->cols()));
    Eigen::Map<HeightArray> s_to_n(fourier.samples().data(), field_->rows(), field_->cols());
    s_to_n = 1.0;
    const double scale = field_->half_range_um() > 0 ? 1 / field_->half_range_um() : 0.0;
    for (int n = 0; n < terms; ++n) {
      if (n > 0) s_to_n *= (field_->heights_um() - field_->mid_range_um()) * scale;
      fourier.transform();
      visit(n, fourier.spectrum());
    }
  }

  std::size_t visit_bytes() const override {
    return RealFourier2d::bytes(static_cast<std::size_t>(field_->rows()),
                                static_cast<std::size_t>(field_->cols()));
  }

 private:
  const HeightField* field_;
};

/// Serves transforms from memory: an array [terms][rows][cols / 2 + 1] of what HalfSpectrum reads.
class StoredPowerSpectra final : public PowerSpectra {
 public:
  /// Throws Errc::bad_input where the number of values is not that of the shape, or the shape is
  /// not one.
  StoredPowerSpectra(const PowerSpectraShape& shape, std::vector<std::complex<double>> values)
      : shape_(shape), values_(std::move(values)) {
    if (!(shape.rows >= 1 && shape.cols >= 1 && shape.terms >= 1))
      throw Error(Errc::bad_input, "power spectra of " + std::to_string(shape.rows) + " x " +
                                       std::to_string(shape.cols) + " pixels and " +
                                       std::to_string(shape.terms) + " terms: must be >= 1 each");
    if (values_.size() != shape.size())
      throw Error(Errc::bad_input, "power spectra hold " + std::to_string(values_.size()) +
                                       " values, their shape has " + std::to_string(shape.size()));
  }

  PowerSpectraShape shape() const override { return shape_; }
  std::span<const std::complex<double>> values() const { return values_; }

  void visit(int terms, const Visit& visit) const override {
    const auto each = static_cast<std::size_t>(shape_.rows * shape_.half_cols());
    for (int n = 0; n < terms; ++n)
      visit(n,
            {values().subspan(static_cast<std::size_t>(n) * each, each), shape_.rows, shape_.cols});
  }

  std::size_t visit_bytes() const override { return 0; }

 private:
  PowerSpectraShape shape_;
  std::vector<std::complex<double>> values_;
};

/// The spectra to make a plan from: those kept from before where there are any.
inline std::shared_ptr<const PowerSpectra> spectra_or_computed(
    std::shared_ptr<const PowerSpectra> kept, const HeightField& field) {
  return kept ? std::move(kept) : std::make_shared<const ComputedPowerSpectra>(field);
}

/// The first `terms` >= 1 powers of some heights, kept. Cost: a transform and an array each.
inline StoredPowerSpectra stored_power_spectra(const HeightField& field, int terms) {
  if (terms < 1)
    throw Error(Errc::invalid_argument, "terms " + std::to_string(terms) + " must be >= 1");
  const ComputedPowerSpectra computed(field);
  PowerSpectraShape shape = computed.shape();
  shape.terms = terms;
  std::vector<std::complex<double>> values;
  values.reserve(shape.size());
  computed.visit(terms, [&](int, const HalfSpectrum& spectrum) {
    values.insert(values.end(), spectrum.half.begin(), spectrum.half.end());
  });
  return {shape, std::move(values)};
}

/// Throws Errc::bad_input where the spectra are of another grid or range of heights than the
/// field's, and Errc::not_attainable where they have fewer terms than are needed. Other heights of
/// the same grid and the very same range are not noticed.
inline void require_match(const PowerSpectra& spectra, const HeightField& field, int terms) {
  const PowerSpectraShape shape = spectra.shape();
  const auto differ = [](const std::string& what, const std::string& theirs,
                         const std::string& ours) {
    throw Error(Errc::bad_input, "power spectra of another surface: their " + what + " is " +
                                     theirs + ", the heights' " + ours);
  };
  const auto grid = [](Eigen::Index rows, Eigen::Index cols) {
    return std::to_string(rows) + " x " + std::to_string(cols);
  };
  if (shape.rows != field.rows() || shape.cols != field.cols())
    differ("grid", grid(shape.rows, shape.cols), grid(field.rows(), field.cols()));
  if (shape.mid_range_um != field.mid_range_um())
    differ("mid-range", text(shape.mid_range_um) + " um", text(field.mid_range_um()) + " um");
  if (shape.half_range_um != field.half_range_um())
    differ("half range", text(shape.half_range_um) + " um", text(field.half_range_um()) + " um");
  if (shape.terms < terms)
    throw Error(Errc::not_attainable, "the power spectra have " + std::to_string(shape.terms) +
                                          " terms, the series needs " + std::to_string(terms));
}

}  // namespace brdf
