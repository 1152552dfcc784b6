// The bindings, one file per room of the core. Each function returns the rows of its room; some need the
// session.
#pragma once
#include <string>

#include "script/call/boundary.hpp"
#include "script/call/call.hpp"
#include "script/call/push.hpp"
#include "script/session/entry.hpp"
#include "script/session/session.hpp"
#include "script/session/warning_log.hpp"
#include "script/values/classes.hpp"

namespace fabricsh::script {

void bind_all(Session& session);

void bind_core(Session& session);
void bind_history(Session& session);
void bind_mesh(Session& session);
void bind_card(Session& session);
void bind_prompt(Session& session);

// require "fabric.define": registers functions written in Lua.
int open_define(lua_State* L);
// Pushes the table of functions for reading the registry.
void push_registry(lua_State* L);

// A history argument: number | function(t) | history object.
inline constexpr unsigned history_kinds = number | function | object;
Argument history_(std::string name, std::string unit, std::string sentence);
// Reads the value at index as a history; `what` names it in errors.
history::History read_history(Session& session, lua_State* L, int index, const std::string& what);
// Reads the argument { {time, value}, ... } of a call.
history::History read_points(const Call& call, const char* name);

// Pushes { {code=, text=, time=, element=, serious=}, ... }; elements are numbered from 1.
void push_warnings(lua_State* L, const WarningLog::Warnings& warnings);

}  // namespace fabricsh::script
