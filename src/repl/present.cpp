#include "repl/present.hpp"

#include <string>

#include "script/show/show.hpp"

namespace fabricsh::repl {

int present_all(lua_State* L) {
  const int count = lua_gettop(L);
  std::string out;
  for (int i = 1; i <= count; ++i) out += (i > 1 ? "\t" : "") + script::show(L, i);
  lua_pushlstring(L, out.data(), out.size());
  return 1;
}

}  // namespace fabricsh::repl
