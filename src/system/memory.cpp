#include "system/memory.hpp"

#include <malloc.h>
#include <pthread.h>
#include <sys/resource.h>

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

std::size_t heap_in_use() {
  const struct mallinfo2 now = mallinfo2();
  return now.uordblks + now.hblkhd;
}

MemoryLimit memory_limit() {
  MemoryLimit least;
  const auto look = [&least](auto what, const char* option) {
    rlimit limit{};
    if (getrlimit(what, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
    const auto megabytes = static_cast<std::size_t>(limit.rlim_cur >> 20);
    if (least.option.empty() || megabytes < least.megabytes) least = {megabytes, option};
  };
  look(RLIMIT_AS, "ulimit -v");
  look(RLIMIT_DATA, "ulimit -d");
  return least;
}

bool stack_is_short() {
  static const thread_local std::uintptr_t lowest = lowest_address();
  const char here = 0;
  return reinterpret_cast<std::uintptr_t>(&here) < lowest;
}

}  // namespace fabricsh::system
