// Arrays from which packs are loaded: each begins on a cache line, so that no pack spans two lines.
#pragma once
#include <cstddef>
#include <new>
#include <vector>

namespace fabricsh {

inline constexpr std::align_val_t cache_line{64};

template <class T>
struct LineAllocator {
  using value_type = T;
  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), cache_line)); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, cache_line); }
  friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }
};

using LineVector = std::vector<double, LineAllocator<double>>;

}  // namespace fabricsh
