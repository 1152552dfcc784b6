// Contact where joints open and close: its surfaces are those of the leaders of joints. Crack faces that have
// just parted lie on each other, and how far they have been apart limits what contact does between them
// (contact/scene.hpp).
#include <algorithm>
#include <cmath>

#include "geometry/node_view.hpp"
#include "mechanics/terms/contact_schemes.hpp"

namespace fabricsh::mechanics {

ContactJoints::ContactJoints(const model::Model& model, const Cloth& cloth, const Dofs& dofs,
                             ContactState& state)
    : model_(model),
      cloth_(cloth),
      dofs_(dofs),
      joints_(dofs.joints()),
      state_(state),
      scene_(state.surfaces.scene()),
      nodes_(state.surfaces.nodes()),
      led_by_(joints_.leaders()) {
  find_masses();
}

// A point of contact has the mass of its joint.
void ContactJoints::find_masses() {
  inverse_mass_.assign(state_.x.size(), 0);
  std::vector<double> mass(nodes_, 0);
  for (std::size_t n = 0; n < nodes_; ++n)
    mass[state_.surfaces.point_of(static_cast<Index>(n))] += cloth_.mass()[n];
  for (std::size_t n = 0; n < nodes_; ++n) {
    const auto& eq = dofs_.freedoms().nodes[n].equation;
    const bool moves = std::any_of(eq.begin(), eq.begin() + 3, [](Index e) { return e >= 0 || e == tied; });
    if (moves && mass[n] > 0) inverse_mass_[n] = 1 / mass[n];
  }
  const bool cut = std::any_of(model_.all<model::Support>().begin(), model_.all<model::Support>().end(),
                               [](const auto& support) { return support.symmetry >= 0; });
  if (cut) planes_.assign(state_.x.size(), 0);
  for (const auto& support : model_.all<model::Support>())
    if (support.symmetry >= 0)
      for (const Index n : model_.mesh().set(support.set)) {
        const auto plane = static_cast<unsigned char>(1 << support.symmetry);
        if ((planes_[n] & plane) == 0) inverse_mass_[n] /= 2;
        planes_[n] |= plane;
      }
  for (std::size_t b = 0; b < state_.surfaces.bodies().count(); ++b) {
    const auto [first, last] = state_.surfaces.bodies().vertices(b);
    for (std::size_t v = first; v < last; ++v) {
      inverse_mass_[nodes_ + v] = state_.surfaces.bodies().readings().inverse_mass(b);
      if (cut) planes_[nodes_ + v] = state_.surfaces.bodies().readings().planes_through(b);
    }
  }
}

// The leaders of the joints that a triangle's element has at the places of its corners.
contact::Triangle ContactJoints::corners_of(const contact::TriangleRow& row) const {
  const mesh::Mesh& mesh = model_.mesh();
  const auto& element = mesh.elements[static_cast<std::size_t>(state_.surfaces.element_of(row))];
  contact::Triangle out = row.nodes;
  for (std::int32_t& corner : out)
    for (const Index n : element)
      if (n >= 0 && mesh.place_of(n) == mesh.place_of(corner)) {
        corner = static_cast<std::int32_t>(joints_.leader(n));
        break;
      }
  return out;
}

// How far the points have been apart from the others of their places, m: 0 where the joint has just become
// another; -1 where it is whole.
std::vector<double> ContactJoints::crack_faces() const {
  const mesh::Mesh& mesh = model_.mesh();
  std::vector<double> apart(state_.x.size(), -1);
  std::vector<char> changed(mesh.uncut().nodes.size(), 0), open = changed;
  for (Index n = 0; n < static_cast<Index>(nodes_); ++n) {
    if (joints_.leader(n) != led_by_[n]) changed[mesh.place_of(n)] = 1;
    if (mesh.place_of(n) == n && joints_.is_open(n)) open[n] = 1;
  }
  for (Index n = 0; n < static_cast<Index>(nodes_); ++n) {
    if (open[mesh.place_of(n)] == 0 || !joints_.leads(n)) continue;
    const bool known = changed[mesh.place_of(n)] == 0 && !scene_.neighbours().apart().empty();
    apart[n] = known ? scene_.neighbours().apart()[n] : 0;
  }
  return apart;
}

// As crack_faces(), of seams that have parted.
std::vector<double> ContactJoints::parted_faces() const {
  std::vector<double> apart(state_.x.size(), -1);
  const auto part = [&](Index n) {
    apart[n] = std::max(0.0, scene_.neighbours().apart(static_cast<std::int32_t>(n)));
  };
  for (std::size_t i = 0; i < dofs_.stitches().size(); ++i) {
    if (dofs_.sewn().parted[i] == 0) continue;
    part(dofs_.stitches()[i].node);
    for (const auto& lead : dofs_.stitches()[i].leads) part(lead.node);
  }
  return apart;
}

// The force on a joint that has opened goes to its parts as they have its area.
void ContactJoints::renumbered(Forces& forces) {
  if (!joints_.any()) {
    state_.pairs.scene_changed();
    find_masses();
    return set_apart(parted_faces());
  }
  const std::vector<Vec3> before = state_.force;
  std::vector<double> area(nodes_);
  for (std::size_t n = 0; n < nodes_; ++n) area[n] = scene_.area(static_cast<std::int32_t>(n));
  std::vector<double> apart = crack_faces();
  const std::vector<double> parted = parted_faces();
  for (std::size_t n = 0; n < apart.size(); ++n) apart[n] = std::max(apart[n], parted[n]);
  scene_ = scene_.with_corners([this](const contact::TriangleRow& row) { return corners_of(row); });
  for (std::size_t n = 0; n < nodes_; ++n) {
    const auto led = static_cast<std::size_t>(led_by_[n]);
    const double own = scene_.area(static_cast<std::int32_t>(n));
    if (led == n || !(own > 0) || before[led].isZero(0)) continue;
    const Vec3 moved = own / area[led] * before[led];
    state_.force[n] += moved;
    state_.force[led] -= moved;
    at(forces.on_x, static_cast<Index>(n)) -= moved;
    at(forces.on_x, static_cast<Index>(led)) += moved;
  }
  led_by_ = joints_.leaders();
  state_.pairs.scene_changed();
  find_masses();
  set_apart(std::move(apart));
}

void ContactJoints::set_apart(std::vector<double> apart) {
  scene_.neighbours().set_apart(std::move(apart));
  state_.pairs.apart_changed();
}

bool ContactJoints::follow_faces() {
  const auto young = [](double apart) { return apart >= 0 && std::isfinite(apart); };
  std::vector<double> apart = scene_.neighbours().apart();
  if (std::none_of(apart.begin(), apart.end(), young)) return false;
  state_.positions(state_.configuration.committed_kinematics(), 0, state_.x);
  if (!state_.pairs.widen(state_.x, apart)) return false;
  set_apart(std::move(apart));
  return true;
}

void ContactJoints::keep(Archive& archive) {
  if (!joints_.any() && dofs_.stitches().empty()) return;
  std::vector<double> apart = scene_.neighbours().apart();
  archive(apart);
  if (archive.reading()) set_apart(std::move(apart));
}

}  // namespace fabricsh::mechanics
