#include "repl/libraries.hpp"

#include <histedit.h>

#include <lua.hpp>

namespace fabricsh::repl {

std::vector<Library> libraries() {
  return {{"Lua", LUA_VERSION_MAJOR "." LUA_VERSION_MINOR "." LUA_VERSION_RELEASE},
          {"libedit", std::to_string(LIBEDIT_MAJOR) + "." + std::to_string(LIBEDIT_MINOR)}};
}

}  // namespace fabricsh::repl
