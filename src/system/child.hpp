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

// Runs arguments[0] (looked up in PATH unless it holds a slash) with the text as its input. Error, led by
// `who`: no memory for what it reads and writes, or the program does not start for another reason than that
// it is not there.
ChildResult run_child(const std::vector<std::string>& arguments, const std::string& input,
                      const std::string& who);

}  // namespace fabricsh::system
