#include "system/stack.hpp"

#include <pthread.h>

#include <algorithm>
#include <cstdint>

namespace fabricsh::system {

namespace {

constexpr std::size_t enough = 96 << 10;  // bytes; a run on 64 KiB just works

// The lowest address that may still be used. The stack grows downwards.
std::uintptr_t lowest_address() {
  pthread_attr_t about;
  if (pthread_getattr_np(pthread_self(), &about) != 0) return 0;
  void* bottom = nullptr;
  std::size_t size = 0;
  pthread_attr_getstack(&about, &bottom, &size);
  pthread_attr_destroy(&about);
  return reinterpret_cast<std::uintptr_t>(bottom) + std::min(enough, size / 2);
}

}  // namespace

bool stack_is_short() {
  static const thread_local std::uintptr_t lowest = lowest_address();
  const char here = 0;
  return reinterpret_cast<std::uintptr_t>(&here) < lowest;
}

}  // namespace fabricsh::system
