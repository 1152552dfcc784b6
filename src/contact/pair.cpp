#include "contact/pair.hpp"

#include <cmath>

#include "contact/places.hpp"

namespace fabricsh::contact {
namespace {

// One place of contact, the law's answer there, and the derivatives of its weight.
struct Pressed {
  const Place& place;
  Answer answer;
  double count;  // m2: area times how often it counts
};

// Calls visit(pressed, modulation) for every place within the law's range; returns the smallest gap.
template <class Visit>
double visit_pressed(const Law& law, const Pair& pair, const Corners& x, bool second, Visit visit) {
  Modulation m;
  bool known = false;
  return visit_places(pair, x, law.gap() * pair.scale, [&](const Place& place) {
    double count = place.plain;
    if (place.modulated != 0) {
      if (!known) m = modulation(x, pair.fading, second);
      known = true;
      count += place.modulated * m.value;
      if (count == 0 && m.constant) return;
    }
    visit(Pressed{place, law.scaled(place.touch.distance - pair.offset, pair.scale), pair.area * count}, m);
  });
}

void add_friction(const Pressed& at, const Sliding& sliding, Force& force) {
  const Touch& touch = at.place.touch;
  Vec3 v = Vec3::Zero();
  double lightness = 0;  // 1/kg
  for (std::size_t i = 0; i < 4; ++i) {
    v += touch.weight[i] * sliding.velocity[i];
    lightness += touch.weight[i] * touch.weight[i] * sliding.inverse_mass[i];
  }
  const Vec3 lever = touch.distance * touch.normal;
  v -= sliding.spin.cross(lever);
  v -= touch.normal.dot(v) * touch.normal;
  const double speed = v.norm();
  if (!(speed > 0) || !(lightness > 0)) return;
  const double most = sliding.friction * std::fabs(at.count) * at.answer.pressure;
  const double f = std::copysign(std::min(most, 0.2 * speed / (lightness * sliding.step)), at.count);
  for (std::size_t i = 0; i < 4; ++i) force.on[i] -= f / speed * touch.weight[i] * v;
  force.torque += f / speed * lever.cross(v);
  force.lost += f * speed;
}

}  // namespace

Force pair_force(const Law& law, const Pair& pair, const Corners& x, const Sliding* sliding) {
  Force force;
  const double nearest = visit_pressed(law, pair, x, false, [&](const Pressed& at, const Modulation& m) {
    force.active = true;
    force.contact += at.count * at.answer.contact;
    force.guard += at.count * at.answer.guard;
    const double push = at.count * at.answer.pressure;
    for (std::size_t i = 0; i < 4; ++i)
      if (at.place.touch.weight[i] != 0)
        force.on[i] += push * at.place.touch.weight[i] * at.place.touch.normal;
    if (at.place.modulated != 0 && !m.constant) {
      const double energy = pair.area * at.place.modulated * (at.answer.contact + at.answer.guard);
      for (std::size_t i = 0; i < 4; ++i) force.on[i] -= energy * m.gradient.segment<3>(3 * int(i));
    }
    if (sliding != nullptr) add_friction(at, *sliding, force);
  });
  force.gap = nearest - law.floor() * pair.scale;
  return force;
}

Derivatives pair_derivatives(const Law& law, const Pair& pair, const Corners& x) {
  Derivatives out;
  visit_pressed(law, pair, x, true, [&](const Pressed& at, const Modulation& m) {
    const Touch& touch = at.place.touch;
    const Vector12 slope = distance_gradient(touch);
    out.contact += at.count * at.answer.contact;
    out.guard += at.count * at.answer.guard;
    out.gradient -= at.count * at.answer.pressure * slope;
    out.hessian += at.count * (at.answer.stiffness * slope * slope.transpose() -
                               at.answer.pressure * distance_hessian(x, touch));
    if (at.place.modulated == 0 || m.constant) return;
    const double share = pair.area * at.place.modulated,
                 energy = share * (at.answer.contact + at.answer.guard);
    const Matrix12 mixed = m.gradient * slope.transpose();
    out.gradient += energy * m.gradient;
    out.hessian += energy * m.hessian - share * at.answer.pressure * (mixed + mixed.transpose());
  });
  return out;
}

Matrix12 positive_part(const Matrix12& hessian) {
  const Eigen::SelfAdjointEigenSolver<Matrix12> eigen(hessian);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

namespace {

// f(y)/slip for y = slip/creep (1/m), and the derivative of that by the slip, divided by the slip (1/m3).
struct Hold {
  double value, slope;
};
Hold hold(double slip, double creep) {
  if (slip >= creep) return {1 / slip, -1 / (slip * slip * slip)};
  return {(2 - slip / creep) / creep, slip > 0 ? -1 / (creep * creep * slip) : 0};
}

Mat3 cross_matrix(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

// Derivatives by one corner of all quantities in the friction at a place.
struct Place3 {
  Mat3 sliding;               // of the sliding perpendicular to the normal
  Mat3 lever;                 // of the vector between the closest points
  std::array<Vec3, 2> slide;  // of the parameters of the closest points
};

Place3 sliding_by_corner(const Touch& touch, const Corners& x, const Corners& moved, const Vec3& u,
                         const Vec3& turn, const Slides& slide, std::size_t j) {
  const Mat3 one = Mat3::Identity();
  Mat3 r = touch.weight[j] * one, du = touch.weight[j] * one;
  Place3 out;
  for (std::size_t k = 0; k < std::size_t(touch.freedoms()); ++k) {
    const auto plus = std::size_t(touch.plus[k]), minus = std::size_t(touch.minus[k]);
    out.slide[k] = slide[k][j];
    r += (x[plus] - x[minus]) * slide[k][j].transpose();
    du += (moved[plus] - moved[minus]) * slide[k][j].transpose();
  }
  du -= cross_matrix(turn) * r;
  const Vec3& n = touch.normal;
  const Mat3 across = one - n * n.transpose();
  const Mat3 dn = across * r / touch.distance;
  out.lever = r;
  out.sliding = across * du - n.dot(u) * dn - n * (u.transpose() * dn);
  return out;
}

}  // namespace

Friction pair_friction(const Law& law, const Pair& pair, const Corners& x, const Slip& slip,
                       bool with_jacobian) {
  Friction out;
  Corners moved;
  for (std::size_t i = 0; i < 4; ++i) moved[i] = x[i] - slip.start[i];
  visit_pressed(law, pair, x, false, [&](const Pressed& at, const Modulation& m) {
    const Touch& touch = at.place.touch;
    Vec3 u = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) u += touch.weight[i] * moved[i];
    const Vec3 lever = touch.distance * touch.normal;
    u -= slip.turn.cross(lever);
    const Vec3 slid = u - touch.normal.dot(u) * touch.normal;
    const double length = slid.norm(), normal_force = at.count * at.answer.pressure;
    const Hold h = hold(length, slip.creep);
    const Vec3 pull = slip.friction * normal_force * h.value * slid;  // N, at the place
    for (int i = 0; i < 4; ++i) out.force.segment<3>(3 * i) -= touch.weight[std::size_t(i)] * pull;
    out.torque += lever.cross(pull);
    out.lost += pull.dot(slid);
    if (!with_jacobian) return;

    // Derivative of the normal force by all corners, including that of the modulation.
    Vector12 press = -at.count * at.answer.stiffness * distance_gradient(touch);
    if (at.place.modulated != 0 && !m.constant)
      press += pair.area * at.place.modulated * at.answer.pressure * m.gradient;
    const Mat3 turn =
        slip.friction * normal_force * (h.value * Mat3::Identity() + h.slope * slid * slid.transpose());
    // The lever is along the normal, so lever x turn has no part along it.
    const Mat3 levers = cross_matrix(lever), pull_by_turn = turn * levers;
    for (int i = 0; i < 4; ++i)
      out.by_turn.block<3, 3>(3 * i, 0) -= touch.weight[std::size_t(i)] * pull_by_turn;
    out.torque_by_turn += levers * pull_by_turn;
    const Slides slide = slides(x, touch);
    for (std::size_t j = 0; j < 4; ++j) {
      const Place3 by = sliding_by_corner(touch, x, moved, u, slip.turn, slide, j);
      const Mat3 dpull =
          turn * by.sliding + slip.friction * h.value * slid * press.segment<3>(3 * int(j)).transpose();
      out.torque_by_x.block<3, 3>(0, 3 * int(j)) += levers * dpull - cross_matrix(pull) * by.lever;
      for (std::size_t i = 0; i < 4; ++i) {
        Mat3 block = touch.weight[i] * dpull;
        for (std::size_t k = 0; k < std::size_t(touch.freedoms()); ++k) {
          if (i == std::size_t(touch.plus[k])) block += pull * by.slide[k].transpose();
          if (i == std::size_t(touch.minus[k])) block -= pull * by.slide[k].transpose();
        }
        out.jacobian.block<3, 3>(3 * int(i), 3 * int(j)) -= block;
      }
    }
  });
  return out;
}

}  // namespace fabricsh::contact
