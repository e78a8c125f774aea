// Transforms for tasks that run side by side.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "brdf/fourier.h"

namespace brdf {

/// Transforms of one length, lent to one task at a time; planned once.
class FourierPool {
 public:
  explicit FourierPool(std::size_t length) : length_(length) {}

  /// Makes the plan, if no lease has made it yet.
  void prepare() { give_back(take()); }

  class Lease {
   public:
    explicit Lease(FourierPool& pool) : pool_(pool), fourier_(pool.take()) {}
    ~Lease() { pool_.give_back(std::move(fourier_)); }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    ComplexFourier1d& operator*() const { return *fourier_; }

   private:
    FourierPool& pool_;
    std::unique_ptr<ComplexFourier1d> fourier_;
  };

 private:
  std::unique_ptr<ComplexFourier1d> take() {
    const std::scoped_lock lock(mutex_);
    if (!first_) first_.emplace(length_);
    if (idle_.empty()) return std::make_unique<ComplexFourier1d>(*first_);
    auto fourier = std::move(idle_.back());
    idle_.pop_back();
    return fourier;
  }
  void give_back(std::unique_ptr<ComplexFourier1d> fourier) {
    const std::scoped_lock lock(mutex_);
    idle_.push_back(std::move(fourier));
  }

  std::size_t length_;
  std::mutex mutex_;
  std::optional<ComplexFourier1d> first_;
  std::vector<std::unique_ptr<ComplexFourier1d>> idle_;
};

}  // namespace brdf
