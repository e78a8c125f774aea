#include "benchmarks/sources_algorithm.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "benchmarks/sources_fourier.h"
#include "benchmarks/sources_window.h"
#include "benchmarks/stopwatch.h"

namespace benchmarks {

namespace {

/// 64 bytes of numbers as one vector; the compiler splits it where registers are shorter.
template <class Real>
struct CacheLine;
template <>
struct CacheLine<float> {
  typedef float Vector __attribute__((vector_size(64)));
};
template <>
struct CacheLine<double> {
  typedef double Vector __attribute__((vector_size(64)));
};

/// exp(-2 pi i j x0 / N), j = 0 ... count - 1: moves the transform's origin to pixel x0.
template <class Real>
std::vector<std::complex<Real>> origin_phases(const brdf::SurfaceAxis& axis, long count) {
  std::vector<std::complex<Real>> phases;
  const auto n = static_cast<double>(axis.count);
  for (long j = 0; j < count; ++j)
    phases.push_back(std::complex<Real>(
        std::polar(1.0, -2 * brdf::pi * std::fmod(static_cast<double>(j) * axis.origin, n) / n)));
  return phases;
}

long wrap(long index, long count) {
  const long remainder = index % count;
  return remainder < 0 ? remainder + count : remainder;
}

}  // namespace

template <class Real>
struct SourcesAlgorithm<Real>::Tables {
  using Line = typename CacheLine<Real>::Vector;
  static constexpr int numbers_per_line = sizeof(Line) / sizeof(Real);
  static constexpr int terms_per_line = numbers_per_line / 2;
  static constexpr int lines = (sources_terms + terms_per_line - 1) / terms_per_line;
  struct Entry {
    Line of_terms[lines];
  };

  explicit Tables(const brdf::Surface& surface)
      : x_axis(brdf::x_axis(surface)),
        y_axis(brdf::y_axis(surface)),
        x(surface, x_axis),
        y(surface, y_axis),
        rows(y_axis.count),
        cols(x_axis.count),
        half(cols / 2 + 1),
        entries(brdf::table_memory<Entry>(static_cast<std::size_t>(rows * half))),
        half_range_um(surface.heights->half_range_um()),
        mid_range_um(surface.heights->mid_range_um()) {
    static constexpr Real re[] = {1, 0, -1, 0}, im[] = {0, 1, 0, -1};
    double coefficient = 1 / static_cast<double>(rows * cols);
    for (int n = 0; n < lines * terms_per_line; coefficient /= ++n) {
      const Real size = n < sources_terms ? static_cast<Real>(coefficient) : 0;
      const int line = n / terms_per_line, at = 2 * (n % terms_per_line);
      to_re[line][at] = to_im[line][at + 1] = size * re[n % 4];
      to_im[line][at] = size * im[n % 4];
      to_re[line][at + 1] = -to_im[line][at];
    }
  }

  std::complex<double> amplitude(const brdf::Query& query) const;

  brdf::SurfaceAxis x_axis, y_axis;
  AxisWindow x, y;
  long rows, cols, half;
  /// Of the transform with the minus sign: [row][column <= cols / 2][term].
  brdf::TableMemory<Entry> entries;
  /// i^n / n! / pixels, as they act on (re, im) of the terms.
  Line to_re[lines], to_im[lines];
  double half_range_um, mid_range_um;
};

template <class Real>
std::complex<double> SourcesAlgorithm<Real>::Tables::amplitude(const brdf::Query& query) const {
  const AxisWindow::Bins in_x = x.at(query.qx_per_um), in_y = y.at(query.qy_per_um);
  // Transforms of real samples: the plus sign at (j, l) is the minus sign at (-j, -l), and the
  // conjugate of the minus sign at (j, l). One of the two is in the half that is kept.
  Line straight[lines] = {}, conjugate[lines] = {};
  for (int o = 0; o < in_y.count; ++o) {
    const long j = in_y.first + o;
    const Entry* const line = &entries[wrap(-j, rows) * half];
    const Entry* const mirrored = &entries[wrap(j, rows) * half];
    for (int i = 0; i < in_x.count; ++i) {
      const Real weight = static_cast<Real>(in_y.weights[o] * in_x.weights[i]);
      const long l = wrap(-(in_x.first + i), cols);
      if (l < half)
        for (int v = 0; v < lines; ++v) straight[v] += weight * line[l].of_terms[v];
      else
        for (int v = 0; v < lines; ++v) conjugate[v] += weight * mirrored[cols - l].of_terms[v];
    }
  }
  const auto t = static_cast<Real>(query.c_per_um * half_range_um);
  Real power = 1;
  Line sign = {}, powers = {};
  for (int n = 0; n < terms_per_line; ++n, power *= t) {
    powers[2 * n] = powers[2 * n + 1] = power;
    sign[2 * n] = 1;
    sign[2 * n + 1] = -1;
  }
  Line re = {}, im = {};
  for (int v = 0; v < lines; ++v, powers *= power) {
    const Line term = (straight[v] + sign * conjugate[v]) * powers;
    re += to_re[v] * term;
    im += to_im[v] * term;
  }
  Real sum_re = 0, sum_im = 0;
  for (int lane = 0; lane < numbers_per_line; ++lane) {
    sum_re += re[lane];
    sum_im += im[lane];
  }
  return std::polar(1.0, query.c_per_um * mid_range_um) * std::complex<double>(sum_re, sum_im);
}

template <class Real>
SourcesAlgorithm<Real>::SourcesAlgorithm(const brdf::Surface& surface, Planning planning)
    : planning_(planning), tables_(std::make_unique<Tables>(surface)) {
  using Complex = std::complex<Real>;
  using Line = typename Tables::Line;
  constexpr int terms_per_line = Tables::terms_per_line;
  Tables& t = *tables_;
  const auto pixels = static_cast<std::size_t>(t.rows * t.cols);
  const auto bins = static_cast<std::size_t>(t.rows * t.half);
  const auto heights = brdf::table_memory<Real>(pixels), power = brdf::table_memory<Real>(pixels);
  const auto spectra = brdf::table_memory<Complex>(bins * terms_per_line);

  Stopwatch planning_watch;
  const Fourier transform(static_cast<int>(t.rows), static_cast<int>(t.cols), power.get(),
                          spectra.get(), planning);
  times_.planning_s = planning_watch.seconds();

  const std::vector<Complex> row_phase = origin_phases<Real>(t.y_axis, t.rows);
  const std::vector<Complex> col_phase = origin_phases<Real>(t.x_axis, t.half);
  const double scale = t.half_range_um > 0 ? 1 / t.half_range_um : 0.0;
  Stopwatch transforms;
  const double* h = surface.heights->heights_um().data();
  for (std::size_t i = 0; i < pixels; ++i)
    heights[i] = static_cast<Real>((h[i] - t.mid_range_um) * scale);
  std::fill_n(power.get(), pixels, Real(1));
  times_.transforms_s += transforms.seconds();
  for (int line = 0; line < Tables::lines; ++line) {
    // One cache line of each entry at a time, so that whole lines are written.
    const int count = std::min(terms_per_line, sources_terms - line * terms_per_line);
    const Stopwatch watch;
    for (int n = 0; n < count; ++n) {
      if (line + n > 0)
        for (std::size_t i = 0; i < pixels; ++i) power[i] *= heights[i];
      transform(power.get(), spectra.get() + static_cast<std::size_t>(n) * bins);
    }
    times_.transforms_s += watch.seconds();
    const Stopwatch interleaving;
    for (long j = 0; j < t.rows; ++j)
      for (long l = 0; l < t.half; ++l) {
        // The origin's phase belongs to the plus sign; stored is the minus sign.
        const Complex phase = std::conj(row_phase[static_cast<std::size_t>(j)] *
                                        col_phase[static_cast<std::size_t>(l)]);
        const std::size_t bin = static_cast<std::size_t>(j * t.half + l);
        Line entry = {};
        for (int n = 0; n < count; ++n) {
          const Complex value = spectra[static_cast<std::size_t>(n) * bins + bin];
          entry[2 * n] = value.real() * phase.real() - value.imag() * phase.imag();
          entry[2 * n + 1] = value.real() * phase.imag() + value.imag() * phase.real();
        }
        t.entries[bin].of_terms[line] = entry;
      }
    times_.interleaving_s += interleaving.seconds();
  }
}

template <class Real>
SourcesAlgorithm<Real>::~SourcesAlgorithm() = default;

template <class Real>
void SourcesAlgorithm<Real>::evaluate(std::span<const brdf::Query> queries,
                                      std::span<std::complex<double>> amplitudes) {
  const Stopwatch watch;
  for (std::size_t i = 0; i < queries.size(); ++i) amplitudes[i] = tables_->amplitude(queries[i]);
  times_.gather_s = watch.seconds();
}

template <class Real>
double SourcesAlgorithm<Real>::total_s() const {
  return (planning_ == Planning::estimate ? times_.planning_s : 0) + times_.transforms_s +
         times_.interleaving_s + times_.gather_s;
}

template <class Real>
std::size_t SourcesAlgorithm<Real>::bytes() const {
  return static_cast<std::size_t>(tables_->rows * tables_->half) * sizeof(typename Tables::Entry);
}

template class SourcesAlgorithm<float>;
template class SourcesAlgorithm<double>;

}  // namespace benchmarks
