// The bindings, one file per room of the core. Each function returns the rows of its room; some need the
// session.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "card/card.hpp"
#include "history/history.hpp"
#include "mesh/mesh.hpp"
#include "script/call/call.hpp"
#include "script/call/entry.hpp"
#include "script/session.hpp"

namespace fabricsh::script {

void bind_all(Session& session);

void bind_core(Session& session);
void bind_history(Session& session);
void bind_mesh(Session& session);
void bind_card(Session& session);

// require "fabric.define": registers functions written in Lua.
int open_define(lua_State* L);
// Pushes the table of functions for reading the registry.
void push_registry(lua_State* L);

template <>
struct ClassName<mesh::Mesh> {
  static constexpr const char* name = "mesh";
};
template <>
struct ClassName<card::Card> {
  static constexpr const char* name = "card";
};
template <>
struct ClassName<history::History> {
  static constexpr const char* name = "history";
};

// A history argument: number | function(t) | history object.
inline constexpr unsigned history_kinds = number | function | object;
Argument history_(std::string name, std::string unit, std::string sentence);
// Reads the value at index as a history; `what` names it in errors.
history::History read_history(Session& session, lua_State* L, int index, const std::string& what);

// Arrays as Lua tables; ids count from 0 in C++ and from 1 in Lua.
void push_numbers(lua_State* L, const std::vector<double>& values);
void push_ids(lua_State* L, const std::vector<mesh::Index>& ids);
void set_number(lua_State* L, const char* name, double value);
void set_text(lua_State* L, const char* name, const std::string& value);
// Gives the result table on top of the stack a protected metatable with a __tostring, one per name. The deck
// may change the table, so the function must not rely on its entries.
void set_text_of(lua_State* L, const char* name, lua_CFunction text);
int report_text(lua_State* L);  // the field `text` of a report, for set_text_of()
// The entry `name` of the table at index if it is a string, else empty; calls no metamethods.
std::string raw_text(lua_State* L, int index, const char* name);
// Sets a metamethod of a class; f is called without protection and must not throw.
void set_meta(Session& session, const std::string& cls, const char* name, lua_CFunction f);

// Makes a card from the table of its constructor; kind: "woven", "svk" or "linear".
card::Card read_card(lua_State* L, int index, const std::string& kind);
// The card as a table with units, for printing.
std::string card_words(const card::Card& card);

}  // namespace fabricsh::script
