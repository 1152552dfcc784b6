// Arrays from which packs are loaded: each begins on a cache line, so that no pack spans two lines. Numbers
// without an initial value are left unset, and their memory is first touched when they are written.
#pragma once
#include <sys/mman.h>

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace fabricsh {

inline constexpr std::align_val_t cache_line{64}, large_page{2u << 20};

// Long arrays begin on a large page and ask the system for such pages, which it provides much faster.
inline std::align_val_t line_alignment(std::size_t bytes) {
  return bytes < 4 * static_cast<std::size_t>(large_page) ? cache_line : large_page;
}
inline void* allocate_lines(std::size_t bytes) {
  void* const memory = ::operator new(bytes, line_alignment(bytes));
#if defined(MADV_HUGEPAGE)
  if (line_alignment(bytes) == large_page) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
  return memory;
}

template <class T>
struct LineAllocator {
  using value_type = T;
  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(allocate_lines(n * sizeof(T))); }
  void deallocate(T* p, std::size_t n) { ::operator delete(p, line_alignment(n * sizeof(T))); }
  template <class U>
  void construct(U* p) {
    ::new (static_cast<void*>(p)) U;
  }
  template <class U, class... Arguments>
  void construct(U* p, Arguments&&... arguments) {
    ::new (static_cast<void*>(p)) U(std::forward<Arguments>(arguments)...);
  }
  friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }
};

using LineVector = std::vector<double, LineAllocator<double>>;

}  // namespace fabricsh
