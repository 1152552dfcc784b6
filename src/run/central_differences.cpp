#include "run/central_differences.hpp"

#include <algorithm>
#include <cmath>

#include "base/ordered_sum.hpp"
#include "base/shares.hpp"

namespace fabricsh::run {

namespace {
constexpr std::size_t kShare = 4096;  // number of unknowns from which loops use several threads
}

CentralDifferences::CentralDifferences(std::vector<double> mass, double gamma,
                                       std::function<std::vector<double>()> driven)
    : gamma_(gamma), driven_(std::move(driven)) {
  resize(std::move(mass));
}

void CentralDifferences::start(std::vector<double> velocities) {
  committed_ = {std::move(velocities), std::vector<double>(mass_.size(), 0)};
  trial_ = committed_;
}

void CentralDifferences::resize(std::vector<double> mass) {
  mass_ = std::move(mass);
  per_mass_ = mass_;
  for (double& m : per_mass_) m = 1 / m;
  start(std::vector<double>(mass_.size(), 0));
}

bool CentralDifferences::predict(std::span<const unsigned char> turns,
                                 const std::array<double, 2>& farthest) {
  const double dt = this->dt(), early = (1 - gamma_) * dt;
  const Rates before = rates_of(committed_);
  double* const predicted = trial_.predicted.data();
  // Whether the increment exceeds its limit or is not a number.
  const auto is_far = [&](std::size_t i) {
    const double a = before.acceleration(i), v = before.velocity(i);
    predicted[i] = v + early * a;
    return std::abs(dt * (v + dt / 2 * a)) < farthest[turns[i]] ? 0 : 1;
  };
  std::int64_t far = 0;
  if (in_shares(mass_.size() >= kShare)) {
#pragma omp parallel for schedule(static) reduction(+ : far)
    for (std::size_t i = 0; i < mass_.size(); ++i) far += is_far(i);
  } else {
    for (std::size_t i = 0; i < mass_.size(); ++i) far += is_far(i);
  }
  return far == 0;
}

const std::vector<double>& CentralDifferences::increments() const {
  increments_.resize(mass_.size());
  const Rates before = rates_of(committed_);
  for_each_index(mass_.size(), mass_.size() >= kShare,
                 [&](std::size_t i) { increments_[i] = increment(before, i); });
  return increments_;
}

void CentralDifferences::accelerate(double mass_damping) {
  trial_.kick = gamma_ * dt();
  trial_.damping = mass_damping;
}

std::vector<double> CentralDifferences::velocities() const {
  std::vector<double> v(mass_.size());
  const Rates rates = rates_of(shown());
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = rates.velocity(i);
  return v;
}

double CentralDifferences::work(std::span<const double> before, std::span<const double> after) const {
  const Rates start = rates_of(committed_);
  return ordered_sum(mass_.size(),
                     [&](std::size_t i) { return (before[i] + after[i]) / 2 * increment(start, i); });
}

double CentralDifferences::work_of_velocity(double factor) const {
  const Rates before = rates_of(committed_), after = rates_of(trial_);
  return ordered_sum(mass_.size(), [&](std::size_t i) {
    return factor * mass_[i] * (before.velocity(i) + after.velocity(i)) / 2 * increment(before, i);
  });
}

double CentralDifferences::work_of_acceleration() const {
  const Rates before = rates_of(committed_), after = rates_of(trial_);
  return ordered_sum(mass_.size(), [&](std::size_t i) {
    return mass_[i] * (before.acceleration(i) + after.acceleration(i)) / 2 * increment(before, i);
  });
}

double CentralDifferences::weight_of_acceleration() const {
  const Rates rates = rates_of(committed_);
  return ordered_sum(mass_.size(), [&](std::size_t i) {
    const double a = rates.acceleration(i);
    return mass_[i] * a * a;
  });
}

double CentralDifferences::kinetic_of(const State& state) const {
  const Rates rates = rates_of(state);
  return ordered_sum(mass_.size(), [&](std::size_t i) {
    const double v = rates.velocity(i);
    return mass_[i] * v * v / 2;
  });
}

double CentralDifferences::kinetic(std::span<const Weight> weights) const {
  const Rates rates = rates_of(shown());
  return ordered_sum(weights.size(), [&](std::size_t k) {
    const double v = rates.velocity(static_cast<std::size_t>(weights[k].unknown));
    return weights[k].mass * v * v / 2;
  });
}

}  // namespace fabricsh::run
