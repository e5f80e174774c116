#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace meshgrade {

/// Frees what std::aligned_alloc gave.
struct FreeMemory {
  void operator()(void* memory) const { std::free(memory); }
};

/// An array of plain values without initial values.
template <typename T>
using BigArray = std::unique_ptr<T[], FreeMemory>;

/// Large arrays ask for huge pages: with small ones, the first touch of the memory costs more
/// than all the arithmetic of a subdivision. Throws std::bad_alloc.
template <typename T>
BigArray<T> make_big_array(std::size_t n) {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  constexpr std::size_t kHugePage = std::size_t{1} << 21U;
  constexpr std::size_t kCacheLine = 64;
  const std::size_t n_bytes = n * sizeof(T);
  const std::size_t alignment = n_bytes < kHugePage / 4 ? kCacheLine : kHugePage;
  const std::size_t rounded = (n_bytes + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, rounded);
  if (memory == nullptr && rounded > 0) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  // A wish only: where it is not granted, small pages do.
  if (alignment == kHugePage) madvise(memory, rounded, MADV_HUGEPAGE);
#endif
  return BigArray<T>(static_cast<T*>(memory));
}

}  // namespace meshgrade
