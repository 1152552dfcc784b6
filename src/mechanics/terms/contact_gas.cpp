#include "mechanics/terms/contact_gas.hpp"

#include <cmath>

#include "geometry/node_view.hpp"
#include "geometry/turning.hpp"
#include "linear/vector.hpp"

namespace fabricsh::mechanics {

namespace {

std::vector<Vec3> after_nodes(std::span<const double> on_x, std::size_t nodes) {
  std::vector<Vec3> all(on_x.size() / 3 - nodes);
  for (std::size_t v = 0; v < all.size(); ++v) all[v] = at(on_x, static_cast<Index>(nodes + v));
  return all;
}

}  // namespace

void GasOnBodies::place_points(const Trial& trial, std::vector<double>& x) const {
  const auto nodes = trial.configuration.x();
  const double share = state_.share;
  x.assign(nodes.begin(), nodes.end());
  const auto &from = bodies().state().committed, &to = bodies().state().target;
  for (std::size_t v = 0; v < from.size(); ++v) {
    const Vec3 p = share >= 1 ? to[v] : share <= 0 ? from[v] : Vec3(from[v] + share * (to[v] - from[v]));
    x.insert(x.end(), {p.x(), p.y(), p.z()});
  }
}

void GasOnBodies::begin(std::span<const double> on_x) {
  state_.surfaces.bodies().begin_gas(after_nodes(on_x, nodes()));
  state_.begin();
}

void GasOnBodies::press(std::span<const double> on_x) {
  state_.surfaces.bodies().press(after_nodes(on_x, nodes()));
}

double GasOnBodies::size_of(std::span<const double> on_x, std::size_t from) const {
  double sum = 0;
  for (std::size_t p = from; p < state_.x.size(); ++p)
    sum += at(on_x, static_cast<Index>(p)).norm() * std::sqrt(inverse_mass_[p]);
  return sum;
}

// m, of all vertices when one free body moves and turns.
std::vector<Vec3> GasOnBodies::way_of(int body, const BodyEquations::Vector6& moved) const {
  std::vector<Vec3> way(state_.x.size() - nodes(), Vec3::Zero());
  for (std::size_t v = 0; v < way.size(); ++v)
    if (bodies().state().free_of[v] == body)
      way[v] = moved.head<3>() + Vec3(moved.tail<3>()).cross(bodies().equations().lever(v));
  return way;
}

// m, that the iterate has not made yet.
std::vector<Vec3> GasOnBodies::way_left() const {
  const auto &from = bodies().state().committed, &to = bodies().state().target;
  std::vector<Vec3> way(from.size());
  for (std::size_t v = 0; v < way.size(); ++v) way[v] = (1 - state_.share) * (to[v] - from[v]);
  return way;
}

// N, of the internal forces on all points, when nodes (m, 3 per node) and vertices move; empty: they do not.
// Without what the motion of the nodes alone does to the forces on them, but for that of the volumes, where
// these are asked for.
std::vector<double> GasOnBodies::change(std::span<const double> on_nodes, std::span<const Vec3> vertices,
                                        bool with_volumes) const {
  std::vector<double> way(3 * state_.x.size(), 0), out(way.size(), 0);
  std::copy(on_nodes.begin(), on_nodes.end(), way.begin());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    at(std::span(way), static_cast<Index>(nodes() + v)) = vertices[v];
  for (const GasTangent::Part& part : tangent_.parts)
    at(std::span(out), part.a) += part.k * at(std::span<const double>(way), part.b);
  if (!with_volumes) return out;
  const auto& columns = tangent_.ranks.on_x;
  Eigen::VectorXd along(static_cast<Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i)
    along[static_cast<Index>(i)] = linear::dot(columns[i], way);
  const Eigen::VectorXd weight = tangent_.ranks.core * along;
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t n = 0; n < out.size(); ++n) out[n] += weight[static_cast<Index>(i)] * columns[i][n];
  return out;
}

// The forces and torques on the free bodies of such a change, as far as they count in the step.
Eigen::VectorXd GasOnBodies::on_bodies(std::span<const double> change) const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(bodies().equations().unknowns()));
  for (std::size_t v = 0; nodes() + v < state_.x.size(); ++v) {
    const int body = bodies().state().free_of[v];
    if (body < 0) continue;
    const Vec3 force = -bodies().state().share_of_end() * at(change, static_cast<Index>(nodes() + v));
    out.segment<3>(6 * body) += force;
    out.segment<3>(6 * body + 3) += bodies().equations().lever(v).cross(force);
  }
  return out;
}

// A body that turns takes along the places at which the gas pushes.
void GasOnBodies::add_answers(bool with_volumes, Eigen::MatrixXd& answers) const {
  for (Eigen::Index j = 0; j < answers.cols(); ++j)
    answers.col(j) += on_bodies(
        change({}, way_of(static_cast<int>(j / 6), BodyEquations::Vector6::Unit(j % 6)), with_volumes));
  const auto pressed = bodies().state().pressed();
  for (std::size_t v = 0; v < pressed.size(); ++v) {
    const int body = bodies().state().free_of[v];
    if (body < 0 || pressed[v].isZero(0)) continue;
    answers.block<3, 3>(6 * body + 3, 6 * body + 3) += bodies().state().share_of_end() *
                                                       cross_matrix(pressed[v]) *
                                                       cross_matrix(bodies().equations().lever(v));
  }
}

}  // namespace fabricsh::mechanics
