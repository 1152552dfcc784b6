// Implicit Newmark, with Hilbert, Hughes and Taylor's alpha as an option: nodes and directors, Newton's
// method.
//
//   x+ = x + dt v + dt^2 ((1/2 - beta) a + beta a+),   v+ = v + dt ((1 - gamma) a + gamma a+)
//   M a+ = (1 + alpha) f(x+) - alpha f(x),   f = f_ext - f_int - C v
//
// On the sphere of directors the increment is an arc from d to d+, and what belongs to d is carried along it.
#pragma once
#include "analysis/dynamic.hpp"
#include "analysis/failure.hpp"
#include "analysis/step_control.hpp"
#include "linear/libraries.hpp"
#include "solver/newton.hpp"

namespace fabricsh::analysis {

class Implicit final : public Dynamic {
 public:
  Implicit(std::shared_ptr<model::Model> model, const DynamicOptions& options,
           std::shared_ptr<Notices> notices);
  const mechanics::NodalRates& rates() const override;
  ~Implicit() override;
  double tolerance() const override { return options_.tolerance; }
  std::string kernels() const override { return linear::blas_kernels(); }

 private:
  class Problem;
  void begin() override;
  void take_options(const DynamicOptions& options) override;
  void set_motion(const mechanics::NodalRates& rates) override;
  double try_step(double limit, StepReport& report) override;
  bool attempt(double size, StepReport& report) override;
  double largest_step() const override { return control_.largest(); }
  void commit(StepReport& report) override;
  [[noreturn]] void give_up(const StepReport& report) override;
  double kinetic() const override;
  double free_kinetic() const;
  void memory(Archive& archive) override;

  double along(const mechanics::DrivenFreedom& motion, std::span<const double> v) const;

  std::unique_ptr<Problem> problem_;
  solver::Newton newton_;
  StepControl control_;
  bool tried_ = false;  // is the trial state a whole step, not yet committed
  solver::NewtonResult last_;
  Blame blame_;
  std::vector<Try> tries_;  // of the step under way, that failed
};

}  // namespace fabricsh::analysis
