// How much a deck may use under --safe: memory of Lua and instructions of Lua. What C and C++ use is bounded
// by the limits of the process (app/wall.hpp).
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <lua.hpp>
#include <string>

namespace fabricsh::script {

struct SafeOptions {
  std::size_t megabytes = 4096;                // of Lua; of the process a little more
  std::int64_t instructions = 10'000'000'000;  // of Lua, all coroutines and processes together
  std::int64_t seconds = 86'400;               // of computing, all threads together
};

class Limits {
 public:
  explicit Limits(const SafeOptions& options);
  ~Limits();
  Limits(const Limits&) = delete;
  Limits& operator=(const Limits&) = delete;
  // Puts the state's allocator behind the memory limit and counts instructions from now on, in every
  // coroutine: a new one takes over the hook of the one that makes it.
  void watch(lua_State* L);
  // The hook as it should stand in L while nothing else is asked of it.
  void rest_hook(lua_State* L) const;
  // Takes instructions off in advance: a coroutine that ends before its first count would be free.
  void charge_coroutine(lua_State* L);
  // A new allowance of instructions, for the next line of a prompt.
  void renew();
  // "not enough memory" with the limit that is meant, any other message as it is.
  std::string explained(const std::string& message) const;

 private:
  static void* allocate(void* self, void* block, std::size_t old_size, std::size_t new_size);
  static void count(lua_State* L, lua_Debug*);
  bool take();                      // a period's instructions; false: nothing was left
  void refuse(lua_State* L) const;  // raises; does not return

  static constexpr int period = 1000;  // instructions between two counts
  SafeOptions options_;
  std::atomic<std::int64_t>* left_;  // instructions; copies made by fork() take from the same
  std::size_t used_ = 0;             // bytes
};

}  // namespace fabricsh::script
