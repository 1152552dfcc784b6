// What was printed and did not reach standard output is not lost in silence.
#pragma once

namespace fabricsh::app {

// From now on the end of the program, by whichever way, looks at standard output: when it is full or closed
// that is said, and exit code 0 becomes 1.
void watch_output();

}  // namespace fabricsh::app
