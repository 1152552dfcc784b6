#include "script/session/at_work.hpp"

#include <atomic>

namespace fabricsh::script {

namespace {

// Global, because signals concern the whole process; one session runs at a time.
std::atomic<bool> run{false};

class DeckAtWork {
 public:
  ~DeckAtWork() { run = before_; }

 private:
  bool before_ = run.exchange(false);
};

}  // namespace

RunAtWork::RunAtWork() : before_(run.exchange(true)) {}

RunAtWork::~RunAtWork() { run = before_; }

bool run_is_at_work() { return run; }

void call_deck(lua_State* L, int arguments, int results) {
  const DeckAtWork deck;
  lua_call(L, arguments, results);
}

}  // namespace fabricsh::script
