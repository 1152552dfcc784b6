#include "mechanics/dofs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/shares.hpp"
#include "geometry/node_view.hpp"
#include "geometry/turning.hpp"
#include "mechanics/mesh_tools.hpp"
#include "mechanics/rest_shape.hpp"
#include "mechanics/turning_batch.hpp"

namespace fabricsh::mechanics {

namespace {
constexpr Index kParallelFrom = 1024;  // number of nodes from which loops use several threads
}

Dofs::Dofs(const model::Model& model, Configuration& configuration)
    : configuration_(configuration),
      joints_(model.mesh()),
      X_(model.mesh().nodes),
      directors_(model.has_rest() ? directors_of_folded(model.mesh())
                                  : mechanics::reference_directors(model.mesh())) {
  lay_into_planes(model, directors_);
  freedoms_ = number_freedoms(model, directors_, joints_);
  begin_seams(model);
  meet_directors();
  find_plain_nodes();
  first_axes_.reserve(X_.size());
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n) {
    at(configuration_.x(), n) = X_[n];
    at(configuration_.d(), n) = directors_[n];
    at(configuration_.b1(), n) = first_axis(directors_[n]);
    first_axes_.push_back(at(configuration_.b1(), n));
    realign(n);
  }
  apply_ties({}, 0);
  configuration_.commit(0);
  begin_iterate();
  for (const auto& motion : freedoms_.motions) driven_nodes_.push_back(motion.node);
  std::sort(driven_nodes_.begin(), driven_nodes_.end());
  driven_nodes_.erase(std::unique(driven_nodes_.begin(), driven_nodes_.end()), driven_nodes_.end());
  measure(model);
  list_unknowns();
}

void Dofs::find_plain_nodes() {
  plain_.resize(X_.size());
  const auto small = [](Index e) {
    return e != tied && std::abs(e) <= std::numeric_limits<std::int32_t>::max();
  };
  for (std::size_t n = 0; n < X_.size(); ++n) {
    const NodeFreedoms& node = freedoms_.nodes[n];
    plain_[n].is_plain = joints_.leads(static_cast<Index>(n)) && !node.oblique && !node.turn_axis &&
                         node.held_axes.empty() &&
                         std::all_of(node.equation.begin(), node.equation.end(), small);
    if (!plain_[n].is_plain) continue;
    for (std::size_t c = 0; c < 5; ++c) plain_[n].equation[c] = static_cast<std::int32_t>(node.equation[c]);
  }
}

// The lengths by which moments are divided, and what follows a node.
void Dofs::measure(const model::Model& model) {
  double edges = 0, count = 0;
  for (const auto& e : model.mesh().elements) {
    const int sides = e[3] < 0 ? 3 : 4;
    for (int a = 0; a < sides; ++a) edges += (X_[e[a]] - X_[e[(a + 1) % sides]]).norm();
    count += sides;
  }
  length_ = edges / count;
  list_led();
  for (const RigidBody& body : freedoms_.bodies) {
    const auto x = std::as_const(configuration_).x();
    double radius = 0;
    for (const Index i : body.nodes) radius = std::max(radius, (at(x, i) - centroid(body, x)).norm());
    radius_.push_back(radius);
  }
}

// Which followers each node leads.
void Dofs::list_led() {
  led_.clear();
  tied_nodes_.clear();
  if (!has_ties()) return;
  led_.resize(X_.size());
  for (std::size_t f = 0; f < freedoms_.followers.size(); ++f)
    for (std::size_t k = 0; k < freedoms_.followers[f].leads.size(); ++k)
      led_[freedoms_.followers[f].leads[k].node].emplace_back(static_cast<Index>(f), static_cast<int>(k));
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n)
    if (freedoms_.ties(n)) tied_nodes_.push_back(n);
}

// Finds for each unknown its node and whether it is a rotation.
void Dofs::list_unknowns() {
  unknown_node_.assign(freedoms_.unknowns, -1);
  turns_.assign(freedoms_.unknowns, false);
  for (std::size_t i = 0; i < freedoms_.nodes.size(); ++i)
    for (int c = 0; c < 5; ++c)
      if (const Index eq = freedoms_.nodes[i].equation[c]; eq >= 0 && joints_.leads(static_cast<Index>(i))) {
        unknown_node_[eq] = static_cast<std::int32_t>(i);
        turns_[eq] = c >= 3;
      }
  for (const RigidBody& body : freedoms_.bodies)
    for (Index i = 0; i < 6; ++i) {
      unknown_node_[body.equation + i] = static_cast<std::int32_t>(body.nodes.front());
      turns_[body.equation + i] = i >= 3;
    }
}

// The unknowns of bodies follow those of the nodes, six for each.
double Dofs::lever(Index unknown) const {
  if (!turns_[unknown]) return 1;
  const auto& bodies = freedoms_.bodies;
  if (bodies.empty() || unknown < bodies.front().equation) return length_;
  return radius_[(unknown - bodies.front().equation) / 6];
}

// If held rotation axes leave a director only one tangent direction, that is its first axis b1.
void Dofs::realign(Index node) {
  const auto& held_axes = freedoms_.nodes[node].held_axes;
  if (held_axes.empty()) return;
  const Vec3 direction = allowed_direction(held_axes, at(configuration_.d(), node));
  if (direction.isZero()) return;
  // The direction changes its sign when the director passes a held axis, or when another axis becomes
  // decisive. A rate along b1 keeps its value through a step, so b1 must keep its sense.
  const Vec3 before = at(configuration_.b1(), node);
  at(configuration_.b1(), node) = direction.dot(before) < 0 ? Vec3(-direction) : direction;
}

void Dofs::begin_iterate() {
  iterate_is_committed_ = !configuration_.moved();
  if (iterate_is_committed_) return;
  const auto k = std::as_const(configuration_).kinematics();
  iterate_.assign(k.begin(), k.end());
}

std::span<const double> Dofs::iterate() const {
  return iterate_is_committed_ ? configuration_.committed_kinematics() : std::span<const double>(iterate_);
}

void Dofs::hold_here() {
  held_at_.resize(X_.size());
  const auto x = configuration_.committed_kinematics();
  for (Index i = 0; i < static_cast<Index>(X_.size()); ++i) {
    held_at_[i] = freedoms_.nodes[i].frame * (at(x, i) - X_[i]);
    realign(i);
  }
}

std::vector<double> Dofs::targets(double time) const {
  std::vector<double> history(freedoms_.histories.size());
  for (std::size_t h = 0; h < history.size(); ++h) history[h] = freedoms_.histories[h].value(time);
  std::vector<double> values;
  values.reserve(freedoms_.motions.size());
  for (const auto& m : freedoms_.motions) values.push_back(m.of(history[m.history]));
  return values;
}

void Dofs::apply_increment(std::span<const double> delta, double scale, std::span<const double> targets) {
  const std::size_t n = X_.size();
  const std::span<const double> base = iterate();
  configuration_.overwrite();
  const auto step = [&](Index equation) { return equation >= 0 ? scale * delta[equation] : 0.0; };
  const auto x = configuration_.x(), d = configuration_.d(), b1 = configuration_.b1();
  const auto move = [&](Index i, const auto& equation, Vec3& u) {
    for (int c = 0; c < 3; ++c)
      if (equation[c] >= 0)
        u[c] += step(equation[c]);
      else if (equation[c] == held && !held_at_.empty())
        u[c] = held_at_[i][c];
      else
        u[c] = equation[c] == held || equation[c] == tied ? 0.0 : targets[motion_of(equation[c])];
  };
  // Moves the node and returns whether its director turns, by q.
  const auto move_node = [&](Index i, double(&q)[2]) {
    at(d, i) = at(base.subspan(3 * n), i);
    at(b1, i) = at(base.subspan(6 * n), i);
    Vec3 u = at(base, i) - X_[i];
    if (const std::int32_t* equation = plain_equations(i)) {
      move(i, equation, u);
      at(x, i) = X_[i] + u;
      q[0] = step(equation[3]), q[1] = step(equation[4]);
      return q[0] != 0 || q[1] != 0;
    }
    const NodeFreedoms& node = freedoms_.nodes[i];
    if (node.oblique) u = node.frame * u;
    move(i, node.equation, u);
    if (node.oblique) u = node.frame.transpose() * u;
    at(x, i) = X_[i] + u;
    if (node.turn_axis) {
      const Mat3 R =
          Eigen::AngleAxisd(targets[motion_of(node.equation[3])], *node.turn_axis).toRotationMatrix();
      at(d, i) = R * directors_[i];
      at(b1, i) = R * first_axes_[i];
      return false;
    }
    q[0] = step(node.equation[3]), q[1] = step(node.equation[4]);
    return q[0] != 0 || q[1] != 0;
  };
  const auto move_nodes = [&](Index from, Index to) {
    TurningBatch batch;
    bool turns[lanes] = {}, any = false;
    for (Index i = from; i < to; ++i) {
      double q[2];
      const auto lane = static_cast<std::size_t>(i - from);
      turns[lane] = joints_.leads(i) && move_node(i, q);
      if (!turns[lane]) continue;
      any = true;
      for (std::size_t c = 0; c < 3; ++c) batch.d[c][lane] = at(d, i)[c], batch.b1[c][lane] = at(b1, i)[c];
      batch.q[0][lane] = q[0], batch.q[1][lane] = q[1];
    }
    if (any) turn(batch);
    for (Index i = from; i < to; ++i) {
      if (!joints_.leads(i)) continue;
      if (const auto lane = static_cast<std::size_t>(i - from); turns[lane]) {
        for (std::size_t c = 0; c < 3; ++c) at(d, i)[c] = batch.d[c][lane], at(b1, i)[c] = batch.b1[c][lane];
        if (plain_equations(i) == nullptr) realign(i);
      }
      for (Index other = joints_.next(i); other >= 0; other = joints_.next(other))
        for (const auto& part : {x, d, b1}) at(part, other) = at(part, i);
    }
  };
  const auto nodes = static_cast<Index>(n);
  for_each_index((nodes + lanes - 1) / lanes, nodes >= 128,
                 [&](Index k) { move_nodes(k * lanes, std::min((k + 1) * lanes, nodes)); });
  apply_ties(delta, scale);
  configuration_.touch();
}

namespace {

// The residual force on a director: that of loads and inertia, if any, less the internal one.
Vec3 on_director(std::span<const double> on_d, std::span<const double> internal_d, Index node) {
  const Vec3 internal = at(internal_d, node);
  return on_d.empty() ? Vec3(-internal) : Vec3(at(on_d, node) - internal);
}

}  // namespace

void Dofs::residual(std::span<const double> external, std::span<const double> internal_x,
                    std::span<const double> internal_d, std::span<const double> on_d,
                    const std::vector<Vec3>* moments, std::span<double> r) const {
  const auto d = std::as_const(configuration_).d(), first = std::as_const(configuration_).b1();
  const auto count = static_cast<Index>(X_.size());
  // The sum over the nodes of a joint, whose directors are those of the leader.
  const auto put = [&](Index leader, const auto& equation, const Mat3* frame) {
    const auto out = [&](Index i) {
      const Vec3 f = at(external, i) - at(internal_x, i);
      return frame != nullptr ? Vec3(*frame * f) : f;
    };
    Vec3 force = out(leader);
    for (Index i = joints_.next(leader); i >= 0; i = joints_.next(i)) force += out(i);
    for (int c = 0; c < 3; ++c)
      if (equation[c] >= 0) r[equation[c]] = force[c];
    if (equation[3] < 0) return;
    const Vec3 b1 = at(first, leader), b2 = at(d, leader).cross(b1);
    Vec3 turning = on_director(on_d, internal_d, leader);
    double q1 = b1.dot(turning), q2 = b2.dot(turning);
    for (Index i = joints_.next(leader); i >= 0; i = joints_.next(i)) {
      turning = on_director(on_d, internal_d, i);
      q1 += b1.dot(turning);
      q2 += b2.dot(turning);
    }
    r[equation[3]] = q1;
    if (equation[4] >= 0) r[equation[4]] = q2;
  };
  for_each_index(count, count >= kParallelFrom, [&](Index i) {
    if (!joints_.leads(i)) return;
    if (const std::int32_t* equation = plain_equations(i)) return put(i, equation, nullptr);
    const NodeFreedoms& node = freedoms_.nodes[i];
    put(i, node.equation, node.oblique ? &node.frame : nullptr);
  });
  if (has_ties()) add_tied_residual(external, internal_x, internal_d, on_d, moments, r);
}

Vec3 Dofs::support_force(Index n, std::span<const double> internal_x,
                         std::span<const double> external) const {
  const NodeFreedoms& node = freedoms_.nodes[n];
  Vec3 f = at(internal_x, n) - at(external, n);
  if (!led_.empty() && !led_[n].empty()) f += tied_force(n, internal_x, external);
  f = node.frame * f;
  for (int c = 0; c < 3; ++c)
    if (node.equation[c] >= 0 || node.equation[c] == tied) f[c] = 0;
  return node.frame.transpose() * f;
}

void Dofs::spread_rates(std::span<const double> rates, std::span<const double> driven,
                        NodalRates& out) const {
  out.x.assign(3 * X_.size(), 0);
  out.d.assign(3 * X_.size(), 0);
  const auto rate = [&](Index eq) {
    return eq >= 0 ? rates[eq] : eq == held || eq == tied ? 0.0 : driven[motion_of(eq)];
  };
  const auto d = std::as_const(configuration_).d(), first = std::as_const(configuration_).b1();
  std::vector<Link> node;
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n) {
    const NodeFreedoms& free = freedoms_.nodes[n];
    Eigen::Matrix<double, 5, 1> v = Eigen::Matrix<double, 5, 1>::Zero();
    if (freedoms_.ties(n)) {
      links(n, node);
      for (const Link& link : node) v += rate(link.equation) * link.column;
    } else {
      for (int c = 0; c < 5; ++c) v[c] = rate(free.equation[c]);
    }
    at(out.x, n) = free.frame.transpose() * v.head<3>();
    const Vec3 dn = at(d, n), b1 = at(first, n);
    at(out.d, n) =
        free.turn_axis ? Vec3(v[3] * free.turn_axis->cross(dn)) : Vec3(v[3] * b1 + v[4] * dn.cross(b1));
  }
}

std::vector<double> Dofs::collect_rates(const NodalRates& nodal) const {
  std::vector<double> rates(freedoms_.unknowns, 0);
  const std::span<const double> v(nodal.x), w(nodal.d);
  const Configuration& s = configuration_;
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n) {
    const NodeFreedoms& free = freedoms_.nodes[n];
    const Vec3 along = free.frame * at(v, n), b1 = at(s.b1(), n), dn = at(s.d(), n);
    const double value[5] = {along[0], along[1], along[2], b1.dot(at(w, n)), dn.cross(b1).dot(at(w, n))};
    for (int c = 0; c < 5; ++c)
      if (free.equation[c] >= 0) rates[free.equation[c]] = value[c];
  }
  for (const RigidBody& body : freedoms_.bodies) {
    const Vec3 middle = centroid(body, s.x());
    Vec3 mean = Vec3::Zero(), spin = Vec3::Zero();
    Mat3 J = Mat3::Zero();
    for (const Index n : body.nodes) {
      mean += at(v, n) / static_cast<double>(body.nodes.size());
      for (const auto& [arm, rate] : {std::pair<Vec3, Vec3>{at(s.x(), n) - middle, at(v, n)},
                                      std::pair<Vec3, Vec3>{at(s.d(), n), at(w, n)}}) {
        J += arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose();
        spin += arm.cross(rate);
      }
    }
    const Vec3 turn = J.ldlt().solve(spin);
    for (int i = 0; i < 3; ++i) {
      rates[body.equation + i] = mean[i];
      rates[body.equation + 3 + i] = turn[i];
    }
  }
  return rates;
}

namespace {

// Adds the sums of the rows of L^T M L, M = (m, m, m, J, J), each entry by its size: the kinetic energy is
// then at least that of the node. Where the leads' frames are the global one, the columns of the links add up
// to one, and no entry is negative.
void add_lumped(const std::vector<Link>& links, double m, double J, std::vector<double>& mass) {
  const auto entry = [&](const Link& a, const Link& b) {
    return m * a.column.head<3>().dot(b.column.head<3>()) + J * a.column.tail<2>().dot(b.column.tail<2>());
  };
  const bool plain = std::all_of(links.begin(), links.end(), [](const Link& l) {
    return l.column.minCoeff() >= 0 && (l.column.array() != 0).count() == 1;
  });
  for (const Link& a : links) {
    if (a.equation < 0) continue;
    if (plain) {
      mass[a.equation] += m * a.column.head<3>().sum() + J * a.column.tail<2>().sum();
      continue;
    }
    for (const Link& b : links) mass[a.equation] += std::abs(entry(a, b));
  }
}

}  // namespace

namespace {

// Whether every lead keeps a mass, since weights can be negative.
bool has_lumped_mass(const Freedoms& freedoms, std::span<const double> nodal) {
  if (!freedoms.bodies.empty()) return false;
  std::vector<double> mass;
  for (const double m : nodal) mass.insert(mass.end(), 3, m);
  for (const auto& f : freedoms.followers)
    for (const auto& lead : f.leads)
      if (f.component < 3) mass[3 * lead.node + f.component] += lead.weight * nodal[f.node];
  return std::all_of(mass.begin(), mass.end(), [](double m) { return m >= 0; });
}

}  // namespace

std::vector<double> Dofs::lump(std::span<const double> nodal, std::span<const double> rotary) const {
  std::vector<double> mass(freedoms_.unknowns, 0);
  std::vector<Link> node;
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n) {
    if (!freedoms_.ties(n)) {
      const auto& eq = freedoms_.nodes[n].equation;
      for (int c = 0; c < 5; ++c)
        if (eq[c] >= 0) mass[eq[c]] += c < 3 ? nodal[n] : rotary[n];
      continue;
    }
    links(n, node);
    add_lumped(node, nodal[n], rotary[n], mass);
  }
  if (!has_lumped_mass(freedoms_, nodal) ||
      std::any_of(mass.begin(), mass.end(), [](double m) { return !(m > 0); }))
    throw Error(
        "dynamic: field 'scheme': ties of the kinds \"rigid\" and \"periodic\" have no lumped mass; "
        "expected "
        "scheme=\"implicit\"");
  return mass;
}

double Dofs::lead_of(Index motion, std::span<const double> lead) const {
  const DrivenFreedom& m = freedoms_.motions[motion];
  if (m.component < 3) return lead[motion];
  const Vec3 d = at(std::as_const(configuration_).d(), m.node),
             b1 = at(std::as_const(configuration_).b1(), m.node);
  const Vec3 rate = freedoms_.nodes[m.node].turn_axis->cross(d);
  return lead[motion] * rate.dot(m.component == 3 ? b1 : Vec3(d.cross(b1)));
}

std::pair<double, Index> Dofs::largest_residual(std::span<const double> r) const {
  std::pair<double, Index> best{0, -1};
  for (std::size_t i = 0; i < r.size(); ++i) {
    const double size = std::abs(r[i]) / lever(static_cast<Index>(i));
    if (!std::isfinite(size)) return {std::numeric_limits<double>::infinity(), static_cast<Index>(i)};
    if (size > best.first) best = {size, static_cast<Index>(i)};
  }
  return best;
}

double Dofs::largest_force(std::span<const double> on_x, std::span<const double> on_d) const {
  if (joints_.any()) {
    std::vector<double> x(on_x.begin(), on_x.end()), d(on_d.begin(), on_d.end());
    gather(x);
    gather(d);
    return largest_nodal_force(x, d);
  }
  return largest_nodal_force(on_x, on_d);
}

double Dofs::largest_nodal_force(std::span<const double> on_x, std::span<const double> on_d) const {
  double largest = 0, moment = 0;
  for (const double f : on_x) largest = std::max(largest, std::abs(f));
  for (Index i = 0; i < static_cast<Index>(X_.size()); ++i) {
    const Vec3 d = at(std::as_const(configuration_).d(), i), f = at(on_d, i);
    moment = std::max(moment, (f - f.dot(d) * d).cwiseAbs().maxCoeff());
  }
  return std::max(largest, moment / length_);
}

double Dofs::rounding_floor(const linear::Matrix& K) const {
  if (diagonal_version_ != K.pattern->version) {
    for (auto& entries : diagonal_) entries.clear();
    for (Index eq = 0; eq < K.size(); ++eq) diagonal_[turns_[eq]].push_back(K.pattern->slot(eq, eq));
    diagonal_version_ = K.pattern->version;
  }
  double stiffest[2] = {0, 0}, farthest = 0;  // displacements, rotations; largest coordinate
  for (int turning = 0; turning < 2; ++turning)
    for (const Index entry : diagonal_[turning])
      stiffest[turning] = std::max(stiffest[turning], std::abs(K.entry(entry)));
  for (const double x : std::as_const(configuration_).x()) farthest = std::max(farthest, std::abs(x));
  return 16 * std::numeric_limits<double>::epsilon() *
         std::max(farthest * stiffest[0], stiffest[1] / length_);
}

}  // namespace fabricsh::mechanics
