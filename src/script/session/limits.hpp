// Limits for a deck under --safe: memory of Lua and number of Lua instructions. The limits of the process
// (app/wall.hpp) apply to C and C++.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <lua.hpp>
#include <string>

namespace fabricsh::script {

struct SafeOptions {
  std::size_t megabytes = 4096;                // of Lua; a little more for the process
  std::int64_t instructions = 10'000'000'000;  // of Lua, for all coroutines and processes together
  std::int64_t seconds = 86'400;               // of CPU time, for all threads together
};

class Limits {
 public:
  explicit Limits(const SafeOptions& options);
  ~Limits();
  Limits(const Limits&) = delete;
  Limits& operator=(const Limits&) = delete;
  // Makes the state's allocator obey the memory limit and counts instructions from now on, in every
  // coroutine: a new one inherits the hook of its creator.
  void watch(lua_State* L);
  // Restores the counting hook in L when no interrupt is pending.
  void rest_hook(lua_State* L) const;
  // Subtracts instructions in advance, because a coroutine may end before its first count.
  void charge_coroutine(lua_State* L);
  // A new allowance of instructions for the next line of a prompt.
  void renew();
  // Adds the limit to "not enough memory"; other messages are unchanged.
  std::string explained(const std::string& message) const;

 private:
  static void* allocate(void* self, void* block, std::size_t old_size, std::size_t new_size);
  static void count(lua_State* L, lua_Debug*);
  bool take();                      // subtracts one period; false: none was left
  void refuse(lua_State* L) const;  // raises the error; does not return

  static constexpr int period = 1000;  // number of instructions between two counts
  SafeOptions options_;
  std::atomic<std::int64_t>* left_;  // instructions left; shared with copies made by fork()
  std::size_t used_ = 0;             // bytes
};

}  // namespace fabricsh::script
