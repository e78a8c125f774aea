// The rows of the table; each function times one comparison and adds what came out.
#pragma once

#include <string>

#include "benchmarks/ratio_table.h"
#include "benchmarks/stopwatch.h"

namespace benchmarks {

inline constexpr int repetitions = 9;

/// A median and half the distance of the quartiles.
inline std::string ms(const Samples& times) {
  return format("%.2f ms +- %.0f %%", 1e3 * times.median(), 100 * times.spread());
}

/// B: the most memory held. To be called before anything larger has run in this process.
void memory_of_a_scan(RatioTable& table);
/// A periodic against the sources' algorithm, which is checked first and whose split is printed.
void against_the_sources(RatioTable& table, const std::string& memory);
/// A isolated against a tenth of the cells by direct sum, in five parts.
void against_the_direct_sum(RatioTable& table);
/// Every cell of A at 256 x 256 by direct sum.
void full_check(RatioTable& table);
void tolerances_and_threads(RatioTable& table);
void query_rates(RatioTable& table);
void growth_with_the_patch(RatioTable& table);
void growth_with_the_depth(RatioTable& table);
/// The bands around the orders alone (Nmin/Nmax) against all cells of the same plan.
void orders_only(RatioTable& table);

}  // namespace benchmarks
