// The elastic slips of friction, from step to step.
//
// A slip belongs to a pair as long as it touches. A point that passes from one facet to the next takes its
// slip along: all facets that have common corners hold it with the slip at the nearest of them. So the
// weights of facets, edges and corners cancel for friction as they do for pressure.
#include <algorithm>
#include <bit>
#include <cmath>

#include "base/shares.hpp"
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

// The vector with the components in the frame of u and v that `slip` has in the frame of u0 and v0, of its
// length: it turns with what it belongs to, and does not stretch, which would make energy of nothing.
Vec3 carried(const Vec3& slip, const Vec3& u0, const Vec3& v0, const Vec3& u, const Vec3& v) {
  const double a = u0.dot(u0), b = u0.dot(v0), c = v0.dot(v0), det = a * c - b * b;
  const Vec3 n0 = u0.cross(v0), n = u.cross(v);
  if (!(det > 1e-12 * a * c) || !(n.squaredNorm() > 0)) return slip;
  const double e = slip.dot(u0), f = slip.dot(v0);
  const Vec3 out =
      (c * e - b * f) / det * u + (a * f - b * e) / det * v + slip.dot(n0) / n0.norm() * n.normalized();
  return slip.norm() / out.norm() * out;
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

void Contact::Held::keep(Archive& archive) {
  archive(point[0], point[1], point[2], point[3], interaction, kind);
  for (Vec3* v : {&slip, &pull}) archive((*v)[0], (*v)[1], (*v)[2]);
  archive(gap, damped, slides);
}

bool Contact::Memory::used(std::uint32_t place) const {
  return (lanes_used[place / lanes] >> place % lanes & 1) != 0;
}

Contact::Kept Contact::Memory::at(std::uint32_t place) const {
  const BatchMemory& from = lane[place / lanes];
  const auto k = place % lanes;
  return {{from.slip[0][k], from.slip[1][k], from.slip[2][k]},
          {from.pull[0][k], from.pull[1][k], from.pull[2][k]},
          from.gap[k],
          from.damped[k],
          from.slides[k]};
}

void Contact::put(BatchMemory& to, std::uint32_t k, const Kept& kept) {
  for (int d = 0; d < 3; ++d) {
    to.slip[d][k] = kept.slip[d];
    to.pull[d][k] = kept.pull[d];
  }
  to.gap[k] = kept.gap;
  to.damped[k] = kept.damped;
  to.slides[k] = kept.slides;
}

void Contact::Memory::begin(std::size_t batches) {
  by_lane = true;
  lane.resize(batches);
  lanes_used.assign(batches, 0);
}

template <class Visit>
void Contact::each(const Memory& memory, Visit visit) const {
  if (!memory.by_lane)
    for (const Held& h : memory.list) visit(h);
  else
    for (const std::uint32_t i : by_first_)
      if (memory.used(place_[i]))
        visit(Held{memory.at(place_[i]), inner_[i].point, inner_[i].interaction, inner_[i].pair.kind});
}

void Contact::to_list(Memory& memory) const {
  if (!memory.by_lane) return;
  memory.list.clear();
  each(memory, [&](const Held& h) { memory.list.push_back(h); });
  memory.by_lane = false;
}

namespace {

// Whether two facets have a common corner.
bool are_beside(const std::array<std::int32_t, 4>& a, const std::array<std::int32_t, 4>& b) {
  return std::find_first_of(a.begin() + 1, a.end(), b.begin() + 1, b.end()) != a.end();
}

}  // namespace

// Balls and rods lie on many facets at once, each with a slip of its own.
bool Contact::passes_on(PairKind kind, std::int32_t first, std::int32_t interaction) const {
  if (kind != PairKind::facet) return false;
  const Interaction& it = scene_->interactions()[std::size_t(interaction)];
  return !rigid(first) || scene_->surfaces()[std::size_t(it.second)].shape == Shape::solid;
}

// The committed slip of a pair, or that of the nearest facet beside it, without its forces.
std::optional<Contact::Kept> Contact::held_by(std::size_t slot) {
  const Candidate& c = inner_[slot];
  const bool passes = passes_on(c.pair.kind, c.point[0], c.interaction);
  const auto passed_on = [](const Kept& from) {
    return Kept{from.slip, Vec3::Zero(), from.gap, 0, from.slides};
  };
  if (held_.by_lane) {
    if (held_.used(place_[slot])) return held_.at(place_[slot]);
    std::optional<Kept> found;
    const std::uint32_t row = rows_of_[slot][0];
    for (std::size_t k = first_place_[row]; passes && k < first_place_[row + 1]; ++k) {
      const std::uint32_t i = by_first_[k];
      const Candidate& other = inner_[i];
      if (!held_.used(place_[i]) || other.pair.kind != PairKind::facet ||
          other.interaction != c.interaction || !are_beside(c.point, other.point))
        continue;
      const Kept of_other = held_.at(place_[i]);
      if (!found || of_other.gap < found->gap) found = passed_on(of_other);
    }
    return found;
  }
  const std::vector<Held>& all = held_.list;
  std::int32_t& known = known_[slot];
  if (known == unknown) {
    known = none;
    const auto first =
        std::partition_point(all.begin(), all.end(), [&](const Held& h) { return h.point[0] < c.point[0]; });
    for (auto h = first; h != all.end() && h->point[0] == c.point[0]; ++h) {
      const auto number = std::int32_t(h - all.begin());
      if (h->is(c)) {
        known = number;
        break;
      }
      if (passes && h->kind == PairKind::facet && h->interaction == c.interaction &&
          are_beside(c.point, h->point) && (known == none || h->gap < all[std::size_t(known)].gap))
        known = number;
    }
  }
  if (known == none) return {};
  const Held& found = all[std::size_t(known)];
  return found.is(c) ? std::optional<Kept>(found) : passed_on(found);
}

void Contact::find_held(const BatchPairs& batch, unsigned of_lanes, BatchMemory& to) {
  for (std::uint32_t lane = 0; lane < lanes; ++lane) {
    if ((of_lanes >> lane & 1) == 0) continue;
    put(to, lane, held_by(batch.slot[lane]).value_or(Kept()));
  }
}

void Contact::find_slip(std::size_t i, std::span<const Vec3> x, const Way& way, Slip& slip) {
  const Candidate& c = inner_[i];
  const Interaction& it = scene_->interactions()[std::size_t(c.interaction)];
  slip.friction = it.friction;
  // A barrier carries more than the law. Where the step permits, it holds friction as cloth pressed dense
  // does.
  const double dense = dense_stiffness(it.law.gap(), it.law.floor());
  const bool holds = !it.parts.empty() && way.inverse_mass.empty();
  slip.stiffness =
      c.pair.grip * tangential * (holds ? std::max(it.law.stiffest(), dense) : it.law.stiffest());
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
  if (const auto held = held_by(i)) {
    slip.held = held->slip;
    slip.slides = held->slides;
    slip.pull = held->pull;
    slip.damped = held->damped;
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
  if (way.start.empty() || way.inverse_mass.empty() || !way.planes.empty() || !(way.dt > 0)) return out;
  for (const Interaction& it : scene_->interactions()) {
    BatchLaw row;
    const bool plain = it.across < 0 && it.film.viscous == 0 && !it.rigid && it.parts.empty();
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

// The order of the slips is that of the first corners, for each that of the pairs.
void Contact::index_places() {
  first_place_.assign(touched_.size() + 1, 0);
  for (const auto& rows : rows_of_) ++first_place_[rows[0] + 1];
  for (std::size_t row = 0; row < touched_.size(); ++row) first_place_[row + 1] += first_place_[row];
  std::vector<std::uint32_t> next(first_place_.begin(), first_place_.end() - 1);
  by_first_.resize(inner_.size());
  for (std::size_t i = 0; i < inner_.size(); ++i) by_first_[next[rows_of_[i][0]]++] = std::uint32_t(i);
}

// Facets beside each other hold a point with the slip at the nearest of them: those are looked at in the
// order of their gaps, equal ones in their own.
void Contact::join(std::span<const std::uint32_t> slots) {
  struct Place {
    std::uint32_t slot;
    Kept kept;
  };
  thread_local std::vector<Place> nearest;
  nearest.clear();
  for (const std::uint32_t i : slots) {
    const Candidate& c = inner_[i];
    if (c.pair.kind != PairKind::facet || !tried_.used(place_[i])) continue;
    if (!passes_on(c.pair.kind, c.point[0], c.interaction)) return;
    auto at = nearest.size();
    nearest.push_back({i, tried_.at(place_[i])});
    for (; at > 0 && nearest[at].kept.gap < nearest[at - 1].kept.gap; --at)
      std::swap(nearest[at - 1], nearest[at]);
  }
  for (const Place& own : nearest)
    for (const Place& other : nearest) {
      if (!(other.kept.gap < own.kept.gap)) break;
      const Candidate &one = inner_[own.slot], &two = inner_[other.slot];
      if (one.interaction != two.interaction || !are_beside(one.point, two.point)) continue;
      Kept joined = own.kept;
      joined.slip = other.kept.slip;
      joined.slides = other.kept.slides;
      put(tried_.lane[place_[own.slot] / lanes], place_[own.slot] % lanes, joined);
      break;
    }
}

void Contact::keep_slip(std::size_t slot, const Corners& x, const Way& way, Force& force) {
  const Candidate& c = inner_[slot];
  if (!force.slip.isZero(0))
    force.slip = turned(c, force.slip, corners_of(c, way.start), x, of_body(c, way.turn));
  if (!way.planes.empty()) force.resists = resists(c, force, way);
  const std::uint32_t place = place_[slot];
  put(tried_.lane[place / lanes], place % lanes,
      {force.slip, force.pull, force.gap, force.damped, force.slides});
  tried_.lanes_used[place / lanes] |= 1u << place % lanes;
}

void Contact::share_slips() {
  has_tried_ = true;
  for_each_index(touched_.size(), touched_.size() > 1024, [&](std::size_t row) {
    if (at_point_[row].slips < 2) return;
    const std::size_t first = first_place_[row];
    join({by_first_.data() + first, first_place_[row + 1] - first});
  });
}

double Contact::crowd_at(std::size_t point) const {
  return rubbing_at_.empty() ? 1 : std::max(1.0, rubbing_at_[point] / most_resistance);
}

Contact::Rubbing Contact::held_friction() const {
  Rubbing all;
  double largest = 0;
  each(held_, [&](const Held& h) {
    const double force = h.pull.norm();
    ++all.pairs;
    all.force += force;
    if (!(h.slides > 0)) return;
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
  std::swap(rubbing_at_, tried_rubbing_);
  has_tried_ = false;
  ++commits_;
  if (!at_try_.empty() && patches_.against(at_tally_, at_try_, tally_way_) > tally_way_) {
    std::swap(at_tally_, at_try_);
    tallies_ = true;
  }
  if (!held_.by_lane) std::fill(known_.begin(), known_.end(), unknown);
}

void Contact::keep(Archive& archive) {
  Memory kept;
  if (!archive.reading()) each(held_, [&](const Held& h) { kept.list.push_back(h); });
  bool tallied = !at_tally_.empty();
  archive(kept.list, rubbing_at_, commits_, tallied);
  if (archive.reading()) at_tally_.resize(tallied ? scene_->reference().size() : 0);
  for (Vec3& x : at_tally_) archive.filled({x.data(), 3});
  if (!archive.reading()) return;
  tallies_ = true;
  held_ = std::move(kept);
  has_tried_ = false;
  std::fill(known_.begin(), known_.end(), unknown);
}

}  // namespace fabricsh::contact
