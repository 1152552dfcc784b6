// --safe: the folders and limits of a deck from elsewhere, and their order: the wall first, then the program
// anew so that each of its threads stands behind it, then the gate, then the deck.
#pragma once
#include "app/command_line.hpp"

namespace fabricsh::app {

// Raises the wall and starts the program anew; the second time, closes the gate and returns. Error: a folder
// that cannot be, or one too wide to be given away.
void go_safe(const CommandLine& command, char** words);

}  // namespace fabricsh::app
