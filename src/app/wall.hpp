// What the operating system forbids this process under --safe, in addition to the gate of the room system, in
// case the gate has a gap. It cannot be revoked, and children inherit it.
#pragma once
#include <string>
#include <vector>

#include "script/session/limits.hpp"

namespace fabricsh::app {

// Forbids new rights by starting programs (no_new_privs). With Landlock in the kernel, also: all files except
// the readable and writable folders and the program's own, the network, and all programs except this one and
// gnuplot. To be called before a second thread exists. Features unknown to the kernel are skipped.
void raise_wall(const std::vector<std::string>& readable, const std::string& writable);

// Ends the process with a message when its CPU time is used up. Limits files to 4 GiB, and data memory to the
// given limit plus the needs of libraries and threads.
void limit_process(const script::SafeOptions& limits);

}  // namespace fabricsh::app
