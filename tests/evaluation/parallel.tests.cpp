#include "evaluation/parallel.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

using evaluation::parallel_for;

TEST_CASE("a task that throws stops the others and is thrown again", "[invariant]") {
  std::atomic<int> calls = 0;
  CHECK_THROWS_WITH(parallel_for(100000, 3,
                                 [&](std::size_t i) {
                                   ++calls;
                                   if (i == 10) throw std::runtime_error("ten");
                                   // All of them take seconds: longer than the thread that throws
                                   // may have to wait for a busy machine.
                                   std::this_thread::sleep_for(std::chrono::microseconds(50));
                                 }),
                    "ten");
  CHECK(calls < 100000);
  std::vector<int> seen(1000, 0);
  parallel_for(seen.size(), 4, [&](std::size_t i) { ++seen[i]; });
  CHECK(seen == std::vector<int>(1000, 1));
  parallel_for(0, 4, [](std::size_t) { FAIL("there is nothing to do"); });
}

TEST_CASE("a task may spread work of its own", "[invariant]") {
  std::vector<std::vector<int>> seen(20, std::vector<int>(50, 0));
  parallel_for(seen.size(), 3, [&](std::size_t i) {
    parallel_for(seen[i].size(), 3, [&](std::size_t j) { ++seen[i][j]; });
  });
  CHECK(seen == std::vector<std::vector<int>>(20, std::vector<int>(50, 1)));
}

TEST_CASE("callers on several threads do not disturb each other", "[invariant]") {
  std::vector<long> sums(4, 0);
  {
    std::vector<std::jthread> callers;
    for (std::size_t c = 0; c < sums.size(); ++c)
      callers.emplace_back([&sums, c] {
        for (int round = 0; round < 200; ++round) {
          std::vector<long> parts(7, 0);
          parallel_for(parts.size(), 3, [&](std::size_t i) { parts[i] = static_cast<long>(i); });
          sums[c] += std::accumulate(parts.begin(), parts.end(), 0L);
        }
      });
  }
  CHECK(sums == std::vector<long>(4, 200 * 21));
}

TEST_CASE("no more threads take part than are asked for", "[invariant]") {
  for (const int threads : {1, 2, 5}) {
    std::mutex mutex;
    std::set<std::thread::id> took_part;
    parallel_for(2000, threads, [&](std::size_t) {
      const std::scoped_lock lock(mutex);
      took_part.insert(std::this_thread::get_id());
    });
    CHECK(took_part.size() >= 1);
    CHECK(took_part.size() <= static_cast<std::size_t>(threads));
  }
}
