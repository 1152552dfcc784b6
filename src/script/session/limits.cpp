#include "script/session/limits.hpp"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace fabricsh::script {

using Counter = std::atomic<std::int64_t>;
static_assert(Counter::is_always_lock_free);  // a lock would not work across processes

Limits::Limits(const SafeOptions& options) : options_(options) {
  void* shared = mmap(nullptr, sizeof(Counter), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) throw std::bad_alloc();
  left_ = new (shared) Counter(options.instructions);
}

Limits::~Limits() { munmap(left_, sizeof(Counter)); }

void Limits::renew() { *left_ = options_.instructions; }

bool Limits::take() {
  if (left_->fetch_sub(period) > period) return true;
  *left_ = 0;
  return false;
}

// When this returns null, Lua collects all garbage and tries once more before it reports "not enough
// memory".
void* Limits::allocate(void* self, void* block, std::size_t old_size, std::size_t new_size) {
  Limits& limits = *static_cast<Limits*>(self);
  const std::size_t before = block == nullptr ? 0 : old_size;  // without a block old_size is a kind of object
  if (new_size == 0) {
    std::free(block);
    limits.used_ -= before;
    return nullptr;
  }
  const std::size_t most = limits.options_.megabytes << 20;
  if (new_size > before && (new_size - before > most || limits.used_ > most - (new_size - before)))
    return nullptr;
  void* moved = std::realloc(block, new_size);
  if (moved != nullptr) limits.used_ += new_size - before;
  return moved;
}

// When the allowance is used up, each instruction raises the error again, so that no pcall continues.
void Limits::count(lua_State* L, lua_Debug*) {
  void* limits_of_allocator = nullptr;
  lua_getallocf(L, &limits_of_allocator);
  auto& limits = *static_cast<Limits*>(limits_of_allocator);
  if (!limits.take()) limits.refuse(L);
}

void Limits::refuse(lua_State* L) const {
  lua_sethook(L, count, LUA_MASKCOUNT, 1);
  luaL_error(L, "limit of %s instructions under --safe is reached",
             std::to_string(options_.instructions).c_str());
}

void Limits::watch(lua_State* L) {
  used_ = static_cast<std::size_t>(lua_gc(L, LUA_GCCOUNT)) * 1024 +
          static_cast<std::size_t>(lua_gc(L, LUA_GCCOUNTB));
  lua_setallocf(L, allocate, this);
  rest_hook(L);
}

void Limits::rest_hook(lua_State* L) const { lua_sethook(L, count, LUA_MASKCOUNT, *left_ > 0 ? period : 1); }

void Limits::charge_coroutine(lua_State* L) {
  if (!take()) refuse(L);
}

std::string Limits::explained(const std::string& message) const {
  const std::string mark = "not enough memory";
  if (!message.ends_with(mark)) return message;
  return message.substr(0, message.size() - mark.size()) + "memory limit of " +
         std::to_string(options_.megabytes) + " MB under --safe is reached";
}

}  // namespace fabricsh::script
