// Central differences on the unknowns: beta = 0, lumped mass, one evaluation of forces per step.
//
//   v~ = v + (1 - gamma) dt a,   x+ = x + dt v + dt^2/2 a,   M a+ = f(x+) - C v~ - c M v+,
//   v+ = v~ + gamma dt a+
//
// C: stiffness damping, c: mass damping.
//
// Rotations of a director are components along b1, b2, which are transported with it along its great circle.
// Velocities therefore keep their components, and momentum and angular momentum are conserved exactly.
//
// A step of a large sheet waits for memory, so v and a are not stored but computed from v~ and the residual
// force, which a step needs anyway.
#pragma once
#include <array>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "mechanics/freedoms.hpp"
#include "mechanics/motion.hpp"

namespace fabricsh::run {

class CentralDifferences final : public mechanics::Motion {
 public:
  // mass: per unknown, kg and kg m^2. driven: rates of the driven freedoms at the beginning of the step.
  CentralDifferences(std::vector<double> mass, double gamma, std::function<std::vector<double>()> driven);

  // Computes the predicted velocity in a step of dt(). turns: per unknown 1 for a rotation, 0 for a
  // displacement; farthest: the limits of a displacement, m, and of a rotation, rad. False: an increment
  // exceeds its limit.
  bool predict(std::span<const unsigned char> turns, const std::array<double, 2>& farthest);
  // The increment in the step is reach() times along(), m and rad.
  const std::vector<double>& along() const { return is_midpoint() ? trial_.predicted : increments(); }
  double reach() const { return is_midpoint() ? dt() : 1; }
  const std::vector<double>& increments() const;
  const std::vector<double>& masses() const { return mass_; }  // of the unknowns, kg and kg m^2
  // The trial residual, N and N m, to be written before accelerate(), without the damping of the masses.
  std::span<double> residual() { return trial_.residual; }
  // Completes the trial motion from its residual. mass_damping: 1/s.
  void accelerate(double mass_damping);
  void start(std::vector<double> velocities);  // sets the committed and the trial motion
  void resize(std::vector<double> mass);       // of other unknowns, at rest
  void begin() { committed_ = trial_; }        // to be called with the initial accelerations
  void commit() { std::swap(committed_, trial_); }
  // Whether velocities are those of a complete trial step, to be read before the commit.
  void show_trial(bool tried) { tried_ = tried; }

  std::vector<double> velocities() const;
  // J, work of all forces by the trapezoidal rule less the change of the kinetic energy in the step.
  double loss() const { return work_of_acceleration() - kinetic_of(trial_) + kinetic_of(committed_); }
  double weight_of_acceleration() const;  // J/s^2, sum of m a^2 in the committed state
  void keep(Archive& archive) { archive(committed_); }

  // The predicted velocities.
  std::span<const double> rates() const override { return trial_.predicted; }
  std::vector<double> driven_rates() const override { return driven_(); }
  double damping_weight() const override { return 0; }
  double work(std::span<const double> before, std::span<const double> after) const override;
  double work_of_velocity(double factor) const override;
  double work_of_acceleration() const override;
  double kinetic() const override { return kinetic_of(shown()); }
  // J, of some unknowns, with these masses.
  struct Weight {
    mechanics::Index unknown;
    double mass;  // kg or kg m^2
  };
  double kinetic(std::span<const Weight> weights) const;

 private:
  struct State {
    std::vector<double> predicted, residual;  // per unknown, m/s and 1/s, N and N m
    double kick = 0, damping = 0;             // s, gamma dt; 1/s, of the masses
    void keep(Archive& archive) { archive(predicted, residual, kick, damping); }
  };
  // Of a state, per unknown.
  struct Rates {
    const double *predicted, *residual, *per_mass;
    double kick, damping, share;  // share: 1 / (1 + kick damping)
    double acceleration(std::size_t i) const {
      return share * (residual[i] * per_mass[i] - damping * predicted[i]);
    }
    double velocity(std::size_t i) const { return predicted[i] + kick * acceleration(i); }
  };
  Rates rates_of(const State& s) const {
    return {s.predicted.data(), s.residual.data(),           per_mass_.data(), s.kick,
            s.damping,          1 / (1 + s.kick * s.damping)};
  }
  bool is_midpoint() const { return gamma_ == 0.5; }
  // In the step, by the rates of its beginning.
  double increment(const Rates& before, std::size_t i) const {
    if (is_midpoint()) return dt() * trial_.predicted[i];
    return dt() * (before.velocity(i) + dt() / 2 * before.acceleration(i));
  }
  const State& shown() const { return tried_ ? trial_ : committed_; }
  double kinetic_of(const State& state) const;

  std::vector<double> mass_, per_mass_;
  double gamma_;
  std::function<std::vector<double>()> driven_;
  State committed_, trial_;
  mutable std::vector<double> increments_;
  bool tried_ = false;
};

}  // namespace fabricsh::run
