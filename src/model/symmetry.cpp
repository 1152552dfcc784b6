// Planes of symmetry: whether the nodes lie in one, and the cloth is symmetric about it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/number.hpp"
#include "geometry/box.hpp"
#include "model/model.hpp"

namespace fabricsh::model {

namespace {

constexpr double kFlat = 1e-6;  // of the mesh's size, by which nodes of a plane may lie beside it

[[noreturn]] void refuse(const Support& support, const std::string& what) {
  throw Error("symmetry: set '" + support.set + "': " + what);
}

SymmetryPlane plane_of(const Model& model, const Support& support) {
  const auto& set = model.mesh().set(support.set);
  double low = model.mesh().nodes[static_cast<std::size_t>(set.front())][support.symmetry], high = low;
  for (const Index n : set) {
    const double x = model.mesh().nodes[static_cast<std::size_t>(n)][support.symmetry];
    low = std::min(low, x);
    high = std::max(high, x);
  }
  const std::string axis(1, "xyz"[support.symmetry]);
  if (high - low > kFlat * box_of(model.mesh().nodes).size().norm())
    refuse(support, "expected nodes in a plane normal to " + axis + ", got " + axis + " from " + number(low) +
                        " to " + number(high) + " m");
  return {support.symmetry, set.size() == 1 ? low : (low + high) / 2, support.set};
}

// The normal of the cloth at the plane, which lies in the plane; empty: the element lies in it.
std::optional<Vec3> normal_at(const Model& model, Index element, int axis) {
  const auto& e = model.mesh().elements[static_cast<std::size_t>(element)];
  const auto x = [&](int i) -> const Vec3& { return model.mesh().nodes[static_cast<std::size_t>(e[i])]; };
  Vec3 n = (x(e[3] < 0 ? 1 : 2) - x(0)).cross(x(e[3] < 0 ? 2 : 3) - x(e[3] < 0 ? 0 : 1)).normalized();
  n[axis] = 0;
  if (n.norm() < 1e-6) return {};
  return n.normalized();
}

// rad, from the warp to the plane's normal, about the normal of the cloth.
double angle_from_warp(const Vec3& warp, const Vec3& n, int axis) {
  const Vec3 along = (warp - warp.dot(n) * n).normalized(), across = n.cross(along);
  return std::atan2(across[axis], along[axis]);
}

std::string degrees_shown(double angle) {
  const double shown = std::abs(std::remainder(angle * 180 / std::numbers::pi, 180));
  return number(shown, 4) + " degrees";
}

// Where two nodes of the element lie in the set, the place between them; directions that are singular at a
// node are none there.
std::optional<Vec3> place_in(const mesh::Mesh& mesh, const mesh::NodeSet& set, std::size_t element) {
  std::optional<Vec3> first;
  for (const Index n : mesh.elements[element]) {
    if (n < 0 || !std::binary_search(set.begin(), set.end(), n)) continue;
    const Vec3& x = mesh.nodes[static_cast<std::size_t>(n)];
    if (first) return (*first + x) / 2;
    first = x;
  }
  return {};
}

void check_cloth(const Model& model, const Support& support) {
  const auto& mesh = model.mesh();
  const auto& set = mesh.set(support.set);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto element = static_cast<Index>(e);
    const auto place = place_in(mesh, set, e);
    if (!place) continue;
    const auto n = normal_at(model, element, support.symmetry);
    if (!n) continue;
    const Vec3 warp = model.warp_as_placed(element, *place, *n);
    const double angle = angle_from_warp(warp, *n, support.symmetry);
    const auto& section = model.sections()[static_cast<std::size_t>(model.region_of(element))];
    if (section::mirrored(section, angle)) continue;
    refuse(support, "the cloth of element " + model.element_name(element) +
                        " is not symmetric about the plane, whose normal lies at " + degrees_shown(angle) +
                        " to the warp" + (section.turned_plies() ? " of the layers" : "") +
                        ": expected warp and weft along and across the plane" +
                        (section.turned_plies() ? ", in each layer" : "") + "; or the whole model");
  }
}

}  // namespace

std::string SymmetryPlane::words() const {
  return "the plane of symmetry " + std::string(1, "xyz"[axis]) + " = " + number(at) + " m of set '" + set +
         "'";
}

std::vector<SymmetryPlane> symmetry_planes(const Model& model) {
  std::vector<SymmetryPlane> all;
  const double near = kFlat * box_of(model.mesh().nodes).size().norm();
  for (const Support& support : model.all<Support>()) {
    if (support.symmetry < 0) continue;
    SymmetryPlane plane = plane_of(model, support);
    if (std::none_of(all.begin(), all.end(), [&](const SymmetryPlane& other) {
          return other.axis == plane.axis && std::abs(other.at - plane.at) <= near;
        }))
      all.push_back(std::move(plane));
  }
  return all;
}

void check_symmetry(const Model& model) {
  for (const Support& support : model.all<Support>()) {
    if (support.symmetry < 0) continue;
    plane_of(model, support);
    check_cloth(model, support);
  }
}

}  // namespace fabricsh::model
