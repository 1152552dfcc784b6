// What held cloth in the run from which another one begins: forces on its nodes that fade in time.
#pragma once
#include "mechanics/facets.hpp"

namespace fabricsh::mechanics {

// Forces and, on directors, forces of fixed direction, as at the time `from`; at `from` + `over` nothing of
// them is left. None until it is told.
class Release final : public Term, public FollowerLoad {
 public:
  const char* name() const override { return "release"; }
  // 3 per node: N; N m, tangent to the directors.
  void begin(std::vector<double> on_x, std::vector<double> on_d, double from, double over);
  bool any() const { return !on_x_.empty(); }
  void add_dead(double time, std::span<double> on_x) const override;
  bool constant() const override { return !any(); }
  bool follows_directors() const override { return any(); }
  void add_follower(double time, const Trial&, std::span<double> on_x, std::span<double> on_d) const override;
  Outcome add_forces(const law::Step&, const Trial& trial, Forces& forces) override;
  void add_tangent(const Trial& trial, TangentSink& sink) const override;
  void keep(Archive& archive) override { archive(on_x_, on_d_, from_, over_); }

 private:
  double share(double time) const;
  std::vector<double> on_x_, on_d_;
  double from_ = 0, over_ = 0;  // s
};

}  // namespace fabricsh::mechanics
