#include "run/folds.hpp"

#include <cmath>
#include <numbers>

#include "geometry/node_view.hpp"
#include "mesh/corners.hpp"
#include "mesh/edges.hpp"

namespace fabricsh::run {

namespace {

constexpr double kSharp = 40 * std::numbers::pi / 180;  // an arc of 180 degrees has five elements at least

// m^2: the normal of an element times its area.
Vec3 area_vector(const std::array<mesh::Index, 4>& e, std::span<const double> x) {
  const mesh::Index last = e[3] < 0 ? e[0] : e[3];
  return 0.5 * (at(x, e[2]) - at(x, e[0])).cross(at(x, last) - at(x, e[1]));
}

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace

Folds::Folds(const mesh::Mesh& mesh) : mesh_(mesh) {
  for_each_edge(edges(mesh.uncut()), [&](const mesh::Edge* begin, const mesh::Edge* end) {
    if (end - begin != 2 || begin[0].forward == begin[1].forward) return;
    Hinge h{begin[0].element, begin[1].element, {}, {}};
    const mesh::Index places[] = {begin->first, begin->second};
    for (int i = 0; i < 2; ++i) {
      h.ends[i] = mesh::node_at(mesh, h.element, places[i]);
      h.other_ends[i] = mesh::node_at(mesh, h.other, places[i]);
    }
    hinges_.push_back(h);
  });
}

std::optional<Folds::Fold> Folds::sharpest(std::span<const double> x,
                                           const mechanics::ContactReadings& contacts) const {
  std::optional<Fold> found;
  for (const Hinge& h : hinges_) {
    const Vec3 one = area_vector(mesh_.elements[static_cast<std::size_t>(h.element)], x),
               two = area_vector(mesh_.elements[static_cast<std::size_t>(h.other)], x);
    const double angle = angle_between(one, two);
    if (!(angle > (found ? found->angle : kSharp))) continue;
    if (at(x, h.ends[0]) != at(x, h.other_ends[0]) || at(x, h.ends[1]) != at(x, h.other_ends[1])) continue;
    if (!(contacts.pressure(h.ends[0]) > 0) || !(contacts.pressure(h.ends[1]) > 0)) continue;
    const double width = (at(x, h.ends[1]) - at(x, h.ends[0])).norm();
    found = Fold{h.element, h.other, angle, 0.5 * (at(x, h.ends[0]) + at(x, h.ends[1])),
                 0.5 * (one.norm() + two.norm()) / width};
  }
  return found;
}

}  // namespace fabricsh::run
