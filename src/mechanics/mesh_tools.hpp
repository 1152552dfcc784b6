// Data derived from a mesh before a model is compiled: directors, colours, tributary weights, sizes.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::mechanics {

using Index = std::int64_t;

// Shares of the nodes of a set in something distributed over it: by area if the set has whole elements (m^2),
// otherwise by length if it has whole element edges (m), otherwise equal.
struct Tributary {
  enum class MeasureKind { area, length, count };
  MeasureKind kind = MeasureKind::count;
  std::vector<double> measure;  // per node of the set
  double total = 0;
};
Tributary tributary(const mesh::Mesh& mesh, const mesh::NodeSet& nodes);

// Unit normals at the nodes: mean of the elements' corner normals, weighted by area.
std::vector<Vec3> reference_directors(const mesh::Mesh& mesh);

// Colours the elements such that those of one colour share no node; greedy in the order of the elements.
// Returns the colour of each element.
std::vector<int> colour(const mesh::Mesh& mesh);

// Of an element with nodes at X.
int corners(const std::array<Index, 4>& element);                           // 3 or 4
double area(const std::array<Index, 4>& element, std::span<const Vec3> X);  // m^2
// m: height over the longest edge, the shortest way of a wave through the element.
double size(const std::array<Index, 4>& element, std::span<const Vec3> X);

}  // namespace fabricsh::mechanics
