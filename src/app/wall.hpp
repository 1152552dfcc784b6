// Bans by the operating system on this process under --safe, in addition to the gate of the room system, in
// case the gate has a gap. They cannot be revoked, and children inherit them.
#pragma once
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "script/session/limits.hpp"

namespace fabricsh::app {

// Forbids new rights by starting programs (no_new_privs). With Landlock in the kernel, also: all files except
// the readable and writable folders and the program's own, the network, and all programs except this one and
// gnuplot. To be called before a second thread exists. Features unknown to the kernel are skipped.
void raise_wall(const std::vector<std::string>& readable, const std::string& writable);

// Ends the process with a message when its CPU time is used up. Limits files to 4 GiB, and data memory to the
// given limit plus the needs of libraries and threads.
void limit_process(const script::SafeOptions& limits);

// --- --safe: folders and limits for an untrusted deck. First the wall is raised, then the program is
// restarted so that all its threads are behind the wall, then the gate is closed and the deck run.

// Raises the wall and restarts the program; the second time it closes the gate and returns. Error: an invalid
// folder, or one that contains too much.
void go_safe(const CommandLine& command, char** words);

}  // namespace fabricsh::app
