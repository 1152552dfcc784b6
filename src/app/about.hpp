// The version of this program and its environment.
#pragma once
#include <string>

namespace fabricsh::app {

std::string headline();  // "fabricsh 0.2.0 (Release, GNU 12.2.0)"
// The headline, then versions of the libraries, the instruction set, the threads, and the locations of the
// drawing programs.
std::string about();

}  // namespace fabricsh::app
