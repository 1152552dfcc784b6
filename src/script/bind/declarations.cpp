// model:declared: the declarations of a model as data, for programs that read it; model:list has them in
// words.
#include <numbers>

#include "model/model.hpp"
#include "script/bind/model.hpp"
#include "script/bind/rooms.hpp"

namespace fabricsh::script {

using model::Model;

namespace {

constexpr const char* axes[] = {"x", "y", "z"};

void push_vector_of(lua_State* L, const Vec3& v) { push_numbers(L, {v[0], v[1], v[2]}); }

// Adds rows to the list on top of the stack; the row under way is above it.
class Rows {
 public:
  explicit Rows(lua_State* L) : L_(L) { lua_newtable(L_); }
  Rows& row(const std::string& kind, const std::string& set) {
    close();
    lua_newtable(L_);
    open_ = true;
    set_text(L_, "kind", kind);
    set_text(L_, "set", set);
    return *this;
  }
  void close() {
    if (open_) lua_rawseti(L_, -2, ++count_);
    open_ = false;
  }
  Rows& text(const char* name, const std::string& value) {
    if (!value.empty()) set_text(L_, name, value);
    return *this;
  }
  Rows& number(const char* name, double value) {
    set_number(L_, name, value);
    return *this;
  }
  Rows& number(const char* name, const std::optional<double>& value) {
    return value ? number(name, *value) : *this;
  }
  Rows& flag(const char* name, bool value) {
    lua_pushboolean(L_, value ? 1 : 0);
    lua_setfield(L_, -2, name);
    return *this;
  }
  Rows& flag(const char* name, const std::optional<bool>& value) {
    return value ? flag(name, *value) : *this;
  }
  Rows& vector(const char* name, const Vec3& v) {
    push_vector_of(L_, v);
    lua_setfield(L_, -2, name);
    return *this;
  }
  Rows& vector(const char* name, const std::optional<Vec3>& v) { return v ? vector(name, *v) : *this; }
  Rows& history(const char* name, const model::History& h) {
    push_object(L_, std::make_shared<model::History>(h));
    lua_setfield(L_, -2, name);
    return *this;
  }
  Rows& components(const std::array<std::optional<model::History>, 3>& given) {
    for (std::size_t i = 0; i < 3; ++i)
      if (given[i]) history(axes[i], *given[i]);
    return *this;
  }
  Rows& texts(const char* name, const std::vector<std::string>& values) {
    lua_newtable(L_);
    for (std::size_t i = 0; i < values.size(); ++i) {
      lua_pushlstring(L_, values[i].data(), values[i].size());
      lua_rawseti(L_, -2, static_cast<lua_Integer>(i) + 1);
    }
    lua_setfield(L_, -2, name);
    return *this;
  }
  Rows& frame(const Mat3& frame) {
    if (frame.isApprox(model::global_frame())) return *this;
    lua_createtable(L_, 2, 0);
    for (int i = 0; i < 2; ++i) {
      push_vector_of(L_, Vec3(frame.row(i).transpose()));
      lua_rawseti(L_, -2, i + 1);
    }
    lua_setfield(L_, -2, "frame");
    return *this;
  }

 private:
  lua_State* L_;
  lua_Integer count_ = 0;
  bool open_ = false;
};

std::vector<std::string> held(const model::FixedFreedoms& freedoms) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < 3; ++i)
    if (freedoms.translation[i]) words.emplace_back(axes[i]);
  for (std::size_t i = 0; i < 3; ++i)
    if (freedoms.axis[i]) words.push_back(std::string("r") + axes[i]);
  if (freedoms.rotation) words.emplace_back("rotation");
  return words;
}

Vec3 warp_of(const Model& m, mesh::Index e) {
  const auto& nodes = m.mesh().elements[static_cast<std::size_t>(e)];
  const bool quad = nodes[3] >= 0;
  const auto X = [&](int i) { return m.rest_corner(e, i); };
  Vec3 centre = X(0) + X(1) + X(2);
  if (quad) centre += X(3);
  const Vec3 normal = quad ? (X(2) - X(0)).cross(X(3) - X(1)) : (X(1) - X(0)).cross(X(2) - X(0));
  return m.warp_at(e, centre / (quad ? 4 : 3), normal.normalized()).normalized();
}

// The direction of the warp, if it is the same everywhere in the region.
std::optional<Vec3> warp_of_region(const Model& m, int region) {
  std::optional<Vec3> common;
  for (std::size_t e = 0; e < m.mesh().elements.size(); ++e) {
    if (m.region_of(static_cast<mesh::Index>(e)) != region) continue;
    const Vec3 here = warp_of(m, static_cast<mesh::Index>(e));
    if (common && !((here - *common).norm() < 1e-9)) return {};
    if (!common) common = here;
  }
  return common;
}

void add_sheets(const Model& m, Rows& rows) {
  for (std::size_t r = 0; r < m.regions().size(); ++r) {
    const auto& region = m.regions()[r];
    rows.row("sheet", region.name.empty() ? "all" : region.name)
        .text("card", region.card.name)
        .number("thickness", m.sections()[r].thickness)
        .number("points", region.options.points)
        .number("plies", static_cast<double>(region.options.plies.size()))
        .number("offset", region.options.offset)
        .flag("membrane", region.options.membrane)
        .text("rest", model::rest_text(m.bodies()[static_cast<std::size_t>(region.body)].reference))
        .vector("warp", warp_of_region(m, static_cast<int>(r)));
  }
}

// The members of a load under their names.
struct LoadRow {
  Rows& rows;
  void components(const model::Components& value, const char*) { rows.components(value); }
  void history(const char* name, const model::History& value, const char*) { rows.history(name, value); }
  void frame(const Mat3& value) { rows.frame(value); }
  void stiffness(const std::array<double, 3>& value, const char*) {
    for (std::size_t i = 0; i < 3; ++i)
      if (value[i] != 0) rows.number(axes[i], value[i]);
  }
};

// Of the loads, or of what resists.
template <bool resisting>
void tell_loads(const Model& m, Rows& rows) {
  model::each_kind(m.loads(), [&rows](const auto& all) {
    if (model::resists<typename std::decay_t<decltype(all)>::value_type> != resisting) return;
    for (const auto& load : all) {
      LoadRow row{rows.row(load.call, load.set)};
      load.tell(row);
    }
  });
}

void add_supports(const Model& m, Rows& rows) {
  for (const auto& s : m.supports()) rows.row("fix", s.set).texts("held", held(s.fixed)).frame(s.frame);
  for (const auto& s : m.motions()) rows.row("move", s.set).components(s.displacement).frame(s.frame);
  for (const auto& t : m.turns())
    rows.row("turn", t.set).history("angle", t.angle).vector("axis", t.axis).vector("centre", t.centre);
  tell_loads<true>(m, rows);
  for (const auto& z : m.zones()) rows.row("tearable", z.set).text("path", z.path);
  for (const auto& s : m.strengths())
    rows.row("strength", s.set).number("factor", s.factor).number("modulus", s.modulus);
  for (const auto& c : m.creases())
    rows.row("crease", c.set.empty() ? "a line" : c.set)
        .number("angle", c.angle)
        .number("stiffness", c.stiffness);
  for (const auto& b : m.bands())
    rows.row("band", b.set).number("stiffness", b.stiffness).number("ease", b.ease).number("over", b.over);
  for (const auto& s : m.seams())
    rows.row("seam", s.first)
        .text("partner", s.second)
        .number("over", s.over)
        .flag("reverse", s.reverse)
        .flag("hinge", s.hinge)
        .number("stiffness", s.stiffness)
        .number("strength", s.strength)
        .number("energy", s.energy);
  constexpr const char* ties[] = {"equal", "straight", "rigid", "periodic"};
  for (const auto& t : m.ties())
    rows.row("tie", t.set)
        .text("tie", ties[static_cast<int>(t.kind)])
        .text("partner", t.partner)
        .texts("held", held(t.freedoms));
}

void add_loads(const Model& m, Rows& rows) {
  tell_loads<false>(m, rows);
  for (const auto& gas : m.gases()) {
    rows.row("gas", gas->sets.front())
        .texts("sets", gas->sets)
        .number("initial", gas->initial)
        .number("mass", gas->mass)
        .number("temperature", gas->temperature)
        .number("exponent", gas->exponent)
        .number("outside", gas->outside)
        .number("vents", static_cast<double>(gas->vents.size()))
        .flag("leaks", static_cast<bool>(gas->leakage));
    if (gas->inflow) rows.history("inflow", *gas->inflow);
  }
  const auto& g = m.gravity();
  if (g[0] || g[1] || g[2]) rows.row("gravity", "all").components(g);
  for (const auto& v : m.velocities()) {
    rows.row("velocity", v.set).flag("by_place", static_cast<bool>(v.place));
    if (!v.place)
      rows.vector("linear", v.linear)
          .vector("spin", Vec3(v.spin * 180 / std::numbers::pi))
          .vector("centre", v.centre);
  }
}

void add_contacts(const Model& m, Rows& rows) {
  const auto& given = m.interactions();
  for (const auto& motion : given.motions()) {
    rows.row("move", given.name_of(*motion.body)).flag("body", true).components(motion.displacement);
    if (motion.turn)
      rows.history("angle", motion.turn->angle)
          .vector("axis", motion.turn->axis)
          .vector("centre", motion.turn->centre);
  }
  for (const auto& load : given.loads())
    rows.row(load.moment ? "moment" : "force", given.name_of(*load.body))
        .flag("body", true)
        .components(load.total);
  for (const auto& s : given.springs()) {
    rows.row(s.damper ? "damper" : "spring", given.name_of(*s.body)).flag("body", true);
    for (int i = 0; i < 3; ++i)
      if (s.stiffness[i] != 0) rows.number(axes[i], s.stiffness[i]);
    rows.vector("slack", s.place).text("to", s.to ? given.name_of(*s.to) : "");
  }
  for (const auto& s : given.supports())
    rows.row("fix", given.name_of(*s.body)).flag("body", true).texts("held", held({s.moves, s.turns, false}));
  for (const auto& v : given.velocities())
    rows.row("velocity", given.name_of(*v.body))
        .flag("body", true)
        .vector("linear", v.linear)
        .vector("spin", Vec3(v.spin * 180 / std::numbers::pi));
  for (const auto& c : given.contacts()) {
    std::vector<std::string> sides;
    for (const auto& party : c.between) sides.push_back(party.body ? given.name_of(*party.body) : party.set);
    rows.row("contact", sides.front())
        .texts("between", sides)
        .number("friction", c.friction)
        .number("static_friction", c.sticking)
        .number("weft_friction", c.across)
        .number("film_viscosity", c.viscosity)
        .number("film_thickness", c.film)
        .number("film_speed", c.film_speed > 0 ? std::optional(c.film_speed) : std::nullopt)
        .number("film_exponent", c.film_speed > 0 ? std::optional(c.film_exponent) : std::nullopt)
        .number("thickness", c.thickness)
        .number("stiffness", c.stiffness)
        .number("restitution", c.restitution)
        .number("settle", c.settle);
  }
}

int declared(Call& call) {
  const auto model = call.self<Model>();
  luaL_checkstack(call.L(), 12, "declared");
  Rows rows(call.L());
  add_sheets(*model, rows);
  add_supports(*model, rows);
  add_loads(*model, rows);
  add_contacts(*model, rows);
  rows.close();
  return 1;
}

}  // namespace

void bind_declarations(Session& session) {
  install(session,
          {{"model:declared",
            Style::positional,
            {},
            "What it was told, as data: rows of kind (sheet, or the call's name) and set, with the numbers, "
            "vectors and "
            "histories of the call under their names, in SI units and degrees; freedoms as the list `held`, "
            "axes of "
            "their own as `frame`. model:list says the same in words.",
            sample_model() +
                "m:fix('bottom', 'x y z'):move('top', { y=fabric.history{ {0, 0}, {1, 0.01}, {2, 0} } })\n"
                "local rows = m:declared()\nassert(rows[1].kind == 'sheet' and rows[1].warp[2] == 1)\n"
                "assert(rows[2].held[3] == 'z' and rows[3].y:points()[2][2] == 0.01)",
            declared}});
}

}  // namespace fabricsh::script
