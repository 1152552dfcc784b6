// The motion in a step as defined by a time scheme, for the terms that depend on it: damping and inertia. Of
// the two schemes run/newmark.hpp works with nodes and run/central_differences.hpp with unknowns. A
// quasi-static step has a length but no motion.
#pragma once
#include <span>
#include <vector>

#include "base/archive.hpp"

namespace fabricsh::mechanics {

// Velocities or accelerations of all nodes; 3 per node, global.
struct NodalRates {
  std::vector<double> x;  // m/s or m/s^2
  std::vector<double> d;  // 1/s or 1/s^2, tangent to the sphere of directors
};

class Motion {
 public:
  virtual ~Motion() = default;
  double dt() const { return dt_; }  // s, of the present step
  void set_dt(double dt) { dt_ = dt; }

  // Whether the nodes have velocities.
  virtual bool moves() const { return true; }
  // Rates of the unknowns in the trial state, m/s and 1/s.
  virtual std::span<const double> rates() const = 0;
  // Rates of the driven degrees of freedom in the step, m/s and 1/s.
  virtual std::vector<double> driven_rates() const = 0;
  // 1/s: weight of a damping matrix in the tangent, d(forces in the balance) / d(positions).
  virtual double damping_weight() const = 0;

  // --- work in the step up to the trial state, J, by the trapezoidal rule
  // Of forces on the unknowns, N and N m, with the values `before` and `after` the step.
  virtual double work(std::span<const double> before, std::span<const double> after) const = 0;
  // Of forces equal to mass times `factor` (1/s) times velocity; and of mass times acceleration.
  virtual double work_of_velocity(double factor) const = 0;
  virtual double work_of_acceleration() const = 0;
  // Of the forces at the end of a step in their work; those at its beginning have the rest.
  virtual double weight_of_end() const { return 0.5; }
  // J, in the trial state, without the driven displacements.
  virtual double kinetic() const = 0;

 private:
  double dt_ = 0;
};

// A quasi-static step.
class QuasiStatic final : public Motion {
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
