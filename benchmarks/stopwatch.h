// Times and their medians.
#pragma once

#include <time.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace benchmarks {

/// What a stopwatch counts. On a machine of one's own both agree for work in one thread; where
/// others run beside, only the thread's own time says what the work costs.
enum class Time {
  of_thread,  ///< processor time of the calling thread, the system's part included
  of_wall,
};

class Stopwatch {
 public:
  explicit Stopwatch(Time time = Time::of_thread)
      : clock_(time == Time::of_thread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC),
        start_s_(now_s()) {}
  double seconds() const { return now_s() - start_s_; }

 private:
  double now_s() const {
    timespec now{};
    clock_gettime(clock_, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  clockid_t clock_;
  double start_s_;
};

/// Times of repeated runs of one thing.
class Samples {
 public:
  void add(double value) {
    sorted_.insert(std::upper_bound(sorted_.begin(), sorted_.end(), value), value);
  }
  double median() const {
    const std::size_t n = sorted_.size();
    return (sorted_[(n - 1) / 2] + sorted_[n / 2]) / 2;
  }
  double least() const { return sorted_.front(); }
  /// Half the distance of the quartiles over the median.
  double spread() const {
    const std::size_t last = sorted_.size() - 1;
    return (sorted_[last - last / 4] - sorted_[last / 4]) / (2 * median());
  }

 private:
  std::vector<double> sorted_;
};

}  // namespace benchmarks
