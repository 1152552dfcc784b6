#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "mesh/edges.hpp"
#include "mesh/generators.hpp"
#include "mesh/matching.hpp"

namespace fabricsh::mesh {

namespace {

std::size_t slot(Index i) { return static_cast<std::size_t>(i); }

// A side, its middle and whether the border of the mesh runs along it.
struct CutSide {
  Index first, second, middle;
  bool border;
};

// Ascending by the ends, which middle_of() needs.
std::vector<CutSide> cut_sides(Mesh& mesh) {
  std::vector<CutSide> sides;
  for_each_edge(edges(mesh), [&](const Edge* begin, const Edge* end) {
    sides.push_back({begin->first, begin->second, 0, end - begin == 1});
  });
  for (CutSide& side : sides) {
    side.middle = static_cast<Index>(mesh.nodes.size());
    mesh.nodes.emplace_back((mesh.nodes[slot(side.first)] + mesh.nodes[slot(side.second)]) / 2);
  }
  return sides;
}

Index middle_of(const std::vector<CutSide>& sides, Index a, Index b) {
  const std::pair ends(std::min(a, b), std::max(a, b));
  return std::lower_bound(sides.begin(), sides.end(), ends,
                          [](const CutSide& side, const std::pair<Index, Index>& of) {
                            return std::pair(side.first, side.second) < of;
                          })
      ->middle;
}

// A set of the border alone, such as an edge of a panel, must not take the inner side that joins two of its
// nodes across a corner.
void extend(NodeSet& ids, const std::vector<CutSide>& sides,
            const std::vector<std::array<Index, 4>>& elements, Index first_middle, std::size_t nodes) {
  std::vector<char> member(nodes, 0), border(nodes, 0);
  for (const Index id : ids) member[slot(id)] = 1;
  for (const CutSide& side : sides)
    if (side.border) border[slot(side.first)] = border[slot(side.second)] = 1;
  const bool inner = std::any_of(ids.begin(), ids.end(), [&](Index id) { return border[slot(id)] == 0; });
  for (const CutSide& side : sides)
    if (member[slot(side.first)] != 0 && member[slot(side.second)] != 0 && (side.border || inner))
      ids.push_back(side.middle);
  for (std::size_t e = 0; inner && e < elements.size(); ++e) {
    const auto begin = elements[e].begin();
    if (std::all_of(begin, begin + static_cast<std::ptrdiff_t>(corner_count(elements[e])),
                    [&](Index id) { return member[slot(id)] != 0; }))
      ids.push_back(first_middle + static_cast<Index>(e));
  }
}

constexpr double kLeastSine = 0.5;     // of a corner
constexpr int kMostNew = 4;            // pairs in place of others that join two more triangles
constexpr double kLeastFlat = 0.9848;  // cosine between the two triangles: 10 degrees

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

}  // namespace

void refine(Mesh& mesh) {
  check_unused(mesh, "refine");
  if (!mesh.parts.empty()) throw Error("refine: expected a mesh of one part");
  const std::vector<std::array<Index, 4>> before = mesh.elements;
  const std::vector<Vec3> warp = mesh.warp;
  const std::vector<CutSide> sides = cut_sides(mesh);
  const auto first_middle = static_cast<Index>(mesh.nodes.size());
  mesh.elements.clear();
  mesh.warp.clear();
  for (std::size_t e = 0; e < before.size(); ++e) {
    const auto& ids = before[e];
    const std::size_t n = corner_count(ids);
    const auto middle = static_cast<Index>(mesh.nodes.size());
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < n; ++i) {
      sum += mesh.nodes[slot(ids[i])];
      mesh.elements.push_back({ids[i], middle_of(sides, ids[i], ids[(i + 1) % n]), middle,
                               middle_of(sides, ids[(i + n - 1) % n], ids[i])});
      if (!warp.empty()) mesh.warp.push_back(warp[e]);
    }
    mesh.nodes.emplace_back(sum / static_cast<double>(n));
  }
  for (auto& [name, ids] : mesh.sets) {
    if (name == "all") {
      for (auto id = static_cast<Index>(ids.size()); id < static_cast<Index>(mesh.nodes.size()); ++id)
        ids.push_back(id);
    } else if (name != "corners") {
      extend(ids, sides, before, first_middle, mesh.nodes.size());
    }
  }
  mesh.origin += " refined";
}

Index pair_triangles(Mesh& mesh) {
  check_unused(mesh, "pair");
  constexpr auto single = static_cast<std::size_t>(-1);
  std::vector<std::size_t> partner(mesh.elements.size(), single);
  std::vector<std::array<Index, 4>> joined = mesh.elements;
  const auto rank = [&mesh](const std::array<Index, 4>& ids) { return goodness(mesh, ids); };
  for (const TrianglePair& pair : match_triangles(mesh, rank, kMostNew)) {
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
