// Runs gnuplot on a script.
#pragma once
#include <string>

#include "base/error.hpp"

namespace fabricsh::plot {

// gnuplot is not installed; callers may then continue without the figure.
class NoGnuplot : public Error {
 public:
  using Error::Error;
};

// Returns the drawing that gnuplot writes to its standard output. Throws
// NoGnuplot, or Error with gnuplot's reason if it failed or drew nothing.
std::string run_gnuplot(const std::string& script);

}  // namespace fabricsh::plot
