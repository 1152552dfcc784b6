#include "script/call/push.hpp"

#include "script/call/boundary.hpp"
#include "script/call/object.hpp"

namespace fabricsh::script {

int push_numbers(lua_State* L, const std::vector<double>& values) {
  lua_createtable(L, static_cast<int>(values.size()), 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    lua_pushnumber(L, values[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
  return 1;
}

int push_texts(lua_State* L, const std::vector<std::string>& texts) {
  lua_createtable(L, static_cast<int>(texts.size()), 0);
  lua_Integer place = 0;
  for (const std::string& one : texts) {
    lua_pushlstring(L, one.data(), one.size());
    lua_rawseti(L, -2, ++place);
  }
  return 1;
}

int push_ids(lua_State* L, const std::vector<mesh::Index>& ids) {
  lua_createtable(L, static_cast<int>(ids.size()), 0);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    lua_pushinteger(L, ids[i] + 1);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
  return 1;
}

int push_text(lua_State* L, const std::string& text) {
  lua_pushlstring(L, text.data(), text.size());
  return 1;
}

int report_text(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_getfield(L, 1, "text");
  return 1;
}

void set_text_of(lua_State* L, const char* name, lua_CFunction text) {
  if (luaL_newmetatable(L, name) != 0) {
    put(L, "__tostring", *text, "__metatable", false);
  }
  lua_setmetatable(L, -2);
}

int push_raw(lua_State* L, int index, const std::string& name) {
  index = lua_absindex(L, index);
  lua_pushlstring(L, name.data(), name.size());
  return lua_rawget(L, index);
}

void copy_entries(lua_State* L, int index) {
  index = lua_absindex(L, index);
  luaL_checkstack(L, 6, "fields");
  lua_newtable(L);
  for (lua_pushnil(L); lua_next(L, index) != 0;) {
    lua_pushvalue(L, -2);
    lua_insert(L, -2);
    lua_rawset(L, -4);
  }
}

std::string raw_text(lua_State* L, int index, const char* name) {
  std::string words;
  if (push_raw(L, index, name) == LUA_TSTRING) words = lua_tostring(L, -1);
  lua_pop(L, 1);
  return words;
}

void set_meta(Session& session, const std::string& cls, const char* name, lua_CFunction f) {
  lua_State* L = session.lua();
  push_class(L, cls, nullptr);
  put(L, name, *f);
  lua_pop(L, 1);
}

}  // namespace fabricsh::script
