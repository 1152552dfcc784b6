// fabric.rigid.*, model:contact, and reading both from a run.
#include <numbers>

#include "base/number.hpp"
#include "model/declaration_rows.hpp"
#include "model/model.hpp"
#include "run/bodies.hpp"
#include "script/bind/mesh.hpp"
#include "script/bind/model.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"
#include "script/values/field_rows.hpp"

namespace fabricsh::script {

using model::Rigid;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

// --- bodies

Vec3 vector_of(const Fields& given, const char* name) {
  return read_vector(given.numbers(name), std::string("field '") + name + "'");
}

// A free body far lighter than air or heavier than metals has most often a wrong unit.
void ask_about_mass(const Call& call, const Rigid& body) {
  constexpr double least = 1, most = 3e4;  // kg/m3
  if (!body.free()) return;
  const contact::Mass m = body.weigh();
  const double density = m.mass / m.volume;
  if (density >= least && density <= most) return;
  call.session().warn(
      "units", position(call.L()) + last_word(call.entry().name) +
                   ": field 'mass': " + fabricsh::number(m.mass) + " kg in " + fabricsh::number(m.volume, 3) +
                   " m^3 is " + fabricsh::number(density, 3) +
                   " kg/m^3, far from what bodies are: is it in kg, and the size in m? (write "
                   "30*g, 30*mm)");
}

// Makes a body from a shape, with the fields that all shapes share.
int make(const Call& call, model::RigidShape shape) {
  std::optional<double> mass;
  const auto& rows = call.entry().arguments;
  const bool weighs =
      std::any_of(rows.begin(), rows.end(), [](const Argument& row) { return row.name == "mass"; });
  if (weighs && call.has("mass")) mass = call.number("mass");
  const std::string name = call.has("name") ? call.text("name") : "";
  auto body = std::make_shared<const Rigid>(std::move(shape), mass, name, last_word(call.entry().name));
  ask_about_mass(call, *body);
  return push_object(call.L(), std::move(body));
}

int sphere(Call& call) { return make(call, model::Sphere{call.number("radius"), vector_of(call, "centre")}); }
int plane(Call& call) {
  return make(call, model::Plane{vector_of(call, "point"), vector_of(call, "normal")});
}
int cylinder(Call& call) {
  return make(call, model::Cylinder{call.number("radius"), vector_of(call, "from"), vector_of(call, "to")});
}
int disc(Call& call) {
  return make(call, model::Disc{call.number("radius"), vector_of(call, "centre"), vector_of(call, "normal"),
                                call.number("edge")});
}

// What was mended of a surface is told to those who do not want quiet.
std::vector<model::Facets> facets_of(const Call& call, const model::Shapes& shapes) {
  model::Mended mended;
  auto facets = model::facets_of(shapes, call.flag("closed"), &mended);
  if (const std::string words = mended.words(); !words.empty())
    call.session().notices().remark(last_word(call.entry().name) + " (" + shapes.front()->origin +
                                    "): " + words);
  return facets;
}

int surface(Call& call) {
  call.want_one_of("mesh", "file", "expected either a mesh or file=");
  const auto mesh = call.has("mesh") ? call.object<mesh::Mesh>("mesh")
                                     : std::make_shared<mesh::Mesh>(read_mesh_file(call, call.text("file")));
  return make(call, facets_of(call, {mesh}).front());
}

// Reads the shapes of a moving surface from files or meshes.
std::vector<model::Facets> read_shapes(const Call& call) {
  call.want_one_of("files", "meshes", "expected either files or meshes={...}");
  const char* const field = call.has("files") ? "files" : "meshes";
  lua_State* L = call.L();
  model::Shapes meshes;
  call.each(field, [&](lua_Integer i) {
    auto mesh = call.has("files") && lua_type(L, -1) == LUA_TSTRING
                    ? std::make_shared<mesh::Mesh>(read_mesh_file(call, lua_tostring(L, -1)))
                    : to_object<mesh::Mesh>(L, -1);
    if (mesh == nullptr)
      call.refuse(field, "expected a list of " + std::string(call.has("files") ? "file names" : "meshes") +
                             ", got " + describe(L, -1) + " at place " + std::to_string(i));
    meshes.push_back(std::move(mesh));
  });
  if (meshes.empty()) call.refuse(field, "expected at least one shape, got an empty table");
  const std::string wanted = "expected the same facets in every shape, got ";
  for (std::size_t i = 1; i < meshes.size(); ++i)
    if (meshes[i]->nodes.size() != meshes[0]->nodes.size())
      call.refuse(field, wanted + std::to_string(meshes[i]->nodes.size()) + " vertices in shape " +
                             std::to_string(i + 1) + " and " + std::to_string(meshes[0]->nodes.size()) +
                             " in the first");
  for (std::size_t i = 1; i < meshes.size(); ++i)
    if (meshes[i]->elements != meshes[0]->elements)
      call.refuse(field, wanted + "others in shape " + std::to_string(i + 1));
  return facets_of(call, meshes);
}

int motion(Call& call) {
  model::MovingFacets moving;
  const auto shapes = read_shapes(call);
  moving.first = shapes.front();
  moving.times = call.numbers("times");
  for (const auto& shape : shapes) moving.shapes.push_back(shape.vertices);
  return make(call, std::move(moving));
}

int body_text(lua_State* L) {
  const auto body = to_object<const Rigid>(L, 1);
  return push_text(L, "<" + (body->name().empty() ? "" : body->name() + ": ") + body->describe() + ">");
}

// --- contact

model::Party party_at(const Call& call, lua_State* L, const char* field, lua_Integer place) {
  if (lua_type(L, -1) == LUA_TSTRING) return {lua_tostring(L, -1), nullptr};
  if (auto body = to_object<const Rigid>(L, -1)) return {"", std::move(body)};
  call.refuse(field, "expected a rigid body or the name of a set, got " + describe(L, -1) +
                         (place > 0 ? " at place " + std::to_string(place) : ""));
}

void read_friction(const Call& call, model::ContactGiven& given) {
  if (!call.has("friction") || call.is("friction", LUA_TNUMBER)) {
    given.friction = call.number("friction");
    return;
  }
  const Fields both = call.fields("friction");
  const auto two = [&](const char* first, const char* second) {
    if (both.has(first) != both.has(second))
      call.refuse("friction", std::string("expected ") + first + " and " + second + ", got only " +
                                  (both.has(first) ? first : second));
    return both.has(first);
  };
  const bool by_speed = two("static", "kinetic"), by_direction = two("warp", "weft");
  if (by_speed == by_direction)
    call.refuse("friction", std::string("expected either static and kinetic or warp and weft, got ") +
                                (by_speed ? "both" : "neither"));
  given.friction = both.number(by_speed ? "kinetic" : "warp");
  (by_speed ? given.sticking : given.across) = both.number(by_speed ? "static" : "weft");
  lua_pop(call.L(), 1);
}

Argument friction_row() {
  Argument row = fields_(
      "friction",
      {number_("static?", "", not_negative, "of what sticks, at least the kinetic one"),
       number_("kinetic?", "", not_negative, "of what slides"),
       number_("warp?", "", positive, "of sliding along the warp of the cloth that comes first in the model"),
       number_("weft?", "", positive, "of sliding across it")},
      "friction coefficient; or {static, kinetic}, of what sticks and of what slides; or {warp, weft}, by "
      "direction");
  row.kinds |= number;
  row.range = not_negative;
  return row.usually(1e-3, 5, "friction is a number, not per cent").or_else(0.0);
}

int contact(Call& call) {
  call.want_one_of("between", "self", "expected either between={...} or self=");
  model::ContactGiven given;
  if (call.has("self")) {
    given.between.push_back({call.text("self"), nullptr});
  } else {
    const auto count = call.each(
        "between", [&](lua_Integer i) { given.between.push_back(party_at(call, call.L(), "between", i)); });
    if (count < 2) call.refuse("between", "expected two sides or more, got " + std::to_string(count));
  }
  read_friction(call, given);
  read_rows(call, model::contact_rows(), given);
  if (call.has("film")) {
    const Fields film = call.fields("film");
    if (film.has("speed") != film.has("exponent"))
      call.refuse("film", std::string("expected speed and exponent, or none of them, got only ") +
                              (film.has("speed") ? "speed" : "exponent"));
    lua_pop(call.L(), 1);
  }
  return declare(call, std::move(given));
}

// --- reading

int body(Call& call) {
  const auto state = run::body_state(*call.self<DeckRun>()->analysis, *call.object<const Rigid>("body"));
  for (const Vec3& v : {state.place, state.velocity, Vec3(state.spin / kDegree)})
    for (int i = 0; i < 3; ++i) lua_pushnumber(call.L(), v[i]);
  return 9;
}

int gap(Call& call) {
  const auto nearest = run::nearest_pair(*call.self<DeckRun>()->analysis);
  lua_pushnumber(call.L(), nearest.gap);
  if (nearest.words.empty()) return 1;
  lua_pushlstring(call.L(), nearest.words.data(), nearest.words.size());
  return 2;
}

void set_places(lua_State* L, const std::vector<Vec3>& places) {
  for (int c = 0; c < 3; ++c) {
    push_list(L, places, [&](const Vec3& place) { lua_pushnumber(L, place[c]); });
    lua_setfield(L, -2, std::string(1, "xyz"[c]).c_str());
  }
}

int on_body(Call& call) {
  const auto skin = run::on_skin(*call.self<DeckRun>()->analysis, *call.object<const Rigid>("body"));
  lua_State* L = call.L();
  lua_newtable(L);
  set_places(L, skin.at);
  put(L, "pressure", skin.pressure, "area", skin.area);
  lua_newtable(L);
  set_places(L, skin.place);
  put(L, "node", skin.node);
  lua_setfield(L, -2, "touch");
  return 1;
}

// --- rows

Argument place_row(const char* name, const char* sentence) {
  Argument row = value_(name, numbers, std::string("{x, y, z}: ") + sentence, "m");
  return row;
}
Argument direction_row(const char* sentence) {
  return value_("normal", numbers, std::string("{x, y, z}: ") + sentence);
}
Argument radius_row(const char* sentence) {
  return number_("radius", "m", positive, sentence).usually(1e-5, 10, "is it in m? (write 30*mm)");
}
Argument mass_row() {
  return number_("mass?", "kg", positive, "with it the body moves freely under contact and gravity");
}
Argument name_row() { return value_("name?", text, "for messages and files; default the shape's"); }

std::vector<Entry> body_rows() {
  return {
      {"fabric.rigid.sphere{}",
       {radius_row("of the ball"), place_row("centre", "at time 0"), mass_row(), name_row()},
       "A rigid ball that cloth may touch: fixed, moved (m:move), or free, with a mass.",
       "local ball = fabric.rigid.sphere{ radius=0.03, centre={0.1, 0.1, 0.031}, mass=0.1 }",
       sphere},
      {"fabric.rigid.plane{}",
       {place_row("point", "of the plane"), direction_row("out of the solid, towards the cloth"), name_row()},
       "A rigid plane: all that lies behind it is solid.",
       "local floor = fabric.rigid.plane{ point={0, 0, -0.1}, normal={0, 0, 1} }",
       plane},
      {"fabric.rigid.cylinder{}",
       {radius_row("of the rod"), place_row("from", "one end of its axis"), place_row("to", "the other end"),
        mass_row(), name_row()},
       "A rigid rod, whose ends are round.",
       "local rod = fabric.rigid.cylinder{ radius=0.01, from={-0.1, 0, 0}, to={0.1, 0, 0} }",
       cylinder},
      {"fabric.rigid.disc{}",
       {radius_row("over all"), place_row("centre", "of the disc"), direction_row("of its faces"),
        number_("edge", "m", positive, "radius of its rounded edge: half of its thickness"), mass_row(),
        name_row()},
       "A rigid flat disc with a rounded edge, such as the pedestal of a drape tester.",
       "local support = fabric.rigid.disc{ radius=0.09, centre={0, 0, -0.003}, normal={0, 0, 1}, "
       "edge=0.002 }",
       disc},
      {"fabric.rigid.surface{}",
       {object_("mesh?", "mesh", "its facets, counter-clockwise from outside"),
        value_("file?", text, "a mesh file in its place"),
        flag_("closed", "the surface bounds a solid; a hole in it is an error"), mass_row(), name_row()},
       "A rigid surface of triangles, each counted once; quadrilaterals are cut along their shorter "
       "diagonal, vertices of free edges at one place are one, what looks inwards of a closed one is turned.",
       "local ridge = fabric.rigid.surface{ mesh=fabric.mesh.rectangle{ width=0.1, height=0.1, nx=2, "
       "ny=2 } }",
       surface},
      {"fabric.rigid.motion{}",
       {value_("files?", table, "{ 'file', ... }: mesh files with the same facets at other places"),
        value_("meshes?", table, "{ mesh, ... }: in their place"),
        value_("times", numbers, "at which it has these shapes, ascending", "s"),
        flag_("closed",
              "the surface bounds a solid in every shape; a hole in it is an error, and cloth may not start "
              "inside"),
        name_row()},
       "A rigid surface that moves from shape to shape, each vertex in straight lines; before the first time "
       "and after the last it is at rest. Friction acts with the speed of the surface where it touches.",
       "local function at(z) return fabric.mesh.rectangle{ width=0.1, height=0.1, nx=2, ny=2 "
       "}:map(function(x, y) return x, y, z end) end\n"
       "local press = fabric.rigid.motion{ meshes={ at(0.01), at(0.005) }, times={0, 1} }",
       motion},
  };
}

std::vector<Entry> contact_model_rows() {
  std::vector<Argument> rows{
      value_("between?", table, "{ body or set, ... }: every two of them touch (\"all\": the whole cloth)"),
      value_("self?", text, "a set whose cloth touches itself"), friction_row()};
  for (Argument& row : arguments_of(model::contact_rows())) rows.push_back(std::move(row));
  return {
      {"model:contact{}", rows,
       "Lets surfaces touch: cloth on rigid bodies, on other cloth, on itself. Nothing passes through.",
       sample_model() + "local floor = fabric.rigid.plane{ point={0, 0, -0.001}, normal={0, 0, 1} }\n"
                        "m:contact{ between={floor, 'all'}, friction=0.3 }:contact{ self='all' }",
       contact},
  };
}

std::vector<Entry> run_rows() {
  const std::string falls = sample_model() +
                            "local floor = fabric.rigid.plane{ point={0, 0, -0.001}, normal={0, 0, 1} }\n"
                            "m:contact{ between={floor, 'all'} }:gravity{0, 0, -9.81}\n"
                            "local a = fabric.dynamic{ model=m, duration=1e-4 }\n";
  return {
      {"analysis:body()",
       {object_("body", "body", "that touches something in the model")},
       "Where a rigid body is and how it moves: nine numbers, x y z of its centre (m), its velocity (m/s), "
       "its spin (degrees/s); a moved body's by differences of its histories.",
       falls + "local x, y, z = a:solve():body(floor)\nassert(z == -0.001)",
       body},
      {"analysis:on_body()",
       {object_("body", "body", "of facets (surface, motion, limb, torso), that touches cloth in the model")},
       "The load of the cloth on a rigid surface: of each vertex x, y, z (m, where it is), area (m2, a third "
       "of the facets around it, as they are) and pressure (Pa, without friction); and touch, whose lists "
       "node, x, y, z are the nodes of the cloth that touch the surface, and where on it, m, in its shape at "
       "time 0.",
       sample_model() +
           "local face = fabric.mesh.rectangle{ width=0.4, height=0.4, nx=8, ny=8, origin={-0.1, -0.1, 0} }\n"
           "local slab = fabric.rigid.surface{ mesh=face:map(function(x, y) return x, y, -0.0002 end) }\n"
           "m:contact{ between={slab, 'all'} }:gravity{0, 0, -9.81}\n"
           "local a = fabric.dynamic{ model=m, duration=0.05, damping={ mass=300 } }:solve()\n"
           "local on, weight = a:on_body(slab), 0\n"
           "for i, p in ipairs(on.pressure) do weight = weight + p*on.area[i] end\n"
           "assert(weight > 0 and #on.touch.node > 0)",
       on_body},
      without_arguments(
          "analysis:gap",
          "Smallest distance of surfaces that may touch, less the smallest distance that contact allows, m, "
          "and which surfaces these are; where none are near: the reach of contact, and nil.",
          falls + "assert(a:solve():gap() > 0)", gap),
  };
}

}  // namespace

void bind_contact(Session& session) {
  install(session, body_rows());
  install(session, contact_model_rows());
  install(session, run_rows());
  set_meta(session, "body", "__tostring", body_text);
}

}  // namespace fabricsh::script
