// What acts on a model by calls of a form of their own: springs and dampers, turns, velocities, symmetry.
#include <numbers>

#include "base/number.hpp"
#include "model/model.hpp"
#include "script/bind/model.hpp"
#include "script/bind/rooms.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"

namespace fabricsh::script {

namespace {

std::array<double, 3> read_stiffness(const Call& call, const char* field) {
  const Fields given = call.fields(field);
  std::array<double, 3> k{};
  const char* const axes[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i)
    if (given.has(axes[i])) k[i] = given.number(axes[i]);
  return k;
}

// A spring or damper of a rigid body, to the ground, a place or another body.
int tie_body(Call& call, const char* field, bool damper) {
  const auto k = read_stiffness(call, field);
  model::BodySpring spring{call.object<const model::Rigid>("set"), {k[0], k[1], k[2]}, damper, {}, {}};
  if (call.has("options")) {
    const Fields options = call.fields("options");
    if (options.has("frame"))
      options.refuse("frame", "a rigid body is tied along global axes: expected nothing");
    if (options.has("to")) {
      spring.to = options.object<const model::Rigid>("to");
      if (!spring.to) spring.place = read_vector(options.numbers("to"), "field 'options.to'");
      if (damper && spring.place)
        options.refuse("to", "a damper has no place at which it is slack: expected a rigid body");
    }
  }
  return declare(call, std::move(spring));
}

int damper(Call& call) { return tie_body(call, "rate", true); }

int spring(Call& call) {
  if (call.object<const model::Rigid>("set")) return tie_body(call, "stiffness", false);
  if (call.has("options") && call.fields("options").has("to"))
    throw Error("spring: field 'options.to': expected a rigid body as what is tied, got the set '" +
                call.text("set") + "', whose springs go to the ground");
  const std::array<double, 3> k = read_stiffness(call, "stiffness");
  if (k[0] + k[1] + k[2] == 0) throw Error("spring: expected at least one of x, y, z above 0, got none");
  return declare(call, model::GroundSpring{call.text("set"), k, read_frame(call)});
}

int turn_set(Call& call) {
  const Fields given = call.fields("motion");
  const Vec3 axis = read_vector(given.numbers("axis"), "turn: field 'axis'");
  std::optional<Vec3> centre;
  if (given.has("centre")) centre = read_vector(given.numbers("centre"), "turn: field 'centre'");
  given.push("angle");
  model::History angle =
      read_history(call.session(), call.L(), -1, "turn '" + call.text("set") + "': field 'angle'");
  lua_pop(call.L(), 1);
  return declare(call, model::PrescribedTurn{call.text("set"), axis, std::move(angle), centre});
}

// The fields of a velocity, both in the call and in the result of a function of position.
const std::vector<Argument>& velocity_rows() {
  static const std::vector<Argument> rows{
      number_("x?", "m/s", everything, "along x"), number_("y?", "m/s", everything, "along y"),
      number_("z?", "m/s", everything, "along z"),
      value_("spin?", numbers, "{wx, wy, wz}, degrees/s: in addition, a rigid rotation"),
      value_("centre?", numbers, "{x, y, z}, m: a point of its axis; default {0, 0, 0}")};
  return rows;
}

model::RigidVelocity read_velocity(const Fields& given, const std::string& what) {
  model::RigidVelocity v;
  const char* const axes[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i)
    if (given.has(axes[i])) v.linear[i] = given.number(axes[i]);
  if (given.has("spin"))
    v.spin = std::numbers::pi / 180 * read_vector(given.numbers("spin"), what + "field 'spin'");
  if (given.has("centre")) {
    if (!given.has("spin")) given.refuse("centre", "expected a spin about it too, got none");
    v.centre = read_vector(given.numbers("centre"), what + "field 'centre'");
  }
  return v;
}

// That of the call itself.
model::RigidVelocity read_whole_velocity(const Fields& given) {
  if (!given.has("x") && !given.has("y") && !given.has("z") && !given.has("spin"))
    throw Error("velocity: expected at least one of x, y, z, spin, got none");
  return read_velocity(given, "velocity: ");
}

// Calls the function of position for a node.
model::RigidVelocity velocity_at(const Function& place, const std::string& set, const Vec3& X) {
  lua_State* L = place.push();
  for (int i = 0; i < 3; ++i) lua_pushnumber(L, X[i]);
  lua_call(L, 3, 1);
  const std::string what = "velocity '" + set + "': what the function returned at (" + exact_number(X.x()) +
                           ", " + exact_number(X.y()) + ", " + exact_number(X.z()) + ") m: ";
  if (!lua_istable(L, -1))
    throw Error(what + "expected a table {x, y, z, spin, centre}, got " + describe(L, -1));
  model::RigidVelocity v;
  try {
    v = read_velocity(Fields(L, -1, velocity_rows()), "");
  } catch (const Error& error) {
    throw Error(what + error.what());
  }
  lua_pop(L, 1);
  return v;
}

// Sets the initial velocity of a free body.
int velocity_of_body(Call& call) {
  if (call.is("velocity", LUA_TFUNCTION))
    call.refuse("velocity", "expected {x=, y=, z=, spin=} of a rigid body, got a function");
  const Fields given = call.fields("velocity");
  if (given.has("centre"))
    given.refuse("centre", "a rigid body spins about its centre of mass: expected nothing");
  const model::RigidVelocity v = read_whole_velocity(given);
  return declare(call, model::BodyVelocity{call.object<const model::Rigid>("set"), v.linear, v.spin});
}

int velocity(Call& call) {
  if (call.object<const model::Rigid>("set")) return velocity_of_body(call);
  model::InitialVelocity v{call.text("set")};
  if (const Function place = call.function("velocity")) {
    v.place = [place, set = v.set](const Vec3& X) { return velocity_at(place, set, X); };
  } else {
    const model::RigidVelocity all = read_whole_velocity(call.fields("velocity"));
    v.linear = all.linear;
    v.spin = all.spin;
    v.centre = all.centre;
  }
  return declare(call, std::move(v));
}

int symmetry(Call& call) {
  const std::string axis = call.text("normal");
  if (axis != "x" && axis != "y" && axis != "z")
    throw Error("symmetry: argument 'normal': expected \"x\", \"y\" or \"z\", got \"" + axis + "\"");
  return declare(call, model::symmetry(call.text("set"), axis[0] - 'x'));
}

Argument velocity_row() {
  Argument row =
      fields_("velocity", velocity_rows(), "{x=, y=, z=, spin=, centre=}, or function(x, y, z) returning it");
  row.kinds |= function;
  return row;
}

Argument axis_rows(const char* name, const char* unit, const char* sentence) {
  return fields_(name,
                 {number_("x?", unit, not_negative, "along x"), number_("y?", unit, not_negative, "along y"),
                  number_("z?", unit, not_negative, "along z")},
                 sentence);
}

// The other end of a spring or damper of a rigid body.
Argument far_end_row(const char* sentence, bool frame) {
  Argument to = object_("to?", "body", sentence, numbers);
  std::vector<Argument> rows;
  if (frame) rows = frame_row().rows;
  rows.push_back(std::move(to));
  return fields_("options?", std::move(rows),
                 frame ? "frame = {e1, e2} for x and y that are not those of space, e2 is made normal to e1; "
                         "to = where a body's spring ends"
                       : "to = where it ends");
}

Argument loaded_set_row() { return value_("set", text, "name of a node set"); }

std::vector<Entry> loads_entries() {
  const std::string sample = sample_model();
  return {
      {"model:spring()",
       {set_or_body_row(),
        axis_rows("stiffness", "N/m",
                  "{x=, y=, z=}: the total stiffness to ground, shared by length or area"),
        far_end_row("of a rigid body: another body, or {x, y, z}, m, where its centre is when the spring is "
                    "slack; default where it begins",
                    true)},
       "Ties a node set to its reference position by springs; or the centre of a rigid body to the ground or "
       "to another body.",
       sample + "m:spring('top', { x=1000 })",
       spring},
      {"model:damper()",
       {object_("set", "body", "the rigid body"), axis_rows("rate", "N s/m", "{x=, y=, z=}: force per speed"),
        far_end_row("another body, whose speed is subtracted; default the ground", false)},
       "Resists the speed of a rigid body's centre; what it takes is in a.energy.damping.",
       sample + "local plate = fabric.rigid.disc{ radius=0.05, centre={0, 0, 0.01}, normal={0, 0, 1}, "
                "edge=0.002, mass=1 }\n"
                "m:contact{ between={plate, 'all'} }:fix(plate, 'x y rotation')\n"
                "m:force(plate, { z=-100 }):damper(plate, { z=50 })",
       damper},
      {"model:turn()",
       {loaded_set_row(),
        fields_("motion",
                {value_("axis", numbers, "{x, y, z}: direction of the axis"),
                 history_("angle", "degrees", "angle about the axis"),
                 value_("centre?", numbers, "{x, y, z}, m: with it the nodes turn about this point too")},
                "{axis=, angle=, centre=}")},
       "Turns the directors of a node set rigidly, and with a centre the nodes too: a rotating grip.",
       sample + "m:turn('top', { axis={1,0,0}, angle=fabric.ramp(90, 1) })",
       turn_set},
      {"model:velocity()",
       {set_or_body_row(), velocity_row()},
       "Velocity of a node set, or of a free rigid body, at time 0, for fabric.dynamic: one for all, or a "
       "function of place that returns it for each node.",
       sample + "m:velocity('all', { z=-2, spin={0, 0, 360} })\n"
                "m:velocity('top', function(x, y, z) return { z=0.1 * math.sin(x / 0.0254 * math.pi) } end)",
       velocity},
      {"model:symmetry()",
       {loaded_set_row(), value_("normal", text, "\"x\", \"y\" or \"z\": normal of the plane")},
       "Holds a node set in a plane of symmetry: the displacement along the normal and the two rotations out "
       "of the plane. The nodes lie in such a plane, and the cloth is symmetric about it: its yarns run "
       "along and across it, in each layer. A free body that the plane cuts moves in it; its mass is that of "
       "the part in the model.",
       sample + "m:symmetry('left', 'x')",
       symmetry},
  };
}

}  // namespace

void bind_loads(Session& session) {
  install(session, loads_entries());
  bind_told(session);
  bind_ties(session);
  bind_seams(session);
  bind_creases(session);
  bind_gas(session);
  bind_contact(session);
  bind_declared(session);
  bind_declarations(session);
}

}  // namespace fabricsh::script
