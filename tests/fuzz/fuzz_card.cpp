// Cards as their files are read: any text is a card or an error. A card reads back from its own text,
// and its law answers or refuses. The text sees the constructors, polynomials and units; it can change
// nothing that the next one would see.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <lua.hpp>

#include "card/fields.hpp"
#include "script/open/open_session.hpp"
#include "script/values/card_rows.hpp"

namespace {

using namespace fabricsh;

constexpr char harness[] = R"(
local fabric, card_text = require "fabric", ...
local function frozen(fields)
  return setmetatable({}, { __index=fields, __newindex=function() error "not here" end, __metatable=false })
end
local units, numbers = {}, frozen { huge=math.huge, pi=math.pi }
for name, value in pairs(fabric.units) do units[name] = value end
local face = frozen { units=frozen(units), woven=fabric.woven, svk=fabric.svk, linear=fabric.linear, poly=fabric.poly }

-- The card and its text, or nothing.
local function read(text)
  local chunk = load(text, "@card.lua", "t", { require=function() return face end, math=numbers })
  if not chunk then return end
  local good, card = pcall(chunk)
  if not good then return end
  return card, card_text(card)
end

return function(text)
  local card, own = read(text)
  if not own then return end
  assert(#tostring(card) > 0)
  pcall(card.check, card)
  local again = read(own)
  assert(again == card, "a card that does not read back")
  local good, point = pcall(fabric.point, card)
  if not good then return end
  for _, strain in ipairs { 0.02, 0.3, -0.1 } do
    pcall(point.uniaxial, point, "warp", strain)
    pcall(point.uniaxial, point, "weft", strain)
  end
end
)";

int push_card_text(lua_State* L) {
  const auto card = script::to_object<card::Card>(L, 1);
  if (card == nullptr) return 0;
  lua_pushstring(L, card::lua_text(*card).c_str());
  return 1;
}

script::SessionOptions options() {
  script::SessionOptions o;
  o.safe = script::SafeOptions{256, 1'000'000, 86'400};
  o.quiet = true;
  o.threads = 1;
  o.notice = [](const std::string&) {};
  return o;
}

[[noreturn]] void give_up(lua_State* L) {
  std::fprintf(stderr, "%s\n", lua_tostring(L, -1));
  std::abort();
}

// A session with the harness as its function at index 1.
lua_State* prepare() {
  static script::OpenSession session(options());
  lua_State* L = session.lua();
  lua_settop(L, 0);
  if (luaL_loadstring(L, harness) != LUA_OK) give_up(L);
  lua_pushcfunction(L, push_card_text);
  if (lua_pcall(L, 1, 1, 0) != LUA_OK) give_up(L);
  return L;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static lua_State* const L = prepare();
  script::Session::of(L).limits()->renew();
  lua_pushvalue(L, 1);
  lua_pushlstring(L, reinterpret_cast<const char*>(data), size);
  if (lua_pcall(L, 1, 0, 0) != LUA_OK) give_up(L);
  return 0;
}
