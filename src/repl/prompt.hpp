// The interactive session: reads, evaluates and prints until the input ends.
#pragma once
#include <ostream>

#include "repl/editor.hpp"
#include "repl/evaluator.hpp"
#include "repl/interrupt.hpp"
#include "script/session/session.hpp"

namespace fabricsh::repl {

// The two output streams of the session.
struct Voice {
  std::ostream &out, &err;
  TerminalStyle style = TerminalStyle();  // of err
};

// Errors are shown on err and do not end the session. Returns the outcome of the first input that failed.
// Ctrl-C ends the input that is running; without a user at the prompt it ends the session, too, as it ends a
// deck.
EvaluationOutcome converse(script::Session& session, Lines& lines, const Voice& voice,
                           Attended attended = Attended::yes);

// Advice on input with an effect that is rarely intended; empty: none.
std::string advice(const std::string& input);

}  // namespace fabricsh::repl
