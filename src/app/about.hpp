// What this program is and what it runs on.
#pragma once
#include <string>

namespace fabricsh::app {

std::string headline();  // "fabricsh 0.1.0 (Release, GNU 12.2.0)"
// The headline, then versions of the libraries, the instruction set and the threads, and where the programs
// that draw were found.
std::string about();

}  // namespace fabricsh::app
