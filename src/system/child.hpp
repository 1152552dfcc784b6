// Another program, run to its end.
#pragma once
#include <string>
#include <vector>

namespace fabricsh::system {

struct ChildResult {
  bool found = true;  // false: no such program
  bool good = false;  // it ended by itself with exit code 0
  int signal = 0;     // that ended it; 0: none
  std::string out;    // what it wrote to stdout
  std::string said;   // the beginning of what it wrote to stderr
};

// Runs arguments[0] (looked up in PATH unless it contains a slash) with `input` as its
// standard input. A missing program is reported by found = false. Error, beginning with
// `who`: no memory for input and output, or the program cannot be started for another reason.
// A signal to this program ends the child after five seconds of the child's computing time, or as many in
// which it computes nothing; the end of the thread that waits for it ends it at once, however it comes.
ChildResult run_child(const std::vector<std::string>& arguments, const std::string& input,
                      const std::string& who);

// Whether run_child() leaves a child these seconds now. Signal-safe.
bool child_has_grace();

// The program that spawn_bound() starts, with its streams, each -1 to keep that of this program.
struct Spawn {
  std::vector<std::string> arguments;
  int input = -1, out = -1, said = -1;
  bool own_group = true;  // it leads a process group, so that Ctrl-C at the terminal does not reach it
  int ends_by = 9;        // the signal that it gets when the thread that started it ends
};
// Starts a program that dies with the thread that started it, whatever ends that. Returns 0 or the system's
// reason, and sets its number.
int spawn_bound(const Spawn& what, int& child);

}  // namespace fabricsh::system
