// Work of loads and supports on the cloth, by the trapezoidal rule from one committed state to the next.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "mechanics/assembly.hpp"

namespace fabricsh::run {

// Of a node whose director is driven about an axis. The force is that of the support on a node that goes
// about a centre; of others it is zero here and among the forces on positions.
struct TurningSupport {
  mechanics::Index node = -1;
  Vec3 force = Vec3::Zero();  // N
  double moment = 0;          // N m, about the axis
  void keep(Archive& archive) { archive(node, force[0], force[1], force[2], moment); }
};

// The external forces that do work on the cloth; 3 per node, global.
struct WorkingForces {
  std::vector<double> on_x;  // N
  std::vector<double> on_d;  // N m, on directors; empty if no load acts on them
  std::vector<TurningSupport> turning;
};
// Dead loads, follower loads and the forces of moving supports at the trial configuration, whose forces must
// have been computed after set_time() at its time. dead: as for ExternalWork.
void find_working_forces(const mechanics::Assembly& assembly, std::span<const double> dead,
                         WorkingForces& out);

class ExternalWork {
 public:
  // Called with the trial configuration, its forces computed for its time, before the commit. dead: dead
  // loads at that time, N, 3 per node. The first state of a run does no work.
  void start(mechanics::Assembly& assembly, std::span<const double> dead);
  void add(mechanics::Assembly& assembly, std::span<const double> dead);
  // The same where the path between the states is unknown (relaxation). With forces that change monotonically
  // along it the work lies between that of the first and of the last state's forces.
  mechanics::StepWork add_bounded(mechanics::Assembly& assembly, std::span<const double> dead);
  // The same where the forces count `theta` at the end of a step and the rest at its beginning.
  void add_weighted(mechanics::Assembly& assembly, std::span<const double> dead, double theta);
  // J, adds work known from elsewhere.
  void add(double work);
  void keep(Archive& archive) { archive(total_, largest_, before_.on_x, before_.on_d, before_.turning); }
  double total() const { return total_; }      // J
  double largest() const { return largest_; }  // J, the largest |total| so far

 private:
  mechanics::StepWork of_step(mechanics::Assembly& assembly, std::span<const double> dead, bool bounded,
                              double* change = nullptr);
  double total_ = 0, largest_ = 0;
  WorkingForces before_, now_;
  std::optional<bool> loaded_;  // whether constant dead loads are other than zero, once known
};

}  // namespace fabricsh::run
