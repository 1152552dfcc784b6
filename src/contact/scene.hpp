// The surfaces that may touch: cloth, solids of triangles, balls, rods and walls, stored as
// points, edges and triangles with common numbering; and which of them meet under which law.
//
// Points: first the nodes of the cloth in the model's numbering, then the vertices of rigid shapes.
// A ball is one point with a radius, a rod a segment with a radius, a wall three points of its
// plane, a solid a set of triangles with a radius (for a rounded disc; may be 0). Rigid shapes are
// moved by moving their vertices, and the force on a shape is the sum of the forces on its vertices.
//
// The weights of facets, edges and corners are explained in share/doc/contact.md.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "contact/intersect.hpp"
#include "contact/law.hpp"
#include "contact/pair.hpp"
#include "mesh/mesh.hpp"

namespace fabricsh::contact {

// --- Which points of the cloth count as neighbours, beside those of one element: they touch later, or never.

class Neighbours {
 public:
  // The first point of the sheet of a point: sheets are what elements connect.
  std::int32_t sheet(std::int32_t point) const { return sheet_[std::size_t(point)]; }
  bool same_sheet(std::int32_t a, std::int32_t b) const { return sheet(a) == sheet(b); }

  // Crack faces: points that were one with others of their place until a joint opened. For each point how far
  // it has been from all that it was near to, m; -1: it is no crack face. Between crack faces the law's
  // lengths are at most 0.9 of the least of these, so that nothing is pressed when they part, and nothing
  // gets through later. Empty: there are no crack faces.
  void set_apart(std::vector<double> apart) {
    const bool any = std::any_of(apart.begin(), apart.end(), [](double a) { return a >= 0; });
    apart_ = any ? std::move(apart) : std::vector<double>();
  }
  const std::vector<double>& apart() const { return apart_; }
  double apart(std::int32_t point) const { return apart_.empty() ? -1 : apart_[std::size_t(point)]; }

  // Points that seams hold together: of each point those that it is sewn to, ascending. Pairs of such points
  // do not touch, wherever they are in the reference, unless both are crack faces. Empty: there are no seams.
  void sew(std::vector<std::vector<std::int32_t>> partners) { partners_ = std::move(partners); }
  bool is_sewn(std::int32_t point) const {
    return std::size_t(point) < partners_.size() && !partners_[std::size_t(point)].empty();
  }
  bool are_sewn(std::int32_t a, std::int32_t b) const {
    return is_sewn(a) &&
           std::binary_search(partners_[std::size_t(a)].begin(), partners_[std::size_t(a)].end(), b);
  }

 private:
  friend class Scene;                // which finds the sheets
  std::vector<std::int32_t> sheet_;  // of each point
  std::vector<double> apart_;
  std::vector<std::vector<std::int32_t>> partners_;
};

// Quadrilaterals cut along the shorter reference diagonal, and triangles as they are, oriented as the
// elements. Of equal diagonals, in a flat sheet with a centre, that which does not point there, so that
// elements at mirrored places about it have mirrored diagonals, as in a quarter of a symmetric sheet and the
// whole one; else by the parity of the element's number. `element[i]` is the element of triangle i.
struct Split {
  std::vector<Triangle> triangles;
  std::vector<std::int32_t> element;
};
Split split(std::span<const Vec3> nodes, std::span<const std::array<mesh::Index, 4>> elements,
            const std::optional<Vec3>& centre = {});

enum class Shape : std::uint8_t { cloth, solid, ball, rod, wall };

struct Surface {
  Shape shape = Shape::cloth;
  double radius = 0;                               // m
  std::int32_t first_vertex = 0, vertices = 0;     // of a rigid shape
  std::int32_t followers = 0;                      // points after them that move with it and touch nothing
  std::int32_t first_edge = 0, edges = 0;          // rows of Scene::edges
  std::int32_t first_triangle = 0, triangles = 0;  // rows of Scene::triangles
  std::vector<std::int32_t> points;                // ascending; of a solid without those inside flat parts
  double mean_area = 0;                            // m2 per point
  bool changes_shape = false;                      // a solid whose vertices move against each other
};

struct EdgeRow {
  std::int32_t a = 0, b = 0, surface = 0;
  double length = 0;  // m, reference
  double area = 0;    // m2: a third of the area of its triangles
  // Between two facets of a solid in one plane. Nothing crosses it that does not pass through a facet or an
  // edge at the rim of this plane, and cloth on it is pressed by its nodes alone.
  bool inside_flat = false;
};

struct TriangleRow {
  Triangle nodes{};
  std::int32_t surface = 0, element = 0;
  double area = 0;                         // m2, reference
  std::array<std::int32_t, 3> edge_row{};  // opposite to each corner
  std::array<std::int8_t, 3> edge{},
      corner{};  // weights of the edges and corners that are stored in this triangle
  // Those that all their triangles share, so that any of them may store the weight, -1 of an edge and 1 of a
  // corner: a bit for each edge, then for each corner.
  std::uint8_t shared = 0;
};

// Pa, presses woven cloth down to its fibres.
inline constexpr double dense_pressure = 1e6;
// Pa/m: of a contact with that pressure where its range, from gap to floor (m), is used up.
inline double dense_stiffness(double gap, double floor) { return dense_pressure / (gap - floor); }

struct Interaction {
  std::int32_t first = 0, second = 0;  // surfaces; equal for a cloth in contact with itself
  ContactLaw law;
  double friction = 0;
  double sticking = 0;  // static friction, at least `friction`, which is that of what slides
  double loss = 0;      // sqrt(kg)/m: 2 zeta sqrt(areal mass), where zeta is the share of critical damping
  bool rigid = false;   // neither is cloth
  Film film = {};       // between them
  // Friction across the warp of the first surface, a cloth; `friction` is then that along it. Below 0: it is
  // the same in all directions.
  double across = -1;
  // The warp of each triangle of the scene as a sum of its first two sides, those from its first corner: it
  // follows them. Empty without friction by direction.
  std::vector<std::array<double, 2>> warp = {};
  bool cloths = false;  // both are cloth
  // In explicit steps the guard is met by more inertia of what it presses, and not by shorter steps. Its
  // second surface is then a cloth, or one whose motion is given.
  bool eased = false;
  bool rubs() const { return sticking > 0 || loss > 0 || film.viscous > 0; }
  // Contact points inside the facets of the first surface, a cloth, on the second, a ball or a rod: each of
  // its triangles is divided into parts[i]^2 of equal area, and has a point in the middle of each. 0: it has
  // none, and its nodes and edges take part. Empty: no triangle has any. Set by Scene::spread.
  std::vector<std::int8_t> parts = {};
  // The share of the law's lengths from which on vertices of the second surface, a solid, press the facets of
  // the first, and edges each other. Below 1: nodes stand so close for what they are pressed into that they
  // carry the law, and the others keep what is between them apart.
  double guarded = 1;
  // Opening of overlaps at the start: for each point the share, 0 to 1, of the law's lengths with which it
  // begins; two edges begin with the smallest share of their ends, and sheets of one surface that share no
  // node do not count as neighbours. Empty: nothing is opened.
  std::vector<double> opening = {};
};

// A contact point inside a triangle: its corners, and the weight of each as a share of the sum of all three.
struct Spot {
  std::array<std::int32_t, 3> node{-1, -1, -1};
  std::array<std::int16_t, 3> part{};
  bool any() const { return node[0] >= 0; }
  double weight(std::size_t k) const { return part[k] / double(part[0] + part[1] + part[2]); }
  Vec3 of(std::span<const Vec3> x) const {
    return weight(0) * x[std::size_t(node[0])] + weight(1) * x[std::size_t(node[1])] +
           weight(2) * x[std::size_t(node[2])];
  }
};

// The numbers of contact points inside triangles: they follow those of all other points.
class Spots {
 public:
  static constexpr int most_parts = 64;  // a triangle
  Spots(std::size_t points, std::int32_t each, std::span<const TriangleRow> triangles)
      : first_(std::int32_t(points)), each_(each), triangles_(triangles) {}
  // Point `k` of the parts^2 of a triangle, and its number.
  Spot at(std::int32_t triangle, int parts, int k) const;
  std::int32_t number(std::int32_t triangle, int k) const { return first_ + triangle * each_ + k; }
  bool is(std::int32_t point) const { return point >= first_; }
  std::int32_t triangle_of(std::int32_t point) const { return (point - first_) / each_; }
  // The points of a pair, with the corners of its triangle in place of a contact point inside it.
  std::array<std::int32_t, 4> with_nodes(const std::array<std::int32_t, 4>& points) const;

 private:
  std::int32_t first_, each_;
  std::span<const TriangleRow> triangles_;
};

// Whether rigid shapes meet each other: a ball anything but cloth, a rod a ball or a wall.
bool can_meet(Shape first, Shape second);

class Scene {
 public:
  // `nodes`: reference positions of all nodes of the model, m.
  explicit Scene(std::vector<Vec3> nodes);

  // Each returns the number of the surface. Errors: an unknown node, a triangle without area, a radius that
  // is not positive and finite (that of a solid may be 0), a wall with a zero normal, a rod without length.
  int add_cloth(std::span<const std::array<mesh::Index, 4>> elements, const std::optional<Vec3>& centre = {});
  int add_solid(std::span<const Vec3> vertices, std::span<const Triangle> triangles, double radius,
                bool changes_shape = false);
  int add_ball(const Vec3& centre, double radius);
  int add_rod(const Vec3& from, const Vec3& to, double radius);
  int add_wall(const Vec3& point, const Vec3& normal);
  // Points that move with the last surface, which is rigid, and touch nothing.
  void add_followers(std::span<const Vec3> points);

  // Declares that two surfaces meet under a law. Of two rigid ones the law is one of force (N) and not of
  // pressure: they begin to press where their surfaces touch, and its gap is how deep they come at most.
  // Errors: unknown surfaces, two rigid ones with friction or of shapes that do not meet (can_meet), friction
  // or a loss that is negative or not finite, a pair declared already.
  void meet(int first, int second, const ContactLaw& law, double friction, double loss = 0,
            std::optional<double> sticking = {});
  // For another law; of another gap only before a Contact searches the scene.
  Interaction& interaction(std::size_t number) { return interactions_[number]; }
  // Sets Interaction::parts.
  void spread(std::size_t interaction, std::vector<std::int8_t> parts);
  Spots spots() const { return {reference_.size(), spots_, triangles_}; }

  // The same scene with other nodes at the corners of the triangles of cloth, which lie at the same places.
  Scene with_corners(const std::function<Triangle(const TriangleRow&)>& corners) const;
  Neighbours& neighbours() { return neighbours_; }
  const Neighbours& neighbours() const { return neighbours_; }

  const std::vector<Vec3>& reference() const { return reference_; }
  std::size_t nodes() const { return nodes_; }  // of the cloth; the rigid vertices follow them
  const std::vector<Surface>& surfaces() const { return surfaces_; }
  const std::vector<EdgeRow>& edges() const { return edges_; }
  const std::vector<TriangleRow>& triangles() const { return triangles_; }
  double area(std::int32_t point) const { return area_[std::size_t(point)]; }  // m2
  const std::vector<Interaction>& interactions() const { return interactions_; }
  // The interaction of two surfaces, or null.
  const Interaction* between(std::int32_t first, std::int32_t second) const;
  int interaction_number(std::int32_t first, std::int32_t second) const;
  std::span<const std::int32_t> triangles_at_edge(std::int32_t edge) const {
    return at_edge_[std::size_t(edge)];
  }
  std::span<const std::int32_t> triangles_at_point(std::int32_t point) const {
    return at_point_[std::size_t(point)];
  }

 private:
  int add_triangles(Surface surface, std::span<const Triangle> triangles,
                    std::span<const std::int32_t> element);
  int add_rigid(Surface surface, std::span<const Vec3> vertices);
  void share_areas(const Surface& surface, std::span<const std::int32_t> element);
  void add_edges(Surface& surface);
  void count_places(const Surface& surface);
  void find_sheets(const Surface& surface);
  void find_flat_parts(Surface& surface);
  std::size_t nodes_ = 0;
  std::vector<Vec3> reference_;
  std::vector<double> area_;
  Neighbours neighbours_;
  std::vector<Surface> surfaces_;
  std::vector<EdgeRow> edges_;
  std::vector<TriangleRow> triangles_;
  std::vector<std::vector<std::int32_t>> at_edge_, at_point_;
  std::vector<Interaction> interactions_;
  std::int32_t spots_ = 1;  // at most in a triangle
};

// Adds a flat disc with a rounded edge, as a solid: `radius` (m) is the outer radius, `edge` (m) that of the
// rounding, `sides` the number of sides of the polygon that approximates the circle.
int add_disc(Scene& scene, const Vec3& centre, const Vec3& normal, double radius, double edge,
             int sides = 128);

// The direction of the warp at a pair: that of the first triangle at the pair's first point on the cloth.
Vec3 warp_at(const Scene& scene, const Interaction& it, const std::array<std::int32_t, 4>& points,
             std::span<const Vec3> x);

}  // namespace fabricsh::contact
