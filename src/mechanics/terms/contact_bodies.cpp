#include "mechanics/terms/contact_bodies.hpp"

#include <algorithm>
#include <limits>

#include "contact/search.hpp"
#include "geometry/node_view.hpp"
#include "geometry/turning.hpp"

namespace fabricsh::mechanics {

using Columns = Eigen::Matrix<double, 12, 6>;

void BodyUnknowns::begin_iterate() {
  state_.iterate = state_.share;
  equations().begin_iterate();
}

void BodyUnknowns::move(double scale) {
  state_.share = state_.iterate + scale * (1 - state_.iterate);
  equations().move(scale);
}

void BodyUnknowns::save() {
  saved_share_ = state_.share;
  equations().save();
}

void BodyUnknowns::restore() {
  state_.share = saved_share_;
  equations().restore();
}

void BodyUnknowns::clear() {
  pairs_ = 0;
  blocks_.clear();
  on_bodies_.clear();
}

void BodyUnknowns::add(const std::array<std::int32_t, 4>& points, const contact::Matrix12& k,
                       const contact::FrictionTangent* friction) {
  const auto nodes = static_cast<std::int32_t>(this->nodes());
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4 && points[a] >= 0 && points[a] < nodes; ++b)
      if (points[b] >= 0 && (points[b] < nodes || leads()) && !k.block<3, 3>(3 * a, 3 * b).isZero(0))
        blocks_.push_back(
            {points[a], points[b], k.block<3, 3>(3 * a, 3 * b),
             friction == nullptr ? Mat3(Mat3::Zero()) : Mat3(-friction->apart.block<3, 3>(3 * a, 3 * b))});
  ++pairs_;
  if (own_unknowns() == 0) return;
  const auto begin = on_bodies_.size();
  for (int q = 0; q < 4; ++q) {
    const auto v = static_cast<std::size_t>(points[q] - nodes);
    if (points[q] < nodes || bodies().state().free_of[v] < 0) continue;
    const int body = bodies().state().free_of[v];
    if (on_bodies_.size() == begin || on_bodies_.back().body != body)
      on_bodies_.push_back({pairs_, points, body, Columns::Zero(), Columns::Zero(),
                            Eigen::Matrix<double, 6, 12>::Zero(), BodyEquations::Matrix6::Zero()});
    auto& by = on_bodies_.back().by;
    by.block<3, 3>(3 * q, 0).setIdentity();
    by.block<3, 3>(3 * q, 3) = -cross_matrix(equations().lever(v));
  }
  for (std::size_t i = begin; i < on_bodies_.size(); ++i) {
    OnBody& out = on_bodies_[i];
    out.force = k * out.by;
    out.answer = -out.by.transpose() * k;
    if (friction == nullptr) continue;
    out.force.rightCols<3>() -= friction->by_turn;
    out.answer.bottomRows<3>() += friction->torque_by_x;
    out.rubbed.rightCols<3>() += out.by.transpose() * friction->by_turn;
    out.rubbed.bottomRightCorner<3, 3>() += friction->torque_by_turn;
  }
}

void BodyUnknowns::add_ties() {
  for (const BodyTies::Tie& tie : state_.ties.all()) {
    const double stiffness = state_.ties.stiffness(tie);
    contact::Matrix12 k = contact::Matrix12::Zero();
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        k.block<3, 3>(3 * a, 3 * b) = (a == b ? stiffness : -stiffness) * Mat3::Identity();
    add({static_cast<std::int32_t>(tie.node), static_cast<std::int32_t>(tie.point), -1, -1}, k, nullptr);
    const std::size_t vertex = tie.point - nodes();
    if (own_unknowns() == 0 || bodies().state().free_of[vertex] < 0) continue;
    const Vec3 force = stiffness * (state_.x[tie.node] - state_.x[tie.point]);
    on_bodies_.back().rubbed.bottomRightCorner<3, 3>() +=
        cross_matrix(force) * cross_matrix(equations().lever(vertex));
  }
}

void BodyUnknowns::add_to_nodes(const OnBody& part, const BodyEquations::Vector6& moved, double weight,
                                std::span<double> on_x) const {
  const contact::Vector12 f = part.force * moved;
  for (int a = 0; a < 4; ++a)
    if (const std::int32_t p = part.point[a]; p >= 0 && p < static_cast<std::int32_t>(nodes()))
      at(on_x, p) += weight * f.segment<3>(3 * a);
}

// Two bodies may meet where no cloth has any force.
double BodyUnknowns::largest_own_force() const {
  if (bodies().state().balances()) return equations().largest_force();
  const auto& all = state_.surfaces.scene().interactions();
  const bool meet = std::any_of(all.begin(), all.end(), [](const auto& it) { return it.rigid; });
  return meet ? equations().largest_force() : 0;
}

void BodyUnknowns::go_static(double rise) {
  if (!bodies().any_free()) return;
  static_ = true;
  double reach = std::numeric_limits<double>::infinity();
  for (const auto& it : state_.surfaces.scene().interactions())
    reach = std::min(reach, it.law.gap() - it.law.floor());
  bodies().go_static(reach, rise);
  state_.begin();
}

bool BodyUnknowns::own_push(std::size_t j, std::span<double> on_x) const {
  const auto body = static_cast<int>(j / 6);
  const BodyEquations::Vector6 moved = equations().compliance(j / 6).col(static_cast<Eigen::Index>(j % 6));
  std::fill(on_x.begin(), on_x.end(), 0.0);
  bool any = false;
  for (const OnBody& part : on_bodies_) {
    if (part.body != body) continue;
    any = true;
    add_to_nodes(part, moved, state_.weight, on_x);
  }
  if (!gas_.any()) return any;
  const auto change = gas_.change({}, gas_.way_of(body, moved), true);
  for (std::size_t i = 0; i < on_x.size(); ++i) on_x[i] += change[i];
  return true;
}

Eigen::VectorXd BodyUnknowns::own_answer(std::span<const double> move) const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(equations().unknowns()));
  for (const OnBody& part : on_bodies_) {
    contact::Vector12 x = contact::Vector12::Zero();
    for (int a = 0; a < 4; ++a)
      if (const std::int32_t p = part.point[a]; p >= 0 && p < static_cast<std::int32_t>(nodes()))
        x.segment<3>(3 * a) = at(move, p);
    out.segment<6>(6 * part.body) += part.answer * x;
  }
  if (gas_.any()) out += gas_.on_bodies(gas_.change(move, {}, true));
  return out;
}

Eigen::MatrixXd BodyUnknowns::own_response() const {
  Eigen::MatrixXd out = responses();
  equations().hold(out);
  return out;
}

void BodyUnknowns::add_places(Places which, std::vector<double>& x) const {
  bodies().readings().add_places(which, x);
}

Eigen::MatrixXd BodyUnknowns::own_stiffness() const {
  if (!static_) return {};
  Eigen::MatrixXd out = -responses();
  const std::vector<bool> held = equations().held();
  for (Eigen::Index i = 0; i < out.rows(); ++i)
    if (held[static_cast<std::size_t>(i)]) out(i, i) += 1;
  return out;
}

// N and N m on the bodies, by their places and turns. Bodies that meet answer each other; the parts of one
// pair stand beside each other.
Eigen::MatrixXd BodyUnknowns::answers(bool with_volumes) const {
  const auto m = static_cast<Eigen::Index>(equations().unknowns());
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(m, m);
  const auto add = [&](const OnBody& part, const OnBody& other) {
    BodyEquations::Matrix6 answer = part.answer * other.by;
    if (part.body == other.body) answer += part.rubbed;
    out.block<6, 6>(6 * part.body, 6 * other.body) += answer;
  };
  for (std::size_t i = 0; i < on_bodies_.size(); ++i) {
    add(on_bodies_[i], on_bodies_[i]);
    if (i + 1 == on_bodies_.size() || on_bodies_[i + 1].pair != on_bodies_[i].pair) continue;
    add(on_bodies_[i], on_bodies_[i + 1]);
    add(on_bodies_[i + 1], on_bodies_[i]);
  }
  if (gas_.any()) gas_.add_answers(with_volumes, out);
  return out;
}

Eigen::MatrixXd BodyUnknowns::responses() const {
  Eigen::MatrixXd out = answers(true);
  for (Eigen::Index j = 0; j < out.cols(); j += 6) {
    const Eigen::MatrixXd of_body =
        out.middleCols<6>(j) * equations().compliance(static_cast<std::size_t>(j / 6));
    out.middleCols<6>(j) = of_body;
  }
  equations().add_response(out);
  return out;
}

BodyUnknowns::AtRest BodyUnknowns::at_rest() const {
  const auto m = static_cast<Eigen::Index>(equations().unknowns());
  AtRest out;
  out.stiffness = equations().spring_stiffness() - answers(false);
  std::vector<char> follows(state_.x.size(), 0);  // what ties push has been counted
  for (const BodyTies::Tie& tie : state_.ties.all()) follows[tie.point] = 1;
  for (std::size_t v = 0; nodes() + v < follows.size(); ++v)
    if (const int body = bodies().state().free_of[v]; body >= 0 && follows[nodes() + v] == 0)
      out.stiffness.block<3, 3>(6 * body + 3, 6 * body + 3) -=
          cross_matrix(state_.force[nodes() + v]) * cross_matrix(equations().lever(v));
  out.stiffness = ((out.stiffness + out.stiffness.transpose()) / 2).eval();
  for (Eigen::Index j = 0; j < m; ++j) {
    const BodyEquations::Vector6 unit = BodyEquations::Vector6::Unit(j % 6);
    const auto way = gas_.way_of(static_cast<int>(j / 6), unit);
    std::vector<double> on_x(3 * nodes(), 0);
    for (const OnBody& part : on_bodies_)
      if (part.body == static_cast<int>(j / 6)) add_to_nodes(part, unit, 1, on_x);
    if (gas_.any()) {
      const auto change = gas_.change({}, way, false);
      for (std::size_t i = 0; i < on_x.size(); ++i) on_x[i] += change[i];
    }
    out.on_nodes.push_back(std::move(on_x));
    std::vector<double> along;  // of the volumes
    for (const auto& column : gas_.of_volumes()) {
      along.push_back(0);
      for (std::size_t v = 0; v < way.size(); ++v)
        along.back() += way[v].dot(at(column, static_cast<Index>(nodes() + v)));
    }
    out.of_volumes.push_back(std::move(along));
  }
  return out;
}

// Includes the part of the bodies' motion that the iterate has not made yet.
Eigen::VectorXd BodyUnknowns::own_residual() const {
  Eigen::VectorXd out = equations().residual();
  if (state_.share >= 1) return out;
  const auto &from = bodies().state().committed, &to = bodies().state().target;
  for (const OnBody& part : on_bodies_) {
    contact::Vector12 x = contact::Vector12::Zero();
    for (int a = 0; a < 4; ++a)
      if (const std::int32_t p = part.point[a]; p >= static_cast<std::int32_t>(nodes()))
        x.segment<3>(3 * a) = (1 - state_.share) * (to[p - nodes()] - from[p - nodes()]);
    out.segment<6>(6 * part.body) += part.answer * x;
  }
  if (gas_.any()) out += gas_.on_bodies(gas_.change({}, gas_.way_left(), true));
  return out;
}

// --- the tangent

// If the stiffness couples nodes not coupled so far, all pairs that are near are added, so that the pattern
// grows seldom. The coupled pairs depend only on the states visited.
void ContactTangent::couple(const contact::Way& way, std::vector<NodePair>& pairs) {
  const auto nodes = static_cast<std::int64_t>(state_.surfaces.nodes());
  bodies_.clear();
  bool known = true;
  const auto add = [&](const std::array<std::int32_t, 4>& points, auto&& visit) {
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a + 1; b < 4; ++b) {
        const std::int64_t p = points[a], q = points[b];
        if (p < 0 || q < 0) continue;
        const auto [low, high] = std::minmax(p, q);
        if (high < nodes) visit(low * nodes + high);
      }
  };
  contact::Wanted wanted;  // all, where bodies are free
  if (bodies_.own_unknowns() == 0) {
    cloth_.assign(state_.x.size(), 0);
    std::fill_n(cloth_.begin(), nodes, 1);
    wanted.on = cloth_;
    if (!bodies_.leads()) wanted.by = cloth_;
  }
  if (state_.surfaces.any())
    state_.pairs.stiffness(
        state_.x,
        [&](const std::array<std::int32_t, 4>& points, const contact::Matrix12& k,
            const contact::FrictionTangent* friction) {
          bodies_.add(points, k, friction);
          add(points, [&](std::int64_t pair) {
            known = known && std::binary_search(pairs_.begin(), pairs_.end(), pair);
          });
        },
        way, wanted);
  bodies_.add_ties();
  if (!known) {
    const contact::Scene& scene = state_.surfaces.scene();
    for (const auto& candidate : contact::find_pairs(scene, state_.x, state_.surfaces.edge() / 3))
      add(scene.spots().with_nodes(candidate.point), [&](std::int64_t pair) { pairs_.push_back(pair); });
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  }
  for (const std::int64_t pair : pairs_) pairs.emplace_back(pair / nodes, pair % nodes);
}

void ContactTangent::add(TangentSink& sink) const {
  const Bodies& bodies = state_.surfaces.bodies();
  const auto &from = bodies.state().committed, &to = bodies.state().target;
  const auto nodes = static_cast<std::int32_t>(state_.surfaces.nodes());
  const double left = 1 - state_.share;
  for (const PairBlock& block : bodies_.blocks()) {
    const Mat3 k = state_.weight * block.k;
    if (block.by < nodes)
      sink.on_positions_apart(block.node, block.by, k, state_.weight * block.apart);
    else
      sink.on_lead(block.node, k * left * (to[block.by - nodes] - from[block.by - nodes]));
  }
  if (!gas_.any() || !bodies_.leads()) return;
  const auto change = gas_.change({}, gas_.way_left(), true);
  for (Index n = 0; n < nodes; ++n) sink.on_lead(n, at(std::span<const double>(change), n));
}

void ContactTangent::commit() {
  if (committed_pairs_.size() != pairs_.size()) committed_pairs_ = pairs_;
}

void ContactTangent::rollback() {
  if (committed_pairs_.size() != pairs_.size()) pairs_ = committed_pairs_;
}

void ContactTangent::keep(Archive& archive) {
  archive(pairs_);
  if (archive.reading()) committed_pairs_ = pairs_;
}

}  // namespace fabricsh::mechanics
