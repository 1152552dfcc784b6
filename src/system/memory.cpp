#include "system/memory.hpp"

#include <malloc.h>
#include <sys/resource.h>

namespace fabricsh::system {

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

}  // namespace fabricsh::system
