#include "mechanics/terms/hinges.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <unsupported/Eigen/AutoDiff>

#include "geometry/node_view.hpp"
#include "mesh/corners.hpp"
#include "mesh/edges.hpp"

namespace fabricsh::mechanics {

namespace {

template <class S>
using Vec = Eigen::Matrix<S, 3, 1>;

template <class S>
struct Gradient {
  Vec<S> way, left, right;  // of the energy by the way along the edge and the directors
};

// p, q: directors of the left and right side. about: rad, the angle that is near.
template <class S>
S angle_about(const Vec<S>& t, const Vec<S>& p, const Vec<S>& q, double about) {
  using std::atan2;
  const S along = p.dot(t) * q.dot(t), c = p.dot(q) - along, s = t.dot(q.cross(p));
  const S raw = atan2(s, c);
  double value = 0;
  if constexpr (std::is_same_v<S, double>)
    value = raw;
  else
    value = raw.value();
  return raw + 2 * std::numbers::pi * std::round((about - value) / (2 * std::numbers::pi));
}

template <class S>
Gradient<S> gradient(const Vec<S>& e, const Vec<S>& p, const Vec<S>& q, double weight, double rest,
                     double about) {
  using std::sqrt;
  const S length = sqrt(e.squaredNorm());
  const Vec<S> t = e / length;
  const S pt = p.dot(t), qt = q.dot(t), c = p.dot(q) - pt * qt, s = t.dot(q.cross(p));
  const S moment = weight * (angle_about<S>(t, p, q, about) - rest) / (s * s + c * c),
          apart = weight * (pt - qt);
  const Vec<S> by_t = moment * (c * q.cross(p) + s * (qt * p + pt * q)) + apart * (p - q);
  return {(by_t - by_t.dot(t) * t) / length, moment * (c * t.cross(q) - s * (q - qt * t)) + apart * t,
          moment * (c * p.cross(t) - s * (p - pt * t)) - apart * t};
}

using Nine = Eigen::Matrix<double, 9, 1>;

// Derivatives of the gradient by the way and both directors.
Eigen::Matrix<double, 9, 9> hessian(const Vec3& e, const Vec3& p, const Vec3& q, double weight, double rest,
                                    double about) {
  using S = Eigen::AutoDiffScalar<Nine>;
  Vec<S> at[3];
  const Vec3* const values[] = {&e, &p, &q};
  for (int v = 0; v < 3; ++v)
    for (int i = 0; i < 3; ++i) at[v][i] = S((*values[v])[i], 9, 3 * v + i);
  const Gradient<S> g = gradient<S>(at[0], at[1], at[2], weight, rest, about);
  Eigen::Matrix<double, 9, 9> H;
  for (int i = 0; i < 3; ++i) {
    H.row(i) = g.way[i].derivatives();
    H.row(3 + i) = g.left[i].derivatives();
    H.row(6 + i) = g.right[i].derivatives();
  }
  return H;
}

}  // namespace

Hinges::Hinges(const model::Model& model, const Configuration& configuration) : model_(model) {
  const mesh::Mesh& mesh = model.mesh();
  std::map<std::pair<Index, Index>, model::CreaseEdge> hinges;
  for (const auto& edge : model::crease_edges(model))
    if (edge.stiffness) hinges.emplace(std::pair(edge.from, edge.to), edge);
  mesh::for_each_edge(mesh::edges(mesh.uncut()), [&](const mesh::Edge* begin, const mesh::Edge*) {
    const auto found = hinges.find({begin->first, begin->second});
    if (found == hinges.end()) return;
    const auto& crease = found->second;
    const Index left = begin[begin[0].forward ? 0 : 1].element,
                right = begin[begin[0].forward ? 1 : 0].element;
    const double length = (model.rest_node(crease.to) - model.rest_node(crease.from)).norm();
    for (const bool forward : {true, false}) {
      const Index here = forward ? begin->first : begin->second,
                  there = forward ? begin->second : begin->first;
      const End end{mesh::node_at(mesh, left, here),  mesh::node_at(mesh, left, there),
                    mesh::node_at(mesh, right, here), forward,
                    *crease.stiffness * length / 2,   crease.angle};
      if (end.left != end.right) ends_.push_back(end);  // at its end within the sheet both sides are one
    }
  });
  // A start that is folded flat is at half a turn to the side to which it rests.
  constexpr double flat = 1e-3;
  for (const End& end : ends_) {
    angle_.push_back(0);
    double& angle = angle_.back();
    angle = this->angle(angle_.size() - 1, configuration);
    if (std::abs(angle) > std::numbers::pi - flat && angle * end.rest < 0)
      angle -= std::copysign(2 * std::numbers::pi, angle);
  }
  now_ = angle_;
}

Vec3 Hinges::way(const End& end, const Configuration& now) const {
  const Vec3 way = at(now.x(), end.far) - at(now.x(), end.left);
  return end.forward ? way : Vec3(-way);
}

double Hinges::angle(std::size_t i, const Configuration& now) const {
  const End& end = ends_[i];
  return angle_about<double>(way(end, now).normalized(), at(now.d(), end.left), at(now.d(), end.right),
                             angle_[i]);
}

Outcome Hinges::add_forces(const law::Step&, const Trial& trial, Forces& forces) {
  const Configuration& now = trial.configuration;
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const End& end = ends_[i];
    now_[i] = angle(i, now);
    const auto g = gradient<double>(way(end, now), at(now.d(), end.left), at(now.d(), end.right), end.weight,
                                    end.rest, angle_[i]);
    const Vec3 pull = end.forward ? g.way : Vec3(-g.way);
    at(forces.on_x, end.far) += pull;
    at(forces.on_x, end.left) -= pull;
    at(forces.on_d, end.left) += g.left;
    at(forces.on_d, end.right) += g.right;
  }
  return {};
}

void Hinges::couple(const Trial&, std::vector<NodePair>& pairs) {
  for (const End& end : ends_) {
    pairs.emplace_back(end.left, end.right);
    pairs.emplace_back(end.right, end.far);
    pairs.emplace_back(end.left, end.far);
  }
}

void Hinges::add_tangent(const Trial& trial, TangentSink& sink) const {
  const Configuration& now = trial.configuration;
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const End& end = ends_[i];
    const Vec3 p = at(now.d(), end.left), q = at(now.d(), end.right), e = way(end, now);
    const auto H = hessian(e, p, q, end.weight, end.rest, angle_[i]);
    const auto g = gradient<double>(e, p, q, end.weight, end.rest, angle_[i]);
    // How the nodes' five degrees of freedom move the way and the directors.
    std::array<Eigen::Matrix<double, 9, 5>, 3> by;
    for (auto& rows : by) rows.setZero();
    const Mat3 along = (end.forward ? 1.0 : -1.0) * Mat3::Identity();
    by[0].block<3, 3>(0, 0) = -along;
    by[2].block<3, 3>(0, 0) = along;
    const auto axes = [&](Index node, const Vec3& d) {
      Eigen::Matrix<double, 3, 2> B;
      B.col(0) = at(now.b1(), node);
      B.col(1) = d.cross(Vec3(B.col(0)));
      return B;
    };
    by[0].block<3, 2>(3, 3) = axes(end.left, p);
    by[1].block<3, 2>(6, 3) = axes(end.right, q);
    const std::array<Index, 3> nodes{end.left, end.right, end.far};
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) {
        Eigen::Matrix<double, 5, 5> k = by[a].transpose() * H * by[b];
        if (a == b && a < 2) k.diagonal().tail<2>().array() -= a == 0 ? g.left.dot(p) : g.right.dot(q);
        sink.on_nodes(nodes[a], nodes[b], k);
      }
  }
}

void Hinges::add_energies(const Trial& trial, std::vector<Energy>& out) const {
  const Configuration& now = trial.configuration;
  double stored = 0;
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const End& end = ends_[i];
    const double turned = angle(i, now) - end.rest,
                 apart = way(end, now).normalized().dot(at(now.d(), end.left) - at(now.d(), end.right));
    stored += end.weight / 2 * (turned * turned + apart * apart);
  }
  out.push_back({"hinges", Account::stored, stored});
}

double Hinges::angle_at(Index node) const {
  const Index place = model_.mesh().place_of(node);
  double widest = 0;
  for (std::size_t i = 0; i < ends_.size(); ++i)
    if (model_.mesh().place_of(ends_[i].left) == place && std::abs(angle_[i]) > std::abs(widest))
      widest = angle_[i];
  return widest * 180 / std::numbers::pi;
}

}  // namespace fabricsh::mechanics
