// Seams of a model, and bands along its edges.
#include "script/bind/model.hpp"
#include "script/bind/rooms.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"

namespace fabricsh::script {

using model::Model;

namespace {

std::vector<Argument> options() {
  return {
      number_("over", "s", positive,
              "time in which threads draw the edges together, before they become one; without it they lie on "
              "each other and are one from the start")
          .optional(),
      number_("ease", "", {0, 0.5, false, true},
              "by what share of the longer edge the other may be shorter; the rest is spread evenly")
          .or_else(0.01),
      value_(
          "reverse", boolean,
          "whether the edges are matched from different ends, the end of an edge with the lowest number of "
          "a node being its first; default so that the ends lie nearer")
          .optional(),
      value_("hinge", boolean,
             "whether the edges can turn against each other; default where their normals are more than 60 "
             "degrees apart as they become one")
          .optional(),
      number_("stiffness", "N/m^2", positive,
              "force per metre of seam and metre of opening, of a seam that gives way; default none, the "
              "edges become one")
          .optional(),
      number_("strength", "N/m", positive, "force per metre at which the seam bursts; default never")
          .optional(),
      number_("energy", "J/m", positive, "that bursting takes, per metre; with strength").optional(),
  };
}

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
  const auto rows = options();
  const Fields fields(L, -1, rows, "seam.");
  const auto number_of = [&](const char* name) {
    return fields.has(name) ? std::optional<double>(fields.number(name)) : std::nullopt;
  };
  const auto flag_of = [&](const char* name) {
    return fields.has(name) ? std::optional<bool>(fields.flag(name)) : std::nullopt;
  };
  seam.over = number_of("over");
  seam.ease = fields.number("ease");
  seam.reverse = flag_of("reverse");
  seam.hinge = flag_of("hinge");
  seam.stiffness = number_of("stiffness");
  seam.strength = number_of("strength");
  seam.energy = number_of("energy");
  lua_pop(L, 2);
  call.self<Model>()->seam(std::move(seam));
  return return_self(call);
}

int band_of(Call& call) {
  model::EdgeBand band{call.text("set"), call.number("stiffness"), call.number("ease"), {}};
  if (call.has("over")) band.over = call.number("over");
  call.self<Model>()->band(std::move(band));
  return return_self(call);
}

std::vector<Entry> seams_entries() {
  Argument given = fields_("seam", options(), "{ first, second, ... }: the sets of the nodes of two edges");
  given.kinds |= table;
  return {
      {"model:seam",
       Style::positional,
       {given},
       "Sews two edges of the cloth together: threads draw them together, then they are one. The edge with "
       "more nodes follows the other, matched by the length along each.",
       "local fabric = require 'fabric'\n"
       "local front = fabric.mesh.rectangle{ width=0.1, height=0.2, nx=4, ny=8 }\n"
       "local back = fabric.mesh.rectangle{ width=0.1, height=0.2, nx=4, ny=10, origin={0.11, 0, 0} }\n"
       "local card = fabric.card 'blend'\n"
       "local m = fabric.model{ bodies={ { name='front', mesh=front, card=card, warp=90 },\n"
       "  { name='back', mesh=back, card=card, warp=90 } } }\n"
       "m:seam{ 'front.right', 'back.left', over=0.1 }\n"
       "assert(m:list()[3].kind == 'seam')",
       seam},
      {"model:band",
       Style::fields,
       {value_("set", text, "the nodes of an edge"),
        number_("stiffness", "N", positive, "force per strain of the band"),
        number_("ease", "", {0, 1, false, true},
                "by what share of the edge the band is shorter without force")
            .or_else(0),
        number_("over", "s", positive,
                "time in which it becomes that short; without it, it is from the start")
            .optional()},
       "Puts a band along an edge: elastic in a hem, or with a high stiffness a cord that is drawn tight. It "
       "pulls and never pushes.",
       "local fabric = require 'fabric'\n"
       "local mesh = fabric.mesh.rectangle{ width=0.1, height=0.05, nx=4, ny=2 }\n"
       "local m = fabric.model{ mesh=mesh, card=fabric.card 'blend', warp=90 }\n"
       "m:band{ set='bottom', stiffness=20, ease=0.2, over=0.1 }\n"
       "assert(m:list()[1].kind == 'band')",
       band_of},
  };
}

}  // namespace

void bind_seams(Session& session) { install(session, seams_entries()); }

}  // namespace fabricsh::script
