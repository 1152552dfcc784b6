#include "mechanics/joints.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "mechanics/mesh_tools.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kOnLine = 0.01;  // of an edge's length: how far from a line its ends may be

double distance_to(const Vec3& x, const Vec3& a, const Vec3& b) {
  const Vec3 way = b - a;
  const double length2 = way.squaredNorm();
  const double s = length2 > 0 ? std::clamp((x - a).dot(way) / length2, 0.0, 1.0) : 0.0;
  return (x - a - s * way).norm();
}

}  // namespace

Joints::Joints(const mesh::Mesh& mesh) : mesh_(mesh) {
  if (!mesh.whole || mesh.hinged) return;
  std::vector<char> several(mesh.whole->nodes.size(), 0);
  for (std::size_t n = several.size(); n < mesh.nodes.size(); ++n)
    several[static_cast<std::size_t>(mesh.place[n])] = 1;
  std::map<Edge, std::set<Edge>> sides;  // of each edge: the nodes at its ends, side by side
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto& element = mesh.elements[e];
    const auto n = static_cast<std::size_t>(corners(element));
    for (std::size_t a = 0; a < n; ++a) {
      Index i = element[a], j = element[(a + 1) % n];
      if (several[static_cast<std::size_t>(mesh.place_of(i))] != 0)
        at_[mesh.place_of(i)].push_back(static_cast<Index>(e));
      if (mesh.place_of(i) > mesh.place_of(j)) std::swap(i, j);
      if (several[static_cast<std::size_t>(mesh.place_of(i))] == 0 &&
          several[static_cast<std::size_t>(mesh.place_of(j))] == 0)
        continue;
      sides[{mesh.place_of(i), mesh.place_of(j)}].insert({i, j});
    }
  }
  for (const auto& [edge, nodes] : sides)
    if (nodes.size() > 1) edges_.insert(edges_.end(), {edge, {edge.second, edge.first}});
  std::sort(edges_.begin(), edges_.end());
  leader_.resize(mesh.nodes.size());
  std::iota(leader_.begin(), leader_.end(), Index{0});
  for (const auto& [place, elements] : at_) divide(place);
  link();
}

std::size_t Joints::open() const {
  return static_cast<std::size_t>(
      std::count_if(at_.begin(), at_.end(), [this](const auto& place) { return is_open(place.first); }));
}

// The first node of a place leads its joint; the place is open if some node has another leader.
bool Joints::is_open(Index node) const {
  const Index place = mesh_.place_of(node);
  const auto found = at_.find(place);
  if (found == at_.end()) return false;
  Index first = -1;
  for (const Index e : found->second)
    for (const Index n : mesh_.elements[static_cast<std::size_t>(e)]) {
      if (n < 0 || mesh_.place_of(n) != place) continue;
      if (first >= 0 && leader(n) != first) return true;
      first = leader(n);
    }
  return false;
}

std::vector<Joints::Edge> Joints::edges_between(std::span<const Index> nodes) const {
  std::set<Index> places;
  for (const Index n : nodes) places.insert(mesh_.place_of(n));
  std::vector<Edge> found;
  for (const Edge& edge : edges_)
    if (places.contains(edge.first) && places.contains(edge.second)) found.push_back(edge);
  return found;
}

std::vector<Joints::Edge> Joints::edges_on(std::span<const Vec3> line) const {
  std::vector<Edge> found;
  for (const Edge& edge : edges_) {
    const Vec3 &a = mesh_.nodes[static_cast<std::size_t>(edge.first)],
               &b = mesh_.nodes[static_cast<std::size_t>(edge.second)];
    const double near = kOnLine * (b - a).norm();
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      if (distance_to(a, line[i], line[i + 1]) <= near && distance_to(b, line[i], line[i + 1]) <= near) {
        found.push_back(edge);
        break;
      }
  }
  return found;
}

bool Joints::set_opened(std::vector<Edge> edges) {
  if (edges == opened_) return false;
  std::vector<Edge> changed;
  std::set_symmetric_difference(edges.begin(), edges.end(), opened_.begin(), opened_.end(),
                                std::back_inserter(changed));
  const std::vector<Index> before = leader_;
  opened_ = std::move(edges);
  std::set<Index> places;
  for (const Edge& edge : changed) places.insert(edge.first);
  for (const Index place : places)
    if (at_.contains(place)) divide(place);
  link();
  return leader_ != before;
}

// Finds the next node of the joint of each node.
void Joints::link() {
  next_.assign(leader_.size(), -1);
  std::vector<Index> last(leader_.size());
  for (std::size_t n = 0; n < leader_.size(); ++n) {
    const auto leader = static_cast<std::size_t>(leader_[n]);
    if (leader != n) next_[static_cast<std::size_t>(last[leader])] = static_cast<Index>(n);
    last[leader] = static_cast<Index>(n);
  }
}

// Works out the joints of a place. As long as none of its edges is open it is one joint, even where elements
// meet in nothing but their corners.
void Joints::divide(Index place) {
  const auto is_opened = [&](Index other) {
    return std::binary_search(opened_.begin(), opened_.end(), Edge(place, other));
  };
  std::vector<Index> nodes;
  std::vector<std::pair<Index, Index>> spokes;  // place at the other end of an edge, node at this one
  bool any_open = false;
  for (const Index e : at_.at(place)) {
    const auto& element = mesh_.elements[static_cast<std::size_t>(e)];
    const auto n = static_cast<std::size_t>(corners(element));
    for (std::size_t a = 0; a < n; ++a) {
      if (mesh_.place_of(element[a]) != place) continue;
      nodes.push_back(element[a]);
      for (const std::size_t next : {(a + 1) % n, (a + n - 1) % n}) {
        const Index other = mesh_.place_of(element[next]);
        any_open = any_open || is_opened(other);
        if (!is_opened(other)) spokes.emplace_back(other, element[a]);
      }
    }
  }
  for (const Index n : nodes)
    leader_[static_cast<std::size_t>(n)] = any_open ? n : *std::min_element(nodes.begin(), nodes.end());
  if (!any_open) return;
  std::sort(spokes.begin(), spokes.end());
  for (std::size_t i = 1; i < spokes.size(); ++i) {
    if (spokes[i].first != spokes[i - 1].first) continue;
    const Index one = leader(spokes[i].second), two = leader(spokes[i - 1].second), to = std::min(one, two),
                from = std::max(one, two);
    for (const Index n : nodes)
      if (leader(n) == from) leader_[static_cast<std::size_t>(n)] = to;
  }
}

std::vector<double> Transfer::apply(std::span<const double> old) const {
  std::vector<double> now(first_.size() - 1, 0);
  for (std::size_t i = 0; i < now.size(); ++i)
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
      now[i] += parts_[k].weight * old[static_cast<std::size_t>(parts_[k].old)];
  return now;
}

}  // namespace fabricsh::mechanics
