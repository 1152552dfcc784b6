// Whether the program's own code of a run is executing, or a Lua function of the deck that the run has
// called. The signal handlers need to know.
#pragma once
#include <lua.hpp>

namespace fabricsh::script {

// While an object of this class exists, a run's own code is executing.
class RunAtWork {
 public:
  RunAtWork();
  ~RunAtWork();
  RunAtWork(const RunAtWork&) = delete;
  RunAtWork& operator=(const RunAtWork&) = delete;

 private:
  bool before_;
};

// Whether a run's own code is executing; it answers a signal after its step or sooner. Signal-safe.
bool run_is_at_work();

// Like lua_call(), for a function of the deck that a run calls; meanwhile the deck's code is executing.
void call_deck(lua_State* L, int arguments, int results);

}  // namespace fabricsh::script
