// Fills the table of a Chebyshev plan from the pixels of a surface.
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "brdf/chebyshev_columns.h"
#include "brdf/chebyshev_design.h"
#include "brdf/chebyshev_projection.h"
#include "brdf/fourier_pool.h"
#include "brdf/query_order.h"
#include "brdf/table_memory.h"
#include "brdf/term_table.h"

namespace brdf {

/// Owns a TermTable. Real: float or double.
template <class Real>
class ChebyshevTable {
 public:
  ChebyshevTable(const ChebyshevDesign& design, const SeriesKernels& kernels)
      : inner_kernel_(design.inner().kernel()) {
    const Surface& surface = design.surface();
    if (design.outer()) outer_kernel_ = design.outer()->kernel();
    view_.inner = axis_view(design.inner(), inner_kernel_, design.inner_axis());
    view_.outer = design.outer() ? axis_view(*design.outer(), outer_kernel_, 0)
                                 : TableAxis{0, 0, 0, 1, 1, 0, 1, 0, nullptr, 1, 1};
    if (design.line()) {
      view_.inner.grid_per_qy_um =
          view_.inner.grid_per_qx_um * design.line()->direction().sin_azimuth;
      view_.inner.grid_per_qx_um *= design.line()->direction().cos_azimuth;
    }
    view_.terms = design.terms().count();
    view_.degrees = design.terms().degrees();
    view_.even_terms = design.terms().even_count();
    const Eigen::MatrixXd& basis = design.terms().query_basis();
    if (basis.size() > 0) {
      basis_.assign(static_cast<std::size_t>(view_.padded_terms() * view_.degrees), 0.0);
      std::copy_n(basis.data(), basis.size(), basis_.data());  // column by column
    }
    view_.c_mid_per_um = design.c_mid_per_um();
    view_.per_c_um = design.c_half_per_um() > 0 ? 1 / design.c_half_per_um() : 0;
    view_.phase_per_c_um = surface.heights->mid_range_um();
    const auto phase = [&](int index) {
      const bool summed = design.parts().axes[index].fft_length == 0 && !design.line();
      return summed ? 0.0 : design.centre_um(index);
    };
    view_.phase_per_qx_um = phase(0);
    view_.phase_per_qy_um = phase(1);
    row_ = static_cast<std::size_t>(2 * view_.padded_terms());
    const auto size = static_cast<std::size_t>(view_.outer.count * view_.inner.count) * row_;
    entries_ = table_memory<Real>(size);
    std::fill_n(entries_.get(), size, Real{0});
    if (design.outer())
      fill_general(design);
    else
      fill_in_plane(design, kernels);
  }

  /// Of a general table.
  TileGrid tiles() const {
    const auto axis = [](const TableAxis& a, double grid_per_q_um) {
      return TileGrid::Axis{grid_per_q_um, static_cast<double>(a.first),
                            static_cast<double>(a.period), static_cast<double>(a.count)};
    };
    return {axis(view_.outer, view_.outer.grid_per_qx_um),
            axis(view_.inner, view_.inner.grid_per_qy_um)};
  }

  /// Refers to this object.
  TermTable<Real> view() const {
    TermTable<Real> view = view_;
    view.entries = entries_.get();
    view.basis = basis_.empty() ? nullptr : basis_.data();
    view.inner.coefficients = inner_kernel_.coefficients().data();
    view.outer.coefficients = outer_kernel_.coefficients().data();
    return view;
  }

 private:
  using Complex = std::complex<double>;

  static TableAxis axis_view(const FourierAxis& axis, const InterpolationKernel& kernel,
                             int index) {
    const double grid = axis.grid_per_frequency_um();
    return {index == 0 ? grid : 0,
            index == 1 ? grid : 0,
            axis.first(),
            static_cast<long>(axis.stored()),
            kernel.width(),
            kernel.degree(),
            kernel.pieces(),
            kernel.tap_stride(),
            nullptr,
            static_cast<long>(axis.length()),
            axis.turn_sign()};
  }

  Real* entry(std::size_t outer, std::size_t inner) {
    return entries_.get() + (outer * static_cast<std::size_t>(view_.inner.count) + inner) * row_;
  }
  void store(std::size_t outer, std::size_t inner, int term, Complex value) {
    Real* target = entry(outer, inner) + 2 * term;
    target[0] = static_cast<Real>(value.real());
    target[1] = static_cast<Real>(value.imag());
  }

  /// Cuts `count` things into tasks of at most `batch` and hands each task a transform.
  template <class Each>
  static void spread(const ChebyshevDesign& design, FourierPool& pool, std::size_t count,
                     std::size_t batch, Each each) {
    design.executor()((count + batch - 1) / batch, [&](std::size_t task) {
      FourierPool::Lease fourier(pool);
      for (std::size_t i = task * batch; i < std::min(count, (task + 1) * batch); ++i)
        each(*fourier, i);
    });
  }

  void fill_in_plane(const ChebyshevDesign& design, const SeriesKernels& kernels) {
    FourierPool pool(design.inner().length());
    const auto beside = [&pool] { pool.prepare(); };  // takes as long as half of the pixels of A
    const ChebyshevColumns columns = design.line() ? projected_columns(design, kernels, beside)
                                                   : contracted_columns(design, kernels, beside);
    spread(design, pool, static_cast<std::size_t>(view_.terms), terms_of_task(design),
           [&](ComplexFourier1d& fourier, std::size_t term) {
             transform_columns(design, columns, fourier, static_cast<int>(term));
           });
  }

  /// Starting a thread takes as long as some 10,000 points to transform.
  static std::size_t terms_of_task(const ChebyshevDesign& design) {
    return 1 + 10'000 / design.inner().length();
  }

  void transform_columns(const ChebyshevDesign& design, const ChebyshevColumns& columns,
                         ComplexFourier1d& fourier, int r) {
    const CarriedTerms& carried = *design.carried();
    std::vector<double> re(columns.count), im(columns.count);
    const auto add = [&](std::vector<double>& to, double factor, const std::vector<double>& from,
                         int p) {
      const double* moments = from.data() + static_cast<std::size_t>(p) * columns.count;
      for (std::size_t i = 0; i < columns.count; ++i) to[i] += factor * moments[i];
    };
    for (int p = 0; p < carried.degrees(); ++p) {
      const double factor = carried.coefficient(p, r);
      const bool turned = CarriedTerms::imaginary(p, r);
      add(turned ? im : re, factor, columns.re, p);
      if (!columns.im.empty()) add(turned ? re : im, turned ? -factor : factor, columns.im, p);
    }
    const auto value = [&](std::size_t i) {  // with the factor i of an odd term
      return r % 2 == 0 ? Complex(re[i], im[i]) : Complex(-im[i], re[i]);
    };
    design.inner().transform(fourier, value,
                             [&](std::size_t slot, Complex f) { store(0, slot, r, f); });
  }

  /// a_r(s) without its factor i, by Clenshaw over the degrees of its parity.
  static double term_value(const ChebyshevTerms& terms, int r, double s) {
    const double* coefficients = terms.pixel_basis().col(r).data();
    const double twice = 2 * (2 * s * s - 1);  // 2 T_2(s): steps of two
    double next = 0, current = 0;
    const int parity = terms.odd(r) ? 1 : 0, last = terms.degrees() - 1;
    for (int m = last - (last - parity) % 2; m >= parity; m -= 2)
      next = std::exchange(current, coefficients[m] + twice * current - next);
    // Even degrees: b_0 - b_2 T_2; odd: s (b_1 - b_3).
    return parity == 0 ? current - next * (2 * s * s - 1) : s * (current - next);
  }

  void fill_general(const ChebyshevDesign& design) {
    const HeightField& field = *design.surface().heights;
    const PixelStrip scale = pixel_scale(design);
    const FourierAxis &outer = *design.outer(), &inner = design.inner();
    const auto rows = static_cast<std::size_t>(field.rows()),
               cols = static_cast<std::size_t>(field.cols());
    HeightArray s = (field.heights_um() - scale.mid_um) * scale.per_half_range_um;
    std::vector<Complex> carrier(rows * cols), lines(outer.stored() * rows);
    constexpr std::size_t batch = 16;
    FourierPool along_x(outer.length()), along_y(inner.length());
    for (int r = 0; r < view_.terms; ++r) {
      spread(design, along_x, rows, batch, [&](ComplexFourier1d& fourier, std::size_t row) {
        const double* s_row = s.data() + row * cols;
        Complex* carrier_row = carrier.data() + row * cols;
        if (r == 0)
          for (std::size_t col = 0; col < cols; ++col)
            carrier_row[col] = std::polar(1.0, design.carrier_rad() * s_row[col]);
        outer.transform(
            fourier,
            [&](std::size_t col) {
              return carrier_row[col] * term_value(design.terms(), r, s_row[col]);
            },
            [&](std::size_t slot, Complex value) { lines[slot * rows + row] = value; });
      });
      const Complex turn = design.terms().odd(r) ? Complex(0, 1) : Complex(1, 0);
      spread(design, along_y, outer.stored(), batch,
             [&](ComplexFourier1d& fourier, std::size_t line) {
               inner.transform(
                   fourier, [&](std::size_t row) { return lines[line * rows + row]; },
                   [&](std::size_t slot, Complex value) { store(line, slot, r, turn * value); });
             });
    }
  }

  InterpolationKernel inner_kernel_, outer_kernel_ = InterpolationKernel::semicircle(2, 2);
  TermTable<Real> view_{};
  std::vector<double> basis_;
  std::size_t row_ = 0;
  TableMemory<Real> entries_;
};

}  // namespace brdf
