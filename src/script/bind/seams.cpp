// Seams of a model.
#include "model/declaration_rows.hpp"
#include "script/bind/model.hpp"
#include "script/bind/rooms.hpp"
#include "script/call/words.hpp"
#include "script/values/field_rows.hpp"

namespace fabricsh::script {

namespace {

// The options alone, as a table of their own on top of the stack.
void push_options(const Call& call, int given) {
  lua_State* L = call.L();
  lua_newtable(L);
  for (lua_pushnil(L); lua_next(L, given) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) == LUA_TNUMBER) {
      if (lua_isinteger(L, -2) == 0 || lua_tointeger(L, -2) < 1 || lua_tointeger(L, -2) > 2)
        call.refuse("seam", "expected two names of sets and then named fields, got a further entry");
      continue;
    }
    lua_pushvalue(L, -2);
    lua_pushvalue(L, -2);
    lua_rawset(L, -5);
  }
}

std::string read_edge(const Call& call, int given, lua_Integer i) {
  lua_State* L = call.L();
  if (lua_rawgeti(L, given, i) != LUA_TSTRING)
    call.refuse("seam", "expected the names of two sets first, { \"front.left\", \"back.left\" }, got " +
                            describe(L, -1) + " at " + std::to_string(i));
  const std::string name = lua_tostring(L, -1);
  lua_pop(L, 1);
  return name;
}

int seam(Call& call) {
  lua_State* L = call.L();
  call.push("seam");
  const int given = lua_gettop(L);
  model::Seam seam;
  seam.first = read_edge(call, given, 1);
  seam.second = read_edge(call, given, 2);
  push_options(call, given);
  const auto rows = arguments_of(model::seam_rows());
  read_rows(Fields(L, -1, rows, "seam."), model::seam_rows(), seam);
  lua_pop(L, 2);
  return declare(call, std::move(seam));
}

std::vector<Entry> seams_entries() {
  Argument given = fields_("seam", arguments_of(model::seam_rows()),
                           "{ first, second, ... }: the sets of the nodes of two edges");
  given.kinds |= table;
  return {
      {"model:seam()",
       {given},
       "Sews two edges of the cloth together: threads draw them together, then they are one. The edge with "
       "more nodes follows the other, matched by the length along each.",
       "local front = fabric.mesh.rectangle{ width=0.1, height=0.2, nx=4, ny=8 }\n"
       "local back = fabric.mesh.rectangle{ width=0.1, height=0.2, nx=4, ny=10, origin={0.11, 0, 0} }\n"
       "local card = fabric.card 'blend'\n"
       "local m = fabric.model{ bodies={ { name='front', mesh=front, card=card, warp=90 },\n"
       "  { name='back', mesh=back, card=card, warp=90 } } }\n"
       "m:seam{ 'front.right', 'back.left', over=0.1 }\n"
       "assert(m:list()[3].kind == 'seam')",
       seam},
  };
}

}  // namespace

void bind_seams(Session& session) { install(session, seams_entries()); }

}  // namespace fabricsh::script
