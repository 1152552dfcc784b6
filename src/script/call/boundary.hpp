// The boundary of C++ and Lua, through which every function of the registry is called.
#pragma once
#include <lua.hpp>
#include <string>
#include <vector>

#include "script/session/session.hpp"

namespace fabricsh::script {

// "deck.lua:12: " for the innermost Lua line of the user (not in lua/fabric), or empty.
std::string position(lua_State* L);

// Registry key of the report on the last numerical failure.
inline constexpr const char* why_key = "fabricsh.why";

// Pushes the function of a row in the registry.
void push_function(lua_State* L, const Entry& entry);
// The row of the function at index; null if it is not in the registry.
const Entry* entry_of(lua_State* L, int index);
// Stores the function of a row in the table that its name states.
void place(lua_State* L, const Entry& entry);

// Makes reading an unknown field of the table on top of the stack an error with the nearest known name.
void watch_module(lua_State* L, const std::string& name);

// A function of the library, "fabric.lab.bias", that this module of Lua defines. The module is loaded when
// one of its functions is first asked for: most decks need few, and all of them take longer to load than a
// short run.
void define_later(lua_State* L, const std::string& name, const std::string& module);
// Loads what defines the functions of the table with this name that are not defined yet, or of all tables.
void load_defined_later(lua_State* L, const std::string& home = {});
// The same for the table at index, if it is one of the library's.
void load_members(lua_State* L, int index);

// Stores every row at the place that its name states: functions in the table `fabric` (registry key
// "fabric"), methods and properties in their class.
void install(Session& session, std::vector<Entry> entries);

// In the Lua registry: how often a file could not be written, or memory was not given.
inline constexpr const char* refusals_key = "fabricsh.refusals";

}  // namespace fabricsh::script
