#include "analysis/newmark.hpp"

#include <cmath>

#include "tensor/node_view.hpp"

namespace fabricsh::analysis {

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

void newmark_update(const NewmarkScheme& scheme, double dt, const mechanics::Configuration& state,
                    const NodalMotion& before, NodalMotion& after) {
  const std::size_t nodes = state.nodes();
  const auto x = state.x(), d = state.d();
  const auto old = state.committed_kinematics();
  const auto old_d = old.subspan(3 * nodes);
  after.v.x.resize(3 * nodes);
  after.v.d.resize(3 * nodes);
  after.a.x.resize(3 * nodes);
  after.a.d.resize(3 * nodes);
#pragma omp parallel for schedule(static) if (nodes >= 2048)
  for (std::size_t n = 0; n < nodes; ++n) {
    const Pair node = update(scheme, dt, at(x, n) - at(old, n), at(before.v.x, n), at(before.a.x, n));
    at(after.v.x, n) = node.v;
    at(after.a.x, n) = node.a;
    const Vec3 d0 = at(old_d, n), d1 = at(d, n);
    const Pair turn = update(scheme, dt, carry(arc(d0, d1), d0, d1), carry(at(before.v.d, n), d0, d1),
                             carry(at(before.a.d, n), d0, d1));
    at(after.v.d, n) = turn.v;
    at(after.a.d, n) = turn.a;
  }
}

}  // namespace fabricsh::analysis
