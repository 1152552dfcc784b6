// --safe: folders and limits for an untrusted deck. First the wall is raised, then the program is restarted
// so that all its threads are behind the wall, then the gate is closed and the deck run.
#pragma once
#include "app/command_line.hpp"

namespace fabricsh::app {

// Raises the wall and restarts the program; the second time it closes the gate and returns. Error: an invalid
// folder, or one that contains too much.
void go_safe(const CommandLine& command, char** words);

}  // namespace fabricsh::app
