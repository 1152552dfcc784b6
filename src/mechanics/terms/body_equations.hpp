// The equations of free rigid bodies in implicit and static steps, which are solved together with those of
// the cloth. Force (N) and torque (N m) on each at the step's end, six numbers a body: those that act, less
// those with which its flight was computed. In static steps the six numbers are a displacement and a
// rotation.
#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "mechanics/terms/body_loads.hpp"

namespace fabricsh::mechanics {

class BodyEquations {
 public:
  BodyEquations(BodyState& state, const BodyLoads& loads) : state_(state), loads_(loads) {}
  std::size_t unknowns() const { return state_.implicit ? 6 * state_.free.size() : 0; }
  Eigen::VectorXd residual() const;
  double largest_force() const;              // N, torques over the body's size
  double largest_residual() const;           // N, torques over the body's size
  void direct(std::span<const double> way);  // the change that move() takes shares of
  void begin_iterate();
  void move(double scale);
  void save();     // the unknowns
  void restore();  // as saved last
  // Of a free body, by its number: the derivative of its position and rotation by the force and torque at
  // the step's end, 6 x 6.
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  Matrix6 compliance(std::size_t free) const;
  // Of a free body, by its number: kg and kg m2; 1 for what it may do, its places and turns, else 0.
  Matrix6 mass_matrix(std::size_t free) const;
  Vector6 freedom(std::size_t free) const;
  Eigen::MatrixXd spring_stiffness() const;  // N/m, by the places of all free bodies, 6 numbers each
  // Adds to the derivative of the residual by the unknowns what springs and dampers give.
  void add_response(Eigen::MatrixXd& response) const;
  // Adds in static steps the unknowns themselves, and what holds a body that is held by nothing else.
  void hold(Eigen::MatrixXd& response) const;
  // Which of the unknowns are of directions in which a support holds a body.
  std::vector<bool> held() const;
  // m: the lever of vertex row v, which is of a free body, from its centre.
  Vec3 lever(std::size_t v) const {
    return state_.target[v] - state_.free[state_.free_of[v]].predicted.centre();
  }

 private:
  BodyState& state_;
  const BodyLoads& loads_;
};

}  // namespace fabricsh::mechanics
