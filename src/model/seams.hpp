// Seams: two edges of cloth that are sewn together. Which node of the one edge meets which place on the other
// is worked out once from the mesh, by the length along each edge.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "model/ties.hpp"

namespace fabricsh::model {

struct Seam {
  static constexpr const char* call() { return "seam"; }
  std::string first, second;        // sets of the nodes of two edges
  std::optional<double> over = {};  // s, in which the edges are drawn together; empty: they lie on each other
  double ease = 0.01;               // by what share of the longer edge the other may be shorter
  // Whether the edges are matched from different ends, those with the lowest numbers of nodes being the first
  // ends; empty: so that the ends lie nearer.
  std::optional<bool> reverse = {};
  // Whether the directors of both edges are free of each other; empty: where the normals of the edges are
  // more than 60 degrees apart as the seam closes.
  std::optional<bool> hinge = {};
  std::optional<double> stiffness = {};  // N/m^2: N per metre of seam and per metre of opening
  std::optional<double> strength = {};   // N/m
  std::optional<double> energy = {};     // J/m, of breaking a metre of it
  std::string name() const { return "of '" + first + "' and '" + second + "'"; }
  static void tell(auto& d, auto& v) {
    v.set(d.first, d.second);
    v.time("over", d.over, "over # s", "from the start");
    v.flag("hinge", d.hinge, "a hinge", "bends as one piece");
    v.flag("reverse", d.reverse, "reversed", "not reversed");
    v.number("stiffness", d.stiffness, "stiffness # N/m^2");
    v.number("strength", d.strength, "strength # N/m");
    v.number("energy", d.energy, "# J/m");
  }
};

// A node of the edge with more nodes, and the place of the other edge that it meets.
struct Stitch {
  mesh::Index node;
  std::vector<Lead> leads;  // one node, or the two ends of an element's edge; the weights add up to one
  double length;            // m, of the edge for which the node stands
  std::size_t seam;
};

// Nodes of a set along the boundary of the mesh.
struct EdgeChain {
  std::vector<mesh::Index> nodes;  // in order, beginning with the lower number of both ends
  std::vector<double> along;       // m, of each node from the first one
  bool ring = false;               // the last node is connected to the first
  double length = 0;               // m
};
// Error: a node that is not on the boundary; nodes that do not form one line or one ring.
EdgeChain chain_of(const mesh::Mesh& mesh, const std::string& set);

class Model;
// In the order of the seams, and along each. Errors: those of chain_of; an edge sewn to itself; a line to a
// ring; lengths that differ by more than the ease; ends that are connected the wrong way round; edges without
// `over` that do not lie on each other; nodes that are tied or in a tearable zone.
std::vector<Stitch> work_out_seams(const Model& model);

}  // namespace fabricsh::model
