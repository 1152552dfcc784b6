// Structured meshes of simple shapes; lengths in m, angles in
// degrees. Every error has the form "disk: field 'radius': ...".
#pragma once
#include <functional>

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

// Makes one node of those at one place; returns how many are gone. The sets all and boundary are made anew
// where they were those of the mesh. Error: an element two of whose corners would be one node.
Index join_nodes(Mesh& mesh);

// Adds the sets all and boundary (the nodes of free edges, if there are any) unless they are there.
void add_usual_sets(Mesh& mesh);

// Cuts every element from its middle to the middles of its sides: a quadrilateral into four, a triangle into
// three. So no triangle is left. New nodes lie on the sides and in the middles, hence the surface and its
// border stay as they are, with their corners. They have the highest numbers: first the sides, in the order
// of their ends, then the elements. A set takes the middle of a side whose ends it has, of an inner side only
// if it has inner nodes, and the middle of an element all of whose corners it has. The warp goes with the
// elements. Errors: a mesh in use or of several parts.
void refine(Mesh& mesh);

// --- Joins triangles in pairs to quadrilaterals, which yarns do not lock where they cross them obliquely.

// Joins neighbours where the four corners form a convex and nearly flat quadrilateral whose corners are 30 to
// 150 degrees: the best pairs first, then others in their place where that leaves fewer triangles. Nodes and
// sets stay, elements are numbered anew in the order of the first of their triangles. Returns how many
// triangles are left. Error: a mesh in use.
Index pair_triangles(Mesh& mesh);

// --- A slit along a line of edges.

// The nodes of the two sides, ascending; at an end inside the mesh, where the sides stay together, both have
// its node.
struct CrackFaces {
  NodeSet left, right;  // as seen from the start of the slit, against the normal
};

// Cuts the mesh along the edges on the straight line between two points (m): the nodes there are doubled
// except at an end inside the mesh. The left side keeps them; the new ones follow all others, and are in the
// sets of those at their places. A set boundary that has the nodes of all free edges has them again. Errors,
// with the place: no node at an end; a part of the line without an edge, or along an edge that is free; a
// slit of one edge inside the mesh, which would not open; a mesh of several parts or in use.
CrackFaces slit(Mesh& mesh, const Vec3& from, const Vec3& to);

// --- A hole along the grid of a mesh.

// Leaves out the elements whose middle, the mean of their corners (m), is inside, and the nodes that no
// element has any more; sets keep the others, and one that loses all its nodes goes. A set boundary that had
// the nodes of all free edges has them again. Returns the nodes of the rim, which elements on both sides of
// it had, ascending. Errors: no element inside, or all of them; a mesh of several parts
// or in use.
NodeSet hole(Mesh& mesh, const std::function<bool(const Vec3&)>& inside);

}  // namespace fabricsh::mesh
