// The one header that knows FFTW.
#pragma once

#include <fftw3.h>

#include <complex>
#include <cstddef>
#include <memory>
#include <mutex>
#include <new>
#include <span>

#include "brdf/error.h"
#include "brdf/half_spectrum.h"

namespace brdf {

namespace detail {

struct FftwFree {
  void operator()(void* memory) const { fftw_free(memory); }
};

template <class T>
using FftwArray = std::unique_ptr<T[], FftwFree>;

/// Memory with the alignment that FFTW plans count on.
template <class T>
FftwArray<T> fftw_array(std::size_t count) {
  auto* memory = static_cast<T*>(fftw_malloc(sizeof(T) * count));
  if (memory == nullptr) throw std::bad_alloc();
  return FftwArray<T>(memory);
}

struct FftwDestroyPlan {
  void operator()(fftw_plan plan) const {
    const std::scoped_lock lock(mutex());
    fftw_destroy_plan(plan);
  }
  /// FFTW's planner is not thread-safe; its execution is.
  static std::mutex& mutex() {
    static std::mutex planner;
    return planner;
  }
};

using FftwPlan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, FftwDestroyPlan>;

}  // namespace detail

/// Two-dimensional transform of real samples with the plus sign,
/// F(j, l) = sum_{r, c} s(r, c) exp(+2 pi i (j r / rows + l c / cols)), not normalised.
///
/// Planned with FFTW_ESTIMATE, so that results are bit-identical from run to run. Fill `samples`,
/// call `transform` as often as wanted (it keeps the samples), read any bin; bins repeat with the
/// period of the grid. One object serves one thread.
class RealFourier2d {
 public:
  RealFourier2d(int rows, int cols)
      : rows_(rows),
        cols_(cols),
        samples_(detail::fftw_array<double>(static_cast<std::size_t>(rows) * cols)),
        half_(detail::fftw_array<std::complex<double>>(static_cast<std::size_t>(rows) *
                                                       half_cols())) {
    const std::scoped_lock lock(detail::FftwDestroyPlan::mutex());
    plan_.reset(fftw_plan_dft_r2c_2d(rows, cols, samples_.get(),
                                     reinterpret_cast<fftw_complex*>(half_.get()),
                                     FFTW_ESTIMATE | FFTW_PRESERVE_INPUT));
    if (!plan_) throw std::bad_alloc();
  }

  std::span<double> samples() { return {samples_.get(), static_cast<std::size_t>(rows_) * cols_}; }

  void transform() { fftw_execute(plan_.get()); }

  /// What the last transform left; valid until the next one.
  HalfSpectrum spectrum() const {
    return {{half_.get(), static_cast<std::size_t>(rows_) * half_cols()}, rows_, cols_};
  }

  std::complex<double> bin(long j, long l) const { return spectrum().bin(j, l); }

  /// Bytes that an object for this grid takes.
  static std::size_t bytes(std::size_t rows, std::size_t cols) {
    return rows * cols * sizeof(double) + rows * (cols / 2 + 1) * sizeof(std::complex<double>);
  }

 private:
  long half_cols() const { return cols_ / 2 + 1; }

  int rows_, cols_;
  detail::FftwArray<double> samples_;
  detail::FftwArray<std::complex<double>> half_;
  detail::FftwPlan plan_;
};

/// One-dimensional transform of complex samples with the plus sign, in place, not normalised:
/// F(k) = sum_j s(j) exp(+2 pi i j k / count). One object serves one thread; copies share the plan.
class ComplexFourier1d {
 public:
  explicit ComplexFourier1d(std::size_t count)
      : count_(count), data_(detail::fftw_array<std::complex<double>>(count)) {
    const std::scoped_lock lock(detail::FftwDestroyPlan::mutex());
    auto* data = reinterpret_cast<fftw_complex*>(data_.get());
    plan_ = detail::FftwPlan(
        fftw_plan_dft_1d(static_cast<int>(count), data, data, FFTW_BACKWARD, FFTW_ESTIMATE));
    if (!plan_) throw std::bad_alloc();
  }
  /// Planned already, with samples of its own, not set.
  ComplexFourier1d(const ComplexFourier1d& other)
      : count_(other.count_),
        data_(detail::fftw_array<std::complex<double>>(count_)),
        plan_(other.plan_) {}
  ComplexFourier1d& operator=(const ComplexFourier1d&) = delete;

  std::span<std::complex<double>> data() { return {data_.get(), count_}; }
  void transform() {
    auto* data = reinterpret_cast<fftw_complex*>(data_.get());
    fftw_execute_dft(plan_.get(), data, data);
  }

 private:
  std::size_t count_;
  detail::FftwArray<std::complex<double>> data_;
  std::shared_ptr<std::remove_pointer_t<fftw_plan>> plan_;
};

/// Smallest even length >= minimum without a prime factor above 7: fast to transform.
inline std::size_t fast_fourier_length(std::size_t minimum) {
  for (std::size_t length = minimum + minimum % 2;; length += 2) {
    std::size_t rest = length;
    for (const std::size_t prime : {2, 3, 5, 7})
      while (rest > 1 && rest % prime == 0) rest /= prime;
    if (rest <= 1) return length;
  }
}

}  // namespace brdf
