// Memory for large tables that are read at random.
#pragma once

#include <cstddef>
#include <memory>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace brdf {

namespace detail {

inline constexpr std::size_t cache_line = 64, huge_page = std::size_t{1} << 21;

/// Whole cache lines; from two huge pages on, whole huge pages.
constexpr std::align_val_t table_alignment(std::size_t bytes) {
  return std::align_val_t{bytes >= 2 * huge_page ? huge_page : cache_line};
}

struct FreeTable {
  std::align_val_t alignment{cache_line};
  void operator()(void* memory) const { ::operator delete(memory, alignment); }
};

}  // namespace detail

/// An array of plain numbers or of structs of them, not initialised.
template <class T>
using TableMemory = std::unique_ptr<T[], detail::FreeTable>;

/// Linux lends huge pages to large tables for the asking: 55 MB then take some 30 page faults
/// instead of 13,000, and a query finds its rows in few pages. Elsewhere, or where it is refused,
/// the memory is as it comes. Throws std::bad_alloc.
template <class T>
TableMemory<T> table_memory(std::size_t count) {
  const std::size_t bytes = sizeof(T) * count;
  const std::align_val_t alignment = detail::table_alignment(bytes);
  void* memory = ::operator new(bytes, alignment);
#ifdef __linux__
  if (alignment != std::align_val_t{detail::cache_line}) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
  return TableMemory<T>(static_cast<T*>(memory), detail::FreeTable{alignment});
}

}  // namespace brdf
