#include "run/central_differences.hpp"

#include <cmath>
#include <utility>

#include "base/ordered_sum.hpp"

namespace fabricsh::run {

namespace {
constexpr std::size_t kShare = 4096;  // number of unknowns from which loops use several threads
}

CentralDifferences::CentralDifferences(std::vector<double> mass, double gamma,
                                       std::function<std::vector<double>()> driven)
    : mass_(std::move(mass)), gamma_(gamma), driven_(std::move(driven)) {
  for (auto* v : {&committed_.v, &committed_.a, &trial_.v, &trial_.a, &increment_})
    v->assign(mass_.size(), 0);
}

void CentralDifferences::start(std::vector<double> velocities) {
  committed_.v = std::move(velocities);
  trial_.v = committed_.v;
}

bool CentralDifferences::predict(std::span<const unsigned char> turns,
                                 const std::array<double, 2>& farthest) {
  const double dt = this->dt(), early = (1 - gamma_) * dt;
  bool away = false;
#pragma omp parallel for schedule(static) reduction(|| : away) if (mass_.size() >= kShare)
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    increment_[i] = dt * (committed_.v[i] + dt / 2 * committed_.a[i]);
    trial_.v[i] = committed_.v[i] + early * committed_.a[i];
    away = away || !(std::abs(increment_[i]) < (turns[i] != 0 ? farthest[1] : farthest[0]));
  }
  return !away;
}

void CentralDifferences::accelerate(std::span<const double> residual, double mass_damping) {
  const double kick = gamma_ * dt(), effective = 1 + kick * mass_damping;
#pragma omp parallel for schedule(static) if (mass_.size() >= kShare)
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    const double a = (residual[i] / mass_[i] - mass_damping * trial_.v[i]) / effective;
    trial_.a[i] = a;
    trial_.v[i] += kick * a;
  }
}

double CentralDifferences::work(std::span<const double> before, std::span<const double> after) const {
  return ordered_sum(mass_.size(), [&](std::size_t i) { return (before[i] + after[i]) / 2 * increment_[i]; });
}

double CentralDifferences::work_of_velocity(double factor) const {
  return ordered_sum(mass_.size(), [&](std::size_t i) {
    return factor * mass_[i] * (committed_.v[i] + trial_.v[i]) / 2 * increment_[i];
  });
}

double CentralDifferences::work_of_acceleration() const {
  return ordered_sum(mass_.size(), [&](std::size_t i) {
    return mass_[i] * (committed_.a[i] + trial_.a[i]) / 2 * increment_[i];
  });
}

double CentralDifferences::kinetic_of(const std::vector<double>& v) const {
  return ordered_sum(v.size(), [&](std::size_t i) { return mass_[i] * v[i] * v[i] / 2; });
}

}  // namespace fabricsh::run
