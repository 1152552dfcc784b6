// Looking at Lua values without running anything of the user's: raw reads, and of the program's own objects
// the properties, which are functions of the program. For completion and who().
#pragma once
#include <lua.hpp>
#include <string>
#include <vector>

namespace fabricsh::script {

// As long as it lives no finaliser runs.
class NoFinalisers {
 public:
  explicit NoFinalisers(lua_State* L) : L_(L), was_running_(lua_gc(L, LUA_GCISRUNNING) != 0) {
    lua_gc(L_, LUA_GCSTOP);
  }
  ~NoFinalisers() {
    if (was_running_) lua_gc(L_, LUA_GCRESTART);
  }
  NoFinalisers(const NoFinalisers&) = delete;
  NoFinalisers& operator=(const NoFinalisers&) = delete;

 private:
  lua_State* L_;
  bool was_running_;
};

// "mesh" of the program's objects, empty of anything else.
std::string class_of(lua_State* L, int index);

// Pushes what value.key would give, nil where that can't be known without running something.
void peek_field(lua_State* L, int index, const std::string& key);
void peek_item(lua_State* L, int index, lua_Integer number);

// Names that can stand behind the dot (or the colon) of the value at index, sorted.
std::vector<std::string> names_in(lua_State* L, int index, bool methods);

// Names of the node sets of a mesh, a model or an analysis.
std::vector<std::string> sets_of(lua_State* L, int index);

}  // namespace fabricsh::script
