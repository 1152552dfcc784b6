// Words with a meaning only at the prompt: help, ?, quit, exit.
#pragma once
#include <string>

#include "script/session/session.hpp"

namespace fabricsh::repl {

// Shown at the beginning of a session.
inline constexpr const char* greeting =
    "help() shows what there is, help \"shear\" all about shear; Tab completes; quit or Ctrl-D ends";

// quit or exit, with or without (), unless the user has defined such a name.
bool is_exit_command(script::Session& session, const std::string& input);

// Translates "help", "?" and "? word" to Lua; other input is returned unchanged.
std::string command_as_lua(script::Session& session, const std::string& input);

}  // namespace fabricsh::repl
