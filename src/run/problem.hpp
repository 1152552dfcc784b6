// The problem as the solvers see it: the sum of the terms with a time scheme. Supports and loads are those of
// the time given to set_time(); forces, tangent and motion are those of a step to it from the committed
// configuration.
//
// It serves quasi-static steps, Newmark's method, and central differences, which need no matrix.
#pragma once
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "mechanics/terms/cloth.hpp"
#include "run/newmark.hpp"
#include "solver/arc_length.hpp"

namespace fabricsh::run {

class EquilibriumProblem final : public solver::PathProblem {
 public:
  using Poll = std::function<void()>;  // if set, called before each evaluation of forces; may throw
  // Quasi-static. small_time: s, for rates by differences in path following.
  EquilibriumProblem(mechanics::Assembly& assembly, double small_time, const Poll& poll);
  // For Newmark's method; and for a scheme that does not solve for unknowns. Keeps a reference to the motion.
  EquilibriumProblem(mechanics::Assembly& assembly, Newmark& newmark, const Poll& poll);
  EquilibriumProblem(mechanics::Assembly& assembly, mechanics::Motion& motion, const Poll& poll);
  ~EquilibriumProblem() override { assembly_.set_motion(nullptr); }
  EquilibriumProblem(const EquilibriumProblem&) = delete;
  EquilibriumProblem& operator=(const EquilibriumProblem&) = delete;

  const mechanics::Motion& motion() const { return motion_; }
  double time() const { return trial_time_; }                           // s, of the trial
  const std::vector<double>& external() const { return external_; }     // dead loads then, N, 3 per node
  const std::vector<double>& targets() const { return targets_; }       // of the driven freedoms at that time
  const std::vector<double>& driven() const { return memory_.driven; }  // at the last commit
  // With initial velocities, and accelerations from M a = f; those of held and driven degrees of freedom are
  // zero. NumericalFailure: the mass matrix is singular.
  void start(const mechanics::NodalRates& velocities);
  void start();  // from rest, or with the motion that the scheme already has
  // Starts a step from the committed configuration. Returns whether the terms can make it.
  Answer begin_step();
  void commit(double time);  // the trial state; the terms then account for it in finish_step()
  // Makes the whole step, in which the unknowns move by `reach` times `along`.
  void advance_explicit(std::span<const double> along, double reach) {
    assembly_.apply_increment(along, reach, targets_, 1);
  }
  // The numbers of unknowns have changed. Forces of earlier steps are forgotten.
  void resize();
  // The residual of the forces as they are.
  void weigh(std::span<double> r);
  // J, work of the forces without inertia in the step: of contact by its value at the end, of the others by
  // the trapezoidal rule.
  double work_of_balance();
  void keep(Archive& archive);
  // Tells whether a path is at a kink of a history, where loads may reverse.
  void at_kink(bool kink) { memory_.kink = kink; }
  // m: by how much the place of a node, or of a point of a free body, at the end of the trial step may be
  // wrong, at most, because the step is so long: from the way that the steps so far lead.
  double error_of_step() const;

  // --- interface of the solvers, as far as runs use it themselves
  void set_time(double time) override;
  solver::Index size() const override { return assembly_.dofs().unknowns(); }
  Answer predict(linear::Matrix& K, std::span<double> r, std::span<double> lead) override;
  void apply_increment(std::span<const double> delta, double scale) override {
    assembly_.apply_increment(delta, scale, targets_);
  }
  void accept() override {
    assembly_.begin_iterate();
    arrived_ = targets_;
  }
  bool at_target() const override { return assembly_.terms().at_target(); }
  Answer residual(std::span<double> r) override;
  Answer tangent(linear::Matrix& K) override;
  double turn_of(std::span<const double> delta) const override;
  void save_iterate() override { assembly_.save_iterate(); }
  void restore_iterate() override { assembly_.restore_iterate(); }
  double force_scale() const override;

 private:
  void add_mass(linear::Matrix& K, double c, double of_body);
  // --- the rest of it
  double limit(std::span<const double> delta, double way) override {
    return assembly_.limit(delta, targets_, way);
  }
  // The supports go all of their way in any part of a step.
  bool is_safe(std::span<const double> delta, double part) override {
    return !assembly_.limits() || (arrived_ == targets_ && !assembly_.parts_leave_way()) ||
           assembly_.is_safe(delta, part, targets_);
  }
  bool finish_direction(const Solve& solve, std::span<double> delta) override {
    return assembly_.finish_direction(solve, weight(), delta);
  }
  void add_inertia(linear::Matrix& K, double times) override;
  Answer extrapolated_tangent(linear::Matrix& K) override;
  bool has_branches() const override { return newmark_ != nullptr; }
  Answer tangent_on_branches(linear::Matrix& K, std::span<double> r) override;
  Answer start(linear::Matrix& K, std::span<double> r, std::span<double> q) override;
  Answer tangent_and_rate(linear::Matrix& K, std::span<double> q) override;
  double product(std::span<const double> a, std::span<const double> b) const override;
  double opening(std::span<const double> way) const override;
  std::pair<double, solver::Index> largest(std::span<const double> r) const override {
    return assembly_.largest_residual(r);
  }
  double rounding_floor(const linear::Matrix& K) const override { return assembly_.dofs().rounding_floor(K); }

  EquilibriumProblem(mechanics::Assembly& assembly, mechanics::Motion* motion, Newmark* newmark,
                     double small_time,
                     const Poll& poll);  // motion: null: none
  void look_back();
  // m, of the nodes, and after them of what terms move beside them.
  std::vector<double> places(mechanics::OwnUnknowns::Places which) const;
  double goes_on(std::span<const double> from, std::vector<double>& way) const;
  bool tangent_with(mechanics::Cloth::Branches branches, const law::Step& step, linear::Matrix& K,
                    std::span<const double> lead, std::span<double> product);
  // The present step as passed to the law.
  law::Step step(law::AtSwitch at = law::AtSwitch::loading) const;
  Answer made(bool done) const { return done ? Answer::ok : assembly_.outcome().answer; }
  bool iterates() const { return newmark_ != nullptr || !motion_.moves(); }
  double weight() const { return newmark_ == nullptr ? 1 : 1 + newmark_->scheme().hht; }  // of the forces
  void return_to_commit();
  void lead_to_targets();
  void balance(double inertia, double at_end, std::span<double> r);
  mechanics::NodalRates accelerations(std::span<const double> r);
  void forget_step_end();
  void move_bodies(std::span<double> r);
  void close(linear::Matrix& K);
  void remember();
  void remember_bodies();
  void set_push(const std::vector<double>& to, const std::vector<double>& from);
  void look_ahead();
  Answer tangent_and_rate(law::AtSwitch at, linear::Matrix& K, std::span<double> q);
  bool reverses() const;

  mechanics::Assembly& assembly_;
  mechanics::QuasiStatic still_;
  mechanics::Motion& motion_;
  Newmark* newmark_;  // null for other schemes
  const Poll& poll_;
  double small_time_, trial_time_ = 0;
  std::vector<double> product_, ahead_, later_external_, push_, balance_, on_x_, on_d_;
  std::vector<double> lead_, targets_, external_;
  std::vector<double> arrived_;          // the targets at which the supports are in the iterate
  std::vector<double> lumped_;           // mass of each unknown, kg and kg m^2, once it is needed
  struct StepMemory {                    // the data of earlier steps that the next one needs
    std::vector<double> driven, lead;    // at the last commit; change in the last step
    std::vector<double> external, push;  // dead loads likewise
    std::vector<double> balance;         // forces without inertia and contact then, per unknown, N and N m
    std::vector<double> on_bodies;       // the scheme's forces F^ on rigid bodies then, six each
    double peak = 0;                     // N, the largest nodal force of the run's committed states
    bool kink = true;
    // The places() before the last step and before that, and the lengths of the two steps, s.
    // Empty: there were none.
    std::vector<double> before, earlier;
    double last_step = 0, step_before = 0;
    void keep(Archive& archive) {
      archive(driven, lead, external, push, balance, on_bodies, peak, kink, before, earlier, last_step,
              step_before);
    }
  } memory_;
};

}  // namespace fabricsh::run
