// Central differences on the unknowns: beta = 0, lumped mass; one evaluation of forces a step.
//
//   v~ = v + (1 - gamma) dt a,   x+ = x + dt v + dt^2/2 a,   M a+ = f(x+) - C v+,   v+ = v~ + gamma dt a+
//
// Rotations of a director count along b1, b2, which travel with it on its great circle, so that velocities
// keep their components: momentum and angular momentum are kept exactly.
#pragma once
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "mechanics/motion.hpp"

namespace fabricsh::run {

class CentralDifferences final : public mechanics::Motion {
 public:
  // mass: per unknown, kg and kg m^2. driven: rates of the driven freedoms at the step's beginning.
  CentralDifferences(std::vector<double> mass, double gamma, std::function<std::vector<double>()> driven);

  // The increment of a step of dt(), and the velocity predicted in it. farthest: m or rad per unknown; false:
  // one goes beyond.
  bool predict(std::span<const double> farthest);
  // The acceleration that the residual makes, the damping of the masses (1/s) taken into account, and the
  // velocity with it.
  void accelerate(std::span<const double> residual, double mass_damping);
  void start(std::vector<double> velocities);  // of the committed and the trial motion
  void begin() { committed_.a = trial_.a; }    // with the accelerations that the run starts with
  void commit() { std::swap(committed_, trial_); }
  // Is the trial motion that of a whole step, to be read before it is committed?
  void show_trial(bool tried) { tried_ = tried; }

  const std::vector<double>& increment() const { return increment_; }
  const std::vector<double>& velocities() const { return (tried_ ? trial_ : committed_).v; }
  // J, that the trapezoid's work of all forces has beyond the change of the kinetic energy in the step.
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
