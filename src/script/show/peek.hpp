// Reading Lua values without running code of the user, for completion and who(): raw reads, and properties of
// the program's own objects, which are functions of the program.
#pragma once
#include <lua.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace fabricsh::script {

// While an object of this class exists, no finaliser runs.
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

// "mesh" and so on for the program's objects, empty for anything else.
std::string class_of(lua_State* L, int index);

// Pushes the value of value.key, or nil if it cannot be determined without running code.
void peek_field(lua_State* L, int index, const std::string& key);
void peek_item(lua_State* L, int index, lua_Integer number);

// Names that can follow the dot (or the colon) after the value at index, sorted: those with this beginning. A
// large table takes no time: at most ten thousand names are returned, of its first million keys.
struct NamesIn {
  std::vector<std::string> names;
  bool whole = true;  // false: there may be others
};
NamesIn names_in(lua_State* L, int index, bool methods, std::string_view begin = {});

// Names of the node sets of a mesh, a model or an analysis.
std::vector<std::string> sets_of(lua_State* L, int index);

}  // namespace fabricsh::script
