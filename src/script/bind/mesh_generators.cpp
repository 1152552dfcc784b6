// fabric.mesh.disk, annulus, cylinder, hemisphere.
#include <cmath>

#include "base/number.hpp"
#include "mesh/generators.hpp"
#include "script/bind/mesh.hpp"
#include "script/call/words.hpp"

namespace fabricsh::script {

namespace {

int give(Call& call, mesh::Mesh mesh) {
  return push_object(call.L(), std::make_shared<mesh::Mesh>(std::move(mesh)));
}

int disk(Call& call) {
  const mesh::Index rings = call.has("rings") ? call.integer("rings") : 0;
  return give(call, mesh::disk({call.number("radius"), call.integer("cells"), rings}));
}

int annulus(Call& call) {
  return give(call, mesh::annulus({call.number("inner"), call.number("outer"), call.integer("around"),
                                   call.integer("across"), call.number("angle"), call.flag("slit")}));
}

int cylinder_mesh(Call& call) {
  return give(call, mesh::cylinder({call.number("radius"), call.number("length"), call.integer("around"),
                                    call.integer("along"), call.number("angle")}));
}

int hemisphere(Call& call) {
  return give(call, mesh::hemisphere({call.number("radius"), call.number("hole"), call.integer("around"),
                                      call.integer("along"), call.number("angle")}));
}

// The rows of numbers of a table in the field: {{1, 2, 3}, ...}, each of `least` to `most` numbers.
std::vector<std::vector<double>> number_rows(const Call& call, const char* name, std::size_t least,
                                             std::size_t most) {
  lua_State* L = call.L();
  std::vector<std::vector<double>> rows;
  call.push(name);
  for (lua_Integer i = 1; lua_rawgeti(L, -1, i) != LUA_TNIL; ++i) {
    const std::string where = "at place " + std::to_string(i);
    if (!lua_istable(L, -1))
      call.refuse(name, "expected a list of numbers " + where + ", got " + describe(L, -1));
    std::vector<double>& row = rows.emplace_back();
    for (lua_Integer k = 1; lua_rawgeti(L, -1, k) != LUA_TNIL; ++k, lua_pop(L, 1)) {
      if (lua_type(L, -1) != LUA_TNUMBER)
        call.refuse(name, "expected numbers " + where + ", got " + describe(L, -1));
      row.push_back(lua_tonumber(L, -1));
    }
    lua_pop(L, 2);
    if (row.size() < least || row.size() > most)
      call.refuse(name, "expected " + std::to_string(least) + " or " + std::to_string(most) + " numbers " +
                            where + ", got " + std::to_string(row.size()));
  }
  lua_pop(L, 2);
  return rows;
}

int of_lists(Call& call) {
  std::vector<Vec3> nodes;
  for (const auto& x : number_rows(call, "nodes", 2, 3))
    nodes.emplace_back(x[0], x[1], x.size() > 2 ? x[2] : 0);
  std::vector<std::array<mesh::Index, 4>> elements;
  for (const auto& ids : number_rows(call, "elements", 3, 4)) {
    auto& element = elements.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) {
      const double id = k < ids.size() ? ids[k] : 0;
      if (id != std::floor(id) || std::abs(id) > 1e15)
        call.refuse("elements", "expected node numbers at place " + std::to_string(elements.size()) +
                                    ", got " + exact_number(id));
      element[k] = static_cast<mesh::Index>(id) - 1;
    }
    if (ids.size() == 4 && element[3] < 0)
      call.refuse("elements", "expected node numbers from 1 at place " + std::to_string(elements.size()) +
                                  ", got " + exact_number(ids[3]));
  }
  mesh::Mesh made = mesh::from_lists(std::move(nodes), std::move(elements));
  if (call.has("join") && call.flag("join")) mesh::join_nodes(made);
  return give(call, std::move(made));
}

int merge(Call& call) {
  std::vector<std::shared_ptr<const mesh::Mesh>> meshes;
  call.each("meshes", [&](lua_Integer i) {
    meshes.push_back(to_object<mesh::Mesh>(call.L(), -1));
    if (meshes.back() == nullptr)
      call.refuse("meshes",
                  "expected a mesh at place " + std::to_string(i) + ", got " + describe(call.L(), -1));
  });
  if (meshes.size() < 2)
    call.refuse("meshes", "expected at least two meshes, got " + std::to_string(meshes.size()));
  return give(call, mesh::merge(meshes, call.number("distance")));
}

constexpr Range full_turn{0, 360, true, false};
constexpr const char* open_sets =
    "Below 360 degrees the sets start and end are its two cut edges, at 360 degrees seam is the line at "
    "angle 0.";

Argument length_(std::string name, std::string sentence) {
  return number_(std::move(name), "m", positive, std::move(sentence))
      .usually(1e-3, 20, "are the lengths in m? (write 25.4*mm)");
}

Argument angle_(double usual) {
  return number_("angle", "degrees", full_turn, "of the sector, counter-clockwise from +x").or_else(usual);
}

Entry disk_row() {
  return {"fabric.mesh.disk{}",
          {length_("radius", "of the rim"),
           integer_("cells", from_one,
                    "elements along each side of the square core; the rim has four times as many"),
           integer_("rings?", from_one, "rings of elements around the core, default half of cells")},
          "A disk of quadrilaterals in the x-y plane about the origin, normal +z: a square core, then rings. "
          "Sets boundary (the rim), core, all, and centre when cells is even.",
          "local mesh = fabric.mesh.disk{ radius=0.05, cells=4 }\n"
          "assert(#mesh.elements == 4*4 + 2*16 and #mesh:set 'boundary' == 16)",
          disk};
}

Entry annulus_row() {
  return {"fabric.mesh.annulus{}",
          {length_("inner", "radius"), length_("outer", "radius"),
           integer_("around", from_one, "elements along the circle"),
           integer_("across", from_one, "elements from the inner to the outer circle"), angle_(360),
           flag_("slit", "cut a full ring open at angle 0")},
          std::string("A ring or a sector of one in the x-y plane about the origin, normal +z; nodes around "
                      "first, from the inner circle outward. Sets inner, outer, boundary, all. ") +
              open_sets + " A slit ring has start and end too.",
          "local mesh = fabric.mesh.annulus{ inner=0.06, outer=0.10, around=30, across=6, slit=true }\n"
          "assert(#mesh.elements == 180 and #mesh:set 'start' == 7 and #mesh:set 'end' == 7)",
          annulus};
}

Entry cylinder_row() {
  return {"fabric.mesh.cylinder{}",
          {length_("radius", "of the cylinder"), length_("length", "from z = 0 up"),
           integer_("around", from_one, "elements along the circle"),
           integer_("along", from_one, "elements along the axis"), angle_(360)},
          std::string("A sleeve, or an open shell cut from one, about the z axis, normal outward; nodes "
                      "around first, from the bottom up. Sets bottom, top, boundary, all. ") +
              open_sets,
          "local mesh = fabric.mesh.cylinder{ radius=0.04, length=0.2, around=16, along=10 }\n"
          "assert(#mesh.nodes == 16*11 and #mesh:set 'seam' == 11)",
          cylinder_mesh};
}

Entry hemisphere_row() {
  return {"fabric.mesh.hemisphere{}",
          {length_("radius", "of the sphere"),
           number_("hole", "degrees", Range{0, 90, true, true}, "polar angle at which the cap is cut off")
               .or_else(18.0),
           integer_("around", from_one, "elements along the equator"),
           integer_("along", from_one, "elements from the equator to the hole"), angle_(90)},
          std::string("The upper half of a sphere about the origin with a hole at the top, or a sector of "
                      "it, normal outward; nodes around first, from the equator up. Sets bottom (the "
                      "equator), top (edge of the hole), boundary, all. ") +
              open_sets,
          "local mesh = fabric.mesh.hemisphere{ radius=10, around=16, along=16 }\n"
          "assert(#mesh.elements == 256 and #mesh:set 'top' == 17)",
          hemisphere};
}

Entry of_row() {
  return {
      "fabric.mesh.of{}",
      {value_("nodes", table, "{ {x, y, z}, ... }, m; without z it is 0"),
       value_("elements", table, "{ {1, 2, 5, 4}, ... }: node numbers, 3 or 4, counter-clockwise"), join_()},
      "A mesh of your own, from its nodes and elements; also written fabric.mesh{ nodes=, elements= }. "
      "Sets all and boundary.",
      "local mesh = fabric.mesh{ nodes={ {0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1} }, elements={ {1, 2, 3}, "
      "{1, 3, 4} } }\n"
      "assert(#mesh.elements == 2 and #mesh:set 'boundary' == 4)",
      of_lists};
}

Entry merge_row() {
  return {"fabric.mesh.merge{}",
          {value_("meshes", table, "{ a, b, ... }"),
           number_("distance", "m", not_negative, "within which nodes of different meshes become one")
               .or_else(1e-6)},
          "Several meshes as one: nodes of different meshes that coincide are joined, sets of one name "
          "become one, all and boundary are made anew. The edges that meet need the same nodes.",
          "local a = fabric.mesh.rectangle{ width=0.1, height=0.1, nx=2, ny=2 }\n"
          "local b = fabric.mesh.rectangle{ width=0.1, height=0.1, nx=2, ny=2, origin={0.1, 0} }\n"
          "local both = fabric.mesh.merge{ meshes={a, b} }\n"
          "assert(#both.nodes == 15 and #both.elements == 8 and #both:set 'boundary' == 12)",
          merge};
}

}  // namespace

std::vector<Entry> mesh_generator_rows() {
  return {of_row(), merge_row(), disk_row(), annulus_row(), cylinder_row(), hemisphere_row()};
}

}  // namespace fabricsh::script
