// What is read off a mesh before a model is compiled: directors, colours, tributary shares, sizes.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::mechanics {

using Index = std::int64_t;

// What a set's nodes carry of something spread over it: by area where the set holds whole elements (m^2),
// else by length where it holds whole element edges (m), else by count.
struct Tributary {
  enum class Kind { area, length, count };
  Kind kind = Kind::count;
  std::vector<double> measure;  // per node of the set
  double total = 0;
};
Tributary tributary(const mesh::Mesh& mesh, const mesh::NodeSet& nodes);

// Unit normals at the nodes: the mean of the elements' corner normals, weighted by area.
std::vector<Vec3> reference_directors(const mesh::Mesh& mesh);

// Colours such that elements of one colour share no node: greedy in element order. Returns the colour of each
// element.
std::vector<int> colour(const mesh::Mesh& mesh);

// Of an element of nodes X.
int corners(const std::array<Index, 4>& element);                              // 3 or 4
double area(const std::array<Index, 4>& element, const std::vector<Vec3>& X);  // m^2
// m: the height over the longest edge, that a wave crosses first.
double size(const std::array<Index, 4>& element, const std::vector<Vec3>& X);

}  // namespace fabricsh::mechanics
