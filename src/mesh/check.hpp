// Defects of a mesh, and facts worth knowing about it, found before a run.
#pragma once
#include <string>
#include <vector>

#include "base/severity.hpp"
#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

// One finding. The text counts elements and nodes from 1. The lists count from 0, ascend and are complete.
struct Finding {
  std::string key;  // "inverted", "duplicate", ...: these words do not change between releases
  Severity severity = Severity::note;
  std::string text;
  std::vector<Index> elements = {}, nodes = {};
};

struct Measures {
  double area = 0;                   // m2
  double shortest = 0, longest = 0;  // edges, m
  double aspect = 0;                 // the largest of all elements: longest over shortest side
  double warping = 0;                // largest angle between the two halves of a quadrilateral, degrees
  double least_angle = 0;            // smallest corner angle, degrees
  Index triangles = 0, quadrilaterals = 0, parts = 0, borders = 0;  // borders: closed lines of free edges
};

struct Report {
  std::string mesh;
  Measures measures;
  std::vector<Finding> items;
  bool ok() const;                                    // no error
  const Finding* find(const std::string& key) const;  // null if absent
  std::string text() const;                           // the whole report, errors first
};

// Keys of errors: degenerate (no area, an edge without length, a repeated node), inverted (a
// corner with the opposite orientation), fold (at which the mean normal at the nodes is none, or points
// against an element), repeated (elements on the same nodes), orientation (neighbours with opposite
// orientations), one_sided (a Moebius strip), apart (in parts that share places but no nodes, but for
// those of a slit). Keys of warnings: unused and duplicate (nodes), nonmanifold
// (edges shared by three or more elements), aspect (above 10), warping (above 15 degrees), angle (corners
// below 20 degrees). Keys of notes: free (edges).
Report check(const Mesh& mesh);

// Whether a file made the mesh, as it is: then its parts may be what another program left unconnected.
bool of_file(const Mesh& mesh);
// "node 3", "nodes 3, 7, 12", "nodes 1, 2, 3, 4, 5 and 40 more", of ids from 0.
std::string listed(const char* noun, const std::vector<Index>& ids);

// The part of each node, numbered from 0: parts are not connected by edges.
std::vector<Index> parts_of_nodes(const Mesh& mesh);
// Nodes at the place of one before them that is of another part, ascending: within one_place, in a merged
// mesh within a thousandth of the mean side.
NodeSet meeting(const Mesh& mesh, const std::vector<Index>& part);
// That the mesh falls apart: where, and how nodes at one place become one.
std::string words_of_parts(const Mesh& mesh, Index parts, const NodeSet& meeting);

// The elements on the same nodes as one before them, ascending. A model refuses them: they would count twice.
std::vector<Index> repeated_elements(const Mesh& mesh);

// "the mesh spans 60 m, far from what cloth is: are its lengths in m?" where a mesh spans more than 10 m or
// less than 0.1 mm; otherwise empty.
std::string doubt_about_units(const Mesh& mesh);

// Reverses elements until neighbours agree in orientation. Without a direction each part follows the majority
// of its elements; with one, the mean normal of each part points along it. Returns how many elements were
// reversed. Errors: a one-sided part, or a part whose mean normal is perpendicular to the direction.
Index orient(Mesh& mesh, const Vec3& direction = Vec3::Zero());

}  // namespace fabricsh::mesh
