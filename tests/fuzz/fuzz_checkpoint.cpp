// The readers of a checkpoint, on any bytes. The first byte chooses: the file with its envelope; the lists
// of a state behind it, which only a checksum protects; a kept Lua table.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <lua.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/archive.hpp"
#include "format/checkpoint.hpp"
#include "script/values/lua_table.hpp"

namespace {

void read_envelope(std::string_view bytes) {
  const int file = memfd_create("checkpoint", 0);
  if (file < 0 || write(file, bytes.data(), bytes.size()) < 0) std::abort();
  try {
    fabricsh::format::read_checkpoint("/proc/self/fd/" + std::to_string(file));
  } catch (const fabricsh::Error&) {
  }
  close(file);
}

void read_lists(std::string_view bytes) {
  fabricsh::Archive archive{std::string(bytes)};
  std::string text;
  std::vector<std::string> names;
  std::vector<double> numbers;
  std::optional<std::vector<std::vector<std::int64_t>>> ids;
  bool flag = false;
  archive(text, names, numbers, ids, flag);
}

void read_table(std::string_view bytes) {
  lua_State* L = luaL_newstate();
  lua_newtable(L);
  try {
    fabricsh::script::fill_table(L, 1, std::string(bytes));
    if (fabricsh::script::pack_table(L, 1, "t").empty()) std::abort();
  } catch (const fabricsh::Error&) {
  }
  lua_close(L);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    if (data[0] % 3 == 0) read_envelope(bytes);
    if (data[0] % 3 == 1) read_lists(bytes);
    if (data[0] % 3 == 2) read_table(bytes);
  } catch (const fabricsh::Error&) {
  }
  return 0;
}
