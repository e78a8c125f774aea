// Work spread over threads.
#pragma once

#include <cstddef>
#include <functional>

namespace evaluation {

/// Calls task(i) for i in [0, count) from `threads` threads (at least 1), each i once, in no stated
/// order. The first exception stops the rest and is thrown again here.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& task);

}  // namespace evaluation
