#include "model/ties.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "base/error.hpp"
#include "base/number.hpp"
#include "model/model.hpp"

namespace fabricsh::model {

namespace {

using Key = std::pair<mesh::Index, int>;  // node, component
const char* const kNames[] = {"x", "y", "z", "rotation"};
constexpr double kNear = 1e-6;  // of a set's size: positions closer than this are equal

[[noreturn]] void tie_clash(mesh::Index node, const std::string& what) {
  throw Error("model: node " + std::to_string(node + 1) + ": " + what);
}

// How supports, motions and rotations hold the degrees of freedom of each node, for messages.
class HeldFreedoms {
 public:
  explicit HeldFreedoms(const Model& model) {
    const auto& mesh = model.mesh();
    for (const auto& s : model.all<Support>())
      for (const auto n : mesh.set(s.set)) add_support(n, s);
    for (const auto& m : model.all<PrescribedMotion>())
      for (const auto n : mesh.set(m.set)) {
        add_frame(n, m.frame, m.set);
        for (int i = 0; i < 3; ++i)
          if (m.displacement[i]) add({n, i}, "moved (set '" + m.set + "')");
      }
    for (const auto& t : model.all<PrescribedTurn>())
      for (const auto n : mesh.set(t.set))
        for (int i = t.centre ? 0 : 3; i < 4; ++i) add({n, i}, "turned (set '" + t.set + "')");
  }
  void refuse(const Key& freedom, const std::string& tied) const {
    const std::string name = kNames[freedom.second];
    if (const auto held = held_.find(freedom); held != held_.end())
      tie_clash(freedom.first, name + " is tied (" + tied + ") and " + held->second);
    if (const auto framed = framed_.find(freedom.first); freedom.second < 3 && framed != framed_.end())
      tie_clash(freedom.first, name + " is tied (" + tied + ") and the node held in an oblique frame (set '" +
                                   framed->second + "')");
  }

 private:
  void add(const Key& freedom, const std::string& how) { held_.emplace(freedom, how); }
  void add_frame(mesh::Index node, const Mat3& frame, const std::string& set) {
    if (frame != Mat3::Identity()) framed_.emplace(node, set);
  }
  void add_support(mesh::Index node, const Support& s) {
    const auto& f = s.fixed;
    if (f.translation[0] || f.translation[1] || f.translation[2]) add_frame(node, s.frame, s.set);
    for (int i = 0; i < 3; ++i)
      if (f.translation[i]) add({node, i}, "fixed (set '" + s.set + "')");
    if (f.rotation || f.axis[0] || f.axis[1] || f.axis[2]) add({node, 3}, "fixed (set '" + s.set + "')");
  }
  std::map<Key, std::string> held_;
  std::map<mesh::Index, std::string> framed_;
};

std::string text(const Tie& tie) { return "set '" + (tie.partner.empty() ? tie.set : tie.partner) + "'"; }

double extent(const mesh::Mesh& mesh, const mesh::NodeSet& nodes) {
  Eigen::AlignedBox3d box;
  for (const auto n : nodes) box.extend(mesh.nodes[n]);
  return box.diagonal().norm();
}

Vec3 centroid(const mesh::Mesh& mesh, const mesh::NodeSet& nodes) {
  Vec3 sum = Vec3::Zero();
  for (const auto n : nodes) sum += mesh.nodes[n];
  return sum / static_cast<double>(nodes.size());
}

mesh::Index farthest(const mesh::Mesh& mesh, const mesh::NodeSet& nodes, const Vec3& from) {
  return *std::max_element(nodes.begin(), nodes.end(), [&](auto a, auto b) {
    return (mesh.nodes[a] - from).squaredNorm() < (mesh.nodes[b] - from).squaredNorm();
  });
}

std::string in_metres(double length) { return number(length) + " m"; }

// For each node of a the partner in b: the nearest one after translating the centroid of a to that of b.
mesh::NodeSet partners(const mesh::Mesh& mesh, const Tie& tie) {
  const auto &a = mesh.set(tie.set), &b = mesh.set(tie.partner);
  if (a.size() != b.size())
    throw Error("tie: sets '" + tie.set + "' and '" + tie.partner + "' have " + std::to_string(a.size()) +
                " and " + std::to_string(b.size()) + " nodes: they do not pair");
  const Vec3 shift = centroid(mesh, b) - centroid(mesh, a);
  const double near = kNear * std::max(extent(mesh, a), shift.norm());
  mesh::NodeSet found;
  std::set<mesh::Index> used(a.begin(), a.end());
  for (const auto n : a) {
    const Vec3 place = mesh.nodes[n] + shift;
    const auto best = *std::min_element(b.begin(), b.end(), [&](auto p, auto q) {
      return (mesh.nodes[p] - place).squaredNorm() < (mesh.nodes[q] - place).squaredNorm();
    });
    const double off = (mesh.nodes[best] - place).norm();
    if (!(off <= near))
      throw Error("tie: node " + std::to_string(n + 1) + " of set '" + tie.set + "' has no partner in set '" +
                  tie.partner + "': the nearest, node " + std::to_string(best + 1) + ", is " +
                  in_metres(off) + " off");
    if (!used.insert(best).second)
      throw Error("tie: node " + std::to_string(best + 1) + " of set '" + tie.partner +
                  "' is in both sets, or the partner of two nodes");
    found.push_back(best);
  }
  return found;
}

class Builder {
 public:
  explicit Builder(const Model& model) : mesh_(model.mesh()), holds_(model) {
    for (const auto& tie : model.all<Tie>()) {
      if (tie.kind == TieKind::rigid && !tie.partner.empty()) {  // to a rigid body, which moves by itself
        want_body(model.interactions(), tie.partner);
        take_along(tie);
        continue;
      }
      tied_ = text(tie);
      switch (tie.kind) {
        case TieKind::equal:
          equal(tie);
          break;
        case TieKind::straight:
          straight(tie);
          break;
        case TieKind::rigid:
          rigid(tie);
          break;
        case TieKind::periodic:
          periodic(tie);
          break;
      }
    }
    if (mesh_.hinged) join_sides();
  }

  Ties finish() {
    Ties ties;
    ties.bodies = std::move(bodies_);
    for (const auto& [freedom, leads] : first_) {
      Follower f{freedom.first, freedom.second, resolved(freedom.second, leads)};
      for (const auto& lead : f.leads)
        if (in_body_.contains(lead.node))
          tie_clash(lead.node, "is in a rigid set and leads node " + std::to_string(f.node + 1));
      ties.followers.push_back(std::move(f));
    }
    for (const auto& [freedom, leads] : again_)
      if (!same(resolved(freedom.second, leads), resolved(freedom.second, first_.at(freedom))))
        tie_clash(freedom.first, std::string(kNames[freedom.second]) + " is tied twice, in two ways");
    return ties;
  }

 private:
  using Leads = std::vector<Lead>;

  static void want_body(const Interactions& all, const std::string& name) {
    int found = 0;
    for (const RigidPointer& body : all.bodies()) found += body->name() == name ? 1 : 0;
    if (found == 1) return;
    if (found > 1)
      throw Error("tie: " + std::to_string(found) + " bodies have the name '" + name +
                  "': expected a body with a name of its own");
    throw Error(
        "tie: the body '" + name +
        "' neither touches anything nor closes gas: expected m:contact{between={it, ...}} or lids= of "
        "m:gas");
  }

  // Springs to two bodies would hold a node somewhere between them.
  void take_along(const Tie& tie) {
    for (const mesh::Index n : mesh_.set(tie.set))
      if (const auto [at, first] = with_body_.emplace(n, tie.partner); !first && at->second != tie.partner)
        throw Error("tie: node " + std::to_string(n + 1) + " of set '" + tie.set +
                    "' is tied to the bodies '" + at->second + "' and '" + tie.partner + "': expected one");
  }

  void follow(mesh::Index node, int component, Leads leads) {
    const Key freedom(node, component);
    holds_.refuse(freedom, tied_);
    if (in_body_.contains(node)) tie_clash(node, "is in a rigid set and tied (" + tied_ + ")");
    if (!first_.emplace(freedom, leads).second) again_.emplace_back(freedom, std::move(leads));
  }
  void equal(const Tie& tie) {
    const auto& nodes = mesh_.set(tie.set);
    for (std::size_t i = 1; i < nodes.size(); ++i)
      for (int c = 0; c < 3; ++c)
        if (tie.freedoms.translation[c]) follow(nodes[i], c, {{nodes[0], 1}});
  }
  void straight(const Tie& tie) {
    const auto& nodes = mesh_.set(tie.set);
    const auto a = farthest(mesh_, nodes, centroid(mesh_, nodes));
    const auto b = farthest(mesh_, nodes, mesh_.nodes[a]);
    const Vec3 line = mesh_.nodes[b] - mesh_.nodes[a];
    for (const auto n : nodes) {
      if (n == a || n == b) continue;
      const double s = (mesh_.nodes[n] - mesh_.nodes[a]).dot(line) / line.squaredNorm();
      const double off = (mesh_.nodes[n] - mesh_.nodes[a] - s * line).norm();
      if (!(off <= kNear * line.norm()))
        tie_clash(n, "set '" + tie.set + "' is not straight: the node is " + in_metres(off) +
                         " off the line between its ends");
      for (int c = 0; c < 3; ++c)
        if (tie.freedoms.translation[c]) follow(n, c, {{a, 1 - s}, {b, s}});
    }
  }
  void rigid(const Tie& tie) {
    const auto& nodes = mesh_.set(tie.set);
    for (const auto n : nodes) {
      for (int c = 0; c < 4; ++c) {
        holds_.refuse({n, c}, tied_);
        if (first_.contains({n, c})) tie_clash(n, "is in a rigid set (" + tied_ + ") and tied");
      }
      if (!in_body_.insert(n).second) tie_clash(n, "is in two rigid sets");
    }
    bodies_.push_back(nodes);
  }
  void periodic(const Tie& tie) {
    const auto& a = mesh_.set(tie.set);
    const auto b = partners(mesh_, tie);
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (int c = 0; c < 3 && i > 0; ++c)
        if (tie.freedoms.translation[c]) follow(b[i], c, {{a[i], 1}, {b[0], 1}, {a[0], -1}});
      if (tie.freedoms.rotation) follow(b[i], 3, {{a[i], 1}});
    }
  }
  // The sides of a hinge share their place, which supports may hold.
  void join_sides() {
    for (mesh::Index n = 0; n < static_cast<mesh::Index>(mesh_.nodes.size()); ++n)
      for (int c = 0; c < 3 && mesh_.place_of(n) != n && !in_body_.contains(n); ++c) {
        const Leads leads{{mesh_.place_of(n), 1}};
        if (!first_.emplace(Key(n, c), leads).second) again_.emplace_back(Key(n, c), leads);
      }
  }
  // Replaces leads that are followers themselves by their leads, until none is.
  Leads resolved(int component, const Leads& leads, int depth = 0) const {
    if (depth > 100) tie_clash(leads.front().node, std::string(kNames[component]) + " is tied in a circle");
    std::map<mesh::Index, double> sum;
    for (const auto& lead : leads) {
      const auto own = first_.find({lead.node, component});
      if (own == first_.end()) {
        sum[lead.node] += lead.weight;
        continue;
      }
      for (const auto& further : resolved(component, own->second, depth + 1))
        sum[further.node] += lead.weight * further.weight;
    }
    Leads out;
    for (const auto& [node, weight] : sum)
      if (weight != 0) out.push_back({node, weight});
    return out;
  }
  static bool same(const Leads& a, const Leads& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Lead& p, const Lead& q) {
      return p.node == q.node && std::abs(p.weight - q.weight) < 1e-9;
    });
  }

  const mesh::Mesh& mesh_;
  HeldFreedoms holds_;
  std::string tied_;  // the present tie, for messages
  std::map<Key, Leads> first_;
  std::vector<std::pair<Key, Leads>> again_;
  std::vector<mesh::NodeSet> bodies_;
  std::set<mesh::Index> in_body_;
  std::map<mesh::Index, std::string> with_body_;  // the rigid body that takes a node along
};

}  // namespace

Ties work_out_ties(const Model& model) {
  if (model.all<Tie>().empty() && !model.mesh().hinged) return {};
  return Builder(model).finish();
}

}  // namespace fabricsh::model
