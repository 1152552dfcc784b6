#include "contact/pair.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <type_traits>
#include <utility>

#include "contact/places.hpp"
#include "contact/plane.hpp"
#include "geometry/turning.hpp"

namespace fabricsh::contact {
namespace {

// Room for what few of the near pairs need. That of an empty std::optional is cleared each time.
template <class T>
class Late {
 public:
  Late() {}
  ~Late() { static_assert(std::is_trivially_destructible_v<T>); }
  template <class... Values>
  T& emplace(Values&&... values) {
    any_ = true;
    return *::new (static_cast<void*>(&value_)) T(std::forward<Values>(values)...);
  }
  explicit operator bool() const { return any_; }
  T& operator*() { return value_; }
  T* operator->() { return &value_; }

 private:
  union {
    T value_;
  };
  bool any_ = false;
};

// One place of contact, the law's answer there, and the derivatives of its weight.
struct PressedPlace {
  const Place& place;
  ContactResponse answer;
  double count;  // m2: area times how often it counts
};

// Calls visit(pressed, modulation) for every place within the law's range; returns the smallest gap. The
// modulation is null for kinds that have none; its second derivatives go to `hessian`, if they are wanted.
template <class Visit>
double visit_pressed(const ContactLaw& law, const Pair& pair, const Corners& x, Matrix12* hessian,
                     Visit visit) {
  Late<Modulation> m;
  return visit_places(pair, x, law.gap() * pair.scale, [&](const Place& place) {
    double count = place.plain;
    if (place.modulated != 0) {
      if (!m) m.emplace(modulation(x, pair.fading, hessian));
      count += place.modulated * m->value;
      if (count == 0 && m->constant) return;
    }
    visit(PressedPlace{place, law.scaled(place.touch.distance - pair.offset, pair.scale), pair.area * count},
          m ? &*m : nullptr);
  });
}

// Whether the weight of a place changes with the corners.
bool changes(const PressedPlace& at, const Modulation* m) { return at.place.modulated != 0 && !m->constant; }

// The sliding of a step at a place, perpendicular to the normal, and the elastic slip to which it leads, as
// far as friction carries it.
struct Slid {
  Vec3 moved;         // m, of the first side against the second, with its part along the normal
  Vec3 lever;         // m, from the rigid side's corners to its surface
  Vec3 slid;          // m
  Vec3 trial;         // m, elastic slip of a spring that never gives way
  double length = 0;  // m, of that slip
  double damping = 0, damping_slope = 0;  // Pa, by which an approach is resisted; Pa/m, by the opening
  double spring = 0, most = 0;            // N/m; N, mu times the normal force
  double mu = 0;                    // in the direction of the trial slip; static, unless it slides already
  Vec3 mu_by_trial = Vec3::Zero();  // 1/m, its derivative
  // N/m, of the film for the step's sliding; its derivative by the gap, N/m2; and by the sliding, over its
  // length, N/m3.
  double drag = 0, drag_slope = 0, thins = 0;
  Mat3 drag_by_slid() const { return drag * Mat3::Identity() + thins * slid * slid.transpose(); }
  double before = 0;  // of Slip::slides, if it goes on in the same direction
  bool goes_on() const { return before >= 1; }
  bool sticks() const { return spring * length <= most; }
  // Share of the trial slip that friction holds.
  double kept() const { return sticks() ? 1 : most / (spring * length); }
  double slides() const {
    if (sticks()) return before;
    return most > 0 ? std::min(1.0, before + (spring * length - most) / most) : 1;
  }
};

// Whether a side of a pair is neither held nor driven.
bool gives_way(const Touch& touch, const Slip& slip) {
  for (std::size_t i = 0; i < 4; ++i)
    if (touch.weight[i] != 0 && slip.inverse_mass[i] > 0) return true;
  return false;
}

// An implicit step has the stiffness at its beginning, so that the pressure is linear in the approach. A
// pair that an explicit step presses into a guard that inertia meets would swing there: the guard's
// stiffness acts on a quarter of the step's approach, too.
void damp(const ContactLaw& law, const Pair& pair, const PressedPlace& at, const Slip& slip, Slid& out) {
  const double opened = at.place.touch.normal.dot(out.moved);
  if (slip.dt == 0 || opened >= 0) return;
  constexpr double of_approach = 0.25;
  const double gap = at.place.touch.distance - pair.offset - (slip.step == 0 ? opened : 0);
  const double whole = slip.step == 0 ? law.scaled(gap, pair.scale).stiffness : at.answer.stiffness,
               stiffness = std::min(whole, law.stiffest());
  out.damping_slope = -slip.loss * std::sqrt(stiffness) / slip.dt;
  if (slip.eased && at.answer.guard > 0 && gives_way(at.place.touch, slip))
    out.damping_slope -= of_approach * std::max(0.0, whole - law.stiffest());
  out.damping = out.damping_slope * opened;
}

// mu of an ellipse whose half axes are along and across the warp.
void direct(const Touch& touch, const Slip& slip, Slid& out) {
  out.mu = slip.friction;
  if (slip.across < 0) return;
  const Vec3 along = slip.along - touch.normal.dot(slip.along) * touch.normal;
  const double yarn = along.norm();
  if (!(yarn > 0) || !(out.length > 0)) return;
  const Vec3 unit = along / yarn, towards = out.trial / out.length;
  const double c = unit.dot(towards), a = 1 / (slip.friction * slip.friction),
               b = 1 / (slip.across * slip.across);
  out.mu = 1 / std::sqrt(c * c * a + (1 - c * c) * b);
  out.mu_by_trial = -out.mu * out.mu * out.mu * c * (a - b) / out.length * (unit - c * towards);
}

// A film wets the surfaces over the first thousandth of the way from gap to floor, without a kink.
void wet(const ContactLaw& law, const Pair& pair, const PressedPlace& at, const Slip& slip, Slid& out) {
  const Film& film = slip.film;
  if (film.viscous == 0 || slip.dt == 0) return;
  constexpr double of_range = 1e-3;
  const double way = of_range * (law.gap() - law.floor()) * pair.scale,
               depth = (law.gap() * pair.scale - at.place.touch.distance + pair.offset) / way,
               d = std::min(depth, 1.0);
  double whole = film.viscous * at.count / slip.dt;
  if (film.speed > 0) {
    const double slow = film.speed * slip.dt, ratio = 1 + out.slid.squaredNorm() / (slow * slow);
    whole *= std::pow(ratio, (film.exponent - 1) / 2);
    out.thins = whole * d * d * (3 - 2 * d) * (film.exponent - 1) / (ratio * slow * slow);
  }
  out.drag = whole * d * d * (3 - 2 * d);
  out.drag_slope = -whole * 6 * d * (1 - d) / way;
}

[[gnu::always_inline]] inline Slid slide(const ContactLaw& law, const Pair& pair, const PressedPlace& at,
                                         const Slip& slip) {
  const Touch& touch = at.place.touch;
  Slid out;
  out.lever = pair.offset * touch.normal;
  out.moved = Vec3::Zero();
  if (pair.offset != 0) out.moved = -slip.turn.cross(out.lever);
  for (std::size_t i = 0; i < 4; ++i) out.moved += touch.weight[i] * slip.moved[i];
  out.slid = out.moved - touch.normal.dot(out.moved) * touch.normal;
  out.trial = out.slid + slip.held - touch.normal.dot(slip.held) * touch.normal;
  out.length = out.trial.norm();
  damp(law, pair, at, slip, out);
  direct(touch, slip, out);
  wet(law, pair, at, slip, out);
  out.spring = slip.stiffness * std::fabs(at.count);
  out.before = out.slid.dot(slip.held) > 0 ? slip.slides : 0;
  // What breaks away is held by static friction until it has slid by its elastic slip. If it fell at once,
  // that of pairs under uneven pressure would fall one by one, and the whole would never hold; and if an
  // iteration could lower the bound, those of a static step would go past an elastic slip of a micrometre.
  if (!out.goes_on() && slip.across < 0) out.mu = std::max(out.mu, slip.sticking);
  out.most = out.mu * (std::fabs(at.count) * (at.answer.pressure + out.damping));  // as batches have it
  return out;
}

// N/m: what resists the sliding of an explicit step at a place that counts `times`; adds to `resists` what of
// it acts on the corners, see Force.
double resistance(const Touch& touch, const Slip& slip, double times, std::array<double, 4>& resists) {
  if (slip.step == 0) return 0;
  double lightness = 0, alone = 0;  // 1/kg: with all that resists at the corners, and without
  for (std::size_t i = 0; i < 4; ++i) {
    const double share = touch.weight[i] * touch.weight[i] * slip.inverse_mass[i];
    lightness += share;
    alone += slip.crowd[i] == 1 ? share : share / slip.crowd[i];
  }
  if (!(lightness > 0)) return 0;
  for (std::size_t i = 0; i < 4; ++i)
    resists[i] += times * std::abs(touch.weight[i]) * slip.inverse_mass[i] / (slip.crowd[i] * alone);
  return 0.2 * std::abs(times) / (lightness * slip.step * slip.step);
}

// The slip of a pair is that of its nearest place, which comes first; that of an edge on a rod the mean.
class Friction {
 public:
  Friction(const ContactLaw& law, const Pair& pair, const Slip& slip, Force& force)
      : law_(law), pair_(pair), slip_(slip), force_(force) {}
  void add(const PressedPlace& at) {
    const Slid s = slide(law_, pair_, at, slip_);
    damp(at, s);
    if (slip_.rubs() || slip_.film.viscous > 0) rub(at, s);
    first_ = false;
  }

 private:
  void rub(const PressedPlace& at, const Slid& s) {
    const Touch& touch = at.place.touch;
    const double times = slip_.portion * at.count / pair_.area;
    Vec3 pull = Vec3::Zero();
    if (slip_.rubs()) pull = s.spring * s.trial + resistance(touch, slip_, times, force_.resists) * s.slid;
    const double size = pull.norm(), kept = s.kept();
    if (size > s.most) pull *= s.most / size;
    if (at.count < 0) pull = -pull;
    if (s.drag != 0) pull += s.drag * s.slid;
    for (std::size_t i = 0; i < 4; ++i) force_.on[i] -= touch.weight[i] * pull;
    if (pair_.offset != 0) force_.torque += s.lever.cross(pull);
    force_.pull += pull;
    force_.stick += std::copysign(s.spring, at.count) * kept * kept * s.trial.squaredNorm() / 2;
    const double before = slip_.step == 0 ? 0 : 0.5;
    force_.work += (1 - before) * pull.dot(s.slid);
    if (first_) force_.work += before * slip_.pull.dot(s.slid);
    if (!slip_.rubs()) return;
    const double weight = pair_.kind == PairKind::wrap ? s.most : first_ ? 1 : 0;
    share_ += weight;
    if (weight > 0) force_.slides = std::max(force_.slides, s.slides());
    if (weight > 0) force_.slip += weight / share_ * (kept * s.trial - force_.slip);
  }

  void damp(const PressedPlace& at, const Slid& s) {
    const double press = at.count * s.damping;
    const Touch& touch = at.place.touch;
    const double closed = -touch.normal.dot(s.moved), before = slip_.step == 0 ? 0 : 0.5;
    if (first_) force_.impact += before * slip_.damped * closed;
    if (press == 0) return;  // it opens
    for (std::size_t i = 0; i < 4; ++i) force_.on[i] += press * touch.weight[i] * touch.normal;
    force_.damped += press;
    force_.impact += (1 - before) * press * closed;
  }

  const ContactLaw& law_;
  const Pair& pair_;
  const Slip& slip_;
  Force& force_;
  bool first_ = true;
  double share_ = 0;
};

// The normal is that of the nearest place, which comes first.
void add_barrier(const ContactLaw& law, const PressedPlace& at, Force::Barrier& barrier) {
  if (barrier.stiffness == 0) {
    barrier.normal = at.place.touch.normal;
    barrier.weight = at.place.touch.weight;
  }
  barrier.stiffness += at.count * std::max(0.0, at.answer.stiffness - law.stiffest());
}

// slip(): a pointer to the slip at a pair that touches, null without friction; called once. Returns the
// smallest distance above the floor, of any pair.
template <class FindSlip>
double set_force(const ContactLaw& law, const Pair& pair, const Corners& x, FindSlip slip, Force& force) {
  Late<Friction> friction;
  bool touches = false;
  const double nearest =
      visit_pressed(law, pair, x, nullptr, [&](const PressedPlace& at, const Modulation* m) {
        if (!std::exchange(touches, true)) {
          force = {};
          force.active = true;
          if (const Slip* const found = slip()) friction.emplace(law, pair, *found, force);
        }
        force.contact += at.count * at.answer.contact;
        force.guard += at.count * at.answer.guard;
        if (at.answer.guard > 0 && at.count > 0) add_barrier(law, at, force.barrier);
        const double push = at.count * at.answer.pressure;
        for (std::size_t i = 0; i < 4; ++i)
          if (at.place.touch.weight[i] != 0)
            force.on[i] += push * at.place.touch.weight[i] * at.place.touch.normal;
        if (changes(at, m)) {
          const double energy = pair.area * at.place.modulated * (at.answer.contact + at.answer.guard);
          for (std::size_t i = 0; i < 4; ++i) force.on[i] -= energy * m->gradient.segment<3>(3 * int(i));
        }
        if (friction) friction->add(at);
      });
  const double gap = nearest - law.floor() * pair.scale;
  if (touches) force.gap = gap;
  return gap;
}

// Whether the pair is clearly farther apart than `reach`, m: found without the root and the division that its
// distance and normal take.
bool is_far(const Pair& pair, const Corners& x, double reach) {
  const double far = (reach + pair.offset) * (reach + pair.offset) * (1 + 1e-9);
  if (pair.kind == PairKind::plane) return is_above_plane(x, far);
  if (pair.kind == PairKind::centre) return (x[0] - x[1]).squaredNorm() > far;
  if (pair.kind == PairKind::segment) return squared_point_segment(x[0], x[1], x[2]) > far;
  if (pair.kind == PairKind::facet) return squared_point_triangle(x[0], x[1], x[2], x[3]) > far;
  return pair.kind == PairKind::edges && squared_crossing(x[0], x[1], x[2], x[3]) > far;
}

}  // namespace

Force pair_force(const ContactLaw& law, const Pair& pair, const Corners& x, const Slip* slip) {
  Force force;
  force.gap = set_force(
      law, pair, x, [slip] { return slip; }, force);
  return force;
}

bool find_force(const ContactLaw& law, const Pair& pair, const Corners& x, const SlipSource* slips,
                Force& force) {
  if (is_far(pair, x, law.gap() * pair.scale)) return false;
  Late<Slip> slip;
  bool touches = false;
  const auto find = [&]() -> const Slip* {
    touches = true;
    if (slips == nullptr) return nullptr;
    slips->find(slip.emplace());
    return &*slip;
  };
  set_force(law, pair, x, find, force);
  return touches;
}

Derivatives pair_derivatives(const ContactLaw& law, const Pair& pair, const Corners& x, Blocks of) {
  Derivatives out;
  Matrix12 bends;  // second derivatives of the modulation
  if (modulates(pair.kind)) bends.setZero();
  visit_pressed(law, pair, x, &bends, [&](const PressedPlace& at, const Modulation* m) {
    const Touch& touch = at.place.touch;
    const Vector12 slope = distance_gradient(touch);
    out.contact += at.count * at.answer.contact;
    out.guard += at.count * at.answer.guard;
    out.gradient -= at.count * at.answer.pressure * slope;
    const Matrix12 bend = distance_hessian(x, touch, of);
    each_corner(of.rows & touch.corners(), [&](std::size_t i) {
      each_corner(of.columns & touch.corners(), [&](std::size_t j) {
        const auto a = 3 * int(i), b = 3 * int(j);
        out.hessian.block<3, 3>(a, b) +=
            at.count * (at.answer.stiffness * slope.segment<3>(a) * slope.segment<3>(b).transpose() -
                        at.answer.pressure * bend.block<3, 3>(a, b));
      });
    });
    if (!changes(at, m)) return;
    const double share = pair.area * at.place.modulated,
                 energy = share * (at.answer.contact + at.answer.guard);
    out.gradient += energy * m->gradient;
    each_corner(of.rows, [&](std::size_t i) {
      each_corner(of.columns, [&](std::size_t j) {
        const auto a = 3 * int(i), b = 3 * int(j);
        out.hessian.block<3, 3>(a, b) += energy * bends.block<3, 3>(a, b) -
                                         share * at.answer.pressure *
                                             (m->gradient.segment<3>(a) * slope.segment<3>(b).transpose() +
                                              slope.segment<3>(a) * m->gradient.segment<3>(b).transpose());
      });
    });
  });
  return out;
}

namespace {

// Derivatives by one corner of all quantities in the friction at a place.
struct Place3 {
  Mat3 sliding;               // of the sliding perpendicular to the normal
  Mat3 lever;                 // of the lever of the rigid side
  std::array<Vec3, 2> slide;  // of the parameters of the closest points
  Vec3 opened;                // of the motion along the normal
};

Place3 sliding_by_corner(const Touch& touch, const Corners& x, const Slip& slip, const Slid& s, double radius,
                         const Slides& slide, const Vec3& held, std::size_t j) {
  const Mat3 one = Mat3::Identity();
  Mat3 r = touch.weight[j] * one, du = touch.weight[j] * one;
  Place3 out;
  for (std::size_t k = 0; k < std::size_t(touch.freedoms()); ++k) {
    const auto plus = std::size_t(touch.plus[k]), minus = std::size_t(touch.minus[k]);
    out.slide[k] = slide[k][j];
    r += (x[plus] - x[minus]) * slide[k][j].transpose();
    du += (slip.moved[plus] - slip.moved[minus]) * slide[k][j].transpose();
  }
  const Vec3& n = touch.normal;
  const Mat3 across = one - n * n.transpose();
  const Mat3 dn = across * r / touch.distance;
  out.lever = radius * dn;
  du -= cross_matrix(slip.turn) * out.lever;
  const Vec3 trial = s.moved + held;
  out.sliding = across * du - n.dot(trial) * dn - n * (trial.transpose() * dn);
  out.opened = du.transpose() * n + dn.transpose() * s.moved;
  return out;
}

}  // namespace

FrictionTangent friction_tangent(const ContactLaw& law, const Pair& pair, const Corners& x, const Slip& slip,
                                 Blocks of) {
  const bool turns = (of.rows & of.columns) == Blocks().rows;
  FrictionTangent out;
  visit_pressed(law, pair, x, nullptr, [&](const PressedPlace& at, const Modulation* m) {
    const Touch& touch = at.place.touch;
    const Slid s = slide(law, pair, at, slip);
    const bool modulated = changes(at, m);
    const unsigned columns = modulated ? of.columns : of.columns & touch.corners();
    const double share = pair.area * at.place.modulated, pressure = at.answer.pressure + s.damping;
    const Slides slide = slides(x, touch);
    std::array<Place3, 4> by;
    Vector12 opened, press;  // derivatives of the opening, and of the normal force by all corners
    opened.setZero();
    each_corner(columns, [&](std::size_t j) {
      by[j] = sliding_by_corner(touch, x, slip, s, pair.offset, slide, slip.held, j);
      opened.segment<3>(3 * int(j)) = by[j].opened;
    });
    press = at.count * s.damping_slope * opened;
    if (modulated) press += share * s.damping * m->gradient;
    if (s.damping != 0) {
      const Vector12 slope = distance_gradient(touch);
      const Matrix12 bend = distance_hessian(x, touch, of);
      each_corner(of.rows & touch.corners(), [&](std::size_t i) {
        each_corner(columns, [&](std::size_t j) {
          const auto a = 3 * int(i), b = 3 * int(j);
          out.jacobian.block<3, 3>(a, b) += slope.segment<3>(a) * press.segment<3>(b).transpose() +
                                            at.count * s.damping * bend.block<3, 3>(a, b);
        });
      });
    }
    const bool rubs = slip.rubs();
    if (!rubs && slip.film.viscous == 0) return;
    press -= at.count * at.answer.stiffness * distance_gradient(touch);
    if (modulated) press += share * at.answer.pressure * m->gradient;

    // pull = force * direction: of what sticks the direction is the trial slip itself, of what slides its
    // unit vector.
    const bool sticks = s.sticks();
    const double length = s.length;
    const double force = rubs ? at.count * (sticks ? slip.stiffness : s.mu * pressure) : 0;  // N/m or N
    Vector12 grows = Vector12::Zero();
    if (rubs && !sticks) grows = s.mu * press;
    if (rubs && sticks && modulated) grows = share * slip.stiffness * m->gradient;
    const Vec3 direction = sticks ? s.trial : Vec3(s.trial / length);
    Mat3 turn = force * Mat3::Identity();
    Vec3 by_trial = Vec3::Zero();  // the derivative of its size by the trial slip
    if (rubs && !sticks) by_trial = at.count * pressure * s.mu_by_trial;
    if (!sticks)
      turn = force / length * (Mat3::Identity() - direction * direction.transpose()) +
             direction * by_trial.transpose();
    const Vec3 pull = force * direction + s.drag * s.slid;
    Vector12 thickens = s.drag_slope * distance_gradient(touch);  // the derivative of the film's drag
    if (modulated) thickens += s.drag / at.count * share * m->gradient;
    const Mat3 levers = cross_matrix(s.lever), drags = s.drag_by_slid();
    if (turns) {
      // The lever is along the normal, so lever x turn has no part along it.
      const Mat3 pull_by_turn = (turn + drags) * levers;
      for (int i = 0; i < 4; ++i)
        out.by_turn.block<3, 3>(3 * i, 0) -= touch.weight[std::size_t(i)] * pull_by_turn;
      out.torque_by_turn += levers * pull_by_turn;
    }
    each_corner(columns, [&](std::size_t j) {
      Mat3 dpull = turn * by[j].sliding + direction * grows.segment<3>(3 * int(j)).transpose();
      if (slip.film.viscous > 0)
        dpull += drags * sliding_by_corner(touch, x, slip, s, pair.offset, slide, Vec3::Zero(), j).sliding +
                 s.slid * thickens.segment<3>(3 * int(j)).transpose();
      if (turns)
        out.torque_by_x.block<3, 3>(0, 3 * int(j)) += levers * dpull - cross_matrix(pull) * by[j].lever;
      const Vec3 larger = grows.segment<3>(3 * int(j)) + by[j].sliding.transpose() * by_trial;
      each_corner(of.rows & touch.corners(), [&](std::size_t i) {
        Mat3 block = touch.weight[i] * dpull;
        for (std::size_t k = 0; k < std::size_t(touch.freedoms()); ++k) {
          if (i == std::size_t(touch.plus[k])) block += pull * by[j].slide[k].transpose();
          if (i == std::size_t(touch.minus[k])) block -= pull * by[j].slide[k].transpose();
        }
        out.jacobian.block<3, 3>(3 * int(i), 3 * int(j)) -= block;
        out.apart.block<3, 3>(3 * int(i), 3 * int(j)) -= touch.weight[i] * direction * larger.transpose();
      });
    });
  });
  const Matrix12 rest = out.jacobian - out.apart;
  out.apart += (rest - rest.transpose()) / 2;
  return out;
}

}  // namespace fabricsh::contact
