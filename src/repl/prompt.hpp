// The interactive session: reads, evaluates and prints until the input ends.
#pragma once
#include <ostream>
#include <string>

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

// --- Converts prompt input to a part of a deck, so that all of it has the same effect as a single chunk.

// A failed input becomes a comment; an expression is printed by _show(...); an input with local names or a
// return is enclosed in a block.
std::string deck_text(const std::string& input, const Result& result);

// For a deck that was run before the prompt started.
std::string deck_call(const std::string& path);

}  // namespace fabricsh::repl
