#include "mesh/edges.hpp"

#include <algorithm>
#include <tuple>

namespace fabricsh::mesh {

std::vector<Edge> edges(const Mesh& mesh) {
  std::vector<Edge> all;
  all.reserve(4 * mesh.elements.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto& ids = mesh.elements[e];
    const std::size_t n = ids[3] < 0 ? 3 : 4;
    for (std::size_t i = 0; i < n; ++i) {
      const Index a = ids[i], b = ids[(i + 1) % n];
      all.push_back({std::min(a, b), std::max(a, b), static_cast<Index>(e), a < b});
    }
  }
  std::sort(all.begin(), all.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.first, a.second, a.element, a.forward) <
           std::tie(b.first, b.second, b.element, b.forward);
  });
  return all;
}

void for_each_edge(const std::vector<Edge>& sorted,
                   const std::function<void(const Edge* begin, const Edge* end)>& visit) {
  const Edge* const last = sorted.data() + sorted.size();
  for (const Edge* begin = sorted.data(); begin != last;) {
    const Edge* end = begin + 1;
    while (end != last && end->first == begin->first && end->second == begin->second) ++end;
    visit(begin, end);
    begin = end;
  }
}

NodeSet free_nodes(const Mesh& mesh) {
  NodeSet nodes;
  for_each_edge(edges(mesh), [&nodes](const Edge* begin, const Edge* end) {
    if (end - begin == 1) nodes.insert(nodes.end(), {begin->first, begin->second});
  });
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace fabricsh::mesh
