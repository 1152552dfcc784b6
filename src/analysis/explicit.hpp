// Central differences: beta = 0, lumped mass; one evaluation of forces a step.
//
//   v~ = v + (1 - gamma) dt a,   x+ = x + dt v + dt^2/2 a,   M a+ = f(x+) - C v+,   v+ = v~ + gamma dt a+
//
// Rotations of a director count along b1, b2, which travel with it on its great circle, so that velocities
// keep their components: momentum and angular momentum are kept exactly.
#pragma once
#include "analysis/dynamic.hpp"
#include "analysis/stiffness_damping.hpp"

namespace fabricsh::analysis {

class Explicit final : public Dynamic {
 public:
  Explicit(std::shared_ptr<model::Model> model, const DynamicOptions& options,
           std::shared_ptr<Notices> notices);
  const mechanics::NodalRates& rates() const override;

 private:
  void begin() override;
  void take_options(const DynamicOptions& options) override;
  void set_motion(const mechanics::NodalRates& rates) override;
  double try_step(double limit, StepReport& report) override;
  bool attempt(double size, StepReport& report) override;
  double largest_step() const override { return now_.step; }
  void commit(StepReport& report) override;
  [[noreturn]] void give_up(const StepReport& report) override;
  double kinetic() const override;
  void memory(Archive& archive) override;

  void check_stable_step(double undamped) const;  // s, without stiffness damping
  void choose_step();
  void split();  // where the sheet's stretch has brought the stable step below the one in use
  mesh::Index fastest_node() const;  // -1: none moves
  bool accelerate(double dt, const std::vector<double>& dead);
  double kinetic_of(const std::vector<double>& v) const;

  struct Motion {
    std::vector<double> v, a;  // per unknown, m/s and 1/s, m/s^2 and 1/s^2
    std::vector<double> c;     // N and N m, of stiffness damping; empty without
    void keep(Archive& archive) { archive(v, a, c); }
  };
  StiffnessDamping stiffness_;
  std::vector<double> mass_;      // per unknown, kg and kg m^2
  std::vector<double> farthest_;  // per unknown, m or rad: a step beyond is a runaway
  Motion motion_, trial_;
  std::vector<double> increment_, residual_, trial_dead_;
  std::vector<double> targets_, trial_targets_;  // of the driven freedoms
  bool dirty_ = false;                           // does the trial state differ from the committed one
  bool tried_ = false;                           // is it a whole step, not yet committed
  bool ran_away_ = false;
  mutable mechanics::NodalRates rates_;
  mutable std::uint64_t rates_version_ = 0;
};

}  // namespace fabricsh::analysis
