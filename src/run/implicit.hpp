// The run by Newmark's implicit method and Newton's method.
#pragma once
#include "linear/libraries.hpp"
#include "run/diagnosis.hpp"
#include "run/dynamic.hpp"
#include "run/problem.hpp"
#include "run/step_control.hpp"
#include "solver/newton.hpp"
#include "solver/trust_region.hpp"

namespace fabricsh::run {

class Implicit final : public Dynamic {
 public:
  Implicit(std::shared_ptr<model::Model> model, const DynamicOptions& options,
           std::shared_ptr<Notices> notices, const Beginning& beginning = {});
  const mechanics::NodalRates& rates() const override;
  double tolerance() const override { return options_.tolerance; }
  std::string kernels() const override { return linear::blas_kernels(); }

 private:
  bool takes_unsymmetric() const override {
    return !takes_symmetric(options_.linear, assembly_->terms().symmetric());
  }
  bool is_near_symmetric() const {  // but for what contact and loads add
    return options_.linear == Symmetry::automatic && !options_.solver && takes_unsymmetric() &&
           assembly_->cloth().symmetric();
  }
  void begin() override;
  void take_options(const DynamicOptions& options) override;
  void set_motion(const mechanics::NodalRates& rates) override;
  double try_step(double limit, StepReport& report) override;
  bool attempt(double size, StepReport& report) override;
  bool errs(double end);  // more than asked for; chooses the next step
  double largest_step() const override { return control_.largest(); }
  void commit(StepReport& report) override;
  [[noreturn]] void give_up(const StepReport& report) override;
  const mechanics::Motion& motion() const override { return newmark_; }
  double place_of_contact() const override { return newmark_.weight_of_end(); }
  void memory(Archive& archive) override;
  std::vector<double> unknown_rates() const override {
    return assembly_->dofs().collect_rates(newmark_.velocities());
  }
  void resize() override { problem_.resize(); }
  void take(const mechanics::Transfer& change, const std::vector<double>& rates) override;
  bool loss_falls();
  bool leave_hht(bool repeat);
  void begin_free();
  bool chooses_scheme() const;
  bool takes_alpha() const;  // as the first stage of damping
  std::string begin_to_damp(double error) override;
  void damp(Damping damping);
  double turn_per_step() const;       // rad, of a motion that is a turning for the most part, else 0
  std::string shorten_for_turning();  // empty: the motion turns little in a step
  std::string shorten(double turn, double part);
  void watch_turning();  // of a scheme that does not damp
  std::string damping_text() const;
  bool takes_back() override;
  bool tries_again(bool failed) override;
  void weigh_step_ends();
  void take_scheme();  // that of the options, the one that damps, or the one in which directors settle
  bool has_turning_directors() const;
  bool damps_unresolved() const;
  solver::NewtonResult minimise(solver::NewtonResult found, double size, const StepReport& report);
  void settle();
  void watch_corner();
  bool follows_corners() const;

  Newmark newmark_;
  EquilibriumProblem problem_;
  solver::Newton newton_;
  std::unique_ptr<solver::TrustRegion> downhill_;  // created if it is used
  StepControl control_;
  double extent_ = 0, next_ = 0;  // m, the size of the model; s, the next step for the error asked for
  Diagnosis step_;                // the present one
  // The present step, if it may be taken back: as it is tried first, shortened, repeated with strong damping,
  // or as at first for good.
  struct Repeatable {
    enum class Try { first, damped, first_again };
    double step = 0;               // s, for which it began
    std::string start;             // the state before it; empty: it is not taken back
    double surplus = 0, made = 0;  // J, of the ledger before it; its first try's share of the ledger's scale
    double energy = 0;             // J, that its last try without more damping made
    bool young = false;            // whether the run is, in the whole step
    bool settling = false;         // whether directors settle in it
    bool corner = false;           // whether it follows a jump of a support's speed
    Try which = Try::first;
    int halved = 0;  // times, for its error of the ledger
  } repeatable_;
  void mark_repeatable();
  bool repeats() const { return repeatable_.which != Repeatable::Try::first || repeatable_.halved > 0; }
  void return_to_start(Repeatable::Try next);
  bool shortens(double error, double energy, int most);  // at most so many times
  void halve(double end, int halved = 0);
};

}  // namespace fabricsh::run
