#include "mesh/pair.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/edges.hpp"

namespace fabricsh::mesh {

namespace {

constexpr double kLeastSine = 0.5;     // of a corner
constexpr double kLeastFlat = 0.9848;  // cosine between the two triangles: 10 degrees

struct Pair {
  std::int64_t rank;  // the largest first
  std::size_t first, second;
  std::array<Index, 4> ids;
};

std::size_t place_of(Index i) { return static_cast<std::size_t>(i); }

// The sine of the worst corner about the mean normal, in thousandths, so that rounding does not decide; 0 if
// the four are no good quadrilateral.
std::int64_t goodness(const Mesh& mesh, const std::array<Index, 4>& ids) {
  const auto x = [&](std::size_t k) -> const Vec3& { return mesh.nodes[place_of(ids[k % 4])]; };
  const Vec3 one = (x(1) - x(0)).cross(x(2) - x(0)).normalized(),
             other = (x(2) - x(0)).cross(x(3) - x(0)).normalized();
  if (!(one.dot(other) > kLeastFlat)) return 0;
  const Vec3 normal = (one + other).normalized();
  double worst = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 a = x(i + 1) - x(i), b = x(i + 3) - x(i);
    worst = std::min(worst, a.cross(b).dot(normal) / (a.norm() * b.norm()));
  }
  return worst < kLeastSine ? 0 : std::llround(1000 * worst);
}

std::vector<Pair> pairs_of(const Mesh& mesh) {
  std::vector<Pair> pairs;
  for_each_edge(edges(mesh), [&](const Edge* begin, const Edge* end) {
    if (end - begin != 2 || begin[0].forward == begin[1].forward) return;
    for (const Edge* e : {begin, begin + 1})
      if (mesh.elements[place_of(e->element)][3] >= 0) return;
    const auto third = [&](const Edge& edge) {
      for (const Index id : mesh.elements[place_of(edge.element)])
        if (id != edge.first && id != edge.second) return id;
      return Index{-1};
    };
    const Edge &one = begin[0].forward ? begin[0] : begin[1], &other = begin[0].forward ? begin[1] : begin[0];
    const std::array<Index, 4> ids{one.first, third(other), one.second, third(one)};
    if (const auto good = goodness(mesh, ids); good > 0)
      pairs.push_back({good, place_of(one.element), place_of(other.element), ids});
  });
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.rank > b.rank; });
  return pairs;
}

}  // namespace

Index pair_triangles(Mesh& mesh) {
  check_unused(mesh, "pair");
  constexpr auto single = static_cast<std::size_t>(-1);
  std::vector<std::size_t> partner(mesh.elements.size(), single);
  std::vector<std::array<Index, 4>> joined = mesh.elements;
  for (const Pair& pair : pairs_of(mesh)) {
    if (partner[pair.first] != single || partner[pair.second] != single) continue;
    partner[pair.first] = pair.second;
    partner[pair.second] = pair.first;
    joined[std::min(pair.first, pair.second)] = pair.ids;
  }
  std::vector<std::array<Index, 4>> elements;
  std::vector<Vec3> warp;
  Index left = 0;
  for (std::size_t e = 0; e < joined.size(); ++e) {
    if (partner[e] != single && partner[e] < e) continue;
    elements.push_back(joined[e]);
    left += joined[e][3] < 0 ? 1 : 0;
    if (mesh.warp.empty()) continue;
    const Vec3 both = mesh.warp[e] + (partner[e] == single ? mesh.warp[e] : mesh.warp[partner[e]]);
    warp.push_back(both.norm() > 0 ? both.normalized() : mesh.warp[e]);
  }
  mesh.elements = std::move(elements);
  mesh.warp = std::move(warp);
  mesh.origin += " in pairs";
  return left;
}

}  // namespace fabricsh::mesh
