// model:declared: the declarations of a model as data, for programs that read it; model:list has them in
// words.
#include "model/model.hpp"
#include "script/bind/model.hpp"
#include "script/bind/rooms.hpp"

namespace fabricsh::script {

using model::Model;

namespace {

constexpr const char* axes[] = {"x", "y", "z"};

void push_vector_of(lua_State* L, const Vec3& v) { push_numbers(L, {v[0], v[1], v[2]}); }

// Adds rows to the list on top of the stack; the row under way is above it.
class Rows : public model::DeclarationVisitor {
 public:
  Rows(lua_State* L, const Model& model) : L_(L), given_(model.interactions()) { lua_newtable(L_); }
  void row(const std::string& kind) {
    close();
    lua_newtable(L_);
    open_ = true;
    put(L_, "kind", kind);
  }
  void close() {
    if (open_) lua_rawseti(L_, -2, ++count_);
    open_ = false;
  }
  void set(const std::string& name, auto...) { put(L_, "set", name); }
  void set(const std::string& first, const std::string& second) {
    set(first);
    put(L_, "partner", second);
  }
  // Of nodes that the deck has given otherwise than by the name of a set: "a line".
  void place(const char* name) { set(std::string("a ") + name); }
  void sets(const std::vector<std::string>& names) {
    set(names.front());
    texts("sets", names);
  }
  void sides(const std::vector<model::Party>& all) {
    std::vector<std::string> names;
    for (const auto& party : all) names.push_back(party.body ? given_.name_of(*party.body) : party.set);
    set(names.front());
    texts("between", names);
  }
  void body(const model::RigidPointer& body) {
    set(given_.name_of(*body));
    flag("body", true);
  }
  void to(const model::RigidPointer& other) {
    if (other) put(L_, "to", given_.name_of(*other));
  }
  void text(const char* name, const std::string& value, auto...) {
    if (*name != 0 && !value.empty()) put(L_, name, value);
  }
  void number(const char* name, const std::optional<double>& value, auto...) {
    if (value) put(L_, name, *value);
  }
  void time(const char* name, const std::optional<double>& value, auto...) { number(name, value); }
  void flag(const char* name, const std::optional<bool>& value, auto...) {
    if (value) put(L_, name, *value);
  }
  void vector(const char* name, const std::optional<Vec3>& v, auto...) {
    if (!v) return;
    push_vector_of(L_, *v);
    lua_setfield(L_, -2, name);
  }
  void history(const char* name, const std::optional<model::History>& h, auto...) {
    if (!h) return;
    push_object(L_, std::make_shared<model::History>(*h));
    lua_setfield(L_, -2, name);
  }
  void components(const model::Components& given, auto...) {
    for (std::size_t i = 0; i < 3; ++i) history(axes[i], given[i]);
  }
  void stiffness(const std::array<double, 3>& value, auto...) {
    for (std::size_t i = 0; i < 3; ++i)
      if (value[i] != 0) number(axes[i], value[i]);
  }
  void freedoms(const model::FixedFreedoms& value) { texts("held", model::held_words(value)); }
  void frame(const Mat3& frame) {
    if (frame.isApprox(model::global_frame())) return;
    lua_createtable(L_, 2, 0);
    for (int i = 0; i < 2; ++i) {
      push_vector_of(L_, Vec3(frame.row(i).transpose()));
      lua_rawseti(L_, -2, i + 1);
    }
    lua_setfield(L_, -2, "frame");
  }

 private:
  void texts(const char* name, const std::vector<std::string>& values) {
    push_texts(L_, values);
    lua_setfield(L_, -2, name);
  }
  lua_State* L_;
  model::Interactions given_;
  lua_Integer count_ = 0;
  bool open_ = false;
};

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
    rows.row("sheet");
    rows.set(region.name.empty() ? "all" : region.name);
    rows.text("card", region.card.name);
    rows.number("thickness", m.sections()[r].thickness);
    rows.number("points", region.options.points);
    rows.number("plies", static_cast<double>(region.options.plies.size()));
    rows.number("offset", region.options.offset);
    rows.flag("membrane", region.options.membrane);
    rows.text("rest", model::rest_text(m.bodies()[static_cast<std::size_t>(region.body)].reference));
    rows.vector("warp", warp_of_region(m, static_cast<int>(r)));
  }
}

int declared(Call& call) {
  const auto model = call.self<Model>();
  luaL_checkstack(call.L(), 12, "declared");
  Rows rows(call.L(), *model);
  add_sheets(*model, rows);
  model->declarations().each_kind([&rows](const auto& kind) {
    for (const auto& one : kind) {
      rows.row(model::plain(one).call());
      model::tell(one, rows);
    }
  });
  rows.close();
  return 1;
}

}  // namespace

void bind_declarations(Session& session) {
  install(session,
          {without_arguments(
              "model:declared",
              "The declarations as data: rows of kind (sheet, or the call's name) and set, with the "
              "numbers, vectors and histories of the call under their names, in SI units and degrees; "
              "freedoms as the list `held`, axes of their own as `frame`. model:list says the same in words.",
              sample_model() +
                  "m:fix('bottom', 'x y z'):move('top', { y=fabric.history{ {0, 0}, {1, 0.01}, {2, 0} } })\n"
                  "local rows = m:declared()\nassert(rows[1].kind == 'sheet' and rows[1].warp[2] == 1)\n"
                  "assert(rows[2].held[3] == 'z' and rows[3].y:points()[2][2] == 0.01)",
              declared)});
}

}  // namespace fabricsh::script
