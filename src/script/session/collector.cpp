#include "script/session/collector.hpp"

#include <algorithm>
#include <new>

#include "system/memory.hpp"

namespace fabricsh::script {

// A quarter more, and at least 16 MB, is worth a collection, which takes milliseconds.
void Collector::look(lua_State* L) {
  const std::size_t now = system::heap_in_use();
  least_ = std::min(least_, now);
  if (now - least_ < std::max(std::size_t{16} << 20, least_ / 4) || lua_gc(L, LUA_GCISRUNNING) == 0) return;
  lua_gc(L, LUA_GCCOLLECT);
  least_ = system::heap_in_use();
}

void Collector::with_room(lua_State* L, const std::function<void()>& work) {
  const int top = lua_gettop(L);
  try {
    return work();
  } catch (const std::bad_alloc&) {
    lua_settop(L, top);
  }
  lua_gc(L, LUA_GCCOLLECT);
  work();
}

std::string no_memory_text(bool safe) {
  const system::MemoryLimit limit = system::memory_limit();
  if (limit.option.empty()) return "not enough memory";
  return "memory limit of " + std::to_string(limit.megabytes) + " MB for the whole process is reached (" +
         (safe ? "--limit-memory, and what the program itself needs)" : limit.option + ")");
}

}  // namespace fabricsh::script
