// Reports output that did not reach standard output.
#pragma once

namespace fabricsh::app {

// After this call every end of the program checks standard output: if it is full or closed, that is reported,
// and the exit code 0 becomes 1.
void watch_output();

}  // namespace fabricsh::app
