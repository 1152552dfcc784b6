// Free bodies in implicit steps: how their forces and those on the cloth change with each other.
#include <algorithm>
#include <limits>

#include "geometry/node_view.hpp"
#include "geometry/turning.hpp"
#include "mechanics/terms/contact.hpp"

namespace fabricsh::mechanics {

using Columns = Eigen::Matrix<double, 12, 6>;

// Adds the coupling of the last block with the free bodies that it has: one, or two that meet each other.
void Contacts::add_on_body(const contact::FrictionTangent* friction) {
  const Block& block = blocks_.back();
  const auto begin = on_bodies_.size();
  for (int q = 0; q < 4; ++q) {
    const auto v = static_cast<std::size_t>(block.point[q]) - nodes_;
    if (block.point[q] < static_cast<std::int32_t>(nodes_) || bodies_.free_of(v) < 0) continue;
    const int body = bodies_.free_of(v);
    if (on_bodies_.size() == begin || on_bodies_.back().body != body)
      on_bodies_.push_back({blocks_.size() - 1, body, Columns::Zero(), Columns::Zero(),
                            Eigen::Matrix<double, 6, 12>::Zero(), Bodies::Matrix6::Zero()});
    auto& by = on_bodies_.back().by;
    by.block<3, 3>(3 * q, 0).setIdentity();
    by.block<3, 3>(3 * q, 3) = -cross_matrix(bodies_.lever(v));
  }
  for (std::size_t i = begin; i < on_bodies_.size(); ++i) {
    OnBody& out = on_bodies_[i];
    out.force = block.k * out.by;
    out.answer = -out.by.transpose() * block.k;
    if (friction == nullptr) continue;
    out.force.rightCols<3>() -= friction->by_turn;
    out.answer.bottomRows<3>() += friction->torque_by_x;
    out.rubbed.rightCols<3>() += out.by.transpose() * friction->by_turn;
    out.rubbed.bottomRightCorner<3, 3>() += friction->torque_by_turn;
  }
}

// Two bodies may meet where no cloth has any force.
double Contacts::largest_own_force() const {
  if (static_) return bodies_.largest_force();
  const auto& all = scene_.interactions();
  const bool meet = std::any_of(all.begin(), all.end(), [](const auto& it) { return it.rigid; });
  return meet ? bodies_.largest_force() : 0;
}

void Contacts::go_static(double rise) {
  if (!bodies_.any_free()) return;
  static_ = true;
  double reach = std::numeric_limits<double>::infinity();
  for (const auto& it : scene_.interactions()) reach = std::min(reach, it.law.gap() - it.law.floor());
  bodies_.go_static(reach, rise);
  begin_pressed();
}

bool Contacts::own_push(std::size_t j, std::span<double> on_x) const {
  const auto body = static_cast<int>(j / 6);
  const Bodies::Vector6 moved = bodies_.compliance(j / 6).col(static_cast<Eigen::Index>(j % 6));
  std::fill(on_x.begin(), on_x.end(), 0.0);
  bool any = false;
  for (const OnBody& part : on_bodies_) {
    if (part.body != body) continue;
    any = true;
    const contact::Vector12 f = part.force * moved;
    for (int a = 0; a < 4; ++a)
      if (const std::int32_t p = blocks_[part.block].point[a];
          p >= 0 && p < static_cast<std::int32_t>(nodes_))
        at(on_x, p) += weight_ * f.segment<3>(3 * a);
  }
  if (gas_.ranks.on_x.empty()) return any;
  const auto change = gas_change({}, way_of(body, moved), true);
  for (std::size_t i = 0; i < on_x.size(); ++i) on_x[i] += change[i];
  return true;
}

Eigen::VectorXd Contacts::own_answer(std::span<const double> move) const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(bodies_.unknowns()));
  for (const OnBody& part : on_bodies_) {
    contact::Vector12 x = contact::Vector12::Zero();
    for (int a = 0; a < 4; ++a)
      if (const std::int32_t p = blocks_[part.block].point[a];
          p >= 0 && p < static_cast<std::int32_t>(nodes_))
        x.segment<3>(3 * a) = at(move, p);
    out.segment<6>(6 * part.body) += part.answer * x;
  }
  if (!gas_.ranks.on_x.empty()) out += gas_on_bodies(gas_change(move, {}, true));
  return out;
}

Eigen::MatrixXd Contacts::own_response() const {
  Eigen::MatrixXd out = responses();
  bodies_.hold(out);
  return out;
}

Eigen::MatrixXd Contacts::own_stiffness() const {
  if (!static_) return {};
  Eigen::MatrixXd out = -responses();
  const std::vector<bool> held = bodies_.held();
  for (Eigen::Index i = 0; i < out.rows(); ++i)
    if (held[static_cast<std::size_t>(i)]) out(i, i) += 1;
  return out;
}

// N and N m on the bodies, by their places and turns. Bodies that meet answer each other; the parts of one
// pair stand beside each other.
Eigen::MatrixXd Contacts::answers(bool with_volumes) const {
  const auto m = static_cast<Eigen::Index>(bodies_.unknowns());
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(m, m);
  const auto add = [&](const OnBody& part, const OnBody& other) {
    Bodies::Matrix6 answer = part.answer * other.by;
    if (part.body == other.body) answer += part.rubbed;
    out.block<6, 6>(6 * part.body, 6 * other.body) += answer;
  };
  for (std::size_t i = 0; i < on_bodies_.size(); ++i) {
    add(on_bodies_[i], on_bodies_[i]);
    if (i + 1 == on_bodies_.size() || on_bodies_[i + 1].block != on_bodies_[i].block) continue;
    add(on_bodies_[i], on_bodies_[i + 1]);
    add(on_bodies_[i + 1], on_bodies_[i]);
  }
  if (!gas_.ranks.on_x.empty()) add_gas_answers(with_volumes, out);
  return out;
}

Eigen::MatrixXd Contacts::responses() const {
  Eigen::MatrixXd out = answers(true);
  for (Eigen::Index j = 0; j < out.cols(); j += 6) {
    const Eigen::MatrixXd of_body =
        out.middleCols<6>(j) * bodies_.compliance(static_cast<std::size_t>(j / 6));
    out.middleCols<6>(j) = of_body;
  }
  bodies_.add_response(out);
  return out;
}

// The derivatives at rest, of the last tangent.
Contacts::AtRest Contacts::at_rest() const {
  const auto m = static_cast<Eigen::Index>(bodies_.unknowns());
  AtRest out;
  out.stiffness = bodies_.spring_stiffness() - answers(false);
  std::vector<char> follows(x_.size(), 0);  // what ties push has been counted
  for (const TiedTo& tied : tied_) follows[tied.point] = 1;
  for (std::size_t v = 0; nodes_ + v < x_.size(); ++v)
    if (const int body = bodies_.free_of(v); body >= 0 && follows[nodes_ + v] == 0)
      out.stiffness.block<3, 3>(6 * body + 3, 6 * body + 3) -=
          cross_matrix(force_[nodes_ + v]) * cross_matrix(bodies_.lever(v));
  out.stiffness = ((out.stiffness + out.stiffness.transpose()) / 2).eval();
  for (Eigen::Index j = 0; j < m; ++j) {
    const Bodies::Vector6 unit = Bodies::Vector6::Unit(j % 6);
    const auto way = way_of(static_cast<int>(j / 6), unit);
    std::vector<double> on_x(3 * nodes_, 0);
    for (const OnBody& part : on_bodies_) {
      if (part.body != static_cast<int>(j / 6)) continue;
      const contact::Vector12 f = part.force * unit;
      for (int a = 0; a < 4; ++a)
        if (const std::int32_t p = blocks_[part.block].point[a];
            p >= 0 && p < static_cast<std::int32_t>(nodes_))
          at(on_x, p) += f.segment<3>(3 * a);
    }
    if (!gas_.ranks.on_x.empty()) {
      const auto change = gas_change({}, way, false);
      for (std::size_t i = 0; i < on_x.size(); ++i) on_x[i] += change[i];
    }
    out.on_nodes.push_back(std::move(on_x));
    std::vector<double> along;  // of the volumes
    for (const auto& column : gas_.ranks.on_x) {
      along.push_back(0);
      for (std::size_t v = 0; v < way.size(); ++v)
        along.back() += way[v].dot(at(column, static_cast<Index>(nodes_ + v)));
    }
    out.of_volumes.push_back(std::move(along));
  }
  return out;
}

// Includes the part of the bodies' motion that the iterate has not made yet.
Eigen::VectorXd Contacts::own_residual() const {
  Eigen::VectorXd out = bodies_.residual();
  if (share_ >= 1) return out;
  const auto from = bodies_.committed(), to = bodies_.target();
  for (const OnBody& part : on_bodies_) {
    const Block& block = blocks_[part.block];
    contact::Vector12 x = contact::Vector12::Zero();
    for (int a = 0; a < 4; ++a)
      if (const std::int32_t p = block.point[a]; p >= static_cast<std::int32_t>(nodes_))
        x.segment<3>(3 * a) = (1 - share_) * (to[p - nodes_] - from[p - nodes_]);
    out.segment<6>(6 * part.body) += part.answer * x;
  }
  if (!gas_.ranks.on_x.empty()) out += gas_on_bodies(gas_change({}, way_left(), true));
  return out;
}

}  // namespace fabricsh::mechanics
