// Central differences on the unknowns: beta = 0, lumped mass, one evaluation of forces per step.
//
//   v~ = v + (1 - gamma) dt a,   x+ = x + dt v + dt^2/2 a,   M a+ = f(x+) - C v+,   v+ = v~ + gamma dt a+
//
// Rotations of a director are components along b1, b2, which are transported with it along its great circle.
// Velocities therefore keep their components, and momentum and angular momentum are conserved exactly.
#pragma once
#include <array>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "mechanics/motion.hpp"

namespace fabricsh::run {

class CentralDifferences final : public mechanics::Motion {
 public:
  // mass: per unknown, kg and kg m^2. driven: rates of the driven freedoms at the beginning of the step.
  CentralDifferences(std::vector<double> mass, double gamma, std::function<std::vector<double>()> driven);

  // Computes the increment of a step of dt() and the predicted velocity. turns: per unknown 1 for a rotation,
  // 0 for a displacement; farthest: the limits of a displacement, m, and of a rotation, rad. False: an
  // increment exceeds its limit.
  bool predict(std::span<const unsigned char> turns, const std::array<double, 2>& farthest);
  // Computes the acceleration from the residual, including the damping of the masses (1/s), and the corrected
  // velocity.
  void accelerate(std::span<const double> residual, double mass_damping);
  void start(std::vector<double> velocities);  // sets the committed and the trial motion
  void begin() { committed_.a = trial_.a; }    // to be called with the initial accelerations
  void commit() { std::swap(committed_, trial_); }
  // Whether rates() and velocities are those of a complete trial step, to be read before the commit.
  void show_trial(bool tried) { tried_ = tried; }

  const std::vector<double>& increment() const { return increment_; }
  const std::vector<double>& velocities() const { return (tried_ ? trial_ : committed_).v; }
  // J, work of all forces by the trapezoidal rule less the change of the kinetic energy in the step.
  double loss() const { return work_of_acceleration() - kinetic_of(trial_.v) + kinetic_of(committed_.v); }
  void keep(Archive& archive) { archive(committed_.v, committed_.a); }

  std::span<const double> rates() const override { return trial_.v; }
  std::vector<double> driven_rates() const override { return driven_(); }
  double damping_weight() const override { return 0; }
  double work(std::span<const double> before, std::span<const double> after) const override;
  double work_of_velocity(double factor) const override;
  double work_of_acceleration() const override;
  double kinetic() const override { return kinetic_of(velocities()); }

 private:
  double kinetic_of(const std::vector<double>& v) const;
  struct State {
    std::vector<double> v, a;  // per unknown, m/s and 1/s, m/s^2 and 1/s^2
  };
  std::vector<double> mass_;
  double gamma_;
  std::function<std::vector<double>()> driven_;
  State committed_, trial_;
  std::vector<double> increment_;  // m, rad
  bool tried_ = false;
};

}  // namespace fabricsh::run
