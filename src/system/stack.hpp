// The stack of this thread, which a user may have limited (ulimit -s).
#pragma once

namespace fabricsh::system {

// Whether little is left of the stack: less than what a run, its solver and its outputs take, or than half of
// a small stack. To be asked where calls can nest as deeply as a deck likes.
bool stack_is_short();

}  // namespace fabricsh::system
