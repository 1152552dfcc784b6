// fabric.mesh.disk, annulus, cylinder, hemisphere.
#include "mesh/generators.hpp"
#include "script/bind/mesh.hpp"

namespace fabricsh::script {

namespace {

int give(Call& call, mesh::Mesh mesh) {
  push_object(call.L(), std::make_shared<mesh::Mesh>(std::move(mesh)));
  return 1;
}

int disk(Call& call) {
  const mesh::Index rings = call.has("rings") ? call.integer("rings") : 0;
  return give(call, mesh::disk({call.number("radius"), call.integer("cells"), rings}));
}

int annulus(Call& call) {
  return give(call, mesh::annulus({call.number("inner"), call.number("outer"), call.integer("around"),
                                   call.integer("across"), call.number("angle"), call.flag("slit")}));
}

int cylinder(Call& call) {
  return give(call, mesh::cylinder({call.number("radius"), call.number("length"), call.integer("around"),
                                    call.integer("along"), call.number("angle")}));
}

int hemisphere(Call& call) {
  return give(call, mesh::hemisphere({call.number("radius"), call.number("hole"), call.integer("around"),
                                      call.integer("along"), call.number("angle")}));
}

constexpr Range turn{0, 360, true, false};
constexpr const char* open_sets =
    "Below 360 degrees the sets start and end are its two cut edges, at 360 degrees seam is the line at "
    "angle 0.";

Argument length_(std::string name, std::string sentence) {
  return number_(std::move(name), "m", positive, std::move(sentence))
      .usually(1e-3, 20, "are the lengths in m? (write 25.4*mm)");
}

Argument angle_(double usual) {
  return number_("angle", "degrees", turn, "of the sector, counter-clockwise from +x").or_else(usual);
}

Entry disk_row() {
  return {
      "fabric.mesh.disk",
      Style::fields,
      {length_("radius", "of the rim"),
       integer_("cells", from_one,
                "elements along each side of the square core; the rim has four times as many"),
       integer_("rings", from_one, "rings of elements around the core, default half of cells").optional()},
      "A disk of quadrilaterals in the x-y plane about the origin, normal +z: a square core, then rings. "
      "Sets "
      "boundary (the rim), core, all, and centre when cells is even.",
      "local fabric = require 'fabric'\n"
      "local mesh = fabric.mesh.disk{ radius=0.05, cells=4 }\n"
      "assert(#mesh.elements == 4*4 + 2*16 and #mesh:set 'boundary' == 16)",
      disk};
}

Entry annulus_row() {
  return {
      "fabric.mesh.annulus",
      Style::fields,
      {length_("inner", "radius"), length_("outer", "radius"),
       integer_("around", from_one, "elements along the circle"),
       integer_("across", from_one, "elements from the inner to the outer circle"), angle_(360),
       value_("slit", boolean, "cut a full ring open at angle 0").or_else(false)},
      std::string(
          "A ring or a sector of one in the x-y plane about the origin, normal +z; nodes around first, from "
          "the inner circle outward. Sets inner, outer, boundary, all. ") +
          open_sets + " A slit ring has start and end too.",
      "local fabric = require 'fabric'\n"
      "local mesh = fabric.mesh.annulus{ inner=0.06, outer=0.10, around=30, across=6, slit=true }\n"
      "assert(#mesh.elements == 180 and #mesh:set 'start' == 7 and #mesh:set 'end' == 7)",
      annulus};
}

Entry cylinder_row() {
  return {
      "fabric.mesh.cylinder",
      Style::fields,
      {length_("radius", "of the cylinder"), length_("length", "from z = 0 up"),
       integer_("around", from_one, "elements along the circle"),
       integer_("along", from_one, "elements along the axis"), angle_(360)},
      std::string(
          "A sleeve, or an open shell cut from one, about the z axis, normal outward; nodes around first, "
          "from the bottom up. Sets bottom, top, boundary, all. ") +
          open_sets,
      "local fabric = require 'fabric'\n"
      "local mesh = fabric.mesh.cylinder{ radius=0.04, length=0.2, around=16, along=10 }\n"
      "assert(#mesh.nodes == 16*11 and #mesh:set 'seam' == 11)",
      cylinder};
}

Entry hemisphere_row() {
  return {"fabric.mesh.hemisphere",
          Style::fields,
          {length_("radius", "of the sphere"),
           number_("hole", "degrees", Range{0, 90, true, true}, "polar angle at which the cap is cut off")
               .or_else(18.0),
           integer_("around", from_one, "elements along the equator"),
           integer_("along", from_one, "elements from the equator to the hole"), angle_(90)},
          std::string(
              "The upper half of a sphere about the origin with a hole at the top, or a sector of it, normal "
              "outward; nodes around first, from the equator up. Sets bottom (the equator), top (edge of "
              "the hole), boundary, all. ") +
              open_sets,
          "local fabric = require 'fabric'\n"
          "local mesh = fabric.mesh.hemisphere{ radius=10, around=16, along=16 }\n"
          "assert(#mesh.elements == 256 and #mesh:set 'top' == 17)",
          hemisphere};
}

}  // namespace

std::vector<Entry> mesh_generator_rows() {
  return {disk_row(), annulus_row(), cylinder_row(), hemisphere_row()};
}

}  // namespace fabricsh::script
