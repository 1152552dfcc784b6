#include "run/newmark.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/ordered_sum.hpp"
#include "geometry/node_view.hpp"

namespace fabricsh::run {

namespace {

struct Pair {
  Vec3 v, a;
};

Pair update(const NewmarkScheme& s, double dt, const Vec3& increment, const Vec3& v, const Vec3& a) {
  const Vec3 now = (increment - dt * v - dt * dt * (0.5 - s.beta) * a) / (s.beta * dt * dt);
  return {v + dt * ((1 - s.gamma) * a + s.gamma * now), now};
}

}  // namespace

Vec3 carry(const Vec3& u, const Vec3& d, const Vec3& e) { return u - u.dot(e) / (1 + d.dot(e)) * (d + e); }

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
#pragma omp parallel for schedule(static) if (nodes >= 2048)
  for (std::size_t n = 0; n < nodes; ++n) {
    const Pair node =
        run::update(scheme_, dt(), at(x, n) - at(old, n), at(before_.v.x, n), at(before_.a.x, n));
    at(trial_.v.x, n) = node.v;
    at(trial_.a.x, n) = node.a;
    const Vec3 d0 = at(old_d, n), d1 = at(d, n);
    const Pair turn = run::update(scheme_, dt(), carry(arc(d0, d1), d0, d1),
                                  carry(at(before_.v.d, n), d0, d1), carry(at(before_.a.d, n), d0, d1));
    at(trial_.v.d, n) = turn.v;
    at(trial_.a.d, n) = turn.a;
  }
}

void Newmark::commit(double time, std::span<const double> targets) {
  before_ = trial_;
  const double h = 1e-3 * dt();
  const auto earlier = assembly_.targets(time - h);
  const auto& motions = assembly_.freedoms().motions;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const auto& m = motions[i];
    if (m.component > 2) continue;
    const Vec3 along = assembly_.freedoms().nodes[m.node].frame.row(m.component).transpose();
    auto v = at(before_.v.x, m.node), a = at(before_.a.x, m.node);
    v += ((targets[i] - earlier[i]) / h - v.dot(along)) * along;
    a -= a.dot(along) * along;
  }
}

double Newmark::largest_inertia() const {
  const auto& mass = inertia_.mass();
  double largest = 0;
  for (std::size_t i = 0; i < mass.size(); ++i)
    for (int c = 0; c < 3; ++c) largest = std::max(largest, mass[i] * std::abs(trial_.a.x[3 * i + c]));
  return largest;
}

std::span<const double> Newmark::rates() const { return rates_ = assembly_.collect_rates(trial_.v); }

double Newmark::work(std::span<const double> before, std::span<const double> after) const {
  const auto from = assembly_.collect_rates(before_.v), to = assembly_.collect_rates(trial_.v);
  double sum = 0;
  for (std::size_t i = 0; i < to.size(); ++i)
    sum += (before[i] + after[i]) / 2 * (from[i] + to[i]) / 2 * dt();
  return sum;
}

// The component of a vector along a driven displacement.
double Newmark::along(const mechanics::DrivenFreedom& m, std::span<const double> v) const {
  return assembly_.freedoms().nodes[m.node].frame.row(m.component).dot(at(v, m.node));
}

// The force that moves the driven displacements also does work against their inertia and damping, which is
// accounted separately (see Dynamic::driven_work).
double Newmark::work_on_mass(double factor, const mechanics::NodalRates& before,
                             const mechanics::NodalRates& after) const {
  const auto& state = std::as_const(assembly_).state();
  const std::size_t n = 3 * state.nodes();
  const auto old = state.committed_kinematics();
  const auto &mass = inertia_.mass(), &rotary = inertia_.rotary();
  double work = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double moved = state.x()[i] - old[i];
    work += factor * mass[i / 3] * (before.x[i] + after.x[i]) / 2 * moved;
  }
  const auto old_d = old.subspan(n);
  for (std::size_t k = 0; k < state.nodes(); ++k) {
    const Vec3 from = at(old_d, k), to = at(state.d(), k), turned = carry(arc(from, to), from, to);
    work += factor * rotary[k] * (carry(at(before.d, k), from, to) + at(after.d, k)).dot(turned) / 2;
  }
  for (const auto& m : assembly_.freedoms().motions) {
    if (m.component > 2) continue;
    const double moved = along(m, state.x()) - along(m, old);
    work -= factor * mass[m.node] * (along(m, before.x) + along(m, after.x)) / 2 * moved;
  }
  return work;
}

double Newmark::kinetic() const {
  const auto& v = velocities();
  const auto &mass = inertia_.mass(), &rotary = inertia_.rotary();
  double driven = 0;
  for (const auto& m : assembly_.freedoms().motions)
    if (m.component < 3) driven -= mass[m.node] * along(m, v.x) * along(m, v.x) / 2;
  return driven + ordered_sum(v.x.size(), [&](std::size_t i) {
           return (mass[i / 3] * v.x[i] * v.x[i] + rotary[i / 3] * v.d[i] * v.d[i]) / 2;
         });
}

}  // namespace fabricsh::run
