// Objects of the core in Lua: a userdata with a shared_ptr. Class names are those in the rows of the
// registry.
#pragma once
#include <lua.hpp>
#include <memory>
#include <new>
#include <string>

namespace fabricsh::script {

// To be specialised for each type: static constexpr const char* name.
template <class T>
struct ClassName;

// The registry key of a class's metatable is this prefix with the name of the class.
inline std::string class_key(const std::string& name) { return "fabricsh." + name; }

// Pushes the metatable of the class, which is created if it is new.
void push_class(lua_State* L, const std::string& name, lua_CFunction gc);

// A finaliser of the deck may still have an object that has been collected; its metatable is removed, so that
// no call accepts it.
template <class T>
int collect(lua_State* L) {
  static_cast<std::shared_ptr<T>*>(lua_touserdata(L, 1))->~shared_ptr();
  lua_pushnil(L);
  lua_setmetatable(L, 1);
  return 0;
}

// Returns 1, as a function with this one result.
template <class T>
int push_object(lua_State* L, std::shared_ptr<T> value) {
  void* memory = lua_newuserdatauv(L, sizeof(std::shared_ptr<T>), 1);
  new (memory) std::shared_ptr<T>(std::move(value));
  push_class(L, ClassName<T>::name, collect<T>);
  lua_setmetatable(L, -2);
  return 1;
}

// The object at index, or null if it is something else.
template <class T>
std::shared_ptr<T> to_object(lua_State* L, int index) {
  void* memory = luaL_testudata(L, index, class_key(ClassName<T>::name).c_str());
  return memory == nullptr ? nullptr : *static_cast<std::shared_ptr<T>*>(memory);
}

}  // namespace fabricsh::script
