// Prints the speed and memory of the Chebyshev series against their targets, from one run.
//
// What is compared is timed in turn, A B A B, and medians are taken, so that a change in the load
// of the machine falls on both sides.
#include <malloc.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>
#include <thread>

#include "benchmarks/rows.h"
#include "evaluation/kernels/series_kernels.h"

#ifndef SHEDLIGHT_BENCH_FLAGS
#define SHEDLIGHT_BENCH_FLAGS "?"
#endif

namespace {

void print_machine() {
  std::ifstream cpu("/proc/cpuinfo");
  std::string line, model = "?";
  while (std::getline(cpu, line))
    if (line.starts_with("model name")) model = line.substr(line.find(':') + 2);
  double load[3] = {-1, -1, -1};
  getloadavg(load, 3);
  std::printf("Processor: %s, %u threads; kernels: %s; load on start: %.1f\n", model.c_str(),
              std::thread::hardware_concurrency(),
              std::string(evaluation::instruction_set()).c_str(), load[0]);
  std::printf("Compiler: %s; flags: %s\n", __VERSION__, SHEDLIGHT_BENCH_FLAGS);
  std::printf(
      "Times: processor time of the one thread where nothing else is said; medians of %d runs in "
      "turn,\n+- half the distance of their quartiles.\n\n",
      benchmarks::repetitions);
}

}  // namespace

int main() {
  print_machine();
  const benchmarks::Stopwatch wall(benchmarks::Time::of_wall), processor;
  benchmarks::RatioTable table;
  benchmarks::memory_of_a_scan(table);
  benchmarks::against_the_sources(table, "memory fresh in every run");
  // From here on memory once taken is kept: a fresh page costs several times more on some virtual
  // machines than on others, and the sources' tables take many.
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  benchmarks::against_the_sources(table, "memory kept");
  benchmarks::tolerances_and_threads(table);
  benchmarks::query_rates(table);
  benchmarks::growth_with_the_patch(table);
  benchmarks::growth_with_the_depth(table);
  benchmarks::orders_only(table);
  benchmarks::against_the_direct_sum(table);
  std::printf("Share of a processor that this thread had: %.0f %%.\n",
              100 * processor.seconds() / wall.seconds());
  benchmarks::full_check(table);
  std::puts("");
  table.print();
}
