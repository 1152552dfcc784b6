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

}  // namespace fabricsh::repl
