// Bounds of the frequencies of the cloth in its reference configuration, and its largest stable step of
// central differences.
#pragma once
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "law/bound.hpp"
#include "mechanics/batch.hpp"
#include "mechanics/mass_shares.hpp"
#include "mechanics/rest_shape.hpp"

namespace fabricsh::mechanics {

// --- Upper bounds of the frequencies of a mesh from those of its elements, each free in space with its share
// of the nodes' masses: no frequency of the mesh is above the highest of its elements [irons1971]. The
// elements have the stiffest tangent that their laws can take.

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

// 1/s^2: the square of the highest frequency of an element with this stiffness, masses (kg) and rotary
// inertia (kg m^2) at each of its corners.
double highest_rate(const ElementMatrix& stiffness, int corners, const CornerMasses& mass, double inertia);
// The same of its displacements alone.
double rate_of_displacements(const ElementMatrix& stiffness, int corners, const CornerMasses& mass);

// kg m^2: the least rotary inertia at each corner with which no frequency squared is above `rate` (1/s^2).
// Infinite if there is none, because the translations alone exceed it.
double inertia_for(const ElementMatrix& stiffness, int corners, const CornerMasses& mass, double rate);

// 1/m^2, times the square of the speed of waves along the axes: the stiffness of a flat element in its plane
// over the mass of a corner. Its corners along these axes, m; shear: the stiffness over that along the axes.
PlaneMatrix plane_matrix(std::span<const Eigen::Vector2d> corners, double shear);

class ClothRates {
 public:
  ClothRates(const model::Model& model, const RestShape& rest, const std::vector<Batch>& batches,
             const std::vector<BatchLane>& place);

  double stable_step(bool scaled) const;  // s
  // s: the time in which waves in the plane cross the smallest height of an element, longer by what scaled
  // mass makes of the stable step. The default stiffness of contact follows it also where the stable step is
  // longer, so that a rim of small elements is pressed no deeper.
  double step_across_heights() const { return across_heights_; }
  // Per node, what its mass is times its true one with scaled inertia (mechanics/mass_shares.hpp); empty:
  // that.
  const std::vector<double>& mass_times() const { return mass_times_; }
  void keep_mass();  // with scaled inertia, too
  // kg m^2 per node. The rotary inertia per mass of an element is t^2/12 + t^2 zeta_bar^2/4; if scaled, it is
  // at least so large that it permits the stable step of the waves in the plane of the cloth, after the idea
  // of [hughes1978].
  const std::vector<double>& rotary_inertia(bool scaled) const { return bounds(scaled).rotary; }
  // 1/s^2, per element: an upper bound of the squares of its frequencies in the reference configuration
  // (above), with true or scaled rotary inertia.
  const std::vector<double>& highest(bool scaled) const { return bounds(scaled).rates; }
  // 1/s^2, per node: the mean of `rates` over its elements, weighted by their shares of its mass or by their
  // rotary inertia, whichever is more. If no frequency squared of an element is above its rate, none of the
  // cloth is above the largest of these.
  std::vector<double> rates_at_nodes(std::span<const double> rates, bool scaled) const;
  double smallest_size() const { return smallest_size_; }  // m, h of the smallest element

 private:
  Index elements() const { return static_cast<Index>(place_.size()); }
  double plane_rate_of(Index element, const Stiffest& stiffest, double speed) const;
  PlaneMatrix plane_matrix_of(Index element, const Stiffest& stiffest) const;
  double least_across_heights() const;
  void find_membrane_steps();
  CornerMasses shares(Index element, bool scaled) const;
  double inertia_per_mass(const section::Section& section, bool scaled) const;
  double corner_mass(Index element) const;  // kg
  // The rotary inertia of the nodes and the bounds of the elements' frequencies, computed when first used.
  struct FrequencyBounds {
    bool made = false;
    std::vector<double> rates, rotary;
    std::vector<double> inertias;  // of each corner of an element, kg m^2; empty: as the masses
  };
  const FrequencyBounds& bounds(bool scaled) const;
  struct ElementBound {
    double rate, inertia_per_mass;  // 1/s^2, m^2
  };
  std::array<ElementBound, lanes> bounds_of(const Batch& batch, const Stiffest& stiffest, bool scaled,
                                            double permitted) const;
  ElementBound bound_of(const ElementMatrix& stiffness, Index element, bool scaled, double permitted) const;

  const model::Model& model_;
  const RestShape& rest_;
  const std::vector<Batch>& batches_;
  const std::vector<BatchLane>& place_;
  mutable FrequencyBounds bounds_[2];  // with true and with scaled rotary inertia
  std::vector<CornerMasses> shares_;   // kg, per element; with zones and in squares all corners have the same
  std::vector<double> mass_times_;
  std::array<double, 2> membrane_step_;  // s, with true and with scaled inertia
  double across_heights_;
  // m; scaled: of the elements that get no mass. Those that do get the rotary inertia that their bound asks.
  double smallest_size_ = std::numeric_limits<double>::infinity(), smallest_scaled_ = smallest_size_;
};

}  // namespace fabricsh::mechanics
