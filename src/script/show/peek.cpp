#include "script/show/peek.hpp"

#include <set>

#include "script/call/boundary.hpp"
#include "script/call/push.hpp"
#include "script/runs/run.hpp"
#include "script/values/card_rows.hpp"

namespace fabricsh::script {

namespace {

using Names = std::set<std::string>;

constexpr int longest_chain = 20;  // of tables linked by __index
constexpr int most_keys = 1'000'000;
constexpr std::size_t most_names = 10'000;

// Collects names that are wanted.
struct NameCollector {
  std::string_view begin = {};
  Names names = {};
  bool whole = true;

  void add_keys(lua_State* L, int index, bool functions_only) {
    index = lua_absindex(L, index);
    lua_pushnil(L);
    for (int looked = 0; lua_next(L, index) != 0; ++looked) {
      if (looked == most_keys || names.size() == most_names) {
        whole = false;
        return lua_pop(L, 2);
      }
      if (lua_type(L, -2) == LUA_TSTRING && (!functions_only || lua_isfunction(L, -1)))
        if (const std::string name = lua_tostring(L, -2); name.starts_with(begin)) names.insert(name);
      lua_pop(L, 1);
    }
  }
};

// Pushes a table of the class of the object at index: "methods" or "properties".
bool push_part(lua_State* L, int index, const char* part) {
  if (lua_getmetatable(L, index) == 0) return false;
  push_raw(L, -1, part);
  lua_remove(L, -2);
  if (lua_istable(L, -1)) return true;
  lua_pop(L, 1);
  return false;
}

// Replaces the table on top by its metatable's __index; false (and popped) if there is none.
bool go_up(lua_State* L) {
  if (lua_getmetatable(L, -1) != 0) {
    push_raw(L, -1, "__index");
    lua_remove(L, -2);
    lua_remove(L, -2);
    if (lua_istable(L, -1)) return true;
  }
  lua_pop(L, 1);
  return false;
}

// Pushes the table in which the value's fields are looked up; for a string that of its methods.
void push_stand_in(lua_State* L, int index) {
  lua_pushvalue(L, index);
  if (lua_type(L, -1) == LUA_TSTRING && !go_up(L)) lua_pushnil(L);
}

// Replaces the key on top by the raw field of the table or of its __index tables.
void table_field(lua_State* L, int index) {
  lua_pushvalue(L, index);
  for (int i = 0; i < longest_chain; ++i) {
    lua_pushvalue(L, -2);
    if (lua_rawget(L, -2) != LUA_TNIL) {
      lua_replace(L, -3);
      lua_pop(L, 1);
      return;
    }
    lua_pop(L, 1);
    if (!go_up(L)) {
      lua_pop(L, 1);
      lua_pushnil(L);
      return;
    }
  }
  lua_pop(L, 2);
  lua_pushnil(L);
}

// Calls a property function of the program, on top of the stack, for an object.
void read_property(lua_State* L, int index) {
  if (entry_of(L, -1) == nullptr) {
    lua_pop(L, 1);
    return lua_pushnil(L);
  }
  lua_pushvalue(L, index);
  if (lua_pcall(L, 1, 1, 0) == LUA_OK) return;
  lua_pop(L, 1);
  lua_pushnil(L);
}

bool part_field(lua_State* L, int index, const char* part, const std::string& key) {
  if (!push_part(L, index, part)) return false;
  const bool found = push_raw(L, -1, key) != LUA_TNIL;
  lua_remove(L, -2);
  if (found) return true;
  lua_pop(L, 1);
  return false;
}

void object_field(lua_State* L, int index, const std::string& key) {
  if (part_field(L, index, "properties", key)) return read_property(L, index);
  if (const auto card = to_object<card::Card>(L, index)) {
    push_card_table(L, *card);
    const bool found = push_raw(L, -1, key) != LUA_TNIL;
    lua_remove(L, -2);
    if (found) return;
    lua_pop(L, 1);
  }
  if (!part_field(L, index, "methods", key)) lua_pushnil(L);
}

void table_names(lua_State* L, int index, bool methods, NameCollector& names) {
  push_stand_in(L, index);
  if (!lua_istable(L, -1)) return lua_pop(L, 1);
  for (int i = 0; i < longest_chain; ++i) {
    names.add_keys(L, -1, methods);
    if (!go_up(L)) return;
  }
  lua_pop(L, 1);
}

void object_names(lua_State* L, int index, bool methods, NameCollector& names) {
  if (push_part(L, index, methods ? "methods" : "properties")) {
    names.add_keys(L, -1, false);
    lua_pop(L, 1);
  }
  const auto card = methods ? nullptr : to_object<card::Card>(L, index);
  if (card == nullptr) return;
  push_card_table(L, *card);
  names.add_keys(L, -1, false);
  lua_pop(L, 1);
}

}  // namespace

std::string class_of(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TUSERDATA || lua_getmetatable(L, index) == 0) return {};
  std::string name;
  if (push_raw(L, -1, "__name") == LUA_TSTRING) name = lua_tostring(L, -1);
  lua_pop(L, 1);
  luaL_getmetatable(L, class_key(name).c_str());
  const bool own = lua_rawequal(L, -1, -2) != 0;
  lua_pop(L, 2);
  return own ? name : std::string();
}

void peek_field(lua_State* L, int index, const std::string& key) {
  index = lua_absindex(L, index);
  luaL_checkstack(L, 10, "peek");
  if (!class_of(L, index).empty()) return object_field(L, index, key);
  push_stand_in(L, index);
  if (!lua_istable(L, -1)) {
    lua_pop(L, 1);
    return lua_pushnil(L);
  }
  lua_pushstring(L, key.c_str());
  table_field(L, -2);
  lua_remove(L, -2);
}

void peek_item(lua_State* L, int index, lua_Integer number) {
  if (lua_istable(L, index))
    lua_rawgeti(L, index, number);
  else
    lua_pushnil(L);
}

NamesIn names_in(lua_State* L, int index, bool methods, std::string_view begin) {
  index = lua_absindex(L, index);
  luaL_checkstack(L, 10, "peek");
  load_members(L, index);
  NameCollector names{begin};
  if (class_of(L, index).empty())
    table_names(L, index, methods, names);
  else
    object_names(L, index, methods, names);
  return {{names.names.begin(), names.names.end()}, names.whole};
}

std::vector<std::string> sets_of(lua_State* L, int index) {
  std::vector<std::string> names;
  const auto add = [&names](const mesh::Mesh& mesh) {
    for (const auto& [name, nodes] : mesh.sets) names.push_back(name);
  };
  if (const auto mesh = to_object<mesh::Mesh>(L, index)) add(*mesh);
  if (const auto model = to_object<model::Model>(L, index)) add(model->mesh());
  if (const auto run = to_object<DeckRun>(L, index)) add(run->analysis->model().mesh());
  return names;
}

}  // namespace fabricsh::script
