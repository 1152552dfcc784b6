// Contact where joints open and close: its surfaces are those of the leaders of joints. Crack faces that have
// just parted lie on each other, and how far they have been apart limits what contact does between them
// (contact/scene.hpp).
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "geometry/node_view.hpp"
#include "mechanics/terms/contact.hpp"

namespace fabricsh::mechanics {

// A point of contact has the mass of its joint.
void Contacts::find_masses() {
  inverse_mass_.assign(x_.size(), 0);
  std::vector<double> mass(nodes_, 0);
  for (std::size_t n = 0; n < nodes_; ++n)
    mass[model_.mesh().hinged ? model_.mesh().place_of(n) : joints_.leader(n)] += cloth_.mass()[n];
  for (std::size_t n = 0; n < nodes_; ++n) {
    const auto& eq = freedoms_.nodes[n].equation;
    const bool moves = std::any_of(eq.begin(), eq.begin() + 3, [](Index e) { return e >= 0 || e == tied; });
    if (moves && mass[n] > 0) inverse_mass_[n] = 1 / mass[n];
  }
  const bool cut = std::any_of(model_.all<model::Support>().begin(), model_.all<model::Support>().end(),
                               [](const auto& support) { return support.symmetry >= 0; });
  if (cut) planes_.assign(x_.size(), 0);
  for (const auto& support : model_.all<model::Support>())
    if (support.symmetry >= 0)
      for (const Index n : model_.mesh().set(support.set)) {
        const auto plane = static_cast<unsigned char>(1 << support.symmetry);
        if ((planes_[n] & plane) == 0) inverse_mass_[n] /= 2;
        planes_[n] |= plane;
      }
  for (std::size_t b = 0; b < bodies_.count(); ++b) {
    const auto [first, last] = bodies_.vertices(b);
    for (std::size_t v = first; v < last; ++v) {
      inverse_mass_[nodes_ + v] = bodies_.inverse_mass(b);
      if (cut) planes_[nodes_ + v] = bodies_.planes_through(b);
    }
  }
}

// The leaders of the joints that a triangle's element has at the places of its corners.
contact::Triangle Contacts::corners_of(const contact::TriangleRow& row) const {
  const mesh::Mesh& mesh = model_.mesh();
  const auto& element = mesh.elements[surfaces_.elements[row.surface][row.element]];
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
std::vector<double> Contacts::crack_faces() const {
  const mesh::Mesh& mesh = model_.mesh();
  std::vector<double> apart(x_.size(), -1);
  std::vector<char> changed(mesh.uncut().nodes.size(), 0), open = changed;
  for (Index n = 0; n < static_cast<Index>(nodes_); ++n) {
    if (joints_.leader(n) != led_by_[n]) changed[mesh.place_of(n)] = 1;
    if (mesh.place_of(n) == n && joints_.is_open(n)) open[n] = 1;
  }
  for (Index n = 0; n < static_cast<Index>(nodes_); ++n) {
    if (open[mesh.place_of(n)] == 0 || !joints_.leads(n)) continue;
    const bool known = changed[mesh.place_of(n)] == 0 && scene_.parts();
    apart[n] = known ? scene_.apart()[n] : 0;
  }
  return apart;
}

// The points that seams hold together. Where seams meet, as those of four panels under an arm, all nodes that
// become one joint are held together, also those that no stitch of their own connects.
void Contacts::sew_scene() {
  if (dofs_.stitches().empty()) return;
  std::vector<Index> first(nodes_);
  std::iota(first.begin(), first.end(), Index{0});
  const auto root = [&](Index n) {
    while (first[n] != n) n = first[n];
    return n;
  };
  for (const auto& stitch : dofs_.stitches())
    if (stitch.leads.size() == 1) {
      const Index a = root(stitch.node), b = root(stitch.leads[0].node);
      first[std::max(a, b)] = std::min(a, b);
    }
  std::map<Index, std::vector<Index>> joints;
  for (const auto& stitch : dofs_.stitches()) {
    joints[root(stitch.node)].push_back(stitch.node);
    for (const auto& lead : stitch.leads) joints[root(lead.node)].push_back(lead.node);
  }
  std::vector<std::set<std::int32_t>> partners(nodes_);
  for (const auto& stitch : dofs_.stitches())
    for (const auto& lead : stitch.leads)
      for (const Index a : joints[root(stitch.node)])
        for (const Index b : joints[root(lead.node)]) {
          if (a == b) continue;
          partners[a].insert(static_cast<std::int32_t>(b));
          partners[b].insert(static_cast<std::int32_t>(a));
        }
  std::vector<std::vector<std::int32_t>> sorted;
  for (const auto& of_node : partners) sorted.emplace_back(of_node.begin(), of_node.end());
  scene_.sew(std::move(sorted));
}

// As crack_faces(), of seams that have parted.
std::vector<double> Contacts::parted_faces() const {
  std::vector<double> apart(x_.size(), -1);
  const auto part = [&](Index n) { apart[n] = std::max(0.0, scene_.apart(static_cast<std::int32_t>(n))); };
  for (std::size_t i = 0; i < dofs_.stitches().size(); ++i) {
    if (dofs_.sewn().parted[i] == 0) continue;
    part(dofs_.stitches()[i].node);
    for (const auto& lead : dofs_.stitches()[i].leads) part(lead.node);
  }
  return apart;
}

// The force on a joint that has opened goes to its parts as they have its area.
void Contacts::renumbered(Forces& forces) {
  if (!joints_.any()) {
    contact_->scene_changed();
    find_masses();
    return set_apart(parted_faces());
  }
  const std::vector<Vec3> before = force_;
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
    force_[n] += moved;
    force_[led] -= moved;
    at(forces.on_x, static_cast<Index>(n)) -= moved;
    at(forces.on_x, static_cast<Index>(led)) += moved;
  }
  led_by_ = joints_.leaders();
  contact_->scene_changed();
  find_masses();
  set_apart(std::move(apart));
}

void Contacts::set_apart(std::vector<double> apart) {
  scene_.set_apart(std::move(apart));
  contact_->apart_changed();
  reading_.version = 0;
}

// At a commit.
void Contacts::follow_faces() {
  const auto young = [](double apart) { return apart >= 0 && std::isfinite(apart); };
  if (std::none_of(scene_.apart().begin(), scene_.apart().end(), young)) return;
  positions(configuration_.committed_kinematics(), 0, x_);
  std::vector<double> apart = scene_.apart();
  if (contact_->widen(x_, apart)) set_apart(std::move(apart));
}

}  // namespace fabricsh::mechanics
