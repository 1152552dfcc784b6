// The drawing program, run on a script.
#pragma once
#include <string>

namespace fabricsh::files {

// Returns what it drew on its standard output; it is given no file to write to. Error: gnuplot is not
// installed, it failed, or it drew nothing (with its own words).
std::string run_gnuplot(const std::string& script);

}  // namespace fabricsh::files
