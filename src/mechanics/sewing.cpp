#include "mechanics/sewing.hpp"

#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "mechanics/freedoms.hpp"

namespace fabricsh::mechanics {

namespace {

using model::Follower;
using model::Lead;
using model::Stitch;
using Equations = std::vector<std::array<Index, 5>>;
using Leads = std::vector<Lead>;

const char* const kNames[] = {"x", "y", "z", "rotation"};

[[noreturn]] void refuse(Index node, const std::string& what) {
  throw Error("seam: node " + std::to_string(node + 1) + " " + what);
}

// Which node follows which in one component: 0 to 2 a displacement, 3 the director.
class Component {
 public:
  Component(const std::vector<Stitch>& stitches, const Sewn& sewn, const Equations& free, int component)
      : free_(free), component_(component) {
    std::vector<const Stitch*> closed;
    for (std::size_t i = 0; i < stitches.size(); ++i)
      if (sewn.closed[i] != 0 && (component < 3 || sewn.turning[stitches[i].seam] != 0))
        closed.push_back(&stitches[i]);
    for (const Stitch* s : closed) {
      root(s->node);
      for (const Lead& lead : s->leads) root(lead.node);
      if (s->leads.size() == 1) unite(s->node, s->leads[0].node);
    }
    for (const auto& [node, above] : above_) choose(node);
    for (const Stitch* s : closed)
      if (s->leads.size() > 1) add_row(*s);
  }

  void add_followers(std::vector<Follower>& out) {
    for (const auto& [node, above] : above_) {
      if (is_fixed(node) || (leader(node) == node && !rows_.contains(node))) continue;
      out.push_back({node, component_, resolved({{node, 1}}), true});
    }
  }

 private:
  Index root(Index n) {
    Index& above = above_.try_emplace(n, n).first->second;
    return above == n ? n : above = root(above);
  }
  void unite(Index a, Index b) { above_[std::max(root(a), root(b))] = std::min(root(a), root(b)); }
  // How far supports hold it: not at all, a director about one axis, altogether.
  int hold(Index n) const {
    const auto& equation = free_[static_cast<std::size_t>(n)];
    if (component_ < 3) return equation[static_cast<std::size_t>(component_)] < 0 ? 2 : 0;
    return equation[3] < 0 ? 2 : equation[4] < 0 ? 1 : 0;
  }
  bool is_fixed(Index n) const { return hold(n) == 2; }
  void choose(Index n) {
    const auto [place, first] = leader_.try_emplace(root(n), n);
    if (!first && hold(n) > hold(place->second)) place->second = n;
  }
  Index leader(Index n) { return leader_.at(root(n)); }
  void add_row(const Stitch& stitch) {
    const Index follower = leader(stitch.node);
    for (const Lead& lead : stitch.leads)
      if (hold(leader(lead.node)) < hold(follower))
        refuse(follower, std::string("is held by a support in ") + kNames[component_] +
                             " and sewn between nodes " + std::to_string(stitch.leads[0].node + 1) + " and " +
                             std::to_string(stitch.leads[1].node + 1) +
                             ", which are not: expected the same support on both edges");
    if (is_fixed(follower)) return;
    if (!rows_.try_emplace(follower, stitch.leads).second)
      refuse(follower, "is sewn between the nodes of two other edges: expected one of them with more nodes");
  }
  // Replaces leads that follow others by their own leads, until none does.
  Leads resolved(const Leads& leads, int depth = 0) {
    if (depth > 100) refuse(leads.front().node, "is sewn in a circle");
    std::map<Index, double> sum;
    for (const Lead& lead : leads) {
      const Index at = leader(lead.node);
      const auto row = rows_.find(at);
      if (row == rows_.end()) {
        sum[at] += lead.weight;
        continue;
      }
      for (const Lead& further : resolved(row->second, depth + 1))
        sum[further.node] += lead.weight * further.weight;
    }
    Leads out;
    for (const auto& [node, weight] : sum) out.push_back({node, weight});
    return out;
  }

  const Equations& free_;
  int component_;
  std::map<Index, Index> above_, leader_;  // of each node one above it, or itself; of each root
  std::map<Index, Leads> rows_;            // of leaders
};

}  // namespace

std::vector<Follower> sewn_followers(const std::vector<Stitch>& stitches, const Sewn& sewn,
                                     const std::vector<NodeFreedoms>& nodes, const Equations& free) {
  const auto check = [&](Index n) {
    if (nodes[static_cast<std::size_t>(n)].oblique)
      refuse(n, "is held in an oblique frame and sewn: expected supports along x, y and z");
  };
  for (const Stitch& s : stitches) {
    check(s.node);
    for (const Lead& lead : s.leads) check(lead.node);
  }
  std::vector<Follower> all;
  for (int c = 0; c < 4; ++c) Component(stitches, sewn, free, c).add_followers(all);
  std::sort(all.begin(), all.end(), [](const Follower& a, const Follower& b) {
    return a.node != b.node ? a.node < b.node : a.component < b.component;
  });
  return all;
}

using mesh::Index;

namespace {
constexpr double kOnePiece = 0.5;  // cosine of the angle between normals up to which they become one
}

std::uint8_t SewnEdges::turning(const model::Seam& seam, std::size_t number) const {
  if (seam.hinge && *seam.hinge) return 0;
  const Index node = disagree(number);
  if (!seam.hinge) return node < 0 && continues(number) ? 1 : 0;
  if (node < 0) return 1;
  throw Error("seam " + seam.name() + ": field 'hinge': the normals of the edges at node " +
              std::to_string(node + 1) +
              " are more than 60 degrees apart: expected hinge=true, or edges whose normals agree");
}

Index SewnEdges::disagree(std::size_t seam) const {
  for (const model::Stitch& s : stitches) {
    if (s.seam != seam) continue;
    Vec3 other = Vec3::Zero();
    for (const model::Lead& lead : s.leads) other += lead.weight * director(lead.node);
    if (!(director(s.node).dot(other) >= kOnePiece * other.norm())) return s.node;
  }
  return -1;
}

bool SewnEdges::continues(std::size_t seam) const {
  std::map<Index, std::pair<Vec3, int>>
      middle;  // of the elements about each node: sum of corners, their count
  std::vector<const model::Stitch*> own;
  for (const auto& s : stitches) {
    if (s.seam != seam) continue;
    own.push_back(&s);
    middle.try_emplace(s.node, Vec3::Zero(), 0);
    for (const auto& lead : s.leads) middle.try_emplace(lead.node, Vec3::Zero(), 0);
  }
  for (const auto& e : mesh.elements)
    for (const Index n : e)
      if (const auto found = middle.find(n); n >= 0 && found != middle.end())
        for (const Index other : e)
          if (other >= 0) {
            found->second.first += place(other);
            ++found->second.second;
          }
  const auto inwards = [&](Index n) {
    const auto& [sum, count] = middle.at(n);
    return Vec3(sum / count - place(n));
  };
  double sum = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const Vec3 way = place(own[std::min(i + 1, own.size() - 1)]->node) - place(own[i > 0 ? i - 1 : 0]->node);
    const Vec3 along = way.norm() > 0 ? Vec3(way.normalized()) : Vec3(Vec3::Zero());
    Vec3 one = inwards(own[i]->node), other = Vec3::Zero();
    for (const auto& lead : own[i]->leads) other += lead.weight * inwards(lead.node);
    one -= one.dot(along) * along;
    other -= other.dot(along) * along;
    sum += one.dot(other);
  }
  return sum < 0;
}

}  // namespace fabricsh::mechanics
