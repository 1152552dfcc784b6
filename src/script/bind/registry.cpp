// The registry as seen from Lua; the source of help, the reference page and the stubs for editors.
#include <algorithm>

#include "base/number.hpp"
#include "base/suggest.hpp"
#include "run/result_fields.hpp"
#include "script/bind/rooms.hpp"
#include "script/call/parts.hpp"
#include "script/call/words.hpp"
#include "script/show/show.hpp"

namespace fabricsh::script {

namespace {

const char* style_word(const Entry& entry) {
  if (entry.style == Style::property) return "property";
  return entry.style == Style::fields ? "fields" : "positional";
}

void push_kinds(lua_State* L, unsigned kinds) {
  lua_newtable(L);
  lua_Integer place = 0;
  for (const auto& [name, kind] : kind_names)
    if ((kinds & kind) != 0) {
      lua_pushstring(L, name);
      lua_rawseti(L, -2, ++place);
    }
}

void push_row_default(lua_State* L, const Argument& row) {
  if (const double* x = std::get_if<double>(&row.fallback))
    put(L, "default", exact_number(*x));
  else if (const std::string* word = std::get_if<std::string>(&row.fallback))
    put(L, "default", "\"" + *word + "\"");
  else if (const bool* flag = std::get_if<bool>(&row.fallback))
    put(L, "default", *flag ? "true" : "false");
}

void push_rows(lua_State* L, const std::vector<Argument>& rows);

void push_row(lua_State* L, const Argument& row) {
  luaL_checkstack(L, 10, "registry");
  push_record(L, "name", row.name, "unit", row.unit, "sentence", row.sentence, "expected", expected(row),
              "of", row.of, "required", row.required, "low", row.range.low, "high", row.range.high);
  push_row_default(L, row);
  put(
      L, "kinds", [&] { push_kinds(L, row.kinds); }, "choices", row.choices, "rows",
      [&] { push_rows(L, row.rows); });
}

void push_rows(lua_State* L, const std::vector<Argument>& rows) {
  push_list(L, rows, [&](const auto& one) { push_row(L, one); });
}

// rows(): a list of {name, style, owner, sentence, example, arguments}, sorted by name.
int registry_rows(lua_State* L) {
  load_defined_later(L);
  std::vector<const Entry*> entries;
  for (const Entry& entry : Session::of(L).registry().entries()) entries.push_back(&entry);
  std::sort(entries.begin(), entries.end(), [](const Entry* a, const Entry* b) { return a->name < b->name; });
  push_list(L, entries, [&](const Entry* entry) {
    push_record(L, "name", entry->name, "style", style_word(*entry), "owner", entry->owner(), "sentence",
                entry->sentence, "example", entry->example, "arguments",
                [&] { push_rows(L, entry->arguments); });
  });
  return 1;
}

// fields(): a list of {name, unit, shape, place, sentence, components}, in the order of files.
int result_fields(lua_State* L) {
  return push_list(L, run::result_fields(), [L](const auto& field) {
    push_record(L, "name", field.name, "unit", field.unit, "shape", run::name(field.shape), "place",
                run::name(field.place), "sentence", field.sentence, "usual", field.usual, "components",
                field.components);
  });
}

// name_of(f): the row's name of a registered function, or nil.
int name_of(lua_State* L) {
  luaL_checkany(L, 1);
  const Entry* entry = entry_of(L, 1);
  if (entry == nullptr) return 0;
  return push_value(L, entry->name);
}

// class_of(x): the class of a fabricsh object, or nil.
int class_of(lua_State* L) {
  if (lua_type(L, 1) != LUA_TUSERDATA || luaL_getmetafield(L, 1, "__name") != LUA_TSTRING) return 0;
  return 1;
}

// card_of(t): the card from which a table of fields was read, or nil.
int card_of(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  push_card_of(L, 1);
  return 1;
}

// nearest(word, names): the name nearest to a misspelt one, or nil.
int nearest_name(lua_State* L) {
  const char* word = luaL_checkstring(L, 1);
  luaL_checktype(L, 2, LUA_TTABLE);
  std::vector<std::string> names;
  for (lua_Integer i = 1; lua_rawgeti(L, 2, i) != LUA_TNIL; ++i) {
    if (lua_type(L, -1) != LUA_TSTRING)
      return luaL_error(L, "nearest: expected a list of names, got %s at place %I", luaL_typename(L, -1), i);
    names.emplace_back(lua_tostring(L, -1));
    lua_pop(L, 1);
  }
  const std::string found = nearest(word, names);
  if (found.empty()) return 0;
  return push_value(L, found);
}

int show_value(lua_State* L) {
  luaL_checkany(L, 1);
  return push_text(L, show(L, 1));
}

}  // namespace

void push_registry(lua_State* L) {
  const luaL_Reg functions[] = {{"rows", registry_rows}, {"name_of", name_of},      {"class_of", class_of},
                                {"card_of", card_of},    {"fields", result_fields}, {"nearest", nearest_name},
                                {"show", show_value},    {nullptr, nullptr}};
  luaL_newlib(L, functions);
}

}  // namespace fabricsh::script
