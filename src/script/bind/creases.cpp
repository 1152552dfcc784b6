// Creases of a model: lines along which a sheet rests at an angle.
#include "script/bind/model.hpp"
#include "script/bind/rooms.hpp"

namespace fabricsh::script {

using model::Model;

namespace {

int crease(Call& call) {
  if (call.has("set") == call.has("line"))
    call.refuse("set", "expected the name of a set, or a line, got " +
                           std::string(call.has("set") ? "both" : "neither"));
  model::CreaseGiven given;
  given.angle = call.number("angle");
  if (call.has("stiffness")) given.stiffness = call.number("stiffness");
  if (call.has("set"))
    given.set = call.text("set");
  else
    given.line = read_line(call);
  call.self<Model>()->crease(std::move(given));
  return return_self(call);
}

std::vector<Entry> creases_entries() {
  return {
      {"model:crease",
       Style::fields,
       {value_("line", table,
               "{ {x, y, z}, ... }: through points of the stress-free shape, in m, along edges of its mesh")
            .optional(),
        value_("set", text, "the nodes of a line of edges, in place of the line").optional(),
        number_("angle", "degrees", Range{-180, 180},
                "between the normals of both sides where the crease is at rest; positive where they lean "
                "towards each other, as in a valley seen from the side of the normals"),
        number_(
            "stiffness", "N/rad", Range{0, 1e6},
            "N m/rad per metre of crease: makes it a hinge, whose moment is this times the angle from rest; "
            "without it the sheet is as stiff there as elsewhere")
            .optional()},
       "Makes a crease: a line along which the sheet is at rest at an angle. The elements beside it are as "
       "stiff as elsewhere. Creases that all have a stiffness may cross.",
       "local fabric = require 'fabric'\n"
       "local mesh = fabric.mesh.rectangle{ width=0.1, height=0.05, nx=4, ny=2 }\n"
       "local m = fabric.model{ mesh=mesh, card=fabric.card 'blend', warp=90 }\n"
       "m:crease{ line={ {0.05, 0, 0}, {0.05, 0.05, 0} }, angle=90 }\n"
       "assert(m:list()[1].kind == 'crease')",
       crease},
  };
}

}  // namespace

void bind_creases(Session& session) { install(session, creases_entries()); }

}  // namespace fabricsh::script
