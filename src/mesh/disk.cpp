#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "mesh/generators.hpp"
#include "mesh/lattice.hpp"

namespace fabricsh::mesh {

namespace {

// The core is a square whose sides bulge towards the circle through its corners. Its
// corners lie at core_size of the radius; bulge = 1 would give that circle itself.
// Both numbers were chosen by trial for the best worst angle of all elements.
constexpr double core_size = 0.58;
constexpr double bulge = 0.35;

// Maps the square [-1, 1]^2 onto the unit disk: equal steps along a side become equal angles on the circle.
Vec3 round(double u, double v) {
  const double a = std::numbers::pi / 4 * u, b = std::numbers::pi / 4 * v;
  return std::numbers::sqrt2 * Vec3(std::sin(a) * std::cos(b), std::cos(a) * std::sin(b), 0);
}

Vec3 core(double u, double v) {
  return core_size * ((1 - bulge) / std::numbers::sqrt2 * Vec3(u, v, 0) + bulge * round(u, v));
}

// Position (i, j) in the core of the k-th node of its border, counter-clockwise from (0, 0).
std::array<Index, 2> border(Index k, Index cells) {
  const Index along = k % cells;
  switch (k / cells % 4) {
    case 0:
      return {along, 0};
    case 1:
      return {cells, along};
    case 2:
      return {cells - along, cells};
    default:
      return {0, cells - along};
  }
}

double unit(Index i, Index cells) { return static_cast<double>(2 * i - cells) / static_cast<double>(cells); }

void add_rings(Mesh& mesh, const Disk& shape, const Lattice& square) {
  const Index n = shape.cells, around = 4 * n, first = static_cast<Index>(mesh.nodes.size());
  const auto node = [&](Index k, Index ring) {
    const auto at = border(k, n);
    return ring == 0 ? square.node(at[0], at[1]) : first + (ring - 1) * around + k % around;
  };
  for (Index ring = 1; ring <= shape.rings; ++ring)
    for (Index k = 0; k < around; ++k) {
      const double t = static_cast<double>(ring) / static_cast<double>(shape.rings);
      const auto at = border(k, n);
      const Vec3 inside = core(unit(at[0], n), unit(at[1], n));
      const Vec3 rim = direction(225 + 90 * (static_cast<double>(k) / static_cast<double>(n)));
      mesh.nodes.push_back(shape.radius * ((1 - t) * inside + t * rim));
    }
  for (Index ring = 0; ring < shape.rings; ++ring)
    for (Index k = 0; k < around; ++k)
      mesh.elements.push_back({node(k, ring), node(k, ring + 1), node(k + 1, ring + 1), node(k + 1, ring)});
}

NodeSet run(Index first, Index end) {
  NodeSet ids(static_cast<std::size_t>(end - first));
  std::iota(ids.begin(), ids.end(), first);
  return ids;
}

}  // namespace

Mesh disk(const Disk& asked) {
  Disk shape = asked;
  check_length("disk", "radius", shape.radius);
  check_count("disk", "cells", shape.cells);
  if (shape.rings == 0) shape.rings = (shape.cells + 1) / 2;
  check_count("disk", "rings", shape.rings);
  check_product("disk", "cells * (cells + 4 * rings)", shape.cells, shape.cells + 4 * shape.rings);
  const Lattice square{shape.cells, shape.cells};
  Mesh mesh =
      fill(square, [&](double s, double t) -> Vec3 { return shape.radius * core(2 * s - 1, 2 * t - 1); });
  const Index inside = static_cast<Index>(mesh.nodes.size());
  add_rings(mesh, shape, square);
  const Index count = static_cast<Index>(mesh.nodes.size());
  mesh.sets = {
      {"all", run(0, count)}, {"core", run(0, inside)}, {"boundary", run(count - 4 * shape.cells, count)}};
  if (shape.cells % 2 == 0) mesh.define("centre", {square.node(shape.cells / 2, shape.cells / 2)});
  mesh.flat = true;
  mesh.origin = "disk " + std::to_string(shape.cells) + "+" + std::to_string(shape.rings);
  return mesh;
}

}  // namespace fabricsh::mesh
