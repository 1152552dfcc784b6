#include "assembly/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "assembly/batch.hpp"
#include "base/error.hpp"
#include "tensor/node_view.hpp"

namespace fabricsh::assembly {

namespace {

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

// Of the angle whose square is x: cos, sin / angle, (cos - 1) / x. Below x = 0.01, where the steps of
// dynamics are, by series that end under rounding.
struct Turn {
  double cosine, sine, versed;
};
Turn turn_by(double x) {
  if (x < 0.01)
    return {1 - x / 2 * (1 - x / 12 * (1 - x / 30 * (1 - x / 56))),
            1 - x / 6 * (1 - x / 20 * (1 - x / 42 * (1 - x / 72))),
            -0.5 * (1 - x / 12 * (1 - x / 30 * (1 - x / 56 * (1 - x / 90))))};
  const double angle = std::sqrt(x), cosine = std::cos(angle);
  return {cosine, std::sin(angle) / angle, (cosine - 1) / x};
}

// v of almost unit length made so: one step of Newton, whose error is the square of the length's.
void renew(Eigen::Map<Vec3> v) { v *= 1.5 - 0.5 * v.squaredNorm(); }

// d turned by the increment q (tangent to the sphere) along a great circle, b1 carried with it.
void turn(Eigen::Map<Vec3> d, Eigen::Map<Vec3> b1, const Vec3& q) {
  const Turn by = turn_by(q.squaredNorm());
  const Vec3 d0 = d;
  d = by.cosine * d0 + by.sine * q;
  renew(d);
  const double along = b1.dot(q);
  b1 += along * (by.versed * q - by.sine * d0);
  b1 -= b1.dot(d) * Vec3(d);
  renew(b1);
}

}  // namespace

Assembly::Assembly(const model::Model& model) : model_(model), X_(model.mesh().nodes) {
  set_kinds();
  auto directors = reference_directors(model.mesh());
  lay_into_planes(model, directors);
  freedoms_ = number_freedoms(model, directors);
  meet_directors(directors);
  colour_elements();
  std::size_t law = 0, geometry = 0;
  for (Batch& batch : batches_) {
    batch.law = law;
    batch.geometry = geometry;
    law += static_cast<std::size_t>(batch.kind->in_plane) * model.section().state_size * lanes;
    geometry += static_cast<std::size_t>(batch.kind->geometry_size) * lanes;
  }
  geometry_.assign(geometry, 0);
  state_ = std::make_unique<StateStore>(X_.size(), law);
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
  make_force_slots();
  find_tested();
  force_x_.assign(3 * X_.size(), 0);
  force_d_.assign(3 * X_.size(), 0);
  add_inertia();
  loads_ = std::make_unique<Loads>(model, mass_, mass_moment_);
}

Assembly::~Assembly() = default;

void Assembly::set_kinds() {
  const int points = static_cast<int>(model_.section().points.size());
  const element::Shell4Layout four(points);
  const element::Shell3Layout three(points);
  quad_ = {element::shell4_kernels(best_isa()),
           4,
           element::gauss_points,
           element::shell4_dofs,
           four.point(0, 0),
           four.size()};
  triangle_ = {element::shell3_kernels(best_isa()),
               3,
               element::shell3_points,
               element::shell3_dofs,
               three.point(0, 0),
               three.size()};
}

void Assembly::colour_elements() {
  const auto& mesh = model_.mesh();
  const auto colours = colour(mesh);
  const int count = *std::max_element(colours.begin(), colours.end()) + 1;
  place_.resize(mesh.elements.size());
  node_element_.assign(mesh.nodes.size(), -1);
  for (int c = 0; c < count; ++c) {
    colour_start_.push_back(static_cast<Index>(batches_.size()));
    add_batches(colours, c, quad_);
    add_batches(colours, c, triangle_);
  }
  colour_start_.push_back(static_cast<Index>(batches_.size()));
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (const auto n : mesh.elements[e])
      if (n >= 0) node_element_[n] = static_cast<Index>(e);
}

// The elements of one colour and kind.
void Assembly::add_batches(const std::vector<int>& colours, int colour, const Kind& kind) {
  const auto& elements = model_.mesh().elements;
  int lane = lanes;
  for (std::size_t e = 0; e < colours.size(); ++e) {
    if (colours[e] != colour || (elements[e][3] < 0) != (kind.corners == 3)) continue;
    if (lane == lanes) {
      batches_.emplace_back();
      batches_.back().kind = &kind;
      lane = 0;
    }
    Batch& batch = batches_.back();
    place_[e] = {static_cast<Index>(batches_.size()) - 1, lane};
    // Lanes that stay empty repeat the batch's last element, and are never scattered.
    for (int l = lane; l < lanes; ++l) {
      batch.element[l] = static_cast<Index>(e);
      batch.nodes[l] = elements[e];
    }
    batch.used = ++lane;
  }
}

namespace {

template <std::size_t corners>
void put_geometry(const section::Section& section, const std::vector<Vec3>& X,
                  const std::vector<Vec3>& directors, const std::array<Index, 4>& nodes,
                  const element::WarpAt& warp, double* geometry, int lane) {
  std::array<Vec3, corners> x, d;
  for (std::size_t a = 0; a < corners; ++a) {
    x[a] = X[nodes[a]];
    d[a] = directors[nodes[a]];
  }
  if constexpr (corners == 3)
    element::shell3_geometry(section, x, d, warp, geometry, lane, lanes);
  else
    element::shell4_geometry(section, x, d, warp, geometry, lane, lanes);
}

}  // namespace

void Assembly::make_geometry(const std::vector<Vec3>& directors) {
  mass_.assign(X_.size(), 0);
  mass_moment_.assign(X_.size(), 0);
  const auto warp = [this](const Vec3& X, const Vec3& n) { return model_.warp_at(X, n); };
  for (Batch& batch : batches_) {
    double* geometry = geometry_.data() + batch.geometry;
    for (int l = 0; l < lanes; ++l) {
      try {
        if (batch.kind->corners == 3)
          put_geometry<3>(model_.section(), X_, directors, batch.nodes[l], warp, geometry, l);
        else
          put_geometry<4>(model_.section(), X_, directors, batch.nodes[l], warp, geometry, l);
      } catch (const Error& e) {
        const std::string what = e.what();
        if (what.rfind("is ", 0) != 0) throw;
        throw Error("mesh: element " + std::to_string(batch.element[l] + 1) + " " + what);
      }
      if (l < batch.used) add_mass(batch, l);
    }
    batch.sharing = batch.kind->corners == 3 ? element::shell3_sharing(model_.section(), geometry)
                                             : element::shell4_sharing(model_.section(), geometry);
  }
}

void Assembly::add_mass(const Batch& batch, int lane) {
  const auto& section = model_.section();
  const int points = static_cast<int>(section.points.size());
  double mass = 0, moment = 0;  // kg, kg m
  for (int g = 0; g < batch.kind->in_plane; ++g)
    for (int k = 0; k < points; ++k) {
      const double m = section.points[k].density *
                       geometry_[batch.geometry + (batch.kind->point(g, k, points) + 7) * lanes + lane];
      mass += m;
      moment += m * section.thickness / 2 * (section.points[k].zeta - section.offset);
    }
  for (int a = 0; a < batch.kind->corners; ++a) {
    mass_[batch.nodes[lane][a]] += mass / batch.kind->corners;
    mass_moment_[batch.nodes[lane][a]] += moment / batch.kind->corners;
  }
}

void Assembly::realign(Index node, std::span<double> d, std::span<double> b1) const {
  const auto& held_axes = freedoms_.nodes[node].held_axes;
  if (held_axes.empty()) return;
  const Vec3 direction = allowed_direction(held_axes, at(d, node));
  if (direction.isZero()) return;
  // The longest shadow changes from one held axis to another, and turns round where the director passes an
  // axis. A rate along b1 keeps its number through a step, so b1 has to keep its sense.
  at(b1, node) = direction.dot(at(std::span<const double>(b1), node)) < 0 ? Vec3(-direction) : direction;
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
#pragma omp parallel for schedule(static) if (X_.size() >= std::size_t{few_batches * lanes})
  for (Index i = 0; i < static_cast<Index>(n); ++i) {
    const NodeFreedoms& node = freedoms_.nodes[i];
    Vec3 u = at(base, i) - X_[i];
    if (node.oblique) u = node.frame * u;
    for (int c = 0; c < 3; ++c) {
      const Index equation = node.equation[c];
      if (equation >= 0)
        u[c] += step(equation);
      else
        u[c] = equation == held || equation == tied ? 0.0 : targets[motion_of(equation)];
    }
    if (node.oblique) u = node.frame.transpose() * u;
    at(state_->x(), i) = X_[i] + u;
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

Vec3 Assembly::director_force(Index node, std::span<const double> on_d) const {
  const Vec3 internal = at(force_d_, node);
  return on_d.empty() ? Vec3(-internal) : Vec3(at(on_d, node) - internal);
}

void Assembly::residual(std::span<const double> external, std::span<double> r,
                        std::span<const double> on_d) const {
  const std::span<const double> fx(force_x_);
  const auto& s = std::as_const(*state_);
  const auto count = static_cast<Index>(X_.size());
#pragma omp parallel for schedule(static) if (count >= 2048)
  for (Index i = 0; i < count; ++i) {
    const NodeFreedoms& node = freedoms_.nodes[i];
    const Vec3 out = at(external, i) - at(fx, i), f = node.oblique ? Vec3(node.frame * out) : out;
    for (int c = 0; c < 3; ++c)
      if (node.equation[c] >= 0) r[node.equation[c]] = f[c];
    if (node.equation[3] < 0) continue;
    const Vec3 turning = director_force(i, on_d), b1 = at(s.b1(), i);
    r[node.equation[3]] = b1.dot(turning);
    if (node.equation[4] >= 0) r[node.equation[4]] = at(s.d(), i).cross(b1).dot(turning);
  }
  add_tied_residual(external, r, on_d);
}

std::pair<double, Index> Assembly::largest_residual(std::span<const double> r) const {
  std::pair<double, Index> best{0, -1};
  for (std::size_t i = 0; i < r.size(); ++i) {
    const double size = std::abs(r[i]) / lever_[i];
    if (!std::isfinite(size)) return {std::numeric_limits<double>::infinity(), static_cast<Index>(i)};
    if (size > best.first) best = {size, static_cast<Index>(i)};
  }
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
  Vec3 f = at(force_x_, n) - at(external, n);
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
  const Batch& batch = batches_[place.batch];
  const Kind& kind = *batch.kind;
  alignas(64) double x[12 * lanes], d[12 * lanes];
  std::vector<double> E(static_cast<std::size_t>(kind.in_plane) * points * 5 * lanes),
      state(section.state_size + 1);
  gather(batch, x, d, nullptr);
  const double* geometry = geometry_.data() + batch.geometry;
  kind.kernels.strain(section, {geometry, x, d, nullptr, nullptr, nullptr}, E.data());
  const double* law = std::as_const(*state_).law().data() + batch.law;
  for (int g = 0; g < kind.in_plane; ++g)
    for (int k = 0; k < points; ++k) {
      const auto& point = section.points[k];
      double e[5];
      for (int i = 0; i < 5; ++i) e[i] = E[((g * points + k) * 5 + i) * lanes + place.lane];
      const int size = fabric::state_size(*point.law);
      for (int i = 0; i < size; ++i)
        state[i] = law[(g * section.state_size + point.state + i) * lanes + place.lane];
      f(geometry[(kind.point(g, k, points) + 7) * lanes + place.lane], *point.law, e, state.data());
    }
}

Vec3 Assembly::centre(Index element) const {
  const Batch& batch = batches_[place_[element].batch];
  Vec3 sum = Vec3::Zero();
  for (int a = 0; a < batch.kind->corners; ++a)
    sum += at(std::as_const(*state_).x(), batch.nodes[place_[element].lane][a]);
  return sum / batch.kind->corners;
}

std::pair<Vec3, Vec3> Assembly::yarns(Index element) const {
  const Place place = place_[element];
  const Batch& batch = batches_[place.batch];
  const Kind& kind = *batch.kind;
  const auto& nodes = batch.nodes[place.lane];
  const auto x = std::as_const(*state_).x();
  Vec3 a1 = at(x, nodes[1]) - at(x, nodes[0]), a2 = at(x, nodes[2]) - at(x, nodes[0]);
  if (kind.corners == 4) {
    a1 = (at(x, nodes[1]) + at(x, nodes[2]) - at(x, nodes[0]) - at(x, nodes[3])) / 4;
    a2 = (at(x, nodes[2]) + at(x, nodes[3]) - at(x, nodes[0]) - at(x, nodes[1])) / 4;
  }
  // A material direction m_i = T_i1 G_1 + T_i2 G_2 goes to T_i1 a_1 + T_i2 a_2; T is averaged over the
  // in-plane points.
  const int points = static_cast<int>(model_.section().points.size());
  double T[4] = {};
  for (int g = 0; g < kind.in_plane; ++g)
    for (int i = 0; i < 4; ++i)
      T[i] += geometry_[batch.geometry + (kind.point(g, points / 2, points) + i) * lanes + place.lane];
  return {(T[0] * a1 + T[1] * a2).normalized(), (T[2] * a1 + T[3] * a2).normalized()};
}

BendingEnergy Assembly::bending_energy(Index element) const {
  const auto& section = model_.section();
  if (!section.bends_apart) return {};
  const Place place = place_[element];
  const Batch& batch = batches_[place.batch];
  const Kind& kind = *batch.kind;
  alignas(64) double x[12 * lanes], d[12 * lanes], kappa[element::gauss_points * 3 * lanes];
  gather(batch, x, d, nullptr);
  const double* geometry = geometry_.data() + batch.geometry;
  kind.kernels.curvature(section, {geometry, x, d, nullptr, nullptr, nullptr}, kappa);
  const double* law = std::as_const(*state_).law().data() + batch.law;
  BendingEnergy sum;
  for (int g = 0; g < kind.in_plane; ++g) {
    const double area = geometry[(kind.point(g, 0, 1) + 7) * lanes + place.lane] / section.thickness;
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
