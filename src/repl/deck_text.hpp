// Converts prompt input to a part of a deck, so that all of it has the same effect as a single chunk.
#pragma once
#include <string>

#include "repl/evaluator.hpp"

namespace fabricsh::repl {

// A failed input becomes a comment; an expression is printed by _show(...); an input with local names or a
// return is enclosed in a block.
std::string deck_text(const std::string& input, const Result& result);

// For a deck that was run before the prompt started.
std::string deck_call(const std::string& path);

}  // namespace fabricsh::repl
