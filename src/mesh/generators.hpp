// Structured meshes of simple shapes; lengths in m, angles in
// degrees. Every error has the form "disk: field 'radius': ...".
#pragma once
#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

// A disk in the x-y plane about the origin, normal +z: a square core of cells x cells elements, and rings of
// 4 * cells elements around it. Nodes: the core row by row, then the rings outward, each counter-clockwise
// from the direction (-1, -1). Sets: boundary (the rim), core, all, and centre (one node) when cells is even.
struct Disk {
  double radius = 0;
  Index cells = 0;
  Index rings = 0;  // 0: chosen so that the elements are of about equal size
};
Mesh disk(const Disk& shape);

// A ring in the x-y plane about the origin, normal +z, counter-clockwise from the +x axis. Nodes are
// numbered around the ring first, from the inner circle outward. Sets: inner outer boundary all. An
// open ring also has start and end, its two cut edges; a closed one has seam, the nodes at angle 0.
struct Annulus {
  double inner = 0, outer = 0;
  Index around = 0, across = 0;
  double angle = 360;
  bool slit = false;  // a ring of 360 degrees that is cut open at angle 0
};
Mesh annulus(const Annulus& shape);

// A cylinder about the z axis from z = 0 to length, normal outward, counter-clockwise
// from the x-z plane. Nodes are numbered around the axis first, from the bottom up.
// Sets: bottom top boundary all, and start and end or seam as for a ring.
struct CylinderSurface {
  double radius = 0, length = 0;
  Index around = 0, along = 0;
  double angle = 360;
};
Mesh cylinder(const CylinderSurface& shape);

// The upper half of a sphere about the origin without its cap, normal outward; `hole` is the
// polar angle at which the cap is cut off. Nodes are numbered around the axis first, from
// the equator up. Sets as for a cylinder: bottom is the equator, top the edge of the hole.
struct Hemisphere {
  double radius = 0, hole = 18;
  Index around = 0, along = 0;
  double angle = 90;
};
Mesh hemisphere(const Hemisphere& shape);

// A mesh of given nodes (m, global) and elements (ids from 0; a triangle has -1 in the last place), with the
// sets all and boundary. Errors, which count from 1: a position that is not finite, an id outside the nodes,
// a corner named twice, a node in no element, no elements.
Mesh from_lists(std::vector<Vec3> nodes, std::vector<std::array<Index, 4>> elements);

// Several meshes as one: a node within `distance` (m) of a node of another mesh becomes that node. Nodes of
// one mesh stay apart, so that a slit stays open. Sets of one name become one; all and boundary are made
// anew. Error: an element two of whose corners would be one node, which is named.
Mesh merge(const std::vector<std::shared_ptr<const Mesh>>& meshes, double distance);

// The mesh with its nodes moved across the sheet by at most `amplitude` (m), in a pattern of waves that is
// always the same and depends on the places alone: a dozen waves in all directions, of a tenth of the size of
// the mesh and longer. `flat` and sets stay.
Mesh imperfect(const Mesh& mesh, double amplitude);

// Makes one node of those within the distance (m) of each other; returns how many are gone. The sets all and
// boundary are made anew where they were those of the mesh. Error: an element two of whose corners would be
// one node.
Index join_nodes(Mesh& mesh, double distance);

// Adds the sets all and boundary (the nodes of free edges, if there are any) unless they are there.
void add_usual_sets(Mesh& mesh);

}  // namespace fabricsh::mesh
