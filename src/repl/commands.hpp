// Words that mean something at the prompt alone: help, ?, quit, exit.
#pragma once
#include <string>

#include "script/session.hpp"

namespace fabricsh::repl {

// Said when a session begins.
inline constexpr const char* greeting =
    "help() shows what there is, help \"shear\" all about shear; Tab completes; quit or Ctrl-D ends";

// quit, exit, with or without (), where the user has no such name.
bool asks_to_leave(script::Session& session, const std::string& input);

// "help", "?" and "? word" as the Lua that they mean; other input as it is.
std::string meant(script::Session& session, const std::string& input);

}  // namespace fabricsh::repl
