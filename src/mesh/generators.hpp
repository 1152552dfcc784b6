// Structured meshes of plain shapes, lengths in m, angles in degrees. Every error reads "disk: field
// 'radius': ...".
#pragma once
#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

// A disk in the x-y plane about the origin, normal +z: a square core of cells x cells elements, and rings of
// 4 * cells elements around it. Nodes: the core row by row, then the rings outward, each counter-clockwise
// from the direction (-1, -1). Sets: boundary (the rim), core, all, and centre (one node) when cells is even.
struct Disk {
  double radius = 0;
  Index cells = 0;
  Index rings = 0;  // 0: as many as make the elements of one size
};
Mesh disk(const Disk& shape);

// A ring in the x-y plane about the origin, normal +z, counter-clockwise from the +x axis. Nodes run around
// first, from the inner circle outward. Sets: inner outer boundary all; of an open ring also start and end,
// its two cut edges; of a closed one seam, the nodes at angle 0.
struct Annulus {
  double inner = 0, outer = 0;
  Index around = 0, across = 0;
  double angle = 360;
  bool slit = false;  // a ring of 360 degrees that is cut at angle 0
};
Mesh annulus(const Annulus& shape);

// A cylinder about the z axis from z = 0 to length, normal outward, counter-clockwise from the x-z plane.
// Nodes run around first, from the bottom up. Sets: bottom top boundary all; start and end, or seam, as of a
// ring.
struct Cylinder {
  double radius = 0, length = 0;
  Index around = 0, along = 0;
  double angle = 360;
};
Mesh cylinder(const Cylinder& shape);

// The upper half of a sphere about the origin without its cap, normal outward; the hole is the polar angle at
// which the cap is cut off. Nodes run around first, from the equator up. Sets as of a cylinder: bottom is the
// equator, top the edge of the hole.
struct Hemisphere {
  double radius = 0, hole = 18;
  Index around = 0, along = 0;
  double angle = 90;
};
Mesh hemisphere(const Hemisphere& shape);

}  // namespace fabricsh::mesh
