// Another program, run to its end.
#pragma once
#include <string>
#include <vector>

namespace fabricsh::system {

struct ChildResult {
  bool found = true;  // false: no such program
  bool good = false;  // it ended by itself with exit code 0
  std::string out;    // what it wrote to stdout
  std::string said;   // the beginning of what it wrote to stderr
};

// Runs arguments[0] (looked up in PATH unless it contains a slash) with `input` as its
// standard input. A missing program is reported by found = false. Error, beginning with
// `who`: no memory for input and output, or the program cannot be started for another reason.
// A signal to this program ends the child if it has not ended within five seconds.
ChildResult run_child(const std::vector<std::string>& arguments, const std::string& input,
                      const std::string& who);

}  // namespace fabricsh::system
