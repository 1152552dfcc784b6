// The motion of a step as a time scheme has it, for the terms that hang on it: damping and inertia. Two
// schemes are there, run/newmark.hpp by nodes and run/central_differences.hpp by unknowns; a quasi-static
// step has a length and no motion.
#pragma once
#include <span>
#include <vector>

#include "base/archive.hpp"

namespace fabricsh::mechanics {

// Velocities or accelerations of all nodes, 3 per node, global.
struct NodalRates {
  std::vector<double> x;  // m/s or m/s^2
  std::vector<double> d;  // 1/s or 1/s^2, tangent to the sphere of directors
};

class Motion {
 public:
  virtual ~Motion() = default;
  double dt() const { return dt_; }  // s, of the step under way
  void set_dt(double dt) { dt_ = dt; }

  // Do the nodes have velocities?
  virtual bool moves() const { return true; }
  // Of the unknowns in the trial state, m/s and 1/s.
  virtual std::span<const double> rates() const = 0;
  // Of the driven freedoms in the step, m/s and 1/s.
  virtual std::vector<double> driven_rates() const = 0;
  // 1/s: how much a damping matrix counts in the tangent, d(forces in the balance) / d(positions).
  virtual double damping_weight() const = 0;

  // --- J, in the step to the trial state, by the trapezoid
  // Of forces on the unknowns that were `before` and are `after`, N and N m.
  virtual double work(std::span<const double> before, std::span<const double> after) const = 0;
  // Of forces that are the mass times `factor` (1/s) times the velocity; times the acceleration.
  virtual double work_of_velocity(double factor) const = 0;
  virtual double work_of_acceleration() const = 0;
  // J, of the trial state, without the displacements that are driven.
  virtual double kinetic() const = 0;

 private:
  double dt_ = 0;
};

// A quasi-static step.
class Still final : public Motion {
 public:
  bool moves() const override { return false; }
  std::span<const double> rates() const override { return {}; }
  std::vector<double> driven_rates() const override { return {}; }
  double damping_weight() const override { return 0; }
  double work(std::span<const double>, std::span<const double>) const override { return 0; }
  double work_of_velocity(double) const override { return 0; }
  double work_of_acceleration() const override { return 0; }
  double kinetic() const override { return 0; }
};

}  // namespace fabricsh::mechanics
