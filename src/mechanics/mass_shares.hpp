// The shares of the nodes' masses among their elements with which the bound of the frequencies is lowest. It
// holds for any shares: where an element's stiffness is at most its rate times its share of the masses, the
// sum of these is diagonal, and no frequency squared of the mesh is above the largest mean of the rates about
// a node. An element that is fast among slow ones gets more of the masses that it has in common with them.
#pragma once
#include <Eigen/Core>
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::mechanics {

// Of an element in its plane, 1/s^2: the stiffness on two displacements of each corner over the mass of a
// corner.
using PlaneMatrix = Eigen::Matrix<double, 8, 8>;
using CornerMasses = std::array<double, 4>;

// Per node, over its elements: the mean of their rates with the weight(element, corner).
template <class Weight>
std::vector<double> means_at_nodes(const mesh::Mesh& mesh, std::span<const double> rates, Weight weight) {
  std::vector<double> sum(mesh.nodes.size(), 0), all(mesh.nodes.size(), 0);
  for (std::size_t e = 0; e < rates.size(); ++e)
    for (std::size_t c = 0; c < 4; ++c)
      if (const auto n = mesh.elements[e][c]; n >= 0) {
        sum[static_cast<std::size_t>(n)] += weight(e, c) * rates[e];
        all[static_cast<std::size_t>(n)] += weight(e, c);
      }
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] = all[n] > 0 ? sum[n] / all[n] : 0;
  return sum;
}

double largest_eigenvalue(const PlaneMatrix& symmetric);

// Of the corners of each element, kg; the rates of the elements with them, and their largest mean about a
// node, 1/s^2.
struct SharedMasses {
  std::vector<CornerMasses> shares;
  std::vector<double> rates;
  double highest;
};
// equal: with which all corners of an element have the same; rates: of the elements with these; stiffness: of
// an element. The result is `equal` itself where others gain little.
SharedMasses share_masses(const mesh::Mesh& mesh, const std::vector<CornerMasses>& equal,
                          const std::vector<double>& rates,
                          const std::function<PlaneMatrix(mesh::Index)>& stiffness);

// Lumping for a longer step: nodes where the mean of the rates is far above the rest, such as those of small
// elements at a rim, take mass from nodes about them that have to spare. The mass of the cloth, and of each
// neighbourhood, stays.
struct MovedMass {
  std::vector<double> times;  // per node, of its mass; empty: little would be gained
  double highest;             // 1/s^2, the largest mean then
};
// means: per node, 1/s^2; mass: kg.
MovedMass move_mass(const mesh::Mesh& mesh, const std::vector<double>& means,
                    const std::vector<double>& mass);

}  // namespace fabricsh::mechanics
