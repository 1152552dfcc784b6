#include "mesh/pair.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/matching.hpp"

namespace fabricsh::mesh {

namespace {

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
