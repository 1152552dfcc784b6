// Damping forces on the unknowns: Rayleigh's stiffness part, and stabilisation of a sheet that wrinkles.
#pragma once
#include "linear/matrix.hpp"
#include "mechanics/facets.hpp"

namespace fabricsh::mechanics {

class Assembly;

// Forces b K_M v, where K_M is the law's part of the tangent at the beginning of the step [williams2010, eq.
// 5.71, Box 5-2]. In implicit steps it is turned with each element, as far as the velocities at the beginning
// turn it: a rigid turn strains nothing. They act on held and driven degrees of freedom, too. Energies:
// "stiffness damping", lost so far. That is the most of the work at any time: of a turning sheet, vibrations
// that no step resolves let the work fall and rise.
class StiffnessDamping final : public Term, public OnMotion {
 public:
  StiffnessDamping(Assembly& assembly, double b) : assembly_(assembly), b_(b) {}  // b: s
  const char* name() const override { return "stiffness damping"; }
  Outcome begin_step(const Motion& motion) override;
  void resist(const Trial& trial, std::span<double> r) override;
  void add_resistance(const Trial& trial, linear::Matrix& K) override;
  void add_energies(const Trial&, std::vector<Energy>& out) const override;
  std::span<const double> on_supports() const override { return supports_.x; }
  StepWork step_work() const override { return {driven_, 0}; }
  void finish_step(const Motion& motion) override;
  void commit() override { before_ = force_; }
  void renumbered(Forces&) override { number_.clear(); }
  void keep(Archive& archive) override { archive(lost_, work_, before_, supports_.x, supports_.d); }

 private:
  void list_supported();
  NodalRates at_supports(const Motion& motion) const;
  double work_on_driven(const NodalRates& before, double late) const;

  Assembly& assembly_;
  double b_;
  linear::Matrix K_;                    // K_M
  std::vector<double> lead_, product_;  // rates of the driven degrees of freedom, and K_M times these
  std::vector<double> force_, before_;  // per unknown, N and N m: trial, committed
  // The elements at supports, their K_M, and the number of each by batch and lane, -1: it is at none.
  std::vector<BatchLane> supported_;
  std::vector<double> stiffness_;
  std::vector<Index> number_;
  NodalRates supports_;                      // N, and N m on driven directors; committed
  double lost_ = 0, work_ = 0, driven_ = 0;  // J, in committed steps; in the last one, of supports
};

// Viscous forces c m (x - x0) / dt on every free displacement, in a step of dt from x0; m is the node's mass.
// c (1/s) is adapted so that a step dissipates a given fraction of its work. Energies: "stabilisation", lost
// so far.
class Stabilisation final : public Term, public OnMotion {
 public:
  Stabilisation(const Assembly& assembly, double fraction);
  const char* name() const override { return "stabilisation"; }
  void renumbered(Forces&) override { list_freedoms(); }
  void resist(const Trial& trial, std::span<double> r) override;
  // In the first call of a run c is set so that the nodes' viscous stiffness is `fraction` of K's.
  void add_resistance(const Trial& trial, linear::Matrix& K) override;
  void add_energies(const Trial&, std::vector<Energy>& out) const override;
  void finish_step(const Motion& motion) override { lost_ += work(motion); }
  void keep(Archive& archive) override { archive(factor_, lost_); }

  double work(const Motion& motion) const;  // J, lost in the step, at the trial configuration
  double lost() const { return lost_; }     // J, in committed steps
  // To be called after a step, with its dissipation and the work done on the sheet, J.
  void adapt(double lost, double step_work);
  void raise() { factor_ *= 4; }  // after a step that failed
  double factor() const { return factor_; }
  void set_factor(double c) { factor_ = c; }

 private:
  struct Freedom {
    Index equation, node;
    int component;
  };
  void list_freedoms();
  double moved(const Freedom& f) const;  // m, in the node's frame, in the step
  const Assembly& assembly_;
  double fraction_, factor_ = 0, lost_ = 0;
  std::vector<Freedom> freedoms_;
};

}  // namespace fabricsh::mechanics
