#include "mechanics/terms/release.hpp"

#include <algorithm>

#include "geometry/node_view.hpp"

namespace fabricsh::mechanics {

void Release::begin(std::vector<double> on_x, std::vector<double> on_d, double from, double over) {
  on_x_ = std::move(on_x);
  on_d_ = std::move(on_d);
  from_ = from;
  over_ = over;
}

double Release::share(double time) const { return std::clamp(1 - (time - from_) / over_, 0.0, 1.0); }

void Release::add_dead(double time, std::span<double> on_x) const {
  const double s = any() ? share(time) : 0;
  for (std::size_t i = 0; s > 0 && i < on_x_.size(); ++i) on_x[i] += s * on_x_[i];
}

void Release::add_follower(double time, const Trial&, std::span<double>, std::span<double> on_d) const {
  const double s = any() ? share(time) : 0;
  for (std::size_t i = 0; s > 0 && i < on_d_.size(); ++i) on_d[i] += s * on_d_[i];
}

Outcome Release::add_forces(const law::Step&, const Trial& trial, Forces& forces) {
  const double s = any() ? share(trial.time) : 0;
  for (std::size_t i = 0; s > 0 && i < on_d_.size(); ++i) forces.on_d[i] -= s * on_d_[i];
  return {};
}

// A force on a director does the work f . d, whose second variation on the sphere is -f . d.
void Release::add_tangent(const Trial& trial, TangentSink& sink) const {
  const double s = any() ? share(trial.time) : 0;
  if (!(s > 0)) return;
  const auto d = trial.configuration.d();
  for (Index n = 0; n < static_cast<Index>(on_d_.size() / 3); ++n)
    if (const double along = s * at(std::span<const double>(on_d_), n).dot(at(d, n)); along != 0)
      sink.on_director(n, along * Eigen::Matrix2d::Identity());
}

}  // namespace fabricsh::mechanics
