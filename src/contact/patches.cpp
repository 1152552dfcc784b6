#include "contact/patches.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/shares.hpp"

namespace fabricsh::contact {
namespace {

constexpr double no_turn = 1e-13;  // of a normal: rounding
constexpr std::size_t patch = 32;  // largest number of triangles in a leaf

}  // namespace

void Patches::Extent::add(const Vec3& p) {
  low = low.cwiseMin(p);
  high = high.cwiseMax(p);
}

void Patches::Extent::add(const Extent& other) {
  low = low.cwiseMin(other.low);
  high = high.cwiseMax(other.high);
}

Patches::Patches(const Scene& scene) : scene_(&scene) {
  for (const Surface& surface : scene.surfaces()) {
    if (surface.triangles == 0) {
      root_.push_back(leaf(surface.points));
      continue;
    }
    std::vector<std::int32_t> triangles(std::size_t(surface.triangles));
    std::iota(triangles.begin(), triangles.end(), surface.first_triangle);
    root_.push_back(grow(triangles));
  }
}

std::int32_t Patches::leaf(std::span<const std::int32_t> points) {
  Node node;
  node.first = points_.size();
  points_.insert(points_.end(), points.begin(), points.end());
  node.last = points_.size();
  nodes_.push_back(node);
  return std::int32_t(nodes_.size()) - 1;
}

// Halves a set of triangles across its longest side in the reference until a patch is left.
std::int32_t Patches::grow(std::span<std::int32_t> triangles) {
  const auto middle = [&](std::int32_t t) {
    const Triangle& n = scene_->triangles()[std::size_t(t)].nodes;
    const auto& x = scene_->reference();
    return Vec3((x[std::size_t(n[0])] + x[std::size_t(n[1])] + x[std::size_t(n[2])]) / 3);
  };
  if (triangles.size() <= patch) {
    std::vector<std::int32_t> points;
    for (const std::int32_t t : triangles)
      for (const std::int32_t p : scene_->triangles()[std::size_t(t)].nodes) points.push_back(p);
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return leaf(points);
  }
  Extent box;
  for (const std::int32_t t : triangles) box.add(middle(t));
  Eigen::Index axis = 0;
  (box.high - box.low).maxCoeff(&axis);
  const auto half = triangles.size() / 2;
  std::nth_element(triangles.begin(), triangles.begin() + std::ptrdiff_t(half), triangles.end(),
                   [&](std::int32_t a, std::int32_t b) {
                     const double p = middle(a)[axis], q = middle(b)[axis];
                     return p != q ? p < q : a < b;
                   });
  const auto number = std::int32_t(nodes_.size());
  nodes_.emplace_back();
  const std::int32_t left = grow(triangles.first(half)), right = grow(triangles.subspan(half));
  nodes_[std::size_t(number)].left = left;
  nodes_[std::size_t(number)].right = right;
  return number;
}

void Patches::measure(std::span<const Vec3> from, std::span<const Vec3> to, bool whole_way) {
  for_each_index(nodes_.size(), points_.size() > 4096, [&](std::size_t i) {
    Node& node = nodes_[i];
    node.place.clear();
    node.way.clear();
    for (std::size_t k = node.first; k < node.last; ++k) {
      const auto p = std::size_t(points_[k]);
      node.place.add(to[p]);
      if (whole_way) node.place.add(from[p]);
      node.way.add(to[p] - from[p]);
    }
  });
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    Node& node = nodes_[i];
    if (node.left < 0) continue;
    for (const std::int32_t child : {node.left, node.right}) {
      node.place.add(nodes_[std::size_t(child)].place);
      node.way.add(nodes_[std::size_t(child)].way);
    }
  }
}

// Squares of the largest difference are compared, m2.
void Patches::compare(std::int32_t first, std::int32_t second, double reach, double& most) const {
  const Node &a = nodes_[std::size_t(first)], &b = nodes_[std::size_t(second)];
  for (int k = 0; k < 3; ++k)
    if (a.place.low[k] > b.place.high[k] + reach || b.place.low[k] > a.place.high[k] + reach) return;
  const Vec3 way = (a.way.high - b.way.low).cwiseMax(b.way.high - a.way.low);
  const double square = way.squaredNorm();
  if (square <= most) return;
  if (a.left < 0 && b.left < 0) {
    most = square;
    return;
  }
  if (first == second) {
    compare(a.left, a.left, reach, most);
    compare(a.right, a.right, reach, most);
    compare(a.left, a.right, reach, most);
    return;
  }
  const auto size = [](const Node& n) {
    return n.left < 0 ? -1 : (n.place.high - n.place.low).squaredNorm();
  };
  if (size(a) >= size(b)) {
    compare(a.left, second, reach, most);
    compare(a.right, second, reach, most);
  } else {
    compare(first, b.left, reach, most);
    compare(first, b.right, reach, most);
  }
}

Patches::Wall Patches::wall_of(const Surface& surface, std::span<const Vec3> x) {
  const auto v = std::size_t(surface.first_vertex);
  return {x[v], (x[v + 1] - x[v]).cross(x[v + 2] - x[v]).normalized()};
}

bool Patches::walls_turn(std::span<const Vec3> from, std::span<const Vec3> to) const {
  return std::any_of(scene_->surfaces().begin(), scene_->surfaces().end(), [&](const Surface& s) {
    return s.shape == Shape::wall && (wall_of(s, from).normal - wall_of(s, to).normal).norm() > no_turn;
  });
}

// A wall that turns moves farther the farther away a place is.
void Patches::compare(std::int32_t first, const Walls& wall, double& most) const {
  const Node& node = nodes_[std::size_t(first)];
  const Vec3 middle = (node.place.low + node.place.high) / 2, half = node.place.high - middle;
  const auto out_of_reach = [&](const Wall& w) {
    return w.normal.dot(middle - w.place) - w.normal.cwiseAbs().dot(half) > wall.reach;
  };
  if (out_of_reach(wall.is) && (!wall.whole_way || out_of_reach(wall.was))) return;
  const Vec3 moved = wall.is.place - wall.was.place;
  const double far =
                   std::max((middle - wall.is.place).norm(), (middle - wall.was.place).norm()) + half.norm(),
               way = (node.way.high - moved).cwiseMax(moved - node.way.low).norm() + wall.turn * far;
  if (way * way <= most) return;
  if (node.left < 0) {
    most = way * way;
    return;
  }
  compare(node.left, wall, most);
  compare(node.right, wall, most);
}

double Patches::largest(std::span<const Vec3> from, std::span<const Vec3> to, double margin, bool whole_way) {
  measure(from, to, whole_way);
  double most = 0;
  for (const Interaction& it : scene_->interactions()) {
    const Surface &a = scene_->surfaces()[std::size_t(it.first)],
                  &b = scene_->surfaces()[std::size_t(it.second)];
    const double reach = it.law.gap() + a.radius + b.radius + margin;
    if (b.shape == Shape::wall) {
      const Wall was = wall_of(b, from), is = wall_of(b, to);
      compare(root_[std::size_t(it.first)], {was, is, (is.normal - was.normal).norm(), reach, whole_way},
              most);
    } else {
      compare(root_[std::size_t(it.first)], root_[std::size_t(it.second)], reach, most);
    }
  }
  return std::sqrt(most);
}

double Patches::against(std::span<const Vec3> from, std::span<const Vec3> to, double margin) {
  return largest(from, to, margin, false);
}

double Patches::against_on_way(std::span<const Vec3> from, std::span<const Vec3> to) {
  return largest(from, to, 0, true);
}

}  // namespace fabricsh::contact
