// The tables of a Taylor series: the bins of the transforms that a request can reach.
#pragma once

#include <algorithm>
#include <complex>
#include <concepts>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "brdf/amplitude.h"
#include "brdf/power_spectra.h"
#include "brdf/taylor_bounds.h"

namespace brdf {

/// One axis of the bins: which of them a frequency needs, with what weights, and the phase that
/// moves the transform's origin. first and last do not fall as the frequency rises.
template <class B>
concept SpectrumBins = requires(const B& bins, double q_per_um, long bin,
                                std::span<double> weights) {
  { bins.first(q_per_um) } -> std::same_as<long>;
  { bins.last(q_per_um) } -> std::same_as<long>;
  { bins.weights(q_per_um, weights) } -> std::same_as<void>;
  { bins.origin_phase(bin) } -> std::same_as<std::complex<double>>;
};

/// The stored range of one axis. Where all queries share one frequency the neighbours are summed
/// once, when the tables are filled, and a single entry is left.
template <SpectrumBins Bins>
struct BinAxis {
  Bins bins;
  double lo_per_um, hi_per_um;

  bool fixed() const { return lo_per_um == hi_per_um; }
  long first() const { return bins.first(lo_per_um); }
  long last() const { return bins.last(hi_per_um); }
  /// Bins read when the tables are filled.
  std::size_t reached() const { return static_cast<std::size_t>(last() - first() + 1); }
  std::size_t stored() const { return fixed() ? 1 : reached(); }
  std::size_t slot(long bin) const { return fixed() ? 0 : static_cast<std::size_t>(bin - first()); }

  /// Weights of the bins from first to last at the time the tables are filled.
  std::vector<double> fill_weights() const {
    std::vector<double> weights(reached(), 1.0);
    if (fixed()) bins.weights(lo_per_um, weights);
    return weights;
  }
  std::vector<std::complex<double>> origin_phases() const {
    std::vector<std::complex<double>> phases;
    for (long bin = first(); bin <= last(); ++bin) phases.push_back(bins.origin_phase(bin));
    return phases;
  }
  /// The first slot that a query needs, and the weights from there on.
  std::size_t gather(double q_per_um, std::vector<double>& weights) const {
    if (fixed()) return weights.assign(1, 1.0), 0;
    const long from = bins.first(q_per_um);
    weights.resize(static_cast<std::size_t>(bins.last(q_per_um) - from + 1));
    bins.weights(q_per_um, weights);
    return slot(from);
  }
};

/// a = e^{i c h_mid} sum_{n < N} (i c r)^n / n! sum_{j, l} w_j w_l DFT(s^n)_{j l} / pixels, with
/// s = (h - h_mid) / r in [-1, 1], the weights w by the kind of bins (Thesis 1.24, 1.32, 1.37, with
/// the modulus outside both sums; Errata E5, E22).
///
/// The terms of a bin lie side by side. Cost: N transforms where the spectra are not kept, then N
/// times the neighbours' number products a query.
template <SpectrumBins Bins>
class TaylorTable {
 public:
  using Axis = BinAxis<Bins>;

  /// Throws where the spectra are not those of the heights, or too few: see require_match; and
  /// Errc::invalid_argument for terms < 1.
  TaylorTable(const HeightField& field, const QueryBounds& bounds, Axis x, Axis y,
              const PowerSpectra& spectra, int terms)
      : bounds_(bounds),
        half_range_um_(field.half_range_um()),
        mid_range_um_(field.mid_range_um()),
        x_(std::move(x)),
        y_(std::move(y)) {
    require_taylor_terms(terms);
    require_match(spectra, field, terms);
    terms_ = static_cast<std::size_t>(terms);
    table_.resize(x_.stored() * y_.stored() * terms_);
    fill(spectra, static_cast<double>(field.heights_um().size()));
  }

  const Axis& x() const { return x_; }
  const Axis& y() const { return y_; }
  std::size_t bytes() const { return table_.size() * sizeof(table_[0]); }

  /// Bytes that a table takes at its largest, its transforms included.
  static std::size_t bytes(const Axis& x, const Axis& y, const PowerSpectra& spectra, int terms) {
    return x.stored() * y.stored() * static_cast<std::size_t>(terms) *
               sizeof(std::complex<double>) +
           spectra.visit_bytes();
  }

  /// Throws Errc::invalid_argument for a query outside the bounds.
  void evaluate(std::span<const Query> queries, std::span<std::complex<double>> amplitudes) const {
    std::vector<std::complex<double>> sums(terms_);
    std::vector<double> x_weights, y_weights;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const Query& q = queries[i];
      bounds_.require_holds(q);
      const std::size_t x_slot = x_.gather(q.qx_per_um, x_weights);
      const std::size_t y_slot = y_.gather(q.qy_per_um, y_weights);
      std::fill(sums.begin(), sums.end(), 0.0);
      for (std::size_t j = 0; j < y_weights.size(); ++j)
        add_row(entry(y_slot + j, x_slot), y_weights[j], x_weights, sums);
      amplitudes[i] = std::polar(1.0, q.c_per_um * mid_range_um_) * series(q.c_per_um, sums);
    }
  }

 private:
  std::complex<double>* entry(std::size_t y_slot, std::size_t x_slot) {
    return &table_[(y_slot * x_.stored() + x_slot) * terms_];
  }
  const std::complex<double>* entry(std::size_t y_slot, std::size_t x_slot) const {
    return &table_[(y_slot * x_.stored() + x_slot) * terms_];
  }

  void fill(const PowerSpectra& spectra, double pixels) {
    static constexpr std::complex<double> i_to_n[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const std::vector<double> x_weights = x_.fill_weights(), y_weights = y_.fill_weights();
    const auto x_phases = x_.origin_phases(), y_phases = y_.origin_phases();
    const long y_first = y_.first(), x_first = x_.first();
    spectra.visit(static_cast<int>(terms_), [&](int n, const HalfSpectrum& spectrum) {
      for (std::size_t j = 0; j < y_weights.size(); ++j)
        for (std::size_t l = 0; l < x_weights.size(); ++l) {
          const long row = y_first + static_cast<long>(j), col = x_first + static_cast<long>(l);
          entry(y_.slot(row), x_.slot(col))[n] += i_to_n[n % 4] * spectrum.bin(row, col) *
                                                  y_phases[j] * x_phases[l] *
                                                  (y_weights[j] * x_weights[l] / pixels);
        }
    });
  }

  /// sums += y_weight * sum_l x_weights_l row_l
  static void add_row(const std::complex<double>* row, double y_weight,
                      const std::vector<double>& x_weights,
                      std::vector<std::complex<double>>& sums) {
    for (std::size_t l = 0; l < x_weights.size(); ++l, row += sums.size()) {
      const double weight = y_weight * x_weights[l];
      for (std::size_t n = 0; n < sums.size(); ++n) sums[n] += weight * row[n];
    }
  }

  std::complex<double> series(double c_per_um,
                              const std::vector<std::complex<double>>& sums) const {
    std::complex<double> series = 0;
    double coefficient = 1;
    for (std::size_t n = 0; n < sums.size(); ++n) {
      series += coefficient * sums[n];
      coefficient *= c_per_um * half_range_um_ / static_cast<double>(n + 1);
    }
    return series;
  }

  QueryBounds bounds_;
  double half_range_um_, mid_range_um_;
  std::size_t terms_ = 0;
  Axis x_, y_;
  std::vector<std::complex<double>> table_;
};

}  // namespace brdf
