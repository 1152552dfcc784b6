// Ctrl-C, SIGTERM and SIGHUP: stops what is running in a consistent state; ends the program if that fails.
#pragma once
#include "script/session/session.hpp"

namespace fabricsh::repl {

// Whether a user is at the prompt, who can press Ctrl-C again.
enum class Attended { no, yes };

// While the guard exists, Ctrl-C, SIGTERM or SIGHUP stops the Lua code or the analysis running in this
// session. If the signal is not answered within ten seconds, for example in a long function of Lua itself,
// the program ends; but a run is waited for, since it answers after its step, and at a prompt Ctrl-C is left
// to the user. A second Ctrl-C during the same input ends the program at once. A second SIGTERM or SIGHUP
// does so if it comes at least two seconds after the first, because the first may be delivered several times,
// and unless a run is writing its last outputs. After the guard has gone, Ctrl-C is ignored: everything is
// done, and the exit code should still state the result of the deck.
class InterruptGuard {
 public:
  explicit InterruptGuard(script::Session& session, Attended attended = Attended::no);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

// While an object of this class exists, Ctrl-C concerns the input being evaluated, or a deck.
class Running {
 public:
  explicit Running(script::Session& session);
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

 private:
  script::Session& session_;
};

// Whether Ctrl-C came while nothing was running and no line was being typed. Resets the flag.
bool ctrl_c_between_lines();

}  // namespace fabricsh::repl
