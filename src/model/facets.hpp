// The facets of a rigid surface, from meshes as other programs write them.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "contact/intersect.hpp"
#include "geometry/vec.hpp"
#include "mesh/mesh.hpp"

namespace fabricsh::model {

struct Facets {
  std::vector<Vec3> vertices;                // m
  std::vector<contact::Triangle> triangles;  // counter-clockwise from outside
  bool closed = false;                       // whether the surface encloses a solid
};

// How many of the elements of a mesh were mended, for each way to do it.
struct Mended {
  std::size_t doubled = 0;    // left out: on the corners of another one, which would press twice
  std::size_t flat = 0;       // left out: without area
  std::size_t divided = 0;    // triangles: a corner of another one lies on their side
  std::size_t turned = 0;     // triangles of a closed surface, so that they look outwards
  std::string words() const;  // empty: none
};

// The quadrilaterals of each shape cut into triangles, as in the first one, whichever diagonal is the shorter
// in the others; they have the same elements. closed: the surface encloses a solid. Across edges that no two
// facets share the law of contact counts what they have in common twice, so nodes on free edges at one place
// in every shape are one vertex: where numbers of six digits are, within a hundredth of a short edge.
using Shapes = std::vector<std::shared_ptr<const mesh::Mesh>>;
std::vector<Facets> facets_of(const Shapes& shapes, bool closed, Mended* mended = nullptr);

// Where the law of contact counts a place of a surface more than once, within the reach of contact (m).
struct Crowding {
  double share = 0;            // of the area: facets with another sheet behind or, if not closed, before them
  double nearest = 0;          // m, of two such sheets
  Vec3 sheets = Vec3::Zero();  // m, a place of them
  double length = 0;           // m, of free edges with a facet in front of them that they are not joined to
  double beside = 0;           // the same times the reach, over the area
  double gap = 0;              // m, the smallest of these
  Vec3 edges = Vec3::Zero();   // m, a place of them
};
Crowding crowding(const Facets& facets, double reach);

}  // namespace fabricsh::model
