#include "mechanics/terms/body_equations.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace fabricsh::mechanics {

namespace {

constexpr double kLeastForce = 1e-6;  // N, by which the stiffness is chosen that stands for no support

}  // namespace

Eigen::VectorXd BodyEquations::residual() const {
  Eigen::VectorXd out(static_cast<Eigen::Index>(unknowns()));
  for (std::size_t f = 0; f < state_.free.size(); ++f) {
    const contact::Wrench& is = state_.loaded ? state_.free[f].trial : state_.free[f].wrench;
    const auto row = static_cast<Eigen::Index>(6 * f);
    const contact::Wrench with = state_.statics ? contact::Wrench{} : state_.free[f].end;
    out.segment<3>(row) = is.force - with.force;
    out.segment<3>(row + 3) = is.torque - with.torque;
  }
  return out;
}

// What rounding alone can make of the forces on a body, and of the places from which its springs have theirs,
// is none: beside cloth without forces there is nothing else to compare it with.
double BodyEquations::largest_residual() const {
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  double most = 0;
  if (!state_.implicit || !state_.loaded || state_.to == state_.from) return most;
  const Eigen::VectorXd all = residual();
  for (std::size_t f = 0; f < state_.free.size(); ++f) {
    const BodyState::Free& free = state_.free[f];
    double forces = free.largest;
    for (const BodyLoads::Spring& spring : loads_.springs())
      for (const int body : {static_cast<int>(spring.body), spring.to})
        if (body >= 0 && state_.bodies[static_cast<std::size_t>(body)].free == static_cast<int>(f))
          forces += spring.stiffness.cwiseProduct(free.predicted.centre()).lpNorm<Eigen::Infinity>() /
                    (spring.damper ? state_.to - state_.from : 1);
    const auto row = static_cast<Eigen::Index>(6 * f);
    const double own = std::max(all.segment<3>(row).lpNorm<Eigen::Infinity>(),
                                all.segment<3>(row + 3).lpNorm<Eigen::Infinity>() / free.size);
    if (own > rounding * forces) most = std::max(most, own);
  }
  return most;
}

double BodyEquations::largest_force() const {
  double most = 0;
  for (const BodyState::Free& free : state_.free) {
    // Where all forces balance, each of them is compared with.
    if (state_.balances()) {
      most = std::max(most, free.largest);
      continue;
    }
    const contact::Wrench& is = state_.loaded ? free.trial : free.wrench;
    most =
        std::max({most, is.force.lpNorm<Eigen::Infinity>(), is.torque.lpNorm<Eigen::Infinity>() / free.size});
  }
  return most;
}

void BodyEquations::direct(std::span<const double> way) {
  for (std::size_t f = 0; f < state_.free.size(); ++f) {
    state_.free[f].way = state_.free[f].left(
        {Eigen::Map<const Vec3>(way.data() + 6 * f), Eigen::Map<const Vec3>(way.data() + 6 * f + 3)});
  }
}

void BodyEquations::begin_iterate() {
  for (BodyState::Free& free : state_.free) {
    free.iterate = free.end;
    free.way = {};
  }
}

void BodyEquations::move(double scale) {
  if (!state_.implicit || state_.free.empty()) return;
  for (BodyState::Free& free : state_.free) {
    free.end.force = free.iterate.force + scale * free.way.force;
    free.end.torque = free.iterate.torque + scale * free.way.torque;
  }
  state_.fly();
}

void BodyEquations::save() {
  for (BodyState::Free& free : state_.free) free.saved = free.end;
}

void BodyEquations::restore() {
  if (!state_.implicit || state_.free.empty()) return;
  for (BodyState::Free& free : state_.free) free.end = free.saved;
  state_.fly();
}

BodyEquations::Matrix6 BodyEquations::compliance(std::size_t free) const {
  const double dt = state_.flight();
  Matrix6 out = Matrix6::Zero();
  out.topLeftCorner<3, 3>() = dt * dt * state_.late / state_.free[free].committed.mass() * Mat3::Identity();
  out.bottomRightCorner<3, 3>() = dt * dt * state_.late * state_.free[free].predicted.inertia().inverse();
  if (!state_.free[free].cut) return out;
  Eigen::Matrix<double, 6, 1> left;
  left << state_.free[free].moves, state_.free[free].turns;
  return left.asDiagonal() * out * left.asDiagonal();
}

BodyEquations::Matrix6 BodyEquations::mass_matrix(std::size_t free) const {
  Matrix6 out = Matrix6::Zero();
  out.topLeftCorner<3, 3>() = state_.free[free].committed.mass() * Mat3::Identity();
  out.bottomRightCorner<3, 3>() = state_.free[free].committed.inertia();
  return out;
}

BodyEquations::Vector6 BodyEquations::freedom(std::size_t free) const {
  Vector6 out;
  out << state_.free[free].moves, state_.free[free].turns;
  return out;
}

void BodyEquations::add_response(Eigen::MatrixXd& response) const {
  using Rows = Eigen::Matrix<double, 3, 6>;
  const double dt = state_.to - state_.from;
  const auto add = [&](int row, int column, const Vec3& k) {
    if (row < 0 || column < 0) return;
    const Rows by = k.asDiagonal() * compliance(static_cast<std::size_t>(column)).topRows<3>();
    response.block<3, 6>(6 * row, 6 * column) += by;
  };
  for (const BodyLoads::Spring& spring : loads_.springs()) {
    if (spring.damper && !(dt > 0)) continue;
    const Vec3 k = spring.stiffness * (spring.damper ? 1 / dt : state_.share_of_end());
    const int b = state_.bodies[spring.body].free;
    const int other = spring.to < 0 ? -1 : state_.bodies[std::size_t(spring.to)].free;
    add(b, b, -k);
    add(b, other, k);
    add(other, b, k);
    add(other, other, -k);
  }
}

std::vector<bool> BodyEquations::held() const {
  std::vector<bool> out;
  for (const BodyState::Free& free : state_.free)
    for (const Vec3& left : {free.moves, free.turns})
      for (int i = 0; i < 3; ++i) out.push_back(left[i] == 0);
  return out;
}

void BodyEquations::hold(Eigen::MatrixXd& response) const {
  if (!state_.statics) return;
  for (std::size_t f = 0; f < state_.free.size(); ++f) {
    const BodyState::Free& free = state_.free[f];
    const Matrix6 moved = compliance(f);
    const double load = free.load.force.cwiseProduct(free.moves).norm();
    const double force = std::max({kLeastForce, load, free.trial.force.norm()}) / state_.reach;
    Vec3 springs = Vec3::Zero();  // a direction that they hold needs nothing else
    for (const BodyLoads::Spring& spring : loads_.springs())
      if (!spring.damper && state_.bodies[spring.body].free == static_cast<int>(f))
        springs += spring.stiffness;
    for (int i = 0; i < 6; ++i) {
      const bool turns = i > 2;
      if ((turns ? free.turns[i - 3] : free.moves[i]) == 0) continue;
      const bool sprung = !turns && springs[i] > 0;
      double& on = response(6 * static_cast<Eigen::Index>(f) + i, 6 * static_cast<Eigen::Index>(f) + i);
      const double least = sprung ? 0 : force * (turns ? free.size * free.size : 1) * moved(i, i);
      on = 1 + std::min(on, -least);
    }
  }
}

Eigen::MatrixXd BodyEquations::spring_stiffness() const {
  const auto m = static_cast<Eigen::Index>(6 * state_.free.size());
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(m, m);
  for (const BodyLoads::Spring& spring : loads_.springs()) {
    if (spring.damper) continue;
    const int b = state_.bodies[spring.body].free,
              other = spring.to < 0 ? -1 : state_.bodies[std::size_t(spring.to)].free;
    const Mat3 k = spring.stiffness.asDiagonal();
    for (const auto& [row, column, sign] : {std::tuple(b, b, 1), std::tuple(b, other, -1),
                                            std::tuple(other, b, -1), std::tuple(other, other, 1)})
      if (row >= 0 && column >= 0) out.block<3, 3>(6 * row, 6 * column) += sign * k;
  }
  return out;
}

}  // namespace fabricsh::mechanics
