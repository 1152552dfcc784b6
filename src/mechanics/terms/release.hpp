// Forces that held cloth in the run from which another one begins: they act on its nodes and fade in time.
#pragma once
#include <algorithm>

#include "geometry/node_view.hpp"
#include "mechanics/facets.hpp"

namespace fabricsh::mechanics {

// Forces and, on directors, forces of fixed direction, as at the time `from`; at `from` + `over` nothing of
// them is left. None until it is told.
class Release final : public Term, public FollowerLoad {
 public:
  const char* name() const override { return "release"; }
  // 3 per node: N; N m, tangent to the directors.
  void begin(std::vector<double> on_x, std::vector<double> on_d, double from, double over) {
    on_x_ = std::move(on_x);
    on_d_ = std::move(on_d);
    from_ = from;
    over_ = over;
  }
  bool any() const { return !on_x_.empty(); }
  void add_dead(double time, std::span<double> on_x) const override {
    const double s = any() ? share(time) : 0;
    for (std::size_t i = 0; s > 0 && i < on_x_.size(); ++i) on_x[i] += s * on_x_[i];
  }
  bool constant() const override { return !any(); }
  bool follows_directors() const override { return any(); }
  void add_follower(double time, const Trial&, std::span<double>, std::span<double> on_d) const override {
    const double s = any() ? share(time) : 0;
    for (std::size_t i = 0; s > 0 && i < on_d_.size(); ++i) on_d[i] += s * on_d_[i];
  }
  Outcome add_forces(const law::Step&, const Trial& trial, Forces& forces) override {
    const double s = any() ? share(trial.time) : 0;
    for (std::size_t i = 0; s > 0 && i < on_d_.size(); ++i) forces.on_d[i] -= s * on_d_[i];
    return {};
  }
  // A force on a director does the work f . d, whose second variation on the sphere is -f . d.
  void add_tangent(const Trial& trial, TangentSink& sink) const override {
    const double s = any() ? share(trial.time) : 0;
    if (!(s > 0)) return;
    const auto d = trial.configuration.d();
    for (Index n = 0; n < static_cast<Index>(on_d_.size() / 3); ++n)
      if (const double along = s * at(std::span<const double>(on_d_), n).dot(at(d, n)); along != 0)
        sink.on_director(n, along * Eigen::Matrix2d::Identity());
  }
  void keep(Archive& archive) override { archive(on_x_, on_d_, from_, over_); }

 private:
  double share(double time) const { return std::clamp(1 - (time - from_) / over_, 0.0, 1.0); }
  std::vector<double> on_x_, on_d_;
  double from_ = 0, over_ = 0;  // s
};

}  // namespace fabricsh::mechanics
