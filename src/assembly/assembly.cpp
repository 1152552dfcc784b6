#include "assembly/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "assembly/batch.hpp"
#include "base/error.hpp"

namespace fabricsh::assembly {

namespace {

using element::gauss_points;
using element::shell4_dofs;

// The element's fibre basis after Hughes: the global axis least aligned with the director (PHYSICS section
// 6).
Vec3 first_axis(const Vec3& d) {
  double a1 = std::abs(d.x()), a3 = std::abs(d.z());
  const double a2 = std::abs(d.y());
  int j = 0;
  if (a1 > a3) {
    a3 = a1;
    j = 1;
  }
  if (a2 > a3) j = 2;
  const Vec3 e2 = d.cross(Vec3::Unit(j)).normalized();
  return e2.cross(d);
}

Eigen::Map<Vec3> at(std::span<double> v, Index n) { return Eigen::Map<Vec3>(v.data() + 3 * n); }
Eigen::Map<const Vec3> at(std::span<const double> v, Index n) {
  return Eigen::Map<const Vec3>(v.data() + 3 * n);
}

// d turned by the increment q (tangent to the sphere) along a great circle, b1 carried with it.
void turn(Eigen::Map<Vec3> d, Eigen::Map<Vec3> b1, const Vec3& q) {
  const double angle = q.norm();
  if (angle == 0) return;
  const Vec3 axis = q / angle;
  const Vec3 d0 = d;
  d = std::cos(angle) * d0 + std::sin(angle) * axis;
  d.normalize();
  const double along = b1.dot(axis);
  b1 += along * ((std::cos(angle) - 1) * axis - std::sin(angle) * d0);
  b1 -= b1.dot(d) * Vec3(d);
  b1.normalize();
}

}  // namespace

Assembly::Assembly(const model::Model& model)
    : model_(model), X_(model.mesh().nodes), kernels_(element::shell4_kernels(best_isa())) {
  auto directors = reference_directors(model.mesh());
  freedoms_ = number_freedoms(model, directors);
  meet_directors(directors);
  colour_elements();
  const auto& section = model.section();
  law_size_ = gauss_points * section.state_size * lanes;
  state_ = std::make_unique<StateStore>(X_.size(), batches_.size() * law_size_);
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n) {
    at(state_->x(), n) = X_[n];
    at(state_->d(), n) = directors[n];
    at(state_->b1(), n) = first_axis(directors[n]);
    first_axes_.push_back(at(state_->b1(), n));
    realign(n, state_->d(), state_->b1());
  }
  reference_directors_ = directors;
  retract_ties({}, 0);
  state_->commit(0);
  iterate_.assign(state_->kinematics().begin(), state_->kinematics().end());
  make_geometry(directors);
  make_pattern();
  force_x_.assign(3 * X_.size(), 0);
  force_d_.assign(3 * X_.size(), 0);
  loads_ = std::make_unique<Loads>(model, mass_, mass_moment_);
}

Assembly::~Assembly() = default;

void Assembly::colour_elements() {
  const auto& mesh = model_.mesh();
  const auto colours = colour(mesh);
  const int count = *std::max_element(colours.begin(), colours.end()) + 1;
  place_.resize(mesh.elements.size());
  node_element_.assign(mesh.nodes.size(), -1);
  for (int c = 0; c < count; ++c) {
    colour_start_.push_back(static_cast<Index>(batches_.size()));
    int lane = lanes;
    for (std::size_t e = 0; e < colours.size(); ++e) {
      if (colours[e] != c) continue;
      if (mesh.elements[e][3] < 0)
        throw Error("mesh: element " + std::to_string(e + 1) +
                    " is a triangle; only quadrilaterals are computed");
      if (lane == lanes) {
        batches_.emplace_back();
        lane = 0;
      }
      Batch& batch = batches_.back();
      place_[e] = {static_cast<Index>(batches_.size()) - 1, lane};
      // Lanes that stay empty repeat the batch's last element, and are never scattered.
      for (int l = lane; l < lanes; ++l) {
        batch.element[l] = static_cast<Index>(e);
        batch.nodes[l] = mesh.elements[e];
      }
      batch.used = ++lane;
    }
  }
  colour_start_.push_back(static_cast<Index>(batches_.size()));
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (const auto n : mesh.elements[e])
      if (n >= 0) node_element_[n] = static_cast<Index>(e);
}

void Assembly::make_geometry(const std::vector<Vec3>& directors) {
  const auto& section = model_.section();
  const element::Shell4Layout layout(static_cast<int>(section.points.size()));
  geometry_size_ = layout.size() * lanes;
  geometry_.assign(batches_.size() * geometry_size_, 0);
  mass_.assign(X_.size(), 0);
  mass_moment_.assign(X_.size(), 0);
  const auto warp = [this](const Vec3& X, const Vec3& n) { return model_.warp_at(X, n); };
  for (std::size_t b = 0; b < batches_.size(); ++b) {
    double* geometry = geometry_.data() + b * geometry_size_;
    for (int l = 0; l < lanes; ++l) {
      const auto& nodes = batches_[b].nodes[l];
      std::array<Vec3, 4> X, D;
      for (int a = 0; a < 4; ++a) {
        X[a] = X_[nodes[a]];
        D[a] = directors[nodes[a]];
      }
      try {
        element::shell4_geometry(section, X, D, warp, geometry, l, lanes);
      } catch (const Error& e) {
        const std::string what = e.what();
        if (what.rfind("is ", 0) != 0) throw;
        throw Error("mesh: element " + std::to_string(batches_[b].element[l] + 1) + " " + what);
      }
      if (l >= batches_[b].used) continue;
      double mass = 0, moment = 0;  // kg, kg m
      for (int g = 0; g < gauss_points; ++g)
        for (std::size_t k = 0; k < section.points.size(); ++k) {
          const double m =
              section.points[k].density * geometry[(layout.point(g, static_cast<int>(k)) + 7) * lanes + l];
          mass += m;
          moment += m * section.thickness / 2 * (section.points[k].zeta - section.offset);
        }
      for (int a = 0; a < 4; ++a) {
        mass_[nodes[a]] += mass / 4;
        mass_moment_[nodes[a]] += moment / 4;
      }
    }
  }
}

double* Assembly::trial_law(Index batch) { return state_->law().data() + batch * law_size_; }
const double* Assembly::committed_law(Index batch) const {
  return state_->committed_law().data() + batch * law_size_;
}

void Assembly::realign(Index node, std::span<double> d, std::span<double> b1) const {
  const auto& held_axes = freedoms_.nodes[node].held_axes;
  if (held_axes.empty()) return;
  const Vec3 direction = allowed_direction(held_axes, at(d, node));
  if (!direction.isZero()) at(b1, node) = direction;
}

void Assembly::begin_iterate() {
  const auto k = state_->kinematics();
  iterate_.assign(k.begin(), k.end());
}

std::vector<double> Assembly::targets(double time) const {
  std::vector<double> values;
  values.reserve(freedoms_.motions.size());
  for (const auto& m : freedoms_.motions) values.push_back(m.value(time));
  return values;
}

void Assembly::retract(std::span<const double> delta, double scale, std::span<const double> targets) {
  const std::size_t n = X_.size();
  const std::span<const double> base(iterate_);
  const auto step = [&](Index equation) { return equation >= 0 ? scale * delta[equation] : 0.0; };
  for (Index i = 0; i < static_cast<Index>(n); ++i) {
    const NodeFreedoms& node = freedoms_.nodes[i];
    Vec3 u = node.frame * (at(base, i) - X_[i]);
    for (int c = 0; c < 3; ++c) {
      const Index equation = node.equation[c];
      if (equation >= 0)
        u[c] += step(equation);
      else
        u[c] = equation == held || equation == tied ? 0.0 : targets[motion_of(equation)];
    }
    at(state_->x(), i) = X_[i] + node.frame.transpose() * u;
    at(state_->d(), i) = at(base.subspan(3 * n), i);
    at(state_->b1(), i) = at(base.subspan(6 * n), i);
    if (node.turn_axis) {
      const Mat3 R =
          Eigen::AngleAxisd(targets[motion_of(node.equation[3])], *node.turn_axis).toRotationMatrix();
      at(state_->d(), i) = R * reference_directors_[i];
      at(state_->b1(), i) = R * first_axes_[i];
      continue;
    }
    const double q1 = step(node.equation[3]), q2 = step(node.equation[4]);
    if (q1 == 0 && q2 == 0) continue;
    const Vec3 d = at(state_->d(), i), b1 = at(state_->b1(), i);
    turn(at(state_->d(), i), at(state_->b1(), i), q1 * b1 + q2 * d.cross(b1));
    realign(i, state_->d(), state_->b1());
  }
  retract_ties(delta, scale);
  state_->touch();
}

void Assembly::external(double time, std::vector<double>& out) const { loads_->dead(time, out); }

void Assembly::follower(double time, std::vector<double>& out) const {
  out.assign(3 * X_.size(), 0);
  loads_->add_follower(time, std::as_const(*state_).x(), out, 1.0);
}

double Assembly::spring_energy() const { return loads_->spring_energy(std::as_const(*state_).x(), X_); }

void Assembly::residual(std::span<const double> external, std::span<double> r) const {
  const std::span<const double> fx(force_x_), fd(force_d_);
  for (Index i = 0; i < static_cast<Index>(X_.size()); ++i) {
    const NodeFreedoms& node = freedoms_.nodes[i];
    const Vec3 f = node.frame * (at(external, i) - at(fx, i));
    for (int c = 0; c < 3; ++c)
      if (node.equation[c] >= 0) r[node.equation[c]] = f[c];
    if (node.equation[3] < 0) continue;
    const Vec3 d = at(std::as_const(*state_).d(), i), b1 = at(state_->b1(), i);
    r[node.equation[3]] = -b1.dot(at(fd, i));
    if (node.equation[4] >= 0) r[node.equation[4]] = -d.cross(b1).dot(at(fd, i));
  }
  add_tied_residual(external, r);
}

std::pair<double, Index> Assembly::largest_residual(std::span<const double> r) const {
  std::pair<double, Index> best{0, -1};
  for (std::size_t i = 0; i < r.size(); ++i)
    if (const double size = std::abs(r[i]) / lever_[i]; size > best.first)
      best = {size, static_cast<Index>(i)};
  return best;
}

double Assembly::largest_force() const {
  double largest = 0, moment = 0;
  for (const double f : force_x_) largest = std::max(largest, std::abs(f));
  const std::span<const double> fd(force_d_);
  for (Index i = 0; i < static_cast<Index>(X_.size()); ++i) {
    const Vec3 d = at(std::as_const(*state_).d(), i), f = at(fd, i);
    moment = std::max(moment, (f - f.dot(d) * d).cwiseAbs().maxCoeff());
  }
  return std::max(largest, moment / length_);
}

double Assembly::rounding_floor(const solver::SparseMatrix& K) const {
  double stiffest[2] = {0, 0}, farthest = 0;  // displacements, rotations
  for (Index eq = 0; eq < K.size; ++eq) {
    const auto first = K.row.begin() + K.column[eq], last = K.row.begin() + K.column[eq + 1];
    const double k = std::abs(K.value[std::lower_bound(first, last, eq) - K.row.begin()]);
    stiffest[turns_[eq]] = std::max(stiffest[turns_[eq]], k);
  }
  for (const double x : std::as_const(*state_).x()) farthest = std::max(farthest, std::abs(x));
  return 16 * std::numeric_limits<double>::epsilon() *
         std::max(farthest * stiffest[0], stiffest[1] / length_);
}

Vec3 Assembly::support_force(Index n, std::span<const double> external) const {
  const NodeFreedoms& node = freedoms_.nodes[n];
  Vec3 f = at(std::span<const double>(force_x_), n) - at(external, n);
  if (!led_.empty() && !led_[n].empty()) f += tied_force(n, external);
  f = node.frame * f;
  for (int c = 0; c < 3; ++c)
    if (node.equation[c] >= 0 || node.equation[c] == tied) f[c] = 0;
  return node.frame.transpose() * f;
}

Index Assembly::node_of_unknown(Index unknown) const { return unknown_node_[unknown]; }
Index Assembly::element_of_unknown(Index unknown) const { return node_element_[unknown_node_[unknown]]; }

void Assembly::visit(Index element, const PointVisitor& f) const {
  const Place place = place_[element];
  const auto& section = model_.section();
  const int points = static_cast<int>(section.points.size());
  const element::Shell4Layout layout(points);
  alignas(64) double x[12 * lanes], d[12 * lanes];
  std::vector<double> E(static_cast<std::size_t>(gauss_points) * points * 5 * lanes),
      state(section.state_size + 1);
  gather(batches_[place.batch], x, d, nullptr);
  const double* geometry = geometry_.data() + place.batch * geometry_size_;
  kernels_.strain(section, {geometry, x, d, nullptr, nullptr, nullptr}, E.data());
  const double* law = std::as_const(*state_).law().data() + place.batch * law_size_;
  for (int g = 0; g < gauss_points; ++g)
    for (int k = 0; k < points; ++k) {
      const auto& point = section.points[k];
      double e[5];
      for (int i = 0; i < 5; ++i) e[i] = E[((g * points + k) * 5 + i) * lanes + place.lane];
      const int size = fabric::state_size(*point.law);
      for (int i = 0; i < size; ++i)
        state[i] = law[(g * section.state_size + point.state + i) * lanes + place.lane];
      f(geometry[(layout.point(g, k) + 7) * lanes + place.lane], *point.law, e, state.data());
    }
}

std::pair<Vec3, Vec3> Assembly::yarns(Index element) const {
  const Place place = place_[element];
  const auto& nodes = batches_[place.batch].nodes[place.lane];
  const auto x = std::as_const(*state_).x();
  const Vec3 a1 = (at(x, nodes[1]) + at(x, nodes[2]) - at(x, nodes[0]) - at(x, nodes[3])) / 4;
  const Vec3 a2 = (at(x, nodes[2]) + at(x, nodes[3]) - at(x, nodes[0]) - at(x, nodes[1])) / 4;
  // A material direction m_i = T_i1 G_1 + T_i2 G_2 goes to T_i1 a_1 + T_i2 a_2; T is averaged over the
  // in-plane points.
  const element::Shell4Layout layout(static_cast<int>(model_.section().points.size()));
  const int middle = layout.points / 2;
  double T[4] = {};
  for (int g = 0; g < gauss_points; ++g)
    for (int i = 0; i < 4; ++i)
      T[i] += geometry_[place.batch * geometry_size_ + (layout.point(g, middle) + i) * lanes + place.lane];
  return {(T[0] * a1 + T[1] * a2).normalized(), (T[2] * a1 + T[3] * a2).normalized()};
}

BendingEnergy Assembly::bending_energy(Index element) const {
  const auto& section = model_.section();
  if (!section.bends_apart) return {};
  const Place place = place_[element];
  const element::Shell4Layout layout(1);
  alignas(64) double x[12 * lanes], d[12 * lanes], kappa[gauss_points * 3 * lanes];
  gather(batches_[place.batch], x, d, nullptr);
  const double* geometry = geometry_.data() + place.batch * geometry_size_;
  kernels_.curvature(section, {geometry, x, d, nullptr, nullptr, nullptr}, kappa);
  const double* law = std::as_const(*state_).law().data() + place.batch * law_size_;
  BendingEnergy sum;
  for (int g = 0; g < gauss_points; ++g) {
    const double area = geometry[(layout.point(g, 0) + 7) * lanes + place.lane] / section.thickness;
    for (int m = 0; m < 3; ++m) {
      fabric::BendingState<double> state;
      const auto number = [&](int i) {
        return law[(g * section.state_size + section.bending_state + 2 * m + i) * lanes + place.lane];
      };
      if (section.bending_state >= 0 && m < 2) state = {number(0), number(1)};
      sum.stored +=
          area * fabric::bending_stored(section.bending[m], kappa[(3 * g + m) * lanes + place.lane], state);
      sum.lost += area * state.lost;
    }
  }
  return sum;
}

}  // namespace fabricsh::assembly
