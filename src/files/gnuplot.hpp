// The drawing program, run on a script.
#pragma once
#include <string>

namespace fabricsh::files {

// Returns the beginning of what it printed (20000 bytes). Error: gnuplot is not installed, or it failed (with
// its own words).
std::string run_gnuplot(const std::string& script);

}  // namespace fabricsh::files
