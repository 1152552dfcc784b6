// Runs Lua code in a session: whole decks, or prompt input. Does not print and does not end the program.
#pragma once
#include <string>
#include <vector>

#include "script/session/session.hpp"

namespace fabricsh::repl {

enum class EvaluationOutcome {
  done,
  deck_error,         // exit code 1
  numerical_failure,  // exit code 3
};

struct Result {
  EvaluationOutcome outcome = EvaluationOutcome::done;
  std::string message = {};  // of an error
  std::string shown = {};    // the values of an expression as text
  bool expression = false;   // the input was an expression
};

// "=x" as "x", for users accustomed to the older form.
std::string without_equals(const std::string& input);

// Whether the parser reaches the end of the input before the expression or the statements are complete.
bool is_incomplete(script::Session& session, const std::string& input);

// Runs prompt input: an expression (with an optional "=" before it), whose values are returned as text, or
// statements.
Result evaluate(script::Session& session, const std::string& input);

// Runs a chunk of -e.
Result run_text(script::Session& session, const std::string& text, const std::string& name);

// Runs a deck (empty path: standard input) with its arguments, available as `...` and in `arg`.
Result run_deck(script::Session& session, const std::string& path, const std::vector<std::string>& arguments);

// require "module", for -l: "name" or "global=name".
Result run_module(script::Session& session, const std::string& module);

// Calls fabric.globals().
Result spill_globals(script::Session& session);

// Sets the global table `arg`: line[script] at 0, the following words from 1, the preceding ones below 0.
void set_arguments(script::Session& session, const std::vector<std::string>& line, std::size_t script);

// --- Words with a meaning only at the prompt: help, ?, quit, exit.

// Shown at the beginning of a session.
inline constexpr const char* greeting =
    "help() shows what there is, help \"shear\" all about shear; Tab completes; quit or Ctrl-D ends";

// quit or exit, with or without (), unless the user has defined such a name.
bool is_exit_command(script::Session& session, const std::string& input);

// Translates "help", "?" and "? word" to Lua; other input is returned unchanged.
std::string command_as_lua(script::Session& session, const std::string& input);

}  // namespace fabricsh::repl
