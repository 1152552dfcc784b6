// Lua's collector sees of a mesh, a model or a run only a handle of some bytes, and would leave gigabytes of
// objects that no variable holds any more.
#pragma once
#include <cstddef>
#include <functional>
#include <lua.hpp>
#include <string>

namespace fabricsh::script {

class Collector {
 public:
  // Collects all garbage if the memory in use has grown enough since the last time, unless the deck has
  // stopped the collector.
  void look(lua_State* L);
  // Executes the work; if its memory does not suffice, collects all garbage and executes it once more.
  static void with_room(lua_State* L, const std::function<void()>& work);

 private:
  std::size_t least_ = 0;  // bytes in use after the last collection, or later if that was less
};

// The message for std::bad_alloc, with the limit of the process if there is one. safe: it is that of --safe.
std::string no_memory_text(bool safe);

}  // namespace fabricsh::script
