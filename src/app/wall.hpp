// What the system itself forbids this process under --safe, behind the gate of the room system: a second wall
// for the case that the first has a hole. Nothing here can be taken back, and children inherit it.
#pragma once
#include <string>
#include <vector>

#include "script/sandbox/limits.hpp"

namespace fabricsh::app {

// No new rights by starting programs (no_new_privs); where the kernel has Landlock, no files but the readable
// and writable folders and what the program itself lives on, no network, and no programs but this one and
// gnuplot. Call it before there is a second thread. Skips what the kernel does not know.
void raise_wall(const std::vector<std::string>& readable, const std::string& writable);

// Ends the process with a message when its computing time is over, whatever it does; a file of at most 4 GiB;
// memory for data of the process at most the limit plus what its libraries and threads need.
void limit_process(const script::SafeOptions& limits);

}  // namespace fabricsh::app
