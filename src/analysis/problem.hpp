// The quasi-static problem as Newton sees it: supports and loads at a target time, the assembly's forces and
// tangents.
#pragma once
#include "analysis/analysis.hpp"

namespace fabricsh::analysis {

class Static::Problem final : public solver::Problem {
 public:
  explicit Problem(assembly::Assembly& assembly)
      : assembly_(assembly),
        product_(assembly.unknowns()),
        driven_(assembly.targets(0)),
        lead_(driven_.size()) {
    assembly_.external(0, external_);
    committed_external_ = external_;
  }

  // Sets the time whose supports and loads the next predict() aims at.
  void aim(double time) {
    targets_ = assembly_.targets(time);
    assembly_.external(time, external_);
    assembly_.aim(time);
  }
  // After a commit: what the last step did is where a reversal is seen from.
  void committed() {
    previous_lead_ = lead_;
    driven_ = targets_;
    previous_push_ = push();
    committed_external_ = external_;
    peak_ = std::max(peak_, assembly_.largest_force());
  }
  const std::vector<double>& external() const { return external_; }

  solver::Index size() const override { return assembly_.unknowns(); }

  bool predict(solver::SparseMatrix& K, std::span<double> r) override {
    assembly_.state().rollback();
    assembly_.begin_iterate();
    for (std::size_t i = 0; i < lead_.size(); ++i) lead_[i] = targets_[i] - driven_[i];
    const auto at = reverses() ? fabric::AtSwitch::unloading : fabric::AtSwitch::loading;
    if (!assembly_.tangent(at, K, lead_, product_)) return false;
    assembly_.residual(external_, r);
    for (std::size_t i = 0; i < r.size(); ++i) r[i] -= product_[i];
    return true;
  }
  void retract(std::span<const double> delta, double scale) override {
    assembly_.retract(delta, scale, targets_);
  }
  void accept() override { assembly_.begin_iterate(); }
  bool residual(std::span<double> r) override {
    if (!assembly_.forces(fabric::AtSwitch::loading)) return false;
    assembly_.residual(external_, r);
    return true;
  }
  bool tangent(solver::SparseMatrix& K) override {
    return assembly_.tangent(fabric::AtSwitch::loading, K, {}, {});
  }
  std::pair<double, solver::Index> largest(std::span<const double> r) const override {
    return assembly_.largest_residual(r);
  }
  double force_scale() const override { return std::max(peak_, assembly_.largest_force()); }

  double rounding_floor(const solver::SparseMatrix& K) const override { return assembly_.rounding_floor(K); }

 private:
  std::vector<double> push() const {
    std::vector<double> p(external_.size());
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = external_[i] - committed_external_[i];
    return p;
  }
  // Does this step move supports and loads against the way of the last one?
  bool reverses() const {
    double along = 0;
    for (std::size_t i = 0; i < previous_lead_.size(); ++i) along += previous_lead_[i] * lead_[i];
    const auto p = push();
    for (std::size_t i = 0; i < previous_push_.size(); ++i) along += previous_push_[i] * p[i];
    return along < 0;
  }

  assembly::Assembly& assembly_;
  std::vector<double> product_, driven_, lead_, previous_lead_, targets_;
  std::vector<double> external_, committed_external_, previous_push_;
  double peak_ = 0;  // N, the largest nodal force of the run's committed states
};

}  // namespace fabricsh::analysis
