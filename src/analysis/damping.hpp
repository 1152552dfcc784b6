// Viscous forces that hold a sheet still while it wrinkles: c m (x - x0) / dt on every free displacement over
// a step of dt from x0, m the node's mass. c (1/s) is chosen such that a step loses a given fraction of its
// work.
#pragma once
#include <span>
#include <vector>

#include "mechanics/assembly.hpp"

namespace fabricsh::analysis {

class Damping {
 public:
  Damping(const mechanics::Assembly& assembly, double fraction);  // 0: none

  bool on() const { return fraction_ > 0; }
  // A step of dt begins. The first one takes c such that the nodes' viscous stiffness is `fraction` of K's.
  void start(double dt, const linear::Matrix& K);
  void add_force(std::span<double> r) const;
  void add_stiffness(linear::Matrix& K) const;
  double work() const;  // J, lost in the step, at the trial configuration
  // After a step: what it lost and the work that was done on the sheet in it, J.
  void adapt(double lost, double step_work);
  void raise() { factor_ *= 4; }  // after a step that failed
  double factor() const { return factor_; }
  void set_factor(double c) { factor_ = c; }

 private:
  struct Freedom {
    mechanics::Index equation, node;
    int component;
  };
  double moved(const Freedom& f) const;  // m, along the node's frame, in the step
  const mechanics::Assembly& assembly_;
  double fraction_, factor_ = 0, dt_ = 1;
  std::vector<Freedom> freedoms_;
};

}  // namespace fabricsh::analysis
