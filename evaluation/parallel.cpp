#include "evaluation/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <list>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace evaluation {
namespace {

/// Threads that wait for work, started when they are first wanted and kept: waking one takes a
/// fraction of starting one.
class Helpers {
 public:
  static Helpers& instance() {
    static Helpers helpers;
    return helpers;
  }

  /// Runs `work` here, and on up to `count` helpers as they wake. Helpers that have not woken when
  /// it is done here are not waited for; so work may ask for helpers itself.
  void run(std::size_t count, const std::function<void()>& work) {
    Job job{&work, count, 0};
    const auto place = add(job);
    work();
    std::unique_lock lock(mutex_);
    jobs_.erase(place);
    open_places_ -= job.wanted;
    finished_.wait(lock, [&] { return job.running == 0; });
  }

 private:
  struct Job {
    const std::function<void()>* work;
    std::size_t wanted, running;
  };
  using Jobs = std::list<Job*>;

  Jobs::iterator add(Job& job) {
    const std::scoped_lock lock(mutex_);
    while (threads_.size() < job.wanted)
      threads_.emplace_back([this](std::stop_token stop) { help(stop); });
    open_places_ += job.wanted;
    added_.notify_all();
    return jobs_.insert(jobs_.end(), &job);
  }

  Job* open_job() {
    const auto job = std::ranges::find_if(jobs_, [](const Job* j) { return j->wanted > 0; });
    return job == jobs_.end() ? nullptr : *job;
  }

  void help(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    Job* job = nullptr;
    while (added_.wait(lock, stop, [&] { return (job = open_job()) != nullptr; })) {
      --job->wanted;
      --open_places_;
      ++job->running;
      lock.unlock();
      (*job->work)();
      lock.lock();
      if (--job->running == 0) finished_.notify_all();
      lock.unlock();
      stay_awake();
      lock.lock();
    }
  }

  /// Parts of one computation follow each other within microseconds; waking up takes a hundred.
  void stay_awake() const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::microseconds(200);
    while (open_places_ == 0 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  }

  std::mutex mutex_;
  std::condition_variable_any added_;
  std::condition_variable finished_;
  Jobs jobs_;
  std::atomic<std::size_t> open_places_ = 0;  ///< wanted by all jobs; changed under the mutex
  std::vector<std::jthread> threads_;         // last: they end before what they use
};

}  // namespace

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        task(i);
      } catch (...) {
        const std::scoped_lock lock(failure_mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  const std::size_t helpers =
      std::min(count, static_cast<std::size_t>(std::max(threads, 1))) - (count > 0 ? 1 : 0);
  if (helpers == 0)
    work();
  else
    Helpers::instance().run(helpers, work);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace evaluation
