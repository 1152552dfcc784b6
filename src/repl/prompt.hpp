// The interactive session: reads, evaluates, shows, until the lines end.
#pragma once
#include <ostream>

#include "repl/editor.hpp"
#include "script/session.hpp"

namespace fabricsh::repl {

// Errors are shown on err and never end the session.
void converse(script::Session& session, Lines& lines, std::ostream& out, std::ostream& err);

// Ctrl-C stops the Lua code or the analysis that runs in this session, as long as the guard lives.
class InterruptGuard {
 public:
  explicit InterruptGuard(script::Session& session);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

}  // namespace fabricsh::repl
