// The elastic slips of friction, from step to step.
//
// A slip belongs to a pair as long as it touches. A point that passes from one facet to the next takes its
// slip along: all facets that have common corners hold it with the slip at the nearest of them. So the
// weights of facets, edges and corners cancel for friction as they do for pressure.
#include <algorithm>
#include <bit>
#include <cmath>

#include "contact/contact.hpp"

namespace fabricsh::contact {
namespace {

// A spring of 2/7 of the stiffness against pressure: a ball that sticks, on which friction also turns, then
// vibrates along the surface with the frequency with which it vibrates against it, and an explicit step
// carries both.
constexpr double tangential = 2.0 / 7;

// So many times 0.2 m / dt at a point of the mass m do not yet reverse its motion within an explicit step;
// pairs whose resistances add up to more share this.
constexpr double most_resistance = 4;

// The vector with the components in the frame of u and v that `slip` has in the frame of u0 and v0.
Vec3 carried(const Vec3& slip, const Vec3& u0, const Vec3& v0, const Vec3& u, const Vec3& v) {
  const double a = u0.dot(u0), b = u0.dot(v0), c = v0.dot(v0), det = a * c - b * b;
  const Vec3 n0 = u0.cross(v0), n = u.cross(v);
  if (!(det > 1e-12 * a * c) || !(n.squaredNorm() > 0)) return slip;
  const double e = slip.dot(u0), f = slip.dot(v0);
  return (c * e - b * f) / det * u + (a * f - b * e) / det * v + slip.dot(n0) / n0.norm() * n.normalized();
}

// The slip after the step, turned with what it belongs to.
Vec3 turned(const Candidate& c, const Vec3& slip, const Corners& from, const Corners& to, const Vec3& turn) {
  const auto pairs = [&](int a, int b, int p, int q) {
    const auto side = [](const Corners& x, int i, int j) {
      return Vec3(x[std::size_t(j)] - x[std::size_t(i)]);
    };
    return carried(slip, side(from, a, b), side(from, p, q), side(to, a, b), side(to, p, q));
  };
  switch (c.pair.kind) {
    case PairKind::facet:
    case PairKind::plane:
      return from[1] == to[1] && from[2] == to[2] && from[3] == to[3] ? slip : pairs(1, 2, 1, 3);
    case PairKind::edges:
      return pairs(0, 1, 2, 3);
    default:
      break;
  }
  const double angle = turn.norm();
  return angle > 0 ? Vec3(Eigen::AngleAxisd(angle, turn / angle) * slip) : slip;
}

}  // namespace

bool Contact::Held::beside(const Held& other) const {
  if (kind != PairKind::facet || other.kind != PairKind::facet || interaction != other.interaction)
    return false;
  for (std::size_t i = 1; i < 4; ++i)
    for (std::size_t j = 1; j < 4; ++j)
      if (point[i] == other.point[j]) return true;
  return false;
}

void Contact::Held::keep(Archive& archive) {
  archive(point[0], point[1], point[2], point[3], interaction, kind);
  for (Vec3* v : {&slip, &pull}) archive((*v)[0], (*v)[1], (*v)[2]);
  archive(gap, damped, slides, resists[0], resists[1], resists[2], resists[3]);
}

// Balls and rods lie on many facets at once, each with a slip of its own.
bool Contact::passes_on(PairKind kind, std::int32_t first, std::int32_t interaction) const {
  if (kind != PairKind::facet) return false;
  const Interaction& it = scene_->interactions()[std::size_t(interaction)];
  return !rigid(first) || scene_->surfaces()[std::size_t(it.second)].shape == Shape::solid;
}

// The committed slip of a pair, or that of the nearest facet beside it; null: there is none.
const Contact::Held* Contact::held_by(std::size_t slot) {
  const Candidate& c = inner_[slot];
  const Held sought{c.point, c.interaction, c.pair.kind};
  const bool passes = passes_on(c.pair.kind, c.point[0], c.interaction);
  const Held* found = nullptr;
  const auto look_at = [&](const Held& h) {
    if (h.is(c)) found = &h;
    if (h.is(c)) return true;
    if (passes && h.beside(sought) && (found == nullptr || h.gap < found->gap)) found = &h;
    return false;
  };
  const std::vector<Held>& all = held_.held;
  if (held_.by_place) {
    const std::size_t own = place_[slot];
    if (held_.used[own] != 0) return &all[own];
    if (!passes) return nullptr;
    const std::uint32_t row = first_row_of(slot);
    for (std::size_t i = first_place_[row]; i < first_place_[row + 1]; ++i)
      if (held_.used[i] != 0) look_at(all[i]);
    return found;
  }
  std::int32_t& known = known_[slot];
  if (known == none) return nullptr;
  if (known != unknown) return &all[std::size_t(known)];
  const auto first =
      std::partition_point(all.begin(), all.end(), [&](const Held& h) { return h.point[0] < c.point[0]; });
  for (auto h = first; h != all.end() && h->point[0] == c.point[0]; ++h)
    if (look_at(*h)) break;
  known = found == nullptr ? none : std::int32_t(found - all.data());
  return found;
}

void Contact::find_slip(std::size_t i, std::span<const Vec3> x, const Way& way, Slip& slip) {
  const Candidate& c = inner_[i];
  const Interaction& it = scene_->interactions()[std::size_t(c.interaction)];
  slip.friction = it.friction;
  slip.stiffness = tangential * it.law.stiffest();
  slip.sticking = it.sticking;
  slip.film = it.film;
  if (it.across >= 0) {
    slip.across = it.across;
    slip.along = warp_at(*scene_, it, c.point, x);
  }
  if (!way.turn.empty()) slip.turn = of_body(c, way.turn);
  if (c.spot.any()) slip.moved[0] = c.spot.of(x) - c.spot.of(way.start);
  for (std::size_t k = c.spot.any() ? 1 : 0; k < 4; ++k)
    if (const auto p = c.point[k]; p >= 0) slip.moved[k] = x[std::size_t(p)] - way.start[std::size_t(p)];
  if (const Held* held = held_by(i)) {
    slip.held = held->slip;
    slip.slides = held->slides;
    if (held->is(c)) {
      slip.pull = held->pull;
      slip.damped = held->damped;
    }
  }
  slip.loss = it.loss;
  slip.dt = way.dt;
  if (way.inverse_mass.empty()) return;
  slip.step = way.dt;
  slip.eased = eases(it);
  const double images = way.planes.empty() ? 1 : 1u << std::popcount(planes_of(c, way.planes));
  if (c.spot.any()) {
    // Many resist at its nodes: each as its part of a facet has it.
    slip.portion =
        c.pair.area / scene_->triangles()[std::size_t(scene_->spots().triangle_of(c.point[0]))].area;
    double alone = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto p = std::size_t(c.spot.node[k]);
      const double share = c.spot.weight(k) * c.spot.weight(k) * way.inverse_mass[p];
      alone += share;
      slip.inverse_mass[0] +=
          share * (rubbing_at_.empty() ? 1 : std::max(1.0, rubbing_at_[p] / most_resistance));
    }
    if (alone > 0) slip.crowd[0] = slip.inverse_mass[0] / alone;
    slip.inverse_mass[0] *= images;
  }
  for (std::size_t k = c.spot.any() ? 1 : 0; k < 4; ++k)
    if (const auto p = c.point[k]; p >= 0) {
      slip.crowd[k] = crowd_at(std::size_t(p));
      slip.inverse_mass[k] = images * way.inverse_mass[std::size_t(p)] * slip.crowd[k];
    }
}

// The same for batches; the kinds of each interaction in their order.
std::vector<BatchLaw> Contact::laws_of_batches(const Way& way) const {
  std::vector<BatchLaw> out;
  if (way.inverse_mass.empty() || !way.planes.empty() || !(way.dt > 0)) return out;
  for (const Interaction& it : scene_->interactions()) {
    BatchLaw row;
    const bool plain = it.across < 0 && it.film.viscous == 0 && !it.rigid;
    const auto& knots = it.law.knots();
    row.knots = &knots.front().gap;
    row.count = plain ? int(knots.size()) : 0;
    row.gap = it.law.gap();
    row.floor = it.law.floor();
    row.guard = it.law.guard_gap();
    row.stiffest = it.law.stiffest();
    row.rubs = it.rubs();
    row.coulomb = it.friction > 0 || it.sticking > 0;
    row.friction = it.friction;
    row.holding = std::max(it.sticking, it.friction);
    row.spring = tangential * it.law.stiffest();
    row.loss = it.loss;
    row.dt = way.dt;
    const Surface& second = scene_->surfaces()[std::size_t(it.second)];
    if (!way.turn.empty() && second.shape != Shape::cloth)
      std::copy_n(way.turn[std::size_t(second.first_vertex)].data(), 3, row.turn);
    for (const auto kind : {BatchKind::facet, BatchKind::edges, BatchKind::plane}) {
      row.kind = kind;
      out.push_back(row);
    }
  }
  return out;
}

// With those of the pair's mirror images, which the part of the model beyond a plane of symmetry would have.
std::array<double, 4> Contact::resists(const Candidate& c, const Force& force, const Way& way) const {
  std::array<double, 4> out = force.resists;
  if (way.planes.empty()) return out;
  const unsigned own = planes_of(c, way.planes);
  for (std::size_t k = c.spot.any() ? 1 : 0; k < 4; ++k)
    if (const auto p = c.point[k]; p >= 0)
      out[k] *= 1u << std::popcount(way.planes[std::size_t(p)] & ~own & 7u);
  return out;
}

void Contact::Memory::clear_places(std::size_t count) {
  by_place = true;
  held.resize(count);
  used.assign(count, 0);
}

void Contact::Memory::pack() {
  if (!by_place) return;
  std::size_t n = 0;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (used[i] != 0) held[n++] = held[i];
  held.resize(n);
  by_place = false;
}

// The order of the places is that of the first corners, for each that of the pairs.
void Contact::index_places() {
  first_place_.assign(touched_.size() + 1, 0);
  for (std::size_t i = 0; i < inner_.size(); ++i) ++first_place_[first_row_of(i) + 1];
  for (std::size_t row = 0; row < touched_.size(); ++row) first_place_[row + 1] += first_place_[row];
  std::vector<std::uint32_t> next(first_place_.begin(), first_place_.end() - 1);
  place_.resize(inner_.size());
  for (std::size_t i = 0; i < inner_.size(); ++i) place_[i] = next[first_row_of(i)]++;
}

void Contact::hold(std::size_t slot) {
  const Candidate& c = inner_[slot];
  const Force& force = slots_[slot];
  const std::size_t place = place_[slot];
  tried_.used[place] = 1;
  Held& held = tried_.held[place];  // field by field: a whole one would be cleared before
  held.point = c.point;
  held.interaction = c.interaction;
  held.kind = c.pair.kind;
  held.slides = force.slides;
  held.gap = force.gap;
  held.damped = force.damped;
  held.slip = force.slip;
  held.pull = force.pull;
  held.resists = force.resists;
}

// Facets beside each other hold a point with the slip at the nearest of them: those are looked at in the
// order of their gaps, equal ones in their own.
void Contact::join(std::span<Held> of_one_point, const char* used) {
  struct Place {
    double gap;
    Held* of;
    Vec3 slip;
    bool slides;
  };
  thread_local std::vector<Place> nearest;
  nearest.clear();
  for (std::size_t i = 0; i < of_one_point.size(); ++i) {
    Held& h = of_one_point[i];
    if (used[i] == 0 || h.kind != PairKind::facet) continue;
    if (!passes_on(h.kind, h.point[0], h.interaction)) return;
    auto at = nearest.size();
    nearest.push_back({h.gap, &h, h.slip, h.slides});
    for (; at > 0 && h.gap < nearest[at - 1].gap; --at) std::swap(nearest[at - 1], nearest[at]);
  }
  for (const Place& own : nearest)
    for (const Place& other : nearest) {
      if (!(other.gap < own.gap)) break;
      if (!own.of->beside(*other.of)) continue;
      own.of->slip = other.slip;
      own.of->slides = other.slides;
      break;
    }
}

void Contact::keep_slip(std::size_t slot, const Corners& x, const Way& way) {
  const Candidate& c = inner_[slot];
  Force& force = slots_[slot];
  if (!force.slip.isZero(0))
    force.slip = turned(c, force.slip, corners_of(c, way.start), x, of_body(c, way.turn));
  if (!way.planes.empty()) force.resists = resists(c, force, way);
}

void Contact::share_slips() {
  has_tried_ = true;
#pragma omp parallel for schedule(static) if (touched_.size() > 1024)
  for (std::size_t row = 0; row < touched_.size(); ++row) {
    if (at_point_[row].slips < 2) continue;
    const std::size_t first = first_place_[row];
    join({tried_.held.data() + first, first_place_[row + 1] - first}, tried_.used.data() + first);
  }
}

void Contact::count_rubbing() {
  rubbing_at_.assign(scene_->reference().size(), 0);
  const auto count = [&](std::int32_t p, double resists) { rubbing_at_[std::size_t(p)] += resists; };
  held_.each([&](const Held& h) {
    for (std::size_t k = 0; k < 4; ++k)
      if (h.point[k] < 0)
        continue;
      else if (!scene_->spots().is(h.point[k]))
        count(h.point[k], h.resists[k]);
      else
        for (const std::int32_t p :
             scene_->triangles()[std::size_t(scene_->spots().triangle_of(h.point[k]))].nodes)
          count(p, h.resists[k]);
  });
}

double Contact::crowd_at(std::size_t point) const {
  return rubbing_at_.empty() ? 1 : std::max(1.0, rubbing_at_[point] / most_resistance);
}

Contact::Rubbing Contact::held_friction() const {
  Rubbing all;
  double largest = 0;
  held_.each([&](const Held& h) {
    const double force = h.pull.norm();
    ++all.pairs;
    all.force += force;
    if (!h.slides) return;
    ++all.sliding;
    all.of_sliding += force;
    if (force > largest) {
      largest = force;
      all.most = scene_->spots().with_nodes(h.point);
    }
  });
  return all;
}

void Contact::commit() {
  if (!has_tried_) return;
  std::swap(held_, tried_);
  has_tried_ = false;
  count_rubbing();
  if (!held_.by_place) std::fill(known_.begin(), known_.end(), unknown);
}

void Contact::keep(Archive& archive) {
  Memory kept;
  if (!archive.reading()) held_.each([&](const Held& h) { kept.held.push_back(h); });
  archive(kept.held);
  if (!archive.reading()) return;
  held_ = std::move(kept);
  count_rubbing();
  has_tried_ = false;
  std::fill(known_.begin(), known_.end(), unknown);
}

}  // namespace fabricsh::contact
