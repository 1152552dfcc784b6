// Gas that pushes on rigid bodies: their places, the forces on them, and how these change with each other.
#pragma once
#include <vector>

#include "mechanics/facets.hpp"
#include "mechanics/terms/contact_state.hpp"

namespace fabricsh::mechanics {

class GasOnBodies {
 public:
  GasOnBodies(ContactState& state, const std::vector<double>& inverse_mass)
      : state_(state), inverse_mass_(inverse_mass) {}
  const Bodies& bodies() const { return state_.surfaces.bodies(); }
  void place_points(const Trial& trial, std::vector<double>& x) const;  // m, 3 per point
  void begin(std::span<const double> on_x);  // N, 3 per point, at the start of the run
  void press(std::span<const double> on_x);  // the same at the end of the step
  double inverse_mass(Index point) const { return inverse_mass_[static_cast<std::size_t>(point)]; }  // 1/kg
  // The sum of the forces on points, from the given one on, each over the root of its mass.
  double size_of(std::span<const double> on_x, std::size_t from = 0) const;
  // Derivatives of the internal forces of gas by places, of which one is at least a body's; with those of the
  // volumes.
  struct GasTangent {
    struct Part {
      Index a, b;
      Mat3 k;  // d(internal force on a) / d(place of b), N/m
    };
    std::vector<Part> parts;
    NodalRanks ranks;  // by points
  };
  void take(GasTangent tangent) { tangent_ = std::move(tangent); }

  // --- for the unknowns of bodies
  bool any() const { return !tangent_.ranks.on_x.empty(); }  // whether gas pushes on a body
  const std::vector<std::vector<double>>& of_volumes() const { return tangent_.ranks.on_x; }
  std::vector<Vec3> way_of(int body, const BodyEquations::Vector6& moved) const;
  std::vector<Vec3> way_left() const;
  std::vector<double> change(std::span<const double> on_nodes, std::span<const Vec3> vertices,
                             bool with_volumes) const;
  Eigen::VectorXd on_bodies(std::span<const double> change) const;
  void add_answers(bool with_volumes, Eigen::MatrixXd& answers) const;

 private:
  std::size_t nodes() const { return state_.surfaces.nodes(); }

  ContactState& state_;
  const std::vector<double>& inverse_mass_;
  GasTangent tangent_;  // without columns: gas pushes on no body
};

}  // namespace fabricsh::mechanics
