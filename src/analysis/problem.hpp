// The quasi-static problem as Newton sees it: supports and loads at a target time, the assembly's forces and
// tangents.
#pragma once
#include <algorithm>

#include "analysis/damping.hpp"
#include "analysis/static.hpp"

namespace fabricsh::analysis {

class Static::Problem final : public solver::PathProblem {
 public:
  // small_time: s, that rates are differences over.
  // poll: called, where it is set, before each evaluation of forces; may throw.
  Problem(mechanics::Assembly& assembly, double small_time, double stabilise,
          const std::function<void()>& poll)
      : assembly_(assembly),
        poll_(poll),
        damping_(assembly, stabilise),
        small_time_(small_time),
        product_(assembly.unknowns()),
        ahead_(assembly.unknowns()),
        lead_(assembly.targets(0).size()) {
    memory_.driven = assembly.targets(0);
    assembly_.external(0, external_);
    memory_.external = external_;
  }

  // Sets the time whose supports and loads the next predict() aims at.
  void aim(double time) override {
    aimed_ = time;
    targets_ = assembly_.targets(time);
    assembly_.external(time, external_);
    assembly_.aim(time);
  }
  // After a commit: what the last step did is where a reversal is seen from.
  void committed() {
    memory_.lead = lead_;
    memory_.driven = targets_;
    memory_.push = push_;
    memory_.external = external_;
    memory_.peak = std::max(memory_.peak, assembly_.largest_force());
  }
  void keep(Archive& archive) {
    if (archive.reading()) aim(std::as_const(assembly_).state().time());
    double damping = damping_.factor();
    archive(memory_, damping);
    damping_.set_factor(damping);
  }
  const std::vector<double>& external() const { return external_; }
  Damping& damping() { return damping_; }
  // Has a path come to a kink of a history, where loads may turn round?
  void at_kink(bool kink) { memory_.kink = kink; }
  // A configuration to come back to.
  void keep() {
    const auto k = assembly_.state().kinematics();
    kept_.assign(k.begin(), k.end());
  }
  void recall() {
    std::copy(kept_.begin(), kept_.end(), assembly_.state().kinematics().begin());
    assembly_.state().touch();
  }

  solver::Index size() const override { return assembly_.unknowns(); }

  bool predict(linear::Matrix& K, std::span<double> r) override {
    assembly_.rollback();
    assembly_.begin_iterate();
    for (std::size_t i = 0; i < lead_.size(); ++i) lead_[i] = targets_[i] - memory_.driven[i];
    set_push(external_, memory_.external);
    const auto at = reverses() ? fabric::AtSwitch::unloading : fabric::AtSwitch::loading;
    if (!assembly_.tangent(step(at), K, lead_, product_)) return false;
    assembly_.residual(external_, r);
    for (std::size_t i = 0; i < r.size(); ++i) r[i] -= product_[i];
    damping_.start(aimed_ - assembly_.state().time(), K);
    damping_.add_stiffness(K);
    return true;
  }
  void retract(std::span<const double> delta, double scale) override {
    assembly_.retract(delta, scale, targets_);
  }
  void accept() override { assembly_.begin_iterate(); }
  bool residual(std::span<double> r) override {
    if (poll_) poll_();
    if (!assembly_.forces(step(fabric::AtSwitch::loading))) return false;
    assembly_.residual(external_, r);
    damping_.add_force(r);
    return true;
  }
  bool tangent(linear::Matrix& K) override {
    if (!assembly_.tangent(step(fabric::AtSwitch::loading), K, {}, {})) return false;
    damping_.add_stiffness(K);
    return true;
  }

  bool start(linear::Matrix& K, std::span<double> r, std::span<double> q) override {
    assembly_.rollback();
    assembly_.begin_iterate();
    look_ahead();
    const auto at = memory_.kink && reverses() ? fabric::AtSwitch::unloading : fabric::AtSwitch::loading;
    if (!tangent_and_rate(at, K, q)) return false;
    assembly_.residual(external_, r);
    return true;
  }
  bool tangent_and_rate(linear::Matrix& K, std::span<double> q) override {
    look_ahead();
    return tangent_and_rate(fabric::AtSwitch::loading, K, q);
  }
  double product(std::span<const double> a, std::span<const double> b) const override {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      if (!assembly_.turns(static_cast<mechanics::Index>(i))) sum += a[i] * b[i];
    return sum;
  }
  std::pair<double, solver::Index> largest(std::span<const double> r) const override {
    return assembly_.largest_residual(r);
  }
  double force_scale() const override { return std::max(memory_.peak, assembly_.largest_force()); }

  double rounding_floor(const linear::Matrix& K) const override { return assembly_.rounding_floor(K); }

 private:
  // The step under way, as the law sees it.
  fabric::Step step(fabric::AtSwitch at) const {
    const double now = std::as_const(assembly_).state().time();
    return {now, aimed_ - now, at};
  }
  void set_push(const std::vector<double>& to, const std::vector<double>& from) {
    push_.resize(to.size());
    for (std::size_t i = 0; i < to.size(); ++i) push_[i] = to[i] - from[i];
  }
  // What supports and dead loads do in a small time from the one aimed at.
  void look_ahead() {
    const double later = aimed_ + small_time_;
    const auto moved = assembly_.targets(later);
    for (std::size_t i = 0; i < lead_.size(); ++i) lead_[i] = moved[i] - targets_[i];
    assembly_.external(later, later_external_);
    set_push(later_external_, external_);
  }
  // K and q = dr/dt at fixed unknowns; the coupling with the driven freedoms is the tangent's own, the rate
  // of follower loads a difference of forces. Leaves the forces of the time aimed at.
  bool tangent_and_rate(fabric::AtSwitch at, linear::Matrix& K, std::span<double> q) {
    const bool follower = !assembly_.symmetric_loads();
    if (follower) {
      assembly_.aim(aimed_ + small_time_);
      const bool done = assembly_.forces(step(at));
      assembly_.residual(later_external_, ahead_);
      assembly_.aim(aimed_);
      if (!done) return false;
    }
    if (!assembly_.tangent(step(at), K, lead_, product_)) return false;
    if (!follower) assembly_.residual(later_external_, ahead_);
    assembly_.residual(external_, q);
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = (ahead_[i] - q[i] - product_[i]) / small_time_;
    return true;
  }
  // Does this step move supports and loads against the way of the last one?
  bool reverses() const {
    double along = 0;
    for (std::size_t i = 0; i < memory_.lead.size(); ++i) along += memory_.lead[i] * lead_[i];
    for (std::size_t i = 0; i < memory_.push.size(); ++i) along += memory_.push[i] * push_[i];
    return along < 0;
  }

  mechanics::Assembly& assembly_;
  const std::function<void()>& poll_;
  Damping damping_;
  double small_time_, aimed_ = 0;
  std::vector<double> product_, ahead_, later_external_, push_, kept_;
  std::vector<double> lead_, targets_, external_;
  struct Memory {                        // all that the next step remembers of the last ones
    std::vector<double> driven, lead;    // at the last commit; what the last step did to them
    std::vector<double> external, push;  // dead loads likewise
    double peak = 0;                     // N, the largest nodal force of the run's committed states
    bool kink = true;
    void keep(Archive& archive) { archive(driven, lead, external, push, peak, kink); }
  } memory_;
};

}  // namespace fabricsh::analysis
