// Creases of a model: lines along which a sheet rests at an angle.
#include "model/declaration_rows.hpp"
#include "script/bind/model.hpp"
#include "script/bind/rooms.hpp"
#include "script/values/field_rows.hpp"

namespace fabricsh::script {

namespace {

int crease(Call& call) {
  model::CreaseGiven given;
  std::tie(given.set, given.line) = read_set_or_line(call);
  read_rows(call, model::crease_rows(), given);
  return declare(call, std::move(given));
}

std::vector<Entry> creases_entries() {
  const auto rows = arguments_of(model::crease_rows());
  return {
      {"model:crease{}",
       {value_("line?", table,
               "{ {x, y, z}, ... }: through points of the stress-free shape, in m, along edges of its mesh"),
        value_("set?", text, "the nodes of a line of edges, in place of the line"), rows[0], rows[1]},
       "Makes a crease: a line along which the sheet is at rest at an angle. The elements beside it are as "
       "stiff as elsewhere. Creases that all have a stiffness may cross.",
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
