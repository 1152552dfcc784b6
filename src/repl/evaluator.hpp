// Runs Lua text in a session: decks whole, prompt input as it comes. Never prints, never ends the program.
#pragma once
#include <string>
#include <vector>

#include "script/session.hpp"

namespace fabricsh::repl {

enum class Outcome {
  done,
  deck_error,         // exit code 1
  numerical_failure,  // exit code 3
};

struct Result {
  Outcome outcome = Outcome::done;
  std::string message = {};  // of an error
  std::string shown = {};    // the values of an expression, as text
  bool expression = false;   // it was one
};

// "=x" as "x": what older habits write to see a value.
std::string without_equals(const std::string& input);

// Does the parser come to the end of what is typed before the expression or the statements are whole?
bool wants_more(script::Session& session, const std::string& input);

// What is typed at a prompt: an expression (a "=" before it is ignored), whose values come back as text, or
// statements.
Result evaluate(script::Session& session, const std::string& input);

// A chunk of -e.
Result run_text(script::Session& session, const std::string& text, const std::string& name);

// A deck (empty path: standard input) with its arguments, which it sees as `...` and in `arg`.
Result run_deck(script::Session& session, const std::string& path, const std::vector<std::string>& arguments);

// require "module", as -l does: "name" or "global=name".
Result run_module(script::Session& session, const std::string& module);

// fabric.globals().
Result spill_globals(script::Session& session);

// The global table `arg`: line[script] at 0, what follows from 1, what precedes below 0.
void set_arguments(script::Session& session, const std::vector<std::string>& line, std::size_t script);

}  // namespace fabricsh::repl
