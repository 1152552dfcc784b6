// Changes of the joints: the unknowns are numbered anew, and what they were before is handed on.
#include <map>

#include "base/error.hpp"
#include "base/number.hpp"
#include "geometry/node_view.hpp"
#include "geometry/turning.hpp"
#include "mechanics/dofs.hpp"

namespace fabricsh::mechanics {

// Adds up what acts on the nodes of a joint, 3 numbers per node, at its leader; the others get none.
void Dofs::gather(std::span<double> on_nodes) const {
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n) {
    if (joints_.leads(n)) continue;
    at(on_nodes, joints_.leader(n)) += Vec3(at(on_nodes, n));
    at(on_nodes, n).setZero();
  }
}

std::vector<Dofs::Axes> Dofs::axes() const {
  std::vector<Axes> all;
  const Configuration& s = configuration_;
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n)
    all.push_back({at(s.b1(), n), Vec3(at(s.d(), n)).cross(Vec3(at(s.b1(), n)))});
  return all;
}

// Moves the nodes of joints that are closed, but apart, to their mean.
void Dofs::meet(double within, std::span<const double> mass, std::span<const double> rotary) {
  struct Mean {
    Vec3 x = Vec3::Zero(), d = Vec3::Zero();
    double mass = 0, rotary = 0;
  };
  const Configuration& now = configuration_;
  std::map<Index, Mean> means;  // by leader
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n) {
    const Index l = joints_.leader(n);
    if (at(now.x(), n) != at(now.x(), l) || at(now.d(), n) != at(now.d(), l) ||
        at(now.b1(), n) != at(now.b1(), l))
      means[l];
  }
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n) {
    const auto found = means.find(joints_.leader(n));
    if (found == means.end()) continue;
    const double apart = (at(now.x(), n) - at(now.x(), found->first)).norm();
    if (!(apart <= within))
      throw Error("nodes " + std::to_string(found->first + 1) + " and " + std::to_string(n + 1) +
                  " of a joint are " + fabricsh::number(apart) + " m apart: expected at most " +
                  fabricsh::number(within) + " m (field 'within')");
    found->second.x += mass[n] * at(now.x(), n);
    found->second.d += rotary[n] * at(now.d(), n);
    found->second.mass += mass[n];
    found->second.rotary += rotary[n];
  }
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n) {
    const Index l = joints_.leader(n);
    const auto found = means.find(l);
    if (found == means.end()) continue;
    const Mean& mean = found->second;
    at(configuration_.x(), n) = mean.x / mean.mass;
    const Vec3 d = mean.d.normalized();
    if (n == l) {  // comes first
      const Vec3 b1 = at(configuration_.b1(), n);
      at(configuration_.b1(), n) = (b1 - b1.dot(d) * d).normalized();
      at(configuration_.d(), n) = d;
      realign(n);
    }
    at(configuration_.d(), n) = at(configuration_.d(), l);
    at(configuration_.b1(), n) = at(configuration_.b1(), l);
  }
  if (!means.empty()) configuration_.touch();
}

Transfer Dofs::transfer(const std::vector<std::array<Index, 5>>& before, Index bodies_before,
                        const std::vector<Axes>& axes_before, std::span<const double> mass,
                        std::span<const double> rotary) const {
  std::vector<Index> from(freedoms_.unknowns, -1);  // the old unknown; -2: several
  for (std::size_t n = 0; n < before.size(); ++n)
    for (std::size_t c = 0; c < 5; ++c) {
      if (freedoms_.nodes[n].equation[c] < 0) continue;
      Index& old = from[freedoms_.nodes[n].equation[c]];
      old = old == -1 || old == before[n][c] ? before[n][c] : -2;
    }
  for (const RigidBody& body : freedoms_.bodies)
    for (Index i = 0; i < 6; ++i)
      from[body.equation + i] = bodies_before + body.equation - freedoms_.bodies.front().equation + i;
  const std::vector<Axes> axes_now = axes();
  std::map<Index, std::map<Index, double>> mixed;  // new unknown, old unknown, weight
  std::map<Index, double> whole;
  for (std::size_t n = 0; n < before.size(); ++n)
    for (std::size_t c = 0; c < 5; ++c) {
      const Index now = freedoms_.nodes[n].equation[c];
      if (now < 0 || from[now] != -2) continue;
      if (c < 3) {
        whole[now] += mass[n];
        mixed[now][before[n][c]] += mass[n];
        continue;
      }
      const Vec3 axis = c == 3 ? axes_now[n].q1 : axes_now[n].q2;
      whole[now] += rotary[n];
      if (before[n][3] >= 0) mixed[now][before[n][3]] += rotary[n] * axis.dot(axes_before[n].q1);
      if (before[n][4] >= 0) mixed[now][before[n][4]] += rotary[n] * axis.dot(axes_before[n].q2);
    }
  Transfer out;
  for (Index i = 0; i < freedoms_.unknowns; ++i) {
    std::vector<Transfer::WeightedUnknown> row;
    if (from[i] >= 0) row.push_back({from[i], 1});
    if (from[i] == -2)
      for (const auto& [old, weight] : mixed[i]) row.push_back({old, weight / whole[i]});
    out.add(row);
  }
  return out;
}

std::optional<Transfer> Dofs::open(std::vector<Joints::Edge> edges, std::span<const double> mass,
                                   std::span<const double> rotary, double within) {
  const std::vector<Joints::Edge> opened = joints_.opened();
  std::vector<std::array<Index, 5>> before;
  for (const NodeFreedoms& node : freedoms_.nodes) before.push_back(node.equation);
  const Index bodies = freedoms_.bodies.empty() ? 0 : freedoms_.bodies.front().equation;
  if (!joints_.set_opened(std::move(edges))) return {};
  const std::vector<Axes> axes_before = axes();
  try {
    meet(within, mass, rotary);
  } catch (const Error&) {
    joints_.set_opened(opened);
    throw;
  }
  number();
  return transfer(before, bodies, axes_before, mass, rotary);
}

bool Dofs::reopen(std::vector<Joints::Edge> edges) {
  if (!joints_.set_opened(std::move(edges))) return false;
  number();
  return true;
}

void Dofs::number() {
  freedoms_.number(joints_);
  find_plain_nodes();
  list_unknowns();
  list_led();
}

}  // namespace fabricsh::mechanics
