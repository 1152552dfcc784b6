// The interactive session: reads, evaluates, shows, until the lines end.
#pragma once
#include <ostream>

#include "repl/editor.hpp"
#include "repl/evaluator.hpp"
#include "script/session.hpp"

namespace fabricsh::repl {

// What the session says on its two streams.
struct Voice {
  std::ostream &out, &err;
  Style style = Style();  // of err
};

// Errors are shown on err and never end the session. Returns what the first input that was not done came to.
Outcome converse(script::Session& session, Lines& lines, const Voice& voice);

// A word about input that does what few people mean; empty: nothing to say.
std::string advice(const std::string& input);

// Ctrl-C, SIGTERM or SIGHUP stops the Lua code or the analysis that runs in this session, as long as the
// guard lives; a second one, before that has stopped or within the same input, ends the program.
class InterruptGuard {
 public:
  explicit InterruptGuard(script::Session& session);
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

}  // namespace fabricsh::repl
