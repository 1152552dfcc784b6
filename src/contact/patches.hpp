// Patches of neighbouring facets in a tree of boxes: how far surfaces that are near have moved against each
// other. Near facets of a sheet move nearly alike, however fast the sheet folds up.
#pragma once
#include <span>
#include <vector>

#include "contact/scene.hpp"

namespace fabricsh::contact {

class Patches {
 public:
  explicit Patches(const Scene& scene);

  // m: a bound of |u_i - u_j|, where u is the way of a point between two states, for all points i and j of
  // any two shapes that meet and whose gap is below the law's gap plus `margin` (m) in the later state, `to`.
  double against(std::span<const Vec3> from, std::span<const Vec3> to, double margin);
  // Whether a wall turns on the way: then what is far from its three points moves more than they do.
  bool walls_turn(std::span<const Vec3> from, std::span<const Vec3> to) const;
  // m: the same bound for all shapes that may have met anywhere on the way.
  double against_on_way(std::span<const Vec3> from, std::span<const Vec3> to);

 private:
  struct Extent {
    Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
    void clear() { *this = {}; }
    void add(const Vec3& p);
    void add(const Extent& other);
  };
  struct Node {
    Extent place, way;                   // m, of all its points: positions, displacements
    std::int32_t left = -1, right = -1;  // -1: a leaf
    std::size_t first = 0, last = 0;     // of a leaf: its rows in points_
  };
  std::int32_t grow(std::span<std::int32_t> triangles);
  std::int32_t leaf(std::span<const std::int32_t> points);
  void measure(std::span<const Vec3> from, std::span<const Vec3> to, bool whole_way);
  double largest(std::span<const Vec3> from, std::span<const Vec3> to, double margin, bool whole_way);
  struct Wall {
    Vec3 place, normal;
  };
  struct Walls {
    Wall was, is;
    double turn;  // the length of the difference of the normals
    double reach;
    bool whole_way;
  };
  static Wall wall_of(const Surface& surface, std::span<const Vec3> x);
  void compare(std::int32_t first, const Walls& wall, double& most) const;
  void compare(std::int32_t a, std::int32_t b, double reach, double& most) const;

  const Scene* scene_;
  std::vector<Node> nodes_;         // parents before their children
  std::vector<std::int32_t> root_;  // of each surface
  std::vector<std::int32_t> points_;
};

}  // namespace fabricsh::contact
