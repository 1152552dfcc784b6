#include "mechanics/freedoms.hpp"

#include <numbers>

namespace fabricsh::mechanics {

namespace {

constexpr double kNoShadow = 1e-8;  // a held axis at a smaller angle (its sine) to the director has no effect

Vec3 shadow(const Vec3& axis, const Vec3& d) { return axis - axis.dot(d) * d; }

// The number of director rotations that the held axes prevent: the rank of the axes' projections on the
// tangent plane.
int held_rotations(const std::vector<Vec3>& axes, const Vec3& d) {
  const Vec3 first = allowed_direction(axes, d);
  if (first.isZero()) return 0;
  for (const Vec3& axis : axes) {
    const Vec3 s = shadow(axis, d);
    if ((s - s.dot(first) * first).norm() > kNoShadow) return 2;
  }
  return 1;
}

struct HeldDirections {
  std::array<bool, 3> translation{};
  std::vector<Vec3> axes;
  bool rotation = false;
};

Index add_history(const model::History& history, Freedoms& f) {
  f.histories.push_back(history);
  return static_cast<Index>(f.histories.size()) - 1;
}

// The director of every node in the set becomes driven; with a centre, also its three displacements.
void add_turn(const model::PrescribedTurn& turn, const mesh::Mesh& mesh, Freedoms& f,
              std::vector<std::array<Index, 3>>& motion) {
  using FreedomKind = DrivenFreedom::FreedomKind;
  const Index angle = add_history(turn.angle, f);  // degrees
  for (const Index n : mesh.set(turn.set)) {
    NodeFreedoms& node = f.nodes[n];
    node.turn_axis = turn.axis;
    for (int c = 3; c < 5; ++c) {
      node.equation[c] = driven(static_cast<Index>(f.motions.size()));
      f.motions.push_back({n, c, angle, FreedomKind::angle});
    }
    if (!turn.centre) continue;
    const Vec3 arm = mesh.nodes[n] - *turn.centre;
    for (int i = 0; i < 3; ++i) {
      motion[n][i] = static_cast<Index>(f.motions.size());
      f.motions.push_back({n, i, angle, FreedomKind::arm, arm, turn.axis});
    }
  }
}

// Marks the degrees of freedom that follow others, and the nodes of rigid bodies.
void mark_ties(const model::Model& model, Freedoms& f) {
  auto ties = model::work_out_ties(model);
  for (const auto& follower : ties.followers) {
    auto& equation = f.nodes[follower.node].equation;
    equation[follower.component] = tied;
    if (follower.component == 3) equation[4] = tied;  // a director follows with both of its turns
  }
  f.followers = std::move(ties.followers);
  if (!ties.bodies.empty()) f.body_of.assign(f.nodes.size(), -1);
  for (auto& nodes : ties.bodies) {
    for (const Index n : nodes) {
      f.nodes[n].equation.fill(tied);
      f.body_of[n] = static_cast<Index>(f.bodies.size());
    }
    f.bodies.push_back({std::move(nodes)});
  }
}

}  // namespace

double DrivenFreedom::of(double value) const {
  if (kind == FreedomKind::displacement) return value;
  const double angle = value * std::numbers::pi / 180;
  if (kind == FreedomKind::angle) return angle;
  return (Eigen::AngleAxisd(angle, axis) * arm - arm)[component];
}

Vec3 allowed_direction(const std::vector<Vec3>& held_axes, const Vec3& d) {
  Vec3 best = Vec3::Zero();
  for (const Vec3& axis : held_axes) {
    const Vec3 s = shadow(axis, d);
    if (s.norm() > best.norm()) best = s;
  }
  return best.norm() > kNoShadow ? Vec3(best.normalized()) : Vec3(Vec3::Zero());
}

namespace {

// The axis (0 to 2) of the frame to which a symmetry support's plane is normal; -1: it is no such support.
int plane_normal(const model::FixedFreedoms& fixed) {
  if (fixed.rotation) return -1;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (fixed.translation[i] && !fixed.translation[j] && !fixed.translation[k] && !fixed.axis[i] &&
        fixed.axis[j] && fixed.axis[k])
      return i;
  }
  return -1;
}

}  // namespace

void lay_into_planes(const model::Model& model, std::vector<Vec3>& directors) {
  constexpr double kAcross = 1e-6;  // a shorter projection gives no direction
  std::vector<std::vector<Vec3>> normals(directors.size());
  for (const auto& support : model.all<model::Support>())
    if (const int i = plane_normal(support.fixed); i >= 0)
      for (const Index n : model.mesh().set(support.set))
        normals[n].push_back(support.frame.row(i).transpose());
  for (std::size_t n = 0; n < directors.size(); ++n) {
    Vec3 d = directors[n];
    std::vector<Vec3> crossed;  // normals found so far, orthonormal
    for (Vec3 normal : normals[n]) {
      for (const Vec3& e : crossed) normal -= normal.dot(e) * e;
      if (normal.norm() < kAcross) continue;
      crossed.push_back(normal.normalized());
      d -= d.dot(crossed.back()) * crossed.back();
    }
    if (d.norm() > kAcross) directors[n] = d.normalized();
  }
}

void Freedoms::number(const Joints& joints) {
  unknowns = 0;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const Index leader = joints.leader(static_cast<Index>(n));
    for (std::size_t c = 0; c < 5; ++c)
      if (Index& equation = nodes[n].equation[c]; equation >= 0)
        equation = leader == static_cast<Index>(n) ? unknowns++ : nodes[leader].equation[c];
  }
  for (RigidBody& body : bodies) {
    body.equation = unknowns;
    unknowns += 6;
  }
}

Freedoms number_freedoms(const model::Model& model, const std::vector<Vec3>& directors,
                         const Joints& joints) {
  const auto& mesh = model.mesh();
  Freedoms f;
  f.nodes.resize(mesh.nodes.size());
  std::vector<HeldDirections> holds(mesh.nodes.size());
  std::vector<std::array<Index, 3>> motion(mesh.nodes.size(), {-1, -1, -1});
  auto use_frame = [&](Index n, const Mat3& frame) {
    f.nodes[n].frame = frame;
    f.nodes[n].oblique = frame != Mat3::Identity();
  };
  for (const auto& support : model.all<model::Support>())
    for (const Index n : mesh.set(support.set)) {
      HeldDirections& h = holds[n];
      bool translates = false;
      for (int i = 0; i < 3; ++i) {
        h.translation[i] = h.translation[i] || support.fixed.translation[i];
        translates = translates || support.fixed.translation[i];
        if (support.fixed.axis[i]) h.axes.push_back(support.frame.row(i).transpose());
      }
      h.rotation = h.rotation || support.fixed.rotation;
      // For a node held along all three directions the frame has no effect.
      const bool whole =
          support.fixed.translation[0] && support.fixed.translation[1] && support.fixed.translation[2];
      if (translates && !whole) use_frame(n, support.frame);
      if (whole) h.translation = {true, true, true};
    }
  for (const auto& move : model.all<model::PrescribedMotion>()) {
    std::array<Index, 3> history{-1, -1, -1};
    for (int i = 0; i < 3; ++i)
      if (move.displacement[i]) history[i] = add_history(*move.displacement[i], f);
    for (const Index n : mesh.set(move.set)) {
      use_frame(n, move.frame);
      for (int i = 0; i < 3; ++i)
        if (history[i] >= 0) {
          motion[n][i] = static_cast<Index>(f.motions.size());
          f.motions.push_back({n, i, history[i]});
        }
    }
  }
  for (const auto& turn : model.all<model::PrescribedTurn>()) add_turn(turn, mesh, f, motion);
  mark_ties(model, f);
  for (std::size_t n = 0; n < f.nodes.size(); ++n) {
    auto& node = f.nodes[n];
    for (int i = 0; i < 3; ++i)
      if (node.equation[i] != tied)
        node.equation[i] = motion[n][i] >= 0 ? driven(motion[n][i]) : holds[n].translation[i] ? held : 0;
    if (node.turn_axis || node.equation[3] == tied) continue;
    const int lost = holds[n].rotation || model.membrane() ? 2 : held_rotations(holds[n].axes, directors[n]);
    if (lost == 1) node.held_axes = holds[n].axes;
    node.equation[3] = lost == 2 ? held : 0;
    node.equation[4] = lost >= 1 ? held : 0;
  }
  f.number(joints);
  return f;
}

}  // namespace fabricsh::mechanics
