// The mesh of a panel, which is a flat piece of cloth that an outline of lines and curves encloses.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mesh/curve.hpp"
#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

// A part of a closed line. Pieces of one name form an edge, which becomes a set of nodes.
struct OutlinePiece {
  PlaneCurve curve;
  std::string edge = {};  // empty: of no edge
  Index elements = 0;     // along the whole piece; 0: as many as the size of the panel gives
};
// Each piece starts where the one before it ends, the first where the last ends. Either direction.
using Loop = std::vector<OutlinePiece>;

// A wedge that is cut out of the panel, from a point of the outline to the tip and back to the outline.
// Points on the outline, also those of notches, may be off it by a hundredth of the size of the elements. Its
// sides become the edges name_in (towards the tip) and name_out, counter-clockwise around the panel.
struct Dart {
  std::string name;
  Vec2 from, tip, to;
};

// A place on an edge, which gets a node and the name of the notch.
struct Notch {
  std::string name, edge;            // edge may be empty if there is a point
  std::optional<double> at = {};     // m from the start of the edge as it was drawn
  std::optional<double> share = {};  // of its length
  std::optional<Vec2> point = {};    // on the outline or on the edge
};

struct Panel {
  Loop outline;
  std::vector<Loop> holes = {};
  std::vector<Dart> darts = {};
  std::vector<Notch> notches = {};
  double size = 0;   // of an element, m
  double grain = 0;  // direction of the warp, degrees counter-clockwise from +x
  // Direction of the rows of elements, degrees as above; none: along the grain, or along straight sides that
  // are oblique to it where that leaves less than half as many triangles.
  std::optional<double> rows = {};
  bool triangles = false;  // equilateral inside, instead of squares
  // Whether no element is a triangle. None: where neither rows nor triangles are asked for and a mesh with
  // triangles has rows oblique to the grain, or more than a twentieth of its area in triangles, unless
  // elements would become much narrower.
  std::optional<bool> quadrilaterals = {};
};

// A flat mesh in the x-y plane, normal +z. Inside: rows of squares that fit the panel's extent along and
// across them. Between them and the border: triangles, and quadrilaterals where two triangles form a good
// one; or, of quadrilaterals alone, such a mesh of twice the size cut at the middles of all sides, with the
// nodes near the border moved to better places. All border nodes lie on the curves. Numbers: first the nodes
// of the outline, counter-clockwise from its start (or from its end if it was drawn clockwise), then those of
// the holes, then row by row inside. The warp of each element is along the grain. Sets: the edges; of an edge
// that darts cut, also its parts NAME_1, NAME_2, ...; the notches; boundary, all. The mesh passes check().
// Errors name the field, the edge and the place: lines that are open, cross or touch; a hole or a tip
// outside; a notch or a dart off its edge; sizes; names taken twice.
Mesh panel(const Panel& shape);

// --- A flat mesh laid around a cylinder or a cone, with lengths kept.

// A cylinder, or with an angle a cone. The point `at` of the panel comes to lie at the distance `radius` from
// the axis, beside `from` in the direction `towards`; +y of the panel runs there along the axis, and +x
// around it counter-clockwise, so that the normal of the panel points outward.
struct Wrap {
  double radius = 0;          // m
  double angle = 0;           // between axis and surface, degrees, -90 to 90; positive: wider along the axis
  Vec3 from = Vec3::Zero();   // a point of the axis, m
  Vec3 axis = Vec3::UnitZ();  // any length but 0
  Vec3 towards = Vec3::Zero();  // zero: +x, or +y if the axis is along x, made square to the axis
  Vec2 at = Vec2::Zero();       // m, in the plane of the panel
  bool overlap = false;         // it may go around more than once
};

// Moves the nodes of a mesh in the x-y plane onto the surface. On a cone: what is at the distance s from the
// apex in the plane is at the distance s from the apex on the cone, and the angle about it grows by
// 1 / sin(angle); areas, lengths and angles stay. Errors, before any node is moved: a mesh that is not in the
// x-y plane, or in use; an axis without length, or along `towards`; the apex of the cone in the panel (or a
// panel that runs around it); more than 360 degrees without `overlap`; an element over more than 60 degrees.
void wrap(Mesh& mesh, const Wrap& shape);

}  // namespace fabricsh::mesh
