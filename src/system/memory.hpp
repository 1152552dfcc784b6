// The memory of this process.
#pragma once
#include <cstddef>
#include <string>

namespace fabricsh::system {

// Bytes allocated at present; 0 where the C library does not count them (as under the address sanitizer).
std::size_t heap_in_use();

// The smallest limit that applies to the whole process.
struct MemoryLimit {
  std::size_t megabytes = 0;  // 0: there is none
  std::string option;         // of the shell that sets it: "ulimit -v"
};
MemoryLimit memory_limit();

}  // namespace fabricsh::system
