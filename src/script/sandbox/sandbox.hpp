// --safe: the Lua of decks from elsewhere. What is promised and what is not: share/doc/safe.md.
#pragma once
#include "script/session.hpp"

namespace fabricsh::script {

// Takes away what a deck could leave its place with: programs, C modules, binary chunks, the debug library,
// finalisers; leads every function that opens a file through the gate of the process; and loads the library
// into an environment of its own, so that no deck changes what it calls.
void confine(Session& session);

}  // namespace fabricsh::script
