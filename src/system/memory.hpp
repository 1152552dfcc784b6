// The memory of this process, and the stack of a thread, which a user may have limited (ulimit -s).
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

// Whether little is left of the stack: less than what a run, its solver and its outputs take, or than half of
// a small stack. To be asked where calls can nest as deeply as a deck likes.
bool stack_is_short();

}  // namespace fabricsh::system
