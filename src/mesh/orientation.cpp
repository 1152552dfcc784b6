#include "mesh/orientation.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "mesh/check.hpp"

namespace fabricsh::mesh {

namespace {

struct Neighbour {
  Index element;
  bool agrees;  // the two elements run through their common edge in opposite directions, as they should
};

std::vector<std::vector<Neighbour>> neighbours(const Mesh& mesh, const std::vector<Edge>& sorted) {
  std::vector<std::vector<Neighbour>> list(mesh.elements.size());
  for_each_edge(sorted, [&list](const Edge* begin, const Edge* end) {
    if (end - begin != 2) return;
    const bool agrees = begin[0].forward != begin[1].forward;
    list[static_cast<std::size_t>(begin[0].element)].push_back({begin[1].element, agrees});
    list[static_cast<std::size_t>(begin[1].element)].push_back({begin[0].element, agrees});
  });
  return list;
}

// All elements connected with the first, each reversed if needed to agree with the one it was reached from.
std::vector<Index> spread(Orientation& result, const std::vector<std::vector<Neighbour>>& near, Index first) {
  std::vector<Index> reached{first};
  const Index part = result.parts();
  result.part[static_cast<std::size_t>(first)] = part;
  result.one_sided.push_back(0);
  for (std::size_t at = 0; at < reached.size(); ++at) {
    const auto e = static_cast<std::size_t>(reached[at]);
    for (const Neighbour& other : near[e]) {
      const auto o = static_cast<std::size_t>(other.element);
      const char turned = static_cast<char>(result.turned[e] ^ (other.agrees ? 0 : 1));
      if (result.part[o] < 0) {
        result.part[o] = part;
        result.turned[o] = turned;
        reached.push_back(other.element);
      } else if (result.turned[o] != turned) {
        result.one_sided.back() = 1;
      }
    }
  }
  return reached;
}

void keep_the_most(Orientation& result, const std::vector<Index>& part) {
  const auto turned = [&result](Index e) { return result.turned[static_cast<std::size_t>(e)] != 0; };
  if (2 * std::count_if(part.begin(), part.end(), turned) <= static_cast<std::ptrdiff_t>(part.size())) return;
  for (const Index e : part) result.turned[static_cast<std::size_t>(e)] ^= 1;
}

void turn(std::array<Index, 4>& element) { std::swap(element[1], element[element[3] < 0 ? 2 : 3]); }

// Twice the area times the normal. For a triangle the last corner is used twice.
Vec3 area_vector(const Mesh& mesh, const std::array<Index, 4>& ids) {
  const auto x = [&](std::size_t i) -> const Vec3& { return mesh.nodes[static_cast<std::size_t>(ids[i])]; };
  return (x(2) - x(0)).cross(x(ids[3] < 0 ? 2 : 3) - x(1));
}

// For each part 1 if its mean normal points against the direction, else 0.
std::vector<char> against(const Mesh& mesh, const Orientation& found, const Vec3& direction) {
  std::vector<Vec3> sum(found.one_sided.size(), Vec3::Zero());
  std::vector<double> size(found.one_sided.size(), 0.0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const Vec3 area = area_vector(mesh, mesh.elements[e]);
    sum[static_cast<std::size_t>(found.part[e])] += found.turned[e] != 0 ? Vec3(-area) : area;
    size[static_cast<std::size_t>(found.part[e])] += area.norm();
  }
  std::vector<char> result(sum.size(), 0);
  for (std::size_t p = 0; p < sum.size(); ++p) {
    const double along = sum[p].dot(direction.normalized());
    if (std::abs(along) <= 1e-9 * size[p])
      throw Error("orient: the mean normal of part " + std::to_string(p + 1) +
                  " of the mesh is square to the direction");
    result[p] = along < 0 ? 1 : 0;
  }
  return result;
}

}  // namespace

Orientation orientation(const Mesh& mesh, const std::vector<Edge>& sorted) {
  const auto near = neighbours(mesh, sorted);
  Orientation result{
      std::vector<Index>(mesh.elements.size(), -1), std::vector<char>(mesh.elements.size(), 0), {}};
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (result.part[e] < 0) keep_the_most(result, spread(result, near, static_cast<Index>(e)));
  return result;
}

Index orient(Mesh& mesh, const Vec3& direction) {
  check_unused(mesh, "orient");
  const Orientation found = orientation(mesh, edges(mesh));
  const auto one_sided = std::find(found.one_sided.begin(), found.one_sided.end(), 1);
  if (one_sided != found.one_sided.end())
    throw Error("orient: part " + std::to_string(one_sided - found.one_sided.begin() + 1) +
                " of the mesh has one side only (a Moebius strip), no orientation exists");
  std::vector<char> over(found.one_sided.size(), 0);
  if (direction != Vec3::Zero()) over = against(mesh, found, direction);
  Index count = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (found.turned[e] != over[static_cast<std::size_t>(found.part[e])]) {
      turn(mesh.elements[e]);
      ++count;
    }
  return count;
}

}  // namespace fabricsh::mesh
