// Free bodies in implicit steps: how their forces and those on the cloth change with each other.
#include "geometry/node_view.hpp"
#include "mechanics/terms/contact.hpp"

namespace fabricsh::mechanics {

namespace {

Mat3 cross_matrix(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

}  // namespace

// Adds the coupling of the last block with a free body, if it has one.
void Contacts::add_on_body(const contact::FrictionTangent* friction) {
  Block& block = blocks_.back();
  OnBody out{blocks_.size() - 1, {}, {}, {}};
  Eigen::Matrix<double, 12, 6> by = Eigen::Matrix<double, 12, 6>::Zero();  // corners by place and turn
  for (int q = 0; q < 4; ++q) {
    const std::int32_t p = block.point[q];
    if (p < static_cast<std::int32_t>(nodes_)) continue;
    block.body = bodies_.free_of(static_cast<std::size_t>(p) - nodes_);
    if (block.body < 0) return;
    by.block<3, 3>(3 * q, 0).setIdentity();
    by.block<3, 3>(3 * q, 3) = -cross_matrix(bodies_.lever(static_cast<std::size_t>(p) - nodes_));
  }
  if (block.body < 0) return;
  out.force = block.k * by;
  out.answer = -by.transpose() * block.k;
  if (friction != nullptr) {
    out.force.rightCols<3>() -= friction->by_turn;
    out.answer.bottomRows<3>() += friction->torque_by_x;
  }
  out.own = out.answer * by;
  if (friction != nullptr) {
    out.own.rightCols<3>() += by.transpose() * friction->by_turn;
    out.own.bottomRightCorner<3, 3>() += friction->torque_by_turn;
  }
  on_bodies_.push_back(out);
}

bool Contacts::body_push(std::size_t j, std::span<double> on_x) const {
  const auto body = static_cast<int>(j / 6);
  const Eigen::Matrix<double, 6, 1> moved = bodies_.compliance(j / 6).col(static_cast<Eigen::Index>(j % 6));
  std::fill(on_x.begin(), on_x.end(), 0.0);
  bool any = false;
  for (const OnBody& part : on_bodies_) {
    const Block& block = blocks_[part.block];
    if (block.body != body) continue;
    any = true;
    const contact::Vector12 f = part.force * moved;
    for (int a = 0; a < 4; ++a)
      if (const std::int32_t p = block.point[a]; p >= 0 && p < static_cast<std::int32_t>(nodes_))
        at(on_x, p) += weight_ * f.segment<3>(3 * a);
  }
  return any;
}

Eigen::VectorXd Contacts::body_answer(std::span<const double> move) const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(bodies_.unknowns()));
  for (const OnBody& part : on_bodies_) {
    const Block& block = blocks_[part.block];
    contact::Vector12 x = contact::Vector12::Zero();
    for (int a = 0; a < 4; ++a)
      if (const std::int32_t p = block.point[a]; p >= 0 && p < static_cast<std::int32_t>(nodes_))
        x.segment<3>(3 * a) = at(move, p);
    out.segment<6>(6 * block.body) += part.answer * x;
  }
  return out;
}

Eigen::MatrixXd Contacts::body_response() const {
  const auto m = static_cast<Eigen::Index>(bodies_.unknowns());
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(m, m);
  for (const OnBody& part : on_bodies_) {
    const auto row = 6 * blocks_[part.block].body;
    out.block<6, 6>(row, row) += part.own * bodies_.compliance(static_cast<std::size_t>(row) / 6);
  }
  return out;
}

// Includes the part of the bodies' motion that the iterate has not made yet.
Eigen::VectorXd Contacts::body_residual() const {
  Eigen::VectorXd out = bodies_.residual();
  if (share_ >= 1) return out;
  const auto from = bodies_.committed(), to = bodies_.target();
  for (const OnBody& part : on_bodies_) {
    const Block& block = blocks_[part.block];
    contact::Vector12 x = contact::Vector12::Zero();
    for (int a = 0; a < 4; ++a)
      if (const std::int32_t p = block.point[a]; p >= static_cast<std::int32_t>(nodes_))
        x.segment<3>(3 * a) = (1 - share_) * (to[p - nodes_] - from[p - nodes_]);
    out.segment<6>(6 * block.body) += part.answer * x;
  }
  return out;
}

}  // namespace fabricsh::mechanics
