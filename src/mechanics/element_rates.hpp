// Upper bounds of the frequencies of a mesh from those of its elements, each free in space with its share of
// the nodes' masses: no frequency of the mesh is above the highest of its elements [irons1971]. The elements
// have the stiffest tangent that their laws can take.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "law/bound.hpp"
#include "mechanics/batch.hpp"

namespace fabricsh::mechanics {

using ElementMatrix = Eigen::Matrix<double, element::shell4_dofs, element::shell4_dofs>;

// The stiffest that the points of a section can become, and its springs of bending.
struct Stiffest {
  explicit Stiffest(const section::Section& section);
  std::vector<law::Bound> points;
  std::array<double, 3> bending{};  // N m
  double axial = 0, shear = 0;      // (m/s)^2, in the plane, for the whole thickness, over its mass
};

// The stiffness of the elements of a batch on the five degrees of freedom of each node, N/m, N and N m,
// without that of stresses. x, d, b: as for the kernels.
std::array<ElementMatrix, lanes> stiffest_matrices(const Batch& batch, const Stiffest& stiffest,
                                                   const double* x, const double* d, const double* b);

// 1/s^2: the square of the highest frequency of an element with this stiffness, mass (kg) and rotary inertia
// (kg m^2) at each of its corners.
double highest_rate(const ElementMatrix& stiffness, int corners, double mass, double inertia);
// The same of its displacements alone.
double rate_of_displacements(const ElementMatrix& stiffness, int corners, double mass);

// kg m^2: the least rotary inertia at each corner with which no frequency squared is above `rate` (1/s^2).
// Infinite if there is none, because the translations alone exceed it.
double inertia_for(const ElementMatrix& stiffness, int corners, double mass, double rate);

// 1/m^2, times the square of the speed of waves along the axes: the square of the highest frequency in the
// plane of a flat element. Its corners along these axes, m; shear: the stiffness over that along the axes.
double plane_rate(std::span<const Eigen::Vector2d> corners, double shear);

}  // namespace fabricsh::mechanics
