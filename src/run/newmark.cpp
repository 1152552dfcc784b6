#include "run/newmark.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/ordered_sum.hpp"
#include "base/shares.hpp"
#include "geometry/node_view.hpp"

namespace fabricsh::run {

namespace {

struct NodeRates {
  Vec3 v, a;
};

NodeRates update(const NewmarkScheme& s, double dt, const Vec3& increment, const Vec3& v, const Vec3& a) {
  const Vec3 now = (increment - dt * v - dt * dt * s.delta * a) / (s.beta * dt * dt);
  return {v + dt * ((1 - s.gamma) * a + s.gamma * now), now};
}

}  // namespace

Vec3 parallel_transport(const Vec3& u, const Vec3& d, const Vec3& e) {
  return u - u.dot(e) / (1 + d.dot(e)) * (d + e);
}

Vec3 arc(const Vec3& d, const Vec3& e) {
  const double along = d.dot(e);
  const Vec3 across = e - along * d;
  const double sine = across.norm();
  return sine > 0 ? Vec3(std::atan2(sine, along) / sine * across) : Vec3(Vec3::Zero());
}

Newmark::Newmark(mechanics::Assembly& assembly, const mechanics::Inertia& inertia,
                 const NewmarkScheme& scheme)
    : assembly_(assembly), inertia_(inertia), scheme_(scheme) {
  const std::vector<double> still(3 * inertia.mass().size(), 0);
  before_ = {{still, still}, {still, still}};
}

void Newmark::start(const mechanics::NodalRates& velocities) {
  const std::vector<double> still(3 * inertia_.mass().size(), 0);
  before_ = {velocities, {still, still}};
  trial_ = before_;
}

void Newmark::update() {
  const auto& state = std::as_const(assembly_).state();
  const std::size_t nodes = state.nodes();
  const auto x = state.x(), d = state.d();
  const auto old = state.committed_kinematics();
  const auto old_d = old.subspan(3 * nodes);
  for (auto* rates : {&trial_.v, &trial_.a}) {
    rates->x.resize(3 * nodes);
    rates->d.resize(3 * nodes);
  }
  const mechanics::Freedoms& freedoms = assembly_.dofs().freedoms();
  for_each_index(nodes, nodes >= 256, [&](std::size_t n) {
    if (freedoms.body(static_cast<mechanics::Index>(n)) >= 0) return update_rigid(n, x, old);
    const NodeRates node =
        run::update(scheme_, dt(), at(x, n) - at(old, n), at(before_.v.x, n), at(before_.a.x, n));
    at(trial_.v.x, n) = node.v;
    at(trial_.a.x, n) = node.a;
    const Vec3 d0 = at(old_d, n), d1 = at(d, n);
    const NodeRates turn = run::update(scheme_, dt(), parallel_transport(arc(d0, d1), d0, d1),
                                       parallel_transport(at(before_.v.d, n), d0, d1),
                                       parallel_transport(at(before_.a.d, n), d0, d1));
    at(trial_.v.d, n) = turn.v;
    at(trial_.a.d, n) = turn.a;
  });
}

// The midpoint's rule, x+ - x = dt (v + v+) / 2, or the scheme's weights in its place, for nodes and
// directors alike, which then are points of the body.
void Newmark::update_rigid(std::size_t node, std::span<const double> now, std::span<const double> old) {
  const auto d = std::as_const(assembly_).state().d();
  const auto one = [&](const Vec3& moved, const std::vector<double>& v0, std::vector<double>& v,
                       std::vector<double>& a) {
    at(v, node) = 1 / scheme_.late / dt() * moved - (1 / scheme_.late - 1) * at(v0, node);
    at(a, node) = (at(v, node) - at(v0, node)) / dt();
  };
  one(at(now, node) - at(old, node), before_.v.x, trial_.v.x, trial_.a.x);
  one(at(d, node) - at(old.subspan(now.size()), node), before_.v.d, trial_.v.d, trial_.a.d);
}

// The arms are those of the middle of the step: with the midpoint's rule for the velocities, the change of
// the body's momentum and angular momentum is the impulse of the forces, and that of its energy their work
// [gonzalez1996; betsch2001].
std::array<double, 6> Newmark::rate_of_momentum(const mechanics::RigidBody& body) const {
  const auto& state = std::as_const(assembly_).state();
  const auto x = state.x(), d = state.d(), old = state.committed_kinematics();
  const auto old_d = old.subspan(x.size());
  const Vec3 middle = (assembly_.dofs().centroid(body, x) + assembly_.dofs().centroid(body, old)) / 2;
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
  for (const auto n : body.nodes) {
    const Vec3 force = inertia_.mass()[n] * at(trial_.a.x, n),
               turning = inertia_.rotary()[n] * at(trial_.a.d, n);
    linear += force;
    angular += ((at(x, n) + at(old, n)) / 2 - middle).cross(force);
    angular += Vec3((at(d, n) + at(old_d, n)) / 2).cross(turning);
  }
  return {linear[0], linear[1], linear[2], angular[0], angular[1], angular[2]};
}

void Newmark::commit() {
  before_ = trial_;
  const auto& motions = assembly_.dofs().freedoms().motions;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const auto& m = motions[i];
    if (m.component > 2) continue;
    const Vec3 along = assembly_.dofs().freedoms().nodes[m.node].frame.row(m.component).transpose();
    auto v = at(before_.v.x, m.node), a = at(before_.a.x, m.node);
    v += (driven_[i] - v.dot(along)) * along;
    a -= a.dot(along) * along;
  }
}

void Newmark::take_off(const mechanics::NodalRates& a, double impulse) {
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    before_.a.x[i] -= a.x[i];
    before_.a.d[i] -= a.d[i];
  }
  if (impulse == 0) return;
  for (std::size_t i = 0; i < a.x.size(); ++i) before_.v.x[i] += impulse * a.x[i];
}

double Newmark::largest_inertia() const {
  const auto& mass = inertia_.mass();
  double largest = 0;
  for (std::size_t i = 0; i < mass.size(); ++i)
    for (int c = 0; c < 3; ++c) largest = std::max(largest, mass[i] * std::abs(trial_.a.x[3 * i + c]));
  return largest;
}

std::span<const double> Newmark::rates() const { return rates_ = assembly_.dofs().collect_rates(trial_.v); }

// The rates with which the unknowns went in the step, which those at its ends do not always have for a mean.
std::vector<double> Newmark::mean_rates() const {
  const auto& state = std::as_const(assembly_).state();
  const std::size_t nodes = state.nodes();
  const auto x = state.x(), d = state.d(), old = state.committed_kinematics(), old_d = old.subspan(3 * nodes);
  mechanics::NodalRates mean{std::vector<double>(3 * nodes), std::vector<double>(3 * nodes)};
  for (std::size_t n = 0; n < nodes; ++n) {
    if (assembly_.dofs().freedoms().body(static_cast<mechanics::Index>(n)) >= 0) {
      at(mean.x, n) = (1 - scheme_.late) * at(before_.v.x, n) + scheme_.late * at(trial_.v.x, n);
      at(mean.d, n) = (1 - scheme_.late) * at(before_.v.d, n) + scheme_.late * at(trial_.v.d, n);
      continue;
    }
    const Vec3 d0 = at(old_d, n), d1 = at(d, n);
    at(mean.x, n) = (at(x, n) - at(old, n)) / dt();
    at(mean.d, n) = parallel_transport(arc(d0, d1), d0, d1) / dt();
  }
  return assembly_.dofs().collect_rates(mean);
}

double Newmark::work(std::span<const double> before, std::span<const double> after) const {
  const double late = weight_of_end(), early = 1 - late;
  double sum = 0;
  if (scheme_.gamma != 0.5 || !scheme_.is_trapezoidal()) {
    const auto mean = mean_rates();
    for (std::size_t i = 0; i < mean.size(); ++i)
      sum += (early * before[i] + late * after[i]) * mean[i] * dt();
    return sum;
  }
  const auto from = assembly_.dofs().collect_rates(before_.v), to = assembly_.dofs().collect_rates(trial_.v);
  for (std::size_t i = 0; i < to.size(); ++i)
    sum += (before[i] + after[i]) / 2 * (from[i] + to[i]) / 2 * dt();
  return sum;
}

// The component of a vector along a driven displacement.
double Newmark::along(const mechanics::DrivenFreedom& m, std::span<const double> v) const {
  return assembly_.dofs().freedoms().nodes[m.node].frame.row(m.component).dot(at(v, m.node));
}

// The force that moves the driven displacements also does work against their inertia and damping, which is
// accounted separately (see Dynamic::driven_work).
double Newmark::work_on_mass(double factor, const mechanics::NodalRates& before,
                             const mechanics::NodalRates& after) const {
  const auto& state = std::as_const(assembly_).state();
  const std::size_t n = 3 * state.nodes();
  const auto old = state.committed_kinematics();
  const auto &mass = inertia_.mass(), &rotary = inertia_.rotary();
  const double late = weight_of_end(), early = 1 - late;
  double work = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double moved = state.x()[i] - old[i];
    work += factor * mass[i / 3] * (early * before.x[i] + late * after.x[i]) * moved;
  }
  const auto old_d = old.subspan(n);
  for (std::size_t k = 0; k < state.nodes(); ++k) {
    const Vec3 from = at(old_d, k), to = at(state.d(), k),
               turned = parallel_transport(arc(from, to), from, to);
    work += factor * rotary[k] *
            (early * parallel_transport(at(before.d, k), from, to) + late * at(after.d, k)).dot(turned);
  }
  for (const auto& m : assembly_.dofs().freedoms().motions) {
    if (m.component > 2) continue;
    const double moved = along(m, state.x()) - along(m, old);
    work -= factor * mass[m.node] * (early * along(m, before.x) + late * along(m, after.x)) * moved;
  }
  return work;
}

double Newmark::kinetic() const {
  const auto& v = velocities();
  const auto &mass = inertia_.mass(), &rotary = inertia_.rotary();
  double driven = 0;
  for (const auto& m : assembly_.dofs().freedoms().motions)
    if (m.component < 3) driven -= mass[m.node] * along(m, v.x) * along(m, v.x) / 2;
  return driven + ordered_sum(v.x.size(), [&](std::size_t i) {
           return (mass[i / 3] * v.x[i] * v.x[i] + rotary[i / 3] * v.d[i] * v.d[i]) / 2;
         });
}

}  // namespace fabricsh::run
