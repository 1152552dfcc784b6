#include "mesh/corners.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "mesh/edges.hpp"

namespace fabricsh::mesh {

namespace {

std::shared_ptr<Mesh> without_further_nodes(const Mesh& whole) {
  auto out = std::make_shared<Mesh>();
  out->nodes = whole.nodes;
  out->elements = whole.elements;
  out->flat = whole.flat;
  out->warp = whole.warp;
  out->origin = whole.origin;
  out->parts = whole.parts;
  out->place.resize(whole.nodes.size());
  std::iota(out->place.begin(), out->place.end(), Index{0});
  return out;
}

Index add_node(Mesh& out, Index place) {
  out.nodes.push_back(Vec3(out.nodes[static_cast<std::size_t>(place)]));
  out.place.push_back(place);
  return static_cast<Index>(out.nodes.size()) - 1;
}

}  // namespace

std::shared_ptr<Mesh> split_corners(std::shared_ptr<const Mesh> whole, const std::vector<Index>& elements) {
  auto out = without_further_nodes(*whole);
  std::vector<char> splits(whole->elements.size(), 0), taken(whole->nodes.size(), 0);
  for (const Index e : elements) splits[static_cast<std::size_t>(e)] = 1;
  for (std::size_t e = 0; e < splits.size(); ++e)
    for (const Index n : whole->elements[e])
      if (n >= 0 && splits[e] == 0) taken[static_cast<std::size_t>(n)] = 1;
  std::vector<Index*> further;  // corners that need a node of their own
  for (const Index e : elements)
    for (Index& n : out->elements[static_cast<std::size_t>(e)]) {
      if (n < 0) continue;
      char& used = taken[static_cast<std::size_t>(n)];
      if (used != 0) further.push_back(&n);
      used = 1;
    }
  // In the order of the places: what goes over all of these reads the nodes of a place one after the other.
  std::stable_sort(further.begin(), further.end(), [](const Index* a, const Index* b) { return *a < *b; });
  for (Index* corner : further) *corner = add_node(*out, *corner);
  out->whole = std::move(whole);
  return out;
}

namespace {

// The elements around a place in sectors, of which neighbours have one of the edges between them; those
// without such an edge are with the first. In the order of the elements.
std::vector<std::vector<Index>> sectors(const Mesh& mesh, Index place, const std::vector<Index>& around,
                                        const std::set<std::pair<Index, Index>>& edges) {
  std::vector<std::vector<Index>> all;
  std::vector<char> is_side;
  std::vector<char> taken(around.size(), 0);
  std::map<Index, std::vector<std::size_t>> spokes;  // of each other place: the elements around that have it
  std::vector<std::vector<Index>> ends(around.size());
  for (std::size_t i = 0; i < around.size(); ++i) {
    const auto& e = mesh.elements[static_cast<std::size_t>(around[i])];
    const std::size_t n = corner_count(e);
    for (std::size_t a = 0; a < n; ++a)
      if (e[a] == place) ends[i] = {e[(a + 1) % n], e[(a + n - 1) % n]};
    for (const Index other : ends[i]) spokes[other].push_back(i);
  }
  for (std::size_t first = 0; first < around.size(); ++first) {
    if (taken[first] != 0) continue;
    std::vector<std::size_t> sector{first};
    taken[first] = 1;
    bool side = false;
    for (std::size_t k = 0; k < sector.size(); ++k)
      for (const Index other : ends[sector[k]]) {
        if (edges.contains(std::minmax(place, other))) {
          side = true;
          continue;
        }
        for (const std::size_t next : spokes[other])
          if (taken[next] == 0) {
            taken[next] = 1;
            sector.push_back(next);
          }
      }
    auto& put = !side && !all.empty() ? all.front() : all.emplace_back();
    for (const std::size_t i : sector) put.push_back(around[i]);
  }
  return all;
}

}  // namespace

std::shared_ptr<Mesh> split_sides(std::shared_ptr<const Mesh> whole,
                                  const std::vector<std::pair<Index, Index>>& edges) {
  auto out = without_further_nodes(*whole);
  std::set<std::pair<Index, Index>> hinges;
  std::map<Index, std::vector<Index>> around;
  for (const auto& [a, b] : edges) {
    hinges.insert(std::minmax(a, b));
    for (const Index place : {a, b}) around[place];
  }
  for (std::size_t e = 0; e < whole->elements.size(); ++e)
    for (const Index n : whole->elements[e])
      if (const auto found = around.find(n); found != around.end())
        found->second.push_back(static_cast<Index>(e));
  for (const auto& [place, elements] : around) {
    const auto all = sectors(*whole, place, elements, hinges);
    for (std::size_t s = 1; s < all.size(); ++s) {
      const Index further = add_node(*out, place);
      for (const Index e : all[s]) {
        auto& own = out->elements[static_cast<std::size_t>(e)];
        std::replace(own.begin(), own.end(), place, further);
      }
    }
  }
  out->hinged = true;
  out->whole = std::move(whole);
  return out;
}

Index node_at(const Mesh& mesh, Index element, Index place) {
  for (const Index n : mesh.elements[static_cast<std::size_t>(element)])
    if (n >= 0 && mesh.place_of(n) == place) return n;
  return -1;
}

}  // namespace fabricsh::mesh
