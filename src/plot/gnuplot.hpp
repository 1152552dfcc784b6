// The drawing program, run on a script.
#pragma once
#include <string>

#include "base/error.hpp"

namespace fabricsh::plot {

// The drawing program is not installed: the one reason for which a figure may be missing.
class NoGnuplot : public Error {
 public:
  using Error::Error;
};

// Returns what it drew on its standard output; it is given no file to write to. NoGnuplot; Error: it failed
// or drew nothing, with the reason that it gave.
std::string run_gnuplot(const std::string& script);

}  // namespace fabricsh::plot
