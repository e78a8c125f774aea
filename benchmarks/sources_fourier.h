// FFTW in both precisions, for the sources' algorithm.
#pragma once

#include <fftw3.h>

#include <complex>
#include <cstddef>

#include "benchmarks/sources_algorithm.h"
#include "brdf/table_memory.h"

namespace benchmarks {

/// One real transform, minus sign, in either precision.
class Fourier {
 public:
  Fourier(int rows, int cols, float* from, std::complex<float>* to, Planning planning)
      : single_(fftwf_plan_dft_r2c_2d(rows, cols, from, reinterpret_cast<fftwf_complex*>(to),
                                      flags(planning))) {}
  Fourier(int rows, int cols, double* from, std::complex<double>* to, Planning planning)
      : double_(fftw_plan_dft_r2c_2d(rows, cols, from, reinterpret_cast<fftw_complex*>(to),
                                     flags(planning))) {}
  Fourier(const Fourier&) = delete;
  Fourier& operator=(const Fourier&) = delete;
  ~Fourier() {
    if (single_) fftwf_destroy_plan(single_);
    if (double_) fftw_destroy_plan(double_);
  }
  void operator()(float* from, std::complex<float>* to) const {
    fftwf_execute_dft_r2c(single_, from, reinterpret_cast<fftwf_complex*>(to));
  }
  void operator()(double* from, std::complex<double>* to) const {
    fftw_execute_dft_r2c(double_, from, reinterpret_cast<fftw_complex*>(to));
  }

 private:
  /// An estimate would otherwise take over what was measured before.
  static unsigned flags(Planning planning) {
    if (planning == Planning::measure) return FFTW_MEASURE | FFTW_PRESERVE_INPUT;
    fftwf_forget_wisdom();
    fftw_forget_wisdom();
    return FFTW_ESTIMATE | FFTW_PRESERVE_INPUT;
  }

  fftwf_plan single_ = nullptr;
  fftw_plan double_ = nullptr;
};

}  // namespace benchmarks
