#include "run/central_differences.hpp"

#include <algorithm>
#include <cmath>

#include "base/ordered_sum.hpp"

namespace fabricsh::run {

namespace {
constexpr std::size_t kShare = 4096;  // number of unknowns from which loops use several threads
}

CentralDifferences::CentralDifferences(std::vector<double> mass, double gamma,
                                       std::function<std::vector<double>()> driven)
    : mass_(std::move(mass)), gamma_(gamma), driven_(std::move(driven)) {
  start(std::vector<double>(mass_.size(), 0));
}

void CentralDifferences::start(std::vector<double> velocities) {
  committed_ = {std::move(velocities), std::vector<double>(mass_.size(), 0)};
  trial_ = committed_;
}

void CentralDifferences::resize(std::vector<double> mass) {
  mass_ = std::move(mass);
  start(std::vector<double>(mass_.size(), 0));
}

bool CentralDifferences::predict(std::span<const unsigned char> turns,
                                 const std::array<double, 2>& farthest) {
  const double dt = this->dt(), early = (1 - gamma_) * dt, least = std::min(farthest[0], farthest[1]);
  const State before{{}, {}, committed_.kick, committed_.damping};
  const double *const mass = mass_.data(), *const v0 = committed_.predicted.data(),
                      *const residual = committed_.residual.data();
  double* const predicted = trial_.predicted.data();
  std::int64_t far = 0;  // unknowns whose increment exceeds the smaller limit or is not a number
#pragma omp parallel for simd schedule(static) reduction(+ : far) if (mass_.size() >= kShare)
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    const double a = before.acceleration(residual[i] / mass[i], v0[i]), v = v0[i] + before.kick * a;
    predicted[i] = v + early * a;
    far += std::abs(dt * (v + dt / 2 * a)) < least ? 0 : 1;
  }
  for (std::size_t i = 0; far != 0 && i < mass_.size(); ++i)
    if (!(std::abs(increment(i)) < farthest[turns[i]])) return false;
  return true;
}

const std::vector<double>& CentralDifferences::increments() const {
  increments_.resize(mass_.size());
#pragma omp parallel for schedule(static) if (mass_.size() >= kShare)
  for (std::size_t i = 0; i < mass_.size(); ++i) increments_[i] = increment(i);
  return increments_;
}

void CentralDifferences::accelerate(double mass_damping) {
  trial_.kick = gamma_ * dt();
  trial_.damping = mass_damping;
}

std::vector<double> CentralDifferences::velocities() const {
  std::vector<double> v(mass_.size());
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = velocity(shown(), i);
  return v;
}

double CentralDifferences::work(std::span<const double> before, std::span<const double> after) const {
  return ordered_sum(mass_.size(), [&](std::size_t i) { return (before[i] + after[i]) / 2 * increment(i); });
}

double CentralDifferences::work_of_velocity(double factor) const {
  return ordered_sum(mass_.size(), [&](std::size_t i) {
    return factor * mass_[i] * (velocity(committed_, i) + velocity(trial_, i)) / 2 * increment(i);
  });
}

double CentralDifferences::work_of_acceleration() const {
  return ordered_sum(mass_.size(), [&](std::size_t i) {
    return mass_[i] * (acceleration(committed_, i) + acceleration(trial_, i)) / 2 * increment(i);
  });
}

double CentralDifferences::weight_of_acceleration() const {
  return ordered_sum(mass_.size(), [&](std::size_t i) {
    const double a = acceleration(committed_, i);
    return mass_[i] * a * a;
  });
}

double CentralDifferences::kinetic_of(const State& state) const {
  return ordered_sum(mass_.size(), [&](std::size_t i) {
    const double v = velocity(state, i);
    return mass_[i] * v * v / 2;
  });
}

double CentralDifferences::kinetic(std::span<const Weight> weights) const {
  return ordered_sum(weights.size(), [&](std::size_t k) {
    const double v = velocity(shown(), static_cast<std::size_t>(weights[k].unknown));
    return weights[k].mass * v * v / 2;
  });
}

}  // namespace fabricsh::run
