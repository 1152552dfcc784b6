#include <algorithm>
#include <numbers>

#include "geometry/node_view.hpp"
#include "geometry/turning.hpp"
#include "mechanics/terms/loads.hpp"

namespace fabricsh::mechanics {

namespace {

// Centrifugal forces m w^2 P (x - c) on nodes, where P takes the part across the axis. Their potential is
// -w^2/2 sum m |P (x - c)|^2, so that the tangent is symmetric: the stiffness of the cloth less w^2 m across
// the axis. Where the reference surface is not the middle surface, the mass is off the nodes, along their
// directors.
class Centrifuge final : public Term, public FollowerLoad {
 public:
  explicit Centrifuge(const LoadSite& site) : mass_(site.cloth.mass()), moment_(site.cloth.mass_moment()) {
    for (const auto& load : site.model.all<model::CentrifugalLoad>()) {
      const Vec3 e = load.axis.normalized();
      turns_.push_back({site.model.mesh().set(load.set), Mat3::Identity() - e * e.transpose(),
                        load.centre.value_or(Vec3::Zero()), load.speed});
    }
    is_offset_ = std::any_of(moment_.begin(), moment_.end(), [](double s) { return s != 0; });
    set_time(0);
  }
  const char* name() const override { return "centrifuge"; }
  void set_time(double time) override {
    at_trial_time_.clear();
    for (const Turning& turn : turns_) at_trial_time_.push_back(turn.square(time));
  }
  bool follows_positions() const override { return true; }
  bool follows_directors() const override { return is_offset_; }
  void add_follower(double time, const Trial& trial, std::span<double> on_x,
                    std::span<double> on_d) const override {
    for (const Turning& turn : turns_) add(turn, turn.square(time), trial.configuration, on_x, on_d);
  }
  Outcome add_forces(const law::Step&, const Trial& trial, Forces& forces) override {
    for (std::size_t i = 0; i < turns_.size(); ++i)
      add(turns_[i], -at_trial_time_[i], trial.configuration, forces.on_x, forces.on_d);
    return {};
  }

  void add_tangent(const Trial& trial, TangentSink& sink) const override {
    const auto x = trial.configuration.x(), d = trial.configuration.d(), b1 = trial.configuration.b1();
    for (std::size_t i = 0; i < turns_.size(); ++i)
      for (const Index n : turns_[i].nodes) {
        const Mat3 P = at_trial_time_[i] * turns_[i].across;  // 1/s^2
        if (moment_[n] == 0) {
          sink.on_positions(n, n, -mass_[n] * P);
          continue;
        }
        const Eigen::Matrix<double, 3, 2> B = turning_axes(at(d, n), at(b1, n));
        Eigen::Matrix<double, 5, 5> k;
        k.topLeftCorner<3, 3>() = -mass_[n] * P;
        k.topRightCorner<3, 2>() = -moment_[n] * P * B;
        k.bottomLeftCorner<2, 3>() = k.topRightCorner<3, 2>().transpose();
        // The second variation of the director.
        k.bottomRightCorner<2, 2>() =
            moment_[n] * at(d, n).dot(P * (at(x, n) - turns_[i].centre)) * Eigen::Matrix2d::Identity();
        sink.on_nodes(n, n, k);
      }
  }

 private:
  struct Turning {
    mesh::NodeSet nodes;
    Mat3 across;
    Vec3 centre;                        // m
    model::History speed;               // degrees/s
    double square(double time) const {  // rad^2/s^2
      const double w = std::numbers::pi / 180 * speed.value(time);
      return w * w;
    }
  };
  void add(const Turning& turn, double square, const Configuration& now, std::span<double> on_x,
           std::span<double> on_d) const {
    for (const Index n : turn.nodes) {
      const Vec3 r = square * turn.across * (at(now.x(), n) - turn.centre);
      at(on_x, n) += mass_[n] * r;
      if (moment_[n] == 0) continue;
      at(on_x, n) += moment_[n] * square * turn.across * at(now.d(), n);
      at(on_d, n) += moment_[n] * r;
    }
  }

  const std::vector<double>&mass_, &moment_;  // kg, kg m
  std::vector<Turning> turns_;
  bool is_offset_ = false;
  std::vector<double> at_trial_time_;  // rad^2/s^2
};

}  // namespace

std::unique_ptr<Term> centrifuge_term(const LoadSite& site) {
  if (site.model.all<model::CentrifugalLoad>().empty()) return {};
  return std::make_unique<Centrifuge>(site);
}

}  // namespace fabricsh::mechanics
