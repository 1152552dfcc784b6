#include "script/sandbox/load.hpp"

#include "base/error.hpp"
#include "format/source.hpp"

namespace fabricsh::script {

namespace {

// Skips a byte-order mark and a first line that begins with '#', whose end is kept for the line numbers.
std::string_view text_of(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  if (bytes.starts_with('#')) bytes.remove_prefix(std::min(bytes.find('\n'), bytes.size()));
  return bytes;
}

}  // namespace

int load_file(lua_State* L, const std::string& path) {
  if (path.empty()) return luaL_loadfilex(L, nullptr, "t");
  std::string bytes;
  try {
    bytes = format::read_file(path);
  } catch (const Error& error) {
    lua_pushstring(L, error.what());
    return LUA_ERRFILE;
  }
  const std::string_view text = text_of(bytes);
  return luaL_loadbufferx(L, text.data(), text.size(), ("@" + path).c_str(), "t");
}

}  // namespace fabricsh::script
