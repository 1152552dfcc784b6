// Work of loads and supports on the cloth, by the trapezoidal rule from one committed state to the next.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "mechanics/assembly.hpp"

namespace fabricsh::run {

// The external forces that do work on the cloth; 3 per node, global.
struct WorkingForces {
  std::vector<double> on_x;  // N
  std::vector<double> on_d;  // N m, on directors; empty if no load and no moving support acts on them
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
  struct Bounded {
    double work = 0, half = 0;  // J, by the trapezoidal rule; how far the work can lie from that
  };
  Bounded add_bounded(mechanics::Assembly& assembly, std::span<const double> dead);
  // J, adds work known from elsewhere.
  void add(double work);
  void keep(Archive& archive) { archive(total_, largest_, before_.on_x, before_.on_d); }
  double total() const { return total_; }      // J
  double largest() const { return largest_; }  // J, the largest |total| so far

 private:
  Bounded of_step(mechanics::Assembly& assembly, std::span<const double> dead, bool bounded);
  double total_ = 0, largest_ = 0;
  WorkingForces before_, now_;
  std::optional<bool> loaded_;  // whether constant dead loads are other than zero, once known
};

}  // namespace fabricsh::run
