// What is wrong with a mesh, or worth knowing about it, before a run finds out.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

enum class Severity { note, warning, error };
const char* name(Severity severity);

// One finding. The text counts elements and nodes from 1; the lists count from 0, ascending, and are whole.
struct Finding {
  std::string key;  // "inverted", "duplicate", ...: stable, for programs
  Severity severity = Severity::note;
  std::string text;
  std::vector<Index> elements = {}, nodes = {};
};

struct Measures {
  double area = 0;                   // m2
  double shortest = 0, longest = 0;  // edges, m
  double aspect = 0;                 // largest: longest over shortest side of an element
  double warping = 0;                // largest angle between the halves of a quadrilateral, degrees
  double least_angle = 0;            // smallest corner, degrees
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

// Keys of errors: degenerate (no area, an edge without length, a node twice), inverted (a corner that turns
// the other way), repeated (elements on the same nodes), orientation (neighbours that turn opposite ways),
// one_sided (a Moebius strip). Of warnings: unused and duplicate (nodes), nonmanifold (edges of three
// elements and more), aspect (above 10), warping (above 15 degrees), angle (corners below 20 degrees). Of
// notes: free (edges).
Report check(const Mesh& mesh);

// Turns elements around until neighbours agree, as most of each part do; with a direction, until the mean
// normal of each part points along it. Returns how many were turned. Errors: a one-sided part, a part whose
// mean normal is square to the direction.
Index orient(Mesh& mesh, const Vec3& direction = Vec3::Zero());

}  // namespace fabricsh::mesh
