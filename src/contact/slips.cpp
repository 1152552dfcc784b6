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
  std::int32_t& known = known_[slot];
  if (known == none) return nullptr;
  if (known != unknown) return &held_[std::size_t(known)];
  const Candidate& c = inner_[slot];
  const auto first = std::partition_point(held_.begin(), held_.end(),
                                          [&](const Held& h) { return h.point[0] < c.point[0]; });
  const Held sought{c.point, c.interaction, 0, c.pair.kind};
  const bool passes = passes_on(c.pair.kind, c.point[0], c.interaction);
  auto found = held_.end();
  for (auto h = first; h != held_.end() && h->point[0] == c.point[0]; ++h) {
    if (h->is(c)) {
      found = h;
      break;
    }
    if (passes && h->beside(sought) && (found == held_.end() || h->gap < found->gap)) found = h;
  }
  known = found == held_.end() ? none : std::int32_t(found - held_.begin());
  return known == none ? nullptr : &*found;
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
    slip.along = scene_->warp_at(it, c.point, x);
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
    slip.portion = c.pair.area / scene_->triangles()[std::size_t(scene_->triangle_of_spot(c.point[0]))].area;
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
      if (!rubbing_at_.empty()) slip.crowd[k] = std::max(1.0, rubbing_at_[std::size_t(p)] / most_resistance);
      slip.inverse_mass[k] = images * way.inverse_mass[std::size_t(p)] * slip.crowd[k];
    }
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

// Facets beside each other hold a point with the slip at the nearest of them: those are looked at in the
// order of their gaps, equal ones in their own.
void Contact::join(std::span<Held> of_one_point) {
  struct Place {
    double gap;
    Held* of;
    Vec3 slip;
    bool slides;
  };
  thread_local std::vector<Place> nearest;
  nearest.clear();
  for (Held& h : of_one_point) {
    if (h.kind != PairKind::facet) continue;
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

void Contact::note_slips() {
  if (!tried_) tried_.emplace();
  tried_->version = version_;
  std::vector<Held>& held = tried_->held;
  first_slip_.assign(touched_.size() + 1, 0);
  for (std::size_t row = 0; row < touched_.size(); ++row)
    first_slip_[row + 1] = first_slip_[row] + at_point_[row].slips;
  held.resize(first_slip_.back());
  slip_at_.resize(in_use_.size());
  std::vector<std::uint32_t> next(first_slip_.begin(), first_slip_.end() - 1);
  for (std::size_t k = 0; k < in_use_.size(); ++k)
    if (active_[in_use_[k]] == rubbing) slip_at_[k] = next[first_row_of(in_use_[k])]++;
  const bool many = held.size() > 256;
#pragma omp parallel for schedule(static) if (many)
  for (std::size_t k = 0; k < in_use_.size(); ++k) {
    const std::uint32_t slot = in_use_[k];
    if (active_[slot] != rubbing) continue;
    const Candidate& c = inner_[slot];
    const Force& force = slots_[slot];
    held[slip_at_[k]] = {c.point,   c.interaction, slot,       c.pair.kind, force.slides,
                         force.gap, force.damped,  force.slip, force.pull,  force.resists};
  }
#pragma omp parallel for schedule(static) if (many)
  for (std::size_t row = 0; row < touched_.size(); ++row) {
    const std::span<Held> own(held.data() + first_slip_[row], first_slip_[row + 1] - first_slip_[row]);
    const auto may_pass = [this](const Held& h) {
      return h.kind != PairKind::facet || passes_on(h.kind, h.point[0], h.interaction);
    };
    if (own.size() > 1 && std::all_of(own.begin(), own.end(), may_pass)) join(own);
  }
}

void Contact::count_rubbing() {
  rubbing_at_.assign(scene_->reference().size(), 0);
  const auto count = [&](std::int32_t p, double resists) { rubbing_at_[std::size_t(p)] += resists; };
  for (const Held& h : held_)
    for (std::size_t k = 0; k < 4; ++k)
      if (h.point[k] < 0)
        continue;
      else if (!scene_->is_spot(h.point[k]))
        count(h.point[k], h.resists[k]);
      else
        for (const std::int32_t p :
             scene_->triangles()[std::size_t(scene_->triangle_of_spot(h.point[k]))].nodes)
          count(p, h.resists[k]);
}

Contact::Rubbing Contact::held_friction() const {
  Rubbing all;
  double largest = 0;
  for (const Held& h : held_) {
    const double force = h.pull.norm();
    ++all.pairs;
    all.force += force;
    if (!h.slides) continue;
    ++all.sliding;
    all.of_sliding += force;
    if (force > largest) {
      largest = force;
      all.most = scene_->with_nodes(h.point);
    }
  }
  return all;
}

void Contact::commit() {
  if (!tried_) return;
  std::swap(held_, tried_->held);
  count_rubbing();
  std::fill(known_.begin(), known_.end(), unknown);
  if (tried_->version == version_)
    for (std::size_t i = 0; i < held_.size(); ++i) known_[held_[i].slot] = std::int32_t(i);
  tried_.reset();
}

void Contact::keep(Archive& archive) {
  archive(held_);
  if (!archive.reading()) return;
  count_rubbing();
  tried_.reset();
  std::fill(known_.begin(), known_.end(), unknown);
}

}  // namespace fabricsh::contact
