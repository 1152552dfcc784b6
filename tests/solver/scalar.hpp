// A problem of one unknown for the solvers, whose every number is known beforehand.
#pragma once
#include <cmath>
#include <functional>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "solver/arc_length.hpp"

namespace fabricsh::test {

using solver::Index, solver::Matrix;

inline std::shared_ptr<const linear::Pattern> one_by_one() {
  static const auto pattern =
      std::make_shared<const linear::Pattern>(std::vector<Index>{0, 1}, std::vector<Index>{0});
  return pattern;
}

// r(u, t) = 0 for one unknown u; the solvers get the stiffness that they are told. Without a time, t is 0.
class Scalar final : public solver::PathProblem {
 public:
  std::function<double(double u, double t)> force;        // r; not a number: not with this step
  std::function<bool(double u)> broken;                   // are the forces beyond repair there
  std::function<double(double from, double delta)> safe;  // the share of a step that is
  std::function<bool(double part)> safe_part;             // whether a part of it is
  std::function<double(double u)> stiffness;
  std::function<std::pair<double, double>(double u)> on_branch;  // stiffness and r, if it has branches
  double committed = 0;
  double rate = 1;             // dr/dt
  std::vector<double> shares;  // of its increments that were tried

  double trial() const { return trial_; }
  void set_trial(double u) { trial_ = u; }

  Index size() const override { return 1; }
  void set_time(double time) override { time_ = time; }
  Answer predict(Matrix& K, std::span<double> r, std::span<double> lead) override {
    trial_ = iterate_ = committed;
    lead[0] = 0;
    return worse(tangent(K), residual(r));
  }
  Answer start(Matrix& K, std::span<double> r, std::span<double> q) override {
    trial_ = iterate_ = committed;
    q[0] = rate;
    return worse(tangent(K), residual(r));
  }
  Answer tangent_and_rate(Matrix& K, std::span<double> q) override {
    q[0] = rate;
    return tangent(K);
  }
  void apply_increment(std::span<const double> delta, double scale) override {
    shares.push_back(scale);
    trial_ = iterate_ + scale * delta[0];
  }
  double limit(std::span<const double> delta, double) override { return safe ? safe(iterate_, delta[0]) : 1; }
  bool is_safe(std::span<const double>, double part) override { return !safe_part || safe_part(part); }
  void accept() override { iterate_ = trial_; }
  Answer residual(std::span<double> r) override {
    if (broken && broken(trial_)) return Answer::broken;
    r[0] = force(trial_, time_);
    return std::isnan(r[0]) ? Answer::cut : Answer::ok;
  }
  Answer tangent(Matrix& K) override {
    K.follow(one_by_one());
    K.value[0] = stiffness(trial_);
    return Answer::ok;
  }
  bool has_branches() const override { return static_cast<bool>(on_branch); }
  Answer tangent_on_branches(Matrix& K, std::span<double> r) override {
    K.follow(one_by_one());
    std::tie(K.value[0], r[0]) = on_branch(trial_);
    return Answer::ok;
  }
  double turn_of(std::span<const double> delta) const override { return std::abs(delta[0]); }
  void save_iterate() override { mark_ = iterate_; }
  void restore_iterate() override { trial_ = mark_; }
  double product(std::span<const double> a, std::span<const double> b) const override { return a[0] * b[0]; }
  std::pair<double, Index> largest(std::span<const double> r) const override { return {std::abs(r[0]), 0}; }
  double force_scale() const override { return 1; }
  double rounding_floor(const Matrix&) const override { return 0; }

 private:
  double trial_ = 0, iterate_ = 0, mark_ = 0, time_ = 0;
};

}  // namespace fabricsh::test
