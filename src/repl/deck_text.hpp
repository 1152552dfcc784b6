// Prompt input as part of a deck: so that the same is done when all of it is one chunk.
#pragma once
#include <string>

#include "repl/evaluator.hpp"

namespace fabricsh::repl {

// What failed becomes a comment; an expression is shown by _show(...); what is local or returns keeps to
// itself.
std::string deck_text(const std::string& input, const Result& result);

// A deck that was run before the prompt came.
std::string deck_call(const std::string& path);

}  // namespace fabricsh::repl
