// Ctrl-C, SIGTERM and SIGHUP: what runs stops where it is whole, and what does not stop is ended.
#pragma once
#include "script/session.hpp"

namespace fabricsh::repl {

// Does somebody sit at the program's prompt, who can ask again?
enum class Attended { no, yes };

// Ctrl-C, SIGTERM or SIGHUP stops the Lua code or the analysis that runs in this session, as long as the
// guard lives. The program ends by the signal where that has not been answered after ten seconds, as in one
// long function of Lua's; a run is waited for, which answers after its step, and Ctrl-C at a prompt leaves it
// to who sits there. A second Ctrl-C within the same input ends the program at once; a second SIGTERM or
// SIGHUP does when it comes two seconds after the first or later, for the first may come several times,
// unless a run is at its last outputs. After the guard Ctrl-C is ignored: all that was asked for is done, the
// program is about to end, and its exit code should tell how the deck went.
class InterruptGuard {
 public:
  explicit InterruptGuard(script::Session& session, Attended attended = Attended::no);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

// While this lives Ctrl-C is for what runs: input that is evaluated, or a deck.
class Running {
 public:
  explicit Running(script::Session& session);
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

 private:
  script::Session& session_;
};

// Has Ctrl-C come while nothing ran and no line was being typed? Asking forgets it.
bool ctrl_c_between_lines();

}  // namespace fabricsh::repl
