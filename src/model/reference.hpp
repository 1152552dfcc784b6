// The stress-free shape of a body, where it is not its mesh, and creases, along which a sheet rests at an
// angle.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::model {

class Model;

// Where a sheet is free of moments: with the curvature of its stress-free shape, flat, or as it is placed.
enum class Rest { own, flat, placed };
inline constexpr const char* rest_words[] = {"own", "flat", "as placed"};

struct ReferenceGiven {
  std::shared_ptr<mesh::Mesh> mesh = {};  // the same elements with other nodes; null: the mesh of the body
  Rest rest = Rest::own;
  // N/m along warp and weft, over the width of the mesh, at the start. It comes on top of the strain between
  // the reference and the mesh.
  std::optional<std::array<double, 2>> prestress = {};
  bool any() const { return mesh || rest != Rest::own || prestress; }
};

// "free of stress as rectangle 4x4; rests flat; ", for the printed model; empty if nothing is given.
std::string rest_text(const ReferenceGiven& given);

// Along the edges of the stress-free shape between the nodes of a set, or on a line through its places. The
// normals of both sides are at rest if they differ by the angle; it is positive where they lean towards each
// other. With a stiffness it is a hinge: each side has a director of its own, and the moment between them is
// that times the angle less the one at rest.
struct CreaseGiven {
  static constexpr const char* call() { return "crease"; }
  std::string set;
  std::vector<Vec3> line;                // m
  double angle = 0;                      // degrees
  std::optional<double> stiffness = {};  // N/rad, that is N m/rad per metre of crease; none: it is no hinge
  static void tell(auto& d, auto& v) {
    d.set.empty() ? v.place("line") : v.set(d.set);
    v.number("angle", d.angle, "at rest at # degrees");
    v.number("stiffness", d.stiffness, "# N/rad");
  }
};

// One edge of a crease: nodes of the mesh without further nodes, the angle, rad, and the stiffness of a
// hinge.
struct CreaseEdge {
  mesh::Index from, to;
  double angle;
  std::optional<double> stiffness;
};

// "model: field 'reference': ..." unless the mesh has the elements of the other.
void check_reference(const std::string& of, const mesh::Mesh& mesh, const mesh::Mesh& reference);

// Errors: no edge of the mesh on the line; a set with more than a line of edges.
std::vector<CreaseEdge> edges_of(const Model& model, const CreaseGiven& crease);
// Of all creases. Error: creases that meet in more than one line and are not all hinges.
std::vector<CreaseEdge> crease_edges(const Model& model);
// Of those that are hinges, the places at both ends.
std::vector<std::pair<mesh::Index, mesh::Index>> hinge_edges(const Model& model);
// Errors: hinges in a membrane, beside tearable zones, seams or periodic ties; sides that do not face one
// way.
void check_hinges(const Model& model);

}  // namespace fabricsh::model
