// The drawing program, run on a script.
#pragma once
#include <string>

namespace fabricsh::files {

// Error: gnuplot is not installed, or it failed (with its own words).
void run_gnuplot(const std::string& script);

}  // namespace fabricsh::files
