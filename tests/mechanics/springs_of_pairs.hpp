// A term of tests: springs between pairs of nodes that pull once the pair is longer than a length of its own,
// with energy k / 3 (r - length)^3, so that its tangent couples more nodes the farther a sheet is stretched.
#pragma once
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/node_view.hpp"
#include "mechanics/facets.hpp"

namespace fabricsh::test {

class SpringsOfPairs final : public mechanics::Term, public mechanics::StepLimiter {
 public:
  SpringsOfPairs(std::vector<mechanics::NodePair> pairs, std::vector<double> lengths, double k,
                 bool stiff = true)
      : pairs_(std::move(pairs)), lengths_(std::move(lengths)), k_(k), stiff_(stiff) {}

  bool names_pairs = true;    // or forgets to
  bool names_all = false;     // also of the springs that are slack
  double farthest = 0;        // m: no pair may get longer; 0: no limit
  mechanics::Outcome answer;  // to its forces

  const char* name() const override { return "springs of pairs"; }
  mechanics::Outcome add_forces(const law::Step&, const mechanics::Trial& trial,
                                mechanics::Forces& forces) override {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const auto [a, b] = pairs_[i];
      const Vec3 way = between(trial, i);
      const double pull = beyond(trial, i);
      const Vec3 f = k_ * pull * pull * way.normalized();
      at(forces.on_x, b) += f;
      at(forces.on_x, a) -= f;
    }
    return answer;
  }
  void couple(const mechanics::Trial& trial, std::vector<mechanics::NodePair>& pairs) override {
    for (std::size_t i = 0; i < pairs_.size() && names_pairs; ++i)
      if (names_all || beyond(trial, i) > 0) pairs.push_back(pairs_[i]);
  }
  void add_tangent(const mechanics::Trial& trial, mechanics::TangentSink& sink) const override {
    for (std::size_t i = 0; i < pairs_.size() && stiff_; ++i) {
      const double pull = beyond(trial, i);
      if (!(pull > 0)) continue;
      const auto [a, b] = pairs_[i];
      const Vec3 way = between(trial, i), n = way.normalized();
      const Mat3 along = n * n.transpose();
      const Mat3 k = k_ * (2 * pull * along + pull * pull / way.norm() * (Mat3::Identity() - along));
      sink.on_positions(a, a, k);
      sink.on_positions(b, b, k);
      sink.on_positions(a, b, -k);
      sink.on_positions(b, a, -k);
    }
  }
  void add_energies(const mechanics::Trial& trial, std::vector<mechanics::Energy>& out) const override {
    double sum = 0;
    for (std::size_t i = 0; i < pairs_.size(); ++i) sum += k_ / 3 * std::pow(beyond(trial, i), 3);
    out.push_back({"springs of pairs", mechanics::Account::stored, sum});
  }
  bool limits() const override { return farthest > 0; }
  void mark(const mechanics::Trial& trial) override {
    const auto x = trial.configuration.x();
    marked_.assign(x.begin(), x.end());
  }
  // Exact for pairs that are stretched along themselves.
  double safe_fraction(const mechanics::Trial& trial) override {
    double share = 1;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const auto [a, b] = pairs_[i];
      const double from = (at(marked_, b) - at(marked_, a)).norm(), to = between(trial, i).norm();
      if (to > farthest * (1 + 1e-14)) share = std::min(share, (farthest - from) / (to - from));
    }
    return std::max(0.0, share);
  }

 private:
  Vec3 between(const mechanics::Trial& trial, std::size_t i) const {
    const auto x = trial.configuration.x();
    return at(x, pairs_[i].second) - at(x, pairs_[i].first);
  }
  double beyond(const mechanics::Trial& trial, std::size_t i) const {
    return std::max(0.0, between(trial, i).norm() - lengths_[i]);
  }
  std::vector<mechanics::NodePair> pairs_;
  std::vector<double> lengths_;  // m
  double k_;                     // N/m^2
  bool stiff_;
  std::vector<double> marked_;  // m, 3 per node
};

}  // namespace fabricsh::test
