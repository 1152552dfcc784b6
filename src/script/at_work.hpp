// What is at work: a run's own code, or a function of the deck's that it asked. A signal handler wants to
// know.
#pragma once
#include <lua.hpp>

namespace fabricsh::script {

// As long as it lives, a run's own code is at work.
class RunAtWork {
 public:
  RunAtWork();
  ~RunAtWork();
  RunAtWork(const RunAtWork&) = delete;
  RunAtWork& operator=(const RunAtWork&) = delete;

 private:
  bool before_;
};

// Is a run's own code at work, which answers a signal after its step or sooner? Safe in a signal handler.
bool run_is_at_work();

// lua_call() for a function of the deck's that a run may ask: it is at work meanwhile.
void call_deck(lua_State* L, int arguments, int results);

}  // namespace fabricsh::script
