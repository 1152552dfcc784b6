// fabric.model{...}: the bodies of a model and their materials.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "base/number.hpp"
#include "geometry/box.hpp"
#include "law/check.hpp"
#include "mesh/check.hpp"
#include "mesh/generators.hpp"
#include "script/bind/model.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"

namespace fabricsh::script {

using model::Model;

namespace {

// Reads a direction on top of the stack: an angle or a vector.
model::Direction read_direction(lua_State* L, const std::string& what) {
  if (lua_type(L, -1) == LUA_TNUMBER) return lua_tonumber(L, -1);
  if (!lua_istable(L, -1))
    throw Error(what + ": expected an angle in degrees or {x, y, z}, got " + describe(L, -1));
  return read_vector(read_numbers(L, -1), what);
}

model::WarpField warp_function(const Function& f) {
  return [f](const Vec3& X) {
    lua_State* L = f.push();
    for (int i = 0; i < 3; ++i) lua_pushnumber(L, X[i]);
    lua_call(L, 3, 1);
    const model::Direction direction = read_direction(L, "field 'warp': what the function returned");
    lua_pop(L, 1);
    return direction;
  };
}

// An angle in degrees that is a usual one if it is taken for radians, as 1.5708 is of 90 degrees.
void question_radians(lua_State* L, const std::string& where, double angle) {
  constexpr double usual = 5, near = 1e-3, digit = 1e-9;  // degrees; of a number with one decimal
  const double degrees = angle * 180 / std::numbers::pi;
  const bool rounds = std::abs(degrees - usual * std::round(degrees / usual)) < near,
             plain = std::abs(10 * angle - std::round(10 * angle)) < digit;
  if (angle == 0 || plain || !rounds || std::abs(degrees) > 360 + near) return;
  Session::of(L).warn("units", position(L) + where + ": " + exact_number(angle) +
                                   " degrees are the radians of " +
                                   fabricsh::number(usual * std::round(degrees / usual)) +
                                   " degrees: is it an angle in degrees?");
}

void read_warp(const Fields& given, model::Options& options) {
  if (!given.has("warp")) return;
  if (const Function f = given.function("warp")) {
    options.warp = warp_function(f);
    options.warp_text = "function";
    return;
  }
  given.push("warp");
  lua_State* L = given.L();
  const model::Direction direction = read_direction(L, "field 'warp'");
  if (lua_type(L, -1) == LUA_TNUMBER) question_radians(L, "field 'warp'", lua_tonumber(L, -1));
  options.warp_text = lua_isnumber(L, -1) ? exact_number(lua_tonumber(L, -1)) + " degrees" : "vector";
  lua_pop(L, 1);
  options.warp = [direction](const Vec3&) { return direction; };
}

bool is_digits(const std::string& word) {
  return !word.empty() && word.find_first_not_of("0123456789") == word.npos;
}

// The name of a ply, which becomes a part of the names of its fields; ply1, ply2, ... are taken by their
// numbers.
std::string read_ply_name(const Fields& given, const std::vector<section::Ply>& below) {
  if (!given.has("name")) return {};
  const std::string name = given.text("name");
  if (name.empty() || name.find_first_of(". \t\n") != name.npos ||
      (name.starts_with("ply") && is_digits(name.substr(3))))
    given.refuse("name", "expected a name without blanks and full stops, other than ply1, ply2, ..., got '" +
                             name + "'");
  for (const auto& other : below)
    if (other.name == name) given.refuse("name", "expected a name of its own, got '" + name + "' twice");
  return name;
}

// Reads one entry of layers={ {card=, warp=, thickness=, name=}, ... }.
section::Ply read_ply(lua_State* L, const std::vector<Argument>& fields,
                      const std::vector<section::Ply>& below) {
  const Fields given(L, lua_gettop(L), fields, "layers[" + std::to_string(below.size() + 1) + "].");
  const auto card = given.object<card::Card>("card");
  return {*card, given.has("thickness") ? given.number("thickness") : card->thickness,
          given.has("warp") ? given.number("warp") : 0.0, read_ply_name(given, below)};
}

std::vector<Argument> layer_fields() {
  return {object_("card", "card", "the ply's fabric"),
          number_("warp?", "degrees", everything, "from the model's warp direction"),
          number_("thickness?", "m", positive, "wins over the card's"),
          value_("name?", text,
                 "for its fields: those of the ply face are face.E11, ...; default ply1, ply2, ...")};
}

void read_layers(const Fields& given, model::Options& options) {
  if (!given.has("layers")) return;
  lua_State* L = given.L();
  static const std::vector<Argument> fields = layer_fields();
  given.each("layers", [&](lua_Integer) {
    if (!lua_istable(L, -1))
      given.refuse("layers",
                   "expected a list of tables {card=, warp=, thickness=, name=}, got " + describe(L, -1));
    options.plies.push_back(read_ply(L, fields, options.plies));
  });
  if (options.plies.empty()) given.refuse("layers", "expected at least one layer, got an empty table");
}

// Refuses a card that fails its check; shows each kind of warning once, of the first of what it is of. The
// warning about bending is given by the run, in which it is known whether the sheet can leave its plane.
void check_card(Session& session, const card::Card& card) {
  const auto report = law::check(card);
  const auto kind = [](const std::string& key) { return key.substr(0, key.find('.')); };
  std::vector<std::pair<std::string, std::string>> said;  // kind, words
  for (const auto& item : report.items) {
    const std::string words = "card '" + card.name + "': " + item.key + ": " + item.text;
    if (item.severity == Severity::error) throw Error(words);
    if (item.severity != Severity::warning || item.key.starts_with("bending.")) continue;
    const auto same =
        std::find_if(said.begin(), said.end(), [&](const auto& one) { return one.first == kind(item.key); });
    if (same == said.end())
      said.emplace_back(kind(item.key), words);
    else
      same->second +=
          (same->second.find("; likewise ") == std::string::npos ? "; likewise " : ", ") + item.key;
  }
  for (const auto& one : said) session.warn("card", one.second);
}

// Card or plies, thickness, warp and points of a body or region.
struct BodyMaterial {
  card::Card card;
  model::Options options;
};

BodyMaterial read_made(const Fields& given) {
  BodyMaterial made;
  read_layers(given, made.options);
  if (made.options.plies.empty() == !given.has("card"))
    given.refuse("card", made.options.plies.empty()
                             ? "expected either a card or layers={ {card=}, ... }, got neither"
                             : "expected either a card or layers={ {card=}, ... }, got both");
  made.card =
      made.options.plies.empty() ? *given.object<card::Card>("card") : made.options.plies.front().card;
  if (given.has("thickness")) made.options.thickness = given.number("thickness");
  made.options.points = given.count("points");
  made.options.offset = given.number("offset");
  read_warp(given, made.options);
  return made;
}

void check_made(Session& session, const card::Card& card, const model::Options& options) {
  for (const auto& ply : options.plies) check_card(session, ply.card);
  if (options.plies.empty()) check_card(session, card);
}

Argument warp_row(const char* fallback) {
  return Argument{"warp", number | numbers | function, "degrees", everything,
                  "warp direction: angle counter-clockwise about the normal from global +x, {x, y, z}, or "
                  "function(x, y, z) returning either; " +
                      std::string(fallback)}
      .optional();
}

// For a body, and also for a region.
std::vector<Argument> made_rows(const char* warp_default) {
  return {object_("card?", "card", "the fabric"),
          value_("layers?", table,
                 "{ {card=, warp=, thickness=, name=}, ... }: plies from below, in place of a card"),
          number_("thickness?", "m", positive, "replaces the card's; mass per area changes with it")
              .usually(1e-5, 2e-2, "is it in m? (write 0.38*mm)"),
          warp_row(warp_default),
          integer_("points", Range{1, 9}, "integration points through the thickness").or_else(3),
          number_("offset", "", Range{-1, 1}, "reference surface: -1 lower face, 0 middle, 1 upper face")
              .or_else(0.0)};
}

constexpr const char* flat_default = "default: along the grain of a panel, 0 on another flat generated mesh";
constexpr const char* region_words =
    "{ set = {card=, thickness=, warp=, ...}, ... }: sets of elements with a card or section of their own";

const std::vector<Argument>& region_fields() {
  static const std::vector<Argument> rows = made_rows("default: that of its body");
  return rows;
}

std::vector<Argument> rest_rows() {
  return {object_("reference?", "mesh",
                  "the stress-free shape: the same elements with other nodes. Strains, yarns and masses are "
                  "those of this shape; the mesh is where the run starts"),
          value_("rest", text,
                 "where it is free of moments: own, with the curvature of the stress-free shape; flat; or as "
                 "placed, with that of the mesh")
              .one_of({std::begin(model::rest_words), std::end(model::rest_words)})
              .or_else("own"),
          fields_("prestress?",
                  {number_("warp", "N/m", not_negative, "along the warp").or_else(0.0),
                   number_("weft", "N/m", not_negative, "along the weft").or_else(0.0)},
                  "tension at the start, per width of the mesh, by a strain of the law that is printed")};
}

const std::vector<Argument>& body_fields() {
  static const std::vector<Argument> rows = [] {
    std::vector<Argument> all{value_("name", text, "its sets are then name.left, name.all, ..."),
                              object_("mesh", "mesh", "its surface")};
    for (Argument& row : made_rows(flat_default)) all.push_back(std::move(row));
    for (Argument& row : rest_rows()) all.push_back(std::move(row));
    all.push_back(value_("regions?", table, region_words));
    return all;
  }();
  return rows;
}

// The regions of a body, sorted by name, because the order of a Lua table is not defined.
std::vector<model::RegionGiven> read_regions(const Fields& given, const std::string& path,
                                             const model::Options& body) {
  std::vector<model::RegionGiven> regions;
  if (!given.has("regions")) return regions;
  lua_State* L = given.L();
  given.push("regions");
  const int table = lua_gettop(L);
  std::vector<std::string> sets;
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING || !lua_istable(L, -1))
      given.refuse("regions", "expected { set = {card=, ...}, ... }, got an entry " + describe(L, -2) +
                                  " = " + describe(L, -1));
    sets.emplace_back(lua_tostring(L, -2));
  }
  std::sort(sets.begin(), sets.end());
  for (const std::string& set : sets) {
    lua_getfield(L, table, set.c_str());
    const Fields region(L, lua_gettop(L), region_fields(), path + "regions." + set + ".");
    BodyMaterial made = read_made(region);
    if (!made.options.warp) {
      made.options.warp = body.warp;
      made.options.warp_text = body.warp_text;
    }
    regions.push_back({set, std::move(made.card), std::move(made.options)});
    lua_settop(L, table);
  }
  lua_pop(L, 1);
  if (regions.empty()) given.refuse("regions", "expected at least one region, got an empty table");
  return regions;
}

model::ReferenceGiven read_rest(const Fields& given) {
  model::ReferenceGiven made;
  if (given.has("reference")) made.mesh = given.object<mesh::Mesh>("reference");
  const auto* const found =
      std::find(std::begin(model::rest_words), std::end(model::rest_words), given.text("rest"));
  made.rest = static_cast<model::Rest>(found - std::begin(model::rest_words));
  if (!given.has("prestress")) return made;
  const Fields tension = given.fields("prestress");
  made.prestress = {tension.number("warp"), tension.number("weft")};
  lua_pop(given.L(), 1);
  if (!((*made.prestress)[0] > 0 || (*made.prestress)[1] > 0))
    given.refuse("prestress", "expected a tension along warp or weft, got none");
  return made;
}

model::BodyGiven read_body(const Fields& given, const std::string& name, const std::string& path) {
  BodyMaterial made = read_made(given);
  auto regions = read_regions(given, path, made.options);
  return {name,
          given.object<mesh::Mesh>("mesh"),
          std::move(made.card),
          std::move(made.options),
          std::move(regions),
          read_rest(given)};
}

// Checks the name of a body, which becomes a part of the names of its sets.
void check_name(const Fields& body, const std::string& name, const std::vector<model::BodyGiven>& before) {
  if (name.empty() || name.find_first_of(". \t\n") != std::string::npos)
    body.refuse("name", "expected a name without blanks and full stops, got '" + name + "'");
  for (const auto& other : before)
    if (other.name == name) body.refuse("name", "expected a name of its own, got '" + name + "' twice");
}

std::vector<model::BodyGiven> read_bodies(const Call& call) {
  for (const char* field :
       {"mesh", "card", "layers", "thickness", "warp", "offset", "regions", "reference", "prestress"})
    if (call.has(field)) call.refuse(field, "expected inside each of the bodies, where 'bodies' is given");
  lua_State* L = call.L();
  std::vector<model::BodyGiven> bodies;
  call.each("bodies", [&](lua_Integer i) {
    if (!lua_istable(L, -1))
      call.refuse("bodies", "expected a list of tables {name=, mesh=, card=, ...}, got " + describe(L, -1));
    const std::string path = "bodies[" + std::to_string(i) + "].";
    const Fields body(L, lua_gettop(L), body_fields(), path);
    const std::string name = body.text("name");
    check_name(body, name, bodies);
    bodies.push_back(read_body(body, name, path));
  });
  call.push("bodies");
  for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1))
    if (lua_isinteger(L, -2) == 0 || lua_tointeger(L, -2) < 1 ||
        lua_tointeger(L, -2) > static_cast<lua_Integer>(bodies.size()))
      call.refuse("bodies", "expected a list of tables {name=, mesh=, card=, ...}, got an entry " +
                                describe(L, -2) + " = " + describe(L, -1));
  lua_pop(L, 1);
  if (bodies.empty()) call.refuse("bodies", "expected at least one body, got an empty table");
  return bodies;
}

}  // namespace

// Without bending for the model as a whole. Errors: plies, or a reference surface off the middle.
void make_membrane(const Call& call, std::vector<model::BodyGiven>& bodies) {
  const auto make = [&](model::Options& options) {
    if (!options.plies.empty() || options.offset != 0)
      call.refuse("membrane", "expected a card without layers and offset, of which a membrane knows nothing");
    options.membrane = true;
  };
  for (auto& body : bodies) {
    make(body.options);
    for (auto& region : body.regions) make(region.options);
  }
}

// Where cloth folds, for the model as a whole.
void set_folds(const std::string& word, std::vector<model::BodyGiven>& bodies) {
  const auto* const found = std::find(std::begin(card::fold_words), std::end(card::fold_words), word);
  const auto folds = static_cast<card::Folds>(found - std::begin(card::fold_words));
  for (auto& body : bodies) {
    body.options.folds = folds;
    for (auto& region : body.regions) region.options.folds = folds;
  }
}

void interpolate_yarns(std::vector<model::BodyGiven>& bodies) {
  for (auto& body : bodies) {
    body.options.full_yarns = true;
    for (auto& region : body.regions) region.options.full_yarns = true;
  }
}

std::vector<Argument> model_rows() {
  std::vector<Argument> rows{object_("mesh?", "mesh", "the surface")};
  for (Argument& row : made_rows(flat_default)) rows.push_back(std::move(row));
  for (Argument& row : rest_rows()) rows.push_back(std::move(row));
  rows.push_back(value_("regions?", table, region_words));
  rows.push_back(value_("bodies?", table,
                        "{ {name=, mesh=, card=, regions=, ...}, ... }: several meshes in place of one; "
                        "their sets are then name.left"));
  rows.push_back(flag_("membrane",
                       "cloth without bending and transverse shear, whose directors are held: for sheets "
                       "that are taut, or fold more sharply than an element can show"));
  rows.push_back(value_("folds?", text,
                        "where compressed cloth folds: resolved, in the shape of the mesh alone; within "
                        "elements too, which then carry no more compression than folds of their size; free, "
                        "the same without any force; default: that of each card")
                     .one_of({std::begin(card::fold_words), std::end(card::fold_words)}));
  rows.push_back(value_("yarns", text,
                        "eased: the strain of yarns that cross quadrilaterals obliquely varies in an element "
                        "only as far as shear can hold it, so that stiff yarns do not lock a mesh; full: as "
                        "interpolated, as in the thesis")
                     .one_of({"eased", "full"})
                     .or_else("eased"));
  rows.push_back(number_("imperfection?", "m", positive,
                         "nodes are moved across the sheet by at most this, in a pattern of waves that is "
                         "always the same, so that a sheet that is pressed or sheared in its plane can "
                         "buckle; the mesh of the deck stays as it is"));
  return rows;
}

// Bends the meshes a little. Error: by more than a tenth of their size, which would be another shape.
void bend_meshes(const Call& call, std::vector<model::BodyGiven>& bodies) {
  constexpr double most = 0.1;
  const double amplitude = call.number("imperfection");
  for (auto& body : bodies) {
    const double size = box_of(body.mesh->nodes).size().norm();
    if (!(amplitude <= most * size))
      call.refuse("imperfection", "expected at most a tenth of the size of the mesh, " +
                                      fabricsh::number(most * size) + " m, got " +
                                      fabricsh::number(amplitude));
    body.mesh = std::make_shared<mesh::Mesh>(mesh::imperfect(*body.mesh, amplitude));
  }
}

int make_model(Call& call) {
  if (!call.has("bodies") && !call.has("mesh"))
    call.refuse("mesh", "expected a mesh, got nil (missing, or a misspelt variable)");
  std::vector<model::BodyGiven> bodies;
  if (call.has("bodies"))
    bodies = read_bodies(call);
  else
    bodies.push_back(read_body(call, "", ""));
  if (call.flag("membrane")) make_membrane(call, bodies);
  if (call.has("folds")) set_folds(call.text("folds"), bodies);
  if (call.text("yarns") == "full") interpolate_yarns(bodies);
  if (call.has("imperfection")) bend_meshes(call, bodies);
  std::vector<std::unique_ptr<ChangeRefused>> still;
  for (const auto& body : bodies)
    for (const auto& mesh : {body.mesh, body.reference.mesh})
      if (mesh) still.push_back(std::make_unique<ChangeRefused>(call.session(), mesh.get()));
  auto model = std::make_shared<Model>(std::move(bodies));
  for (const auto& region : model->regions()) check_made(call.session(), region.card, region.options);
  return push_object(call.L(), std::move(model));
}

}  // namespace fabricsh::script
