// Ties by elimination: followers take the weighted sum of their leads' displacements, rigid bodies six
// unknowns. A tied node's forces go to what it follows through the columns of its links, the same that carry
// increments to it.
#include <algorithm>
#include <cmath>

#include "assembly/assembly.hpp"
#include "assembly/batch.hpp"
#include "tensor/node_view.hpp"

namespace fabricsh::assembly {

namespace {

using element::shell4_dofs;
using Column = Eigen::Matrix<double, 5, 1>;

// Second variation of a vector r of a body that turns, exp(theta) r, on a force f: theta . (sym(r f^T) -
// (r.f) 1) theta.
Mat3 turning(const Vec3& r, const Vec3& f) {
  return (r * f.transpose() + f * r.transpose()) / 2 - r.dot(f) * Mat3::Identity();
}

Mat3 cross_matrix(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

}  // namespace

// Directors of nodes tied to each other become their mean: the two sides of a seam see half the elements
// each.
void Assembly::meet_directors(std::vector<Vec3>& directors) const {
  std::vector<Vec3> sum = directors;
  for (const auto& f : freedoms_.followers)
    if (f.component == 3) sum[f.leads[0].node] += directors[f.node];
  for (const auto& f : freedoms_.followers)
    if (f.component == 3) {
      directors[f.leads[0].node] = sum[f.leads[0].node].normalized();
      directors[f.node] = directors[f.leads[0].node];
    }
}

// Elements with a tied node, who follows whom, and what the unknowns of bodies are.
void Assembly::list_tied_elements() {
  if (freedoms_.followers.empty() && freedoms_.bodies.empty()) return;
  tied_place_.assign(batches_.size() * lanes, -1);
  for (const Place place : place_) {
    const auto& nodes = batches_[place.batch].nodes[place.lane];
    if (!std::any_of(nodes.begin(), nodes.end(), [&](Index n) { return n >= 0 && freedoms_.ties(n); }))
      continue;
    tied_place_[place.batch * lanes + place.lane] = static_cast<Index>(tied_elements_.size());
    tied_elements_.push_back(place);
  }
  tied_tangent_.resize(tied_elements_.size() * shell4_dofs * shell4_dofs);
  led_.resize(X_.size());
  for (std::size_t f = 0; f < freedoms_.followers.size(); ++f)
    for (std::size_t k = 0; k < freedoms_.followers[f].leads.size(); ++k)
      led_[freedoms_.followers[f].leads[k].node].emplace_back(static_cast<Index>(f), static_cast<int>(k));
  for (const Body& body : freedoms_.bodies) {
    const auto x = std::as_const(*state_).x();
    double radius = 0;
    for (const Index n : body.nodes) radius = std::max(radius, (at(x, n) - centroid(body, x)).norm());
    for (Index i = 0; i < 6; ++i) {
      unknown_node_[body.equation + i] = body.nodes.front();
      turns_[body.equation + i] = i >= 3;
      if (i >= 3) lever_[body.equation + i] = radius;
    }
  }
}

Vec3 Assembly::centroid(const Body& body, std::span<const double> x) const {
  Vec3 sum = Vec3::Zero();
  for (const Index n : body.nodes) sum += at(x, n);
  return sum / static_cast<double>(body.nodes.size());
}

// What moves a node's five freedoms (along its frame), at the trial configuration.
void Assembly::links(Index n, std::vector<Link>& out) const {
  out.clear();
  const NodeFreedoms& node = freedoms_.nodes[n];
  if (const Index which = freedoms_.body(n); which >= 0) {
    const Body& body = freedoms_.bodies[which];
    const auto& s = std::as_const(*state_);
    const Vec3 r = at(s.x(), n) - centroid(body, s.x()), d = at(s.d(), n), b1 = at(state_->b1(), n);
    for (int i = 0; i < 3; ++i) out.push_back({body.equation + i, Column::Unit(i)});
    for (int i = 0; i < 3; ++i) {
      const Vec3 spin = Vec3::Unit(i).cross(d);
      Column c;
      c << Vec3::Unit(i).cross(r), b1.dot(spin), d.cross(b1).dot(spin);
      out.push_back({body.equation + 3 + i, c});
    }
    return;
  }
  for (int c = 0; c < 5; ++c)
    if (node.equation[c] != tied && node.equation[c] != held)
      out.push_back({node.equation[c], Column::Unit(c)});
  auto f = std::lower_bound(freedoms_.followers.begin(), freedoms_.followers.end(), n,
                            [](const model::Follower& a, Index b) { return a.node < b; });
  for (; f != freedoms_.followers.end() && f->node == n; ++f)
    for (const auto& lead : f->leads) {
      const NodeFreedoms& from = freedoms_.nodes[lead.node];
      if (f->component == 3) {
        for (int c = 3; c < 5; ++c)
          if (from.equation[c] != held) out.push_back({from.equation[c], Column::Unit(c)});
        continue;
      }
      for (int j = 0; j < 3; ++j)
        if (const double w = lead.weight * from.frame(j, f->component); w != 0 && from.equation[j] != held)
          out.push_back({from.equation[j], w * Column::Unit(f->component)});
    }
}

void Assembly::add_link_pattern(std::vector<std::vector<Index>>& rows) const {
  std::vector<Link> node;
  std::vector<Index> all;
  for (const Place place : tied_elements_) {
    all.clear();
    for (const Index n : batches_[place.batch].nodes[place.lane]) {
      if (n < 0) continue;
      links(n, node);
      for (const Link& l : node)
        if (l.equation >= 0) all.push_back(l.equation);
    }
    for (const Index c : all) rows[c].insert(rows[c].end(), all.begin(), all.end());
  }
}

// Tied nodes after all others: bodies from the iterate, followers from their leads.
void Assembly::retract_ties(std::span<const double> delta, double scale) {
  const std::size_t n = X_.size();
  const std::span<const double> base(iterate_);
  const auto x = state_->x(), d = state_->d(), b1 = state_->b1();
  for (const Body& body : freedoms_.bodies) {
    if (delta.empty()) break;
    const Vec3 c = centroid(body, base);
    const double* step = delta.data() + body.equation;
    const Vec3 move = scale * Vec3(step[0], step[1], step[2]), turn = scale * Vec3(step[3], step[4], step[5]);
    const Mat3 R = turn.norm() > 0 ? Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix()
                                   : Mat3::Identity();
    for (const Index i : body.nodes) {
      at(x, i) = c + move + R * (at(base, i) - c);
      at(d, i) = (R * at(base.subspan(3 * n), i)).normalized();
      at(b1, i) = R * at(base.subspan(6 * n), i);
    }
  }
  for (const auto& f : freedoms_.followers) {
    if (f.component == 3) {
      at(d, f.node) = at(d, f.leads[0].node);
      at(b1, f.node) = at(b1, f.leads[0].node);
      continue;
    }
    double u = 0;
    for (const auto& lead : f.leads)
      u += lead.weight * (x[3 * lead.node + f.component] - X_[lead.node][f.component]);
    x[3 * f.node + f.component] = X_[f.node][f.component] + u;
  }
}

void Assembly::add_tied_residual(std::span<const double> external, std::span<double> r,
                                 std::span<const double> on_d) const {
  if (tied_elements_.empty()) return;
  const std::span<const double> fx(force_x_);
  const auto d = std::as_const(*state_).d();
  for (const Body& body : freedoms_.bodies)
    for (Index i = 0; i < 6; ++i) r[body.equation + i] = 0;
  std::vector<Link> node;
  for (Index i = 0; i < static_cast<Index>(X_.size()); ++i) {
    if (!freedoms_.ties(i)) continue;
    const Vec3 b1 = at(state_->b1(), i), b2 = Vec3(at(d, i)).cross(b1);
    Column f;
    const Vec3 turning = director_force(i, on_d);
    f << freedoms_.nodes[i].frame * (at(external, i) - at(fx, i)), b1.dot(turning), b2.dot(turning);
    // What an untied freedom of this node carries is there already.
    for (int c = 0; c < 5; ++c)
      if (freedoms_.nodes[i].equation[c] != tied && !(c == 4 && freedoms_.nodes[i].equation[3] == tied))
        f[c] = 0;
    links(i, node);
    for (const Link& l : node)
      if (l.equation >= 0) r[l.equation] += l.column.dot(f);
    // A director has no rotation about itself: that part of a moment works on the body alone.
    const Vec3* moment = loads_->moment_on(i);
    if (const Index which = freedoms_.body(i); which >= 0 && moment != nullptr) {
      const Vec3 drill = moment->dot(at(d, i)) * at(d, i);
      for (int k = 0; k < 3; ++k) r[freedoms_.bodies[which].equation + 3 + k] += drill[k];
    }
  }
}

// Internal minus external force that a node's followers hand to it, N, global.
Vec3 Assembly::tied_force(Index lead, std::span<const double> external) const {
  Vec3 sum = Vec3::Zero();
  for (const auto& [which, k] : led_[lead]) {
    const auto& f = freedoms_.followers[which];
    if (f.component == 3) continue;
    const Index i = 3 * f.node + f.component;
    sum[f.component] += f.leads[k].weight * (force_x_[i] - external[i]);
  }
  return sum;
}

void Assembly::add_block(Index a, Index b, const Eigen::Matrix<double, 5, 5>& k, solver::SparseMatrix& K,
                         std::span<const double> lead, std::span<double> product) const {
  std::vector<Link> A, B;
  links(a, A);
  links(b, B);
  for (const Link& column : B) {
    const Column kc = k * column.column;
    for (const Link& row : A) add_entry(row.equation, column.equation, row.column.dot(kc), K, lead, product);
  }
}

void Assembly::scatter_tied(solver::SparseMatrix& K, std::span<const double> lead,
                            std::span<double> product) const {
  std::vector<Link> node[4];
  for (std::size_t e = 0; e < tied_elements_.size(); ++e) {
    const Place place = tied_elements_[e];
    const auto& nodes = batches_[place.batch].nodes[place.lane];
    const Eigen::Map<const Eigen::Matrix<double, shell4_dofs, shell4_dofs>> k(tied_tangent_.data() +
                                                                              e * shell4_dofs * shell4_dofs);
    const int corners = batches_[place.batch].kind->corners;
    for (int a = 0; a < corners; ++a) links(nodes[a], node[a]);
    for (int b = 0; b < corners; ++b)
      for (const Link& column : node[b]) {
        const Eigen::Matrix<double, shell4_dofs, 1> kc = k.middleCols<5>(5 * b) * column.column;
        for (int a = 0; a < corners; ++a)
          for (const Link& row : node[a])
            add_entry(row.equation, column.equation, row.column.dot(kc.segment<5>(5 * a)), K, lead, product);
      }
  }
}

// Second variation of the nodes' arms and directors under the forces of the trial configuration, internal
// minus external at the aimed time. The director's own, -(f.d) on its two rotations, is in K already; what
// remains is the force along the sphere, and a moment about the director.
void Assembly::add_body_stiffness(solver::SparseMatrix& K) const {
  if (freedoms_.bodies.empty()) return;
  std::vector<double> dead;
  loads_->dead(loads_->aimed(), dead);
  const std::span<const double> external(dead), fx(force_x_), fd(force_d_);
  const auto& s = std::as_const(*state_);
  for (const Body& body : freedoms_.bodies) {
    Mat3 k = Mat3::Zero();
    const Vec3 c = centroid(body, s.x());
    for (const Index n : body.nodes) {
      const Vec3 d = at(s.d(), n), f = at(fd, n), along = f - f.dot(d) * d;
      k += turning(at(s.x(), n) - c, at(fx, n) - at(external, n)) + turning(d, along);
      const Vec3* moment = loads_->moment_on(n);
      if (moment == nullptr) continue;
      const Vec3 drill = moment->dot(d) * d;
      // Its derivative, in the measure of the exponential map about the trial configuration.
      k -= d * d.cross(*moment).transpose() - cross_matrix(drill) / 2;
    }
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) add_entry(body.equation + 3 + i, body.equation + 3 + j, k(i, j), K, {}, {});
  }
}

}  // namespace fabricsh::assembly
