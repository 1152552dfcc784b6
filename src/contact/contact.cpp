#include "contact/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/shares.hpp"
#include "contact/advance.hpp"
#include "contact/tally.hpp"

namespace fabricsh::contact {
namespace {

constexpr double of_apart = 0.9;  // the gap of crack faces, as a share of how far they have been apart
constexpr double grown_from =
    0.02;  // of the whole gap: crack faces that were less far apart do not touch yet
constexpr double eased_approach = 0.05;    // of the range of contact, in a step
constexpr std::uint32_t tally_every = 32;  // explicit steps

double mean_edge(const Scene& scene) {
  double sum = 0, count = 0;
  for (const EdgeRow& row : scene.edges())
    if (scene.surfaces()[std::size_t(row.surface)].shape == Shape::cloth) {
      sum += row.length;
      count += 1;
    }
  return count > 0 ? sum / count : 1e-3;
}

// Crack faces that come back with some speed do not stop within a gap far below that of the law.
double grown(double apart, const ContactLaw& law) {
  return apart < grown_from * law.gap() ? 0 : of_apart * apart;
}

// The corners of a pair move from x to end; the share of that motion until the pair reaches its floor.
double safe_fraction_of(const Candidate& c, const ContactLaw& law, const Corners& x, const Corners& end) {
  const double least = c.pair.offset + law.floor() * c.pair.scale;
  const auto pairs = Simplices::segment_segment;
  switch (c.pair.kind) {
    case PairKind::facet:
      return safe_fraction(Simplices::point_triangle, x, end, least);
    case PairKind::edges:
    case PairKind::wrap:
      return safe_fraction(pairs, x, end, least);
    case PairKind::segment:
      return safe_fraction(pairs, {x[0], x[0], x[1], x[2]}, {end[0], end[0], end[1], end[2]}, least);
    case PairKind::centre:
      return safe_fraction(pairs, {x[0], x[0], x[1], x[1]}, {end[0], end[0], end[1], end[1]}, least);
    case PairKind::plane:
      break;
  }
  const double from = point_plane(x).distance - least, to = point_plane(end).distance - least;
  if (!(from > 0)) return 0;
  return to >= 0.1 * from ? 1 : 0.9 * from / (from - to);
}

// Scaling the law's lengths for neighbours in a sheet also scales the way from gap to floor.
double narrowest(const Scene& scene, double least) {
  double gap = 0;
  for (const Interaction& it : scene.interactions()) {
    least = std::min(least, it.guarded * (it.law.gap() - it.law.floor()));
    gap = std::max(gap, it.law.gap());
  }
  for (const Candidate& c : find_pairs(scene, scene.reference(), 0.2 * gap)) {
    const ContactLaw& law = scene.interactions()[std::size_t(c.interaction)].law;
    least = std::min(least, c.start * c.pair.scale * (law.gap() - law.floor()));
  }
  return least;
}

}  // namespace

Contact::Contact(const Scene& scene, Skins skins) : scene_(&scene), skins_(skins), patches_(scene) {
  const double edge = mean_edge(scene);
  if (!(skins_.outer > 0)) skins_.outer = edge / 3;
  if (!(skins_.inner > 0)) skins_.inner = std::min(edge / 8, skins_.outer / 2);
  tally_way_ = edge / 8;
  for (const Interaction& it : scene.interactions())
    widest_ = std::max(widest_, it.law.gap() - it.law.floor());
  opened_.assign(scene.interactions().size(), 1);
  lists_all_ = std::all_of(scene.interactions().begin(), scene.interactions().end(),
                           [](const Interaction& it) { return it.parts.empty(); });
  narrowest_ = narrowest_at_first_ = narrowest(scene, widest_);
}

namespace {

// The largest way of any point, m.
double farthest(std::span<const Vec3> x, const std::vector<Vec3>& since) {
  const std::size_t n = x.size();
  return std::sqrt(largest_of(n, n > 4096, [&](std::size_t i) { return (x[i] - since[i]).squaredNorm(); }));
}

}  // namespace

// The inner list holds all pairs that were within its skin of their reach in refine(). A pair within reach
// now is one of them, as long as near surfaces have moved against each other by less than the skin. The way
// since at_check_ of whatever moved most bounds that cheaply; the patches find it out where it does not.
void Contact::prepare(std::span<const Vec3> x) {
  if (at_search_.size() != x.size()) return search(x);
  change_ = checked_ + 2 * farthest(x, at_check_);
  if (!tallies_ && change_ <= nearly * skins_.inner && vertex_motion_bounds_surface_motion(at_check_, x))
    return;
  mark_checked(x, patches_.against(at_refine_, x, skins_.inner));
  if (!tallies_ && change_ <= nearly * skins_.inner) return;
  const double since_search = patches_.against(at_search_, x, skins_.inner);
  if (since_search + skins_.inner > nearly * skins_.outer)
    search(x);
  else
    refine(x, since_search);
}

void Contact::mark_checked(std::span<const Vec3> x, double change) {
  at_check_.assign(x.begin(), x.end());
  checked_ = change_ = change;
}

void Contact::scale(Candidate& c) const {
  const double share = opened_[std::size_t(c.interaction)];
  c.pair.scale = share >= 1 ? c.whole : c.whole * (c.start + (1 - c.start) * share);
  if (c.crack_faces) c.pair.scale = std::min(c.pair.scale, grown(least_apart(c), law(c)) / law(c).gap());
}

// m, of the crack faces among the points of a pair of them.
double Contact::least_apart(const Candidate& c) const {
  double least = std::numeric_limits<double>::infinity();
  const Neighbours& neighbours = scene_->neighbours();
  for (const std::int32_t p : scene_->spots().with_nodes(c.point))
    if (p >= 0 && neighbours.apart(p) >= 0) least = std::min(least, neighbours.apart(p));
  return least;
}

std::vector<Candidate> Contact::find(std::span<const Vec3> x, double skin, std::span<const Vec3> by) const {
  std::vector<Candidate> found = find_pairs(*scene_, x, skin, by);
  for (Candidate& c : found) scale(c);
  return found;
}

void Contact::open_to(std::span<const double> share) {
  if (std::equal(share.begin(), share.end(), opened_.begin(), opened_.end())) return;
  opened_.assign(share.begin(), share.end());
  scale_all();
}

void Contact::scale_all() {
  for (auto* list : {&outer_, &inner_})
    for (Candidate& c : *list) scale(c);
  for (BatchPairs& batch : pairs_)  // lanes that are not in use, too
    for (std::size_t lane = 0; lane < lanes; ++lane) batch.scale[lane] = inner_[batch.slot[lane]].pair.scale;
}

// Only pairs that would be within reach at their whole lengths are looked at: every list has them.
bool Contact::widen(std::span<const Vec3> x, std::vector<double>& apart) {
  prepare(x);
  std::vector<double> nearest(apart.size(), std::numeric_limits<double>::infinity());
  for (const Candidate& c : inner_) {
    const double gap = c.crack_faces ? gap_of(c, corners_of(c, x)) : 0;
    if (!c.crack_faces || gap >= law(c).gap() * c.whole) continue;
    for (const std::int32_t p : c.point)
      if (p >= 0) nearest[std::size_t(p)] = std::min(nearest[std::size_t(p)], gap);
  }
  bool more = false;
  for (std::size_t p = 0; p < apart.size(); ++p) {
    if (!(apart[p] >= 0) || nearest[p] <= apart[p]) continue;
    apart[p] = nearest[p];
    more = true;
  }
  return more;
}

void Contact::scene_changed() {
  patches_ = Patches(*scene_);
  narrowest_at_first_ = narrowest(*scene_, widest_);
  at_search_.clear();  // the lists are found anew
  outer_.clear();
  clear_lists();
  has_tried_ = false;
  apart_changed();
}

void Contact::apart_changed() {
  narrowest_ = narrowest_at_first_;
  for (const double apart : scene_->neighbours().apart())
    for (const Interaction& it : scene_->interactions())
      if (const double gap = grown(apart, it.law); gap > 0)
        narrowest_ = std::min(narrowest_, gap / it.law.gap() * (it.law.gap() - it.law.floor()));
  scale_all();
}

Vec3 Contact::of_body(const Candidate& c, std::span<const Vec3> by_point) const {
  if (!by_point.empty())
    for (const std::int32_t p : c.point)
      if (rigid(p)) return by_point[std::size_t(p)];
  return Vec3::Zero();
}

// The planes of symmetry that all nodes of the pair lie in, one bit each. The parts of the model on both
// sides share such a pair.
unsigned Contact::planes_of(const Candidate& c, std::span<const unsigned char> planes) const {
  if (planes.empty()) return 0;
  unsigned in = 7;
  for (const std::int32_t p : scene_->spots().with_nodes(c.point))
    if (p >= 0 && !rigid(p)) in &= planes[std::size_t(p)];
  return in;
}

// The first rigid corner of a pair holds its torque.
std::uint32_t Contact::torque_row(const Candidate& c) const {
  if (c.pair.offset == 0) return no_row;
  const auto first =
      std::find_if(c.point.begin(), c.point.end(), [this](std::int32_t p) { return rigid(p); });
  return first == c.point.end() ? no_row : row_of_[std::size_t(*first)];
}

void Contact::search(std::span<const Vec3> x) {
  outer_ = find(x, skins_.outer);
  outer_margin_.resize(outer_.size());
#pragma omp parallel for schedule(static) if (outer_.size() > 1024)
  for (std::size_t i = 0; i < outer_.size(); ++i) outer_margin_[i] = margin(outer_[i], x);
  at_search_.assign(x.begin(), x.end());
  ++searches_;
  refine(x, 0);
}

double Contact::margin(const Candidate& c, std::span<const Vec3> x) const {
  return gap_of(c, corners_of(c, x)) - law(c).gap() * c.whole;
}

// `since_search`: m, how much near gaps may have changed.
void Contact::refine(std::span<const Vec3> x, double since_search) {
  const double change = since_search + rounding * skins_.inner;
  std::vector<double> now(outer_margin_);
  if (since_search > 0) {
#pragma omp parallel for schedule(static) if (outer_.size() > 1024)
    for (std::size_t i = 0; i < outer_.size(); ++i)
      if (outer_margin_[i] - change < skins_.inner) now[i] = margin(outer_[i], x);
  }
  clear_lists();
  for (std::size_t i = 0; i < outer_.size(); ++i) {
    if (!(now[i] < skins_.inner)) continue;
    inner_.push_back(outer_[i]);
    margin_.push_back(now[i]);
  }
  at_refine_.assign(x.begin(), x.end());
  mark_checked(x, 0);
  tally_all(x);
  ++version_;
  index_slots();
}

void Contact::tally_all(std::span<const Vec3> x) {
  if (at_tally_.size() != x.size()) at_tally_.assign(x.begin(), x.end());
  tallies_ = false;
  idle_ = margin_;
#pragma omp parallel for schedule(static) if (inner_.size() > 256)
  for (std::size_t i = 0; i < inner_.size(); ++i) {
    Candidate& c = inner_[i];
    if (c.shared == 0) continue;
    tally(*scene_, at_tally_, c);
    idle_[i] = std::max(margin_[i], nothing_counts_for(c.pair, corners_of(c, x)));
  }
}

void Contact::clear_lists() {
  to_list(held_);
  to_list(tried_);
  inner_.clear();
  margin_.clear();
}

// For each point, the slots that hold forces on it, in the order of the pairs.
void Contact::index_slots() {
  forces_.resize(inner_.size());
  guards_.resize(inner_.size());
  guarded_.clear();
  active_.assign(inner_.size(), 0);
  known_.assign(inner_.size(), unknown);
  std::vector<std::uint32_t> count(scene_->reference().size() + 1, 0);
  const auto each = [&](const auto& visit) {
    for (std::size_t i = 0; i < inner_.size(); ++i) {
      const Candidate& c = inner_[i];
      if (c.spot.any())
        for (const std::int32_t p : c.spot.node) visit(p, 4 * i);
      for (std::size_t k = c.spot.any() ? 1 : 0; k < 4; ++k)
        if (c.point[k] >= 0) visit(c.point[k], 4 * i + k);
    }
  };
  each([&](std::int32_t p, std::size_t) { ++count[std::size_t(p) + 1]; });
  touched_.clear();
  for (std::size_t p = 0; p + 1 < count.size(); ++p) {
    if (count[p + 1] > 0) touched_.push_back(std::int32_t(p));
    count[p + 1] += count[p];
  }
  of_point_.resize(count.back());
  first_.clear();
  for (const std::int32_t p : touched_) first_.push_back(count[std::size_t(p)]);
  first_.push_back(count.back());
  std::vector<std::uint32_t> next(count.begin(), count.end() - 1);
  each(
      [&](std::int32_t p, std::size_t corner) { of_point_[next[std::size_t(p)]++] = std::uint32_t(corner); });
  row_of_.resize(count.size() - 1);
  for (std::size_t row = 0; row < touched_.size(); ++row)
    row_of_[std::size_t(touched_[row])] = std::uint32_t(row);
  rows_of_.resize(inner_.size());
  for (std::size_t i = 0; i < inner_.size(); ++i) {
    const Candidate& c = inner_[i];
    for (std::size_t k = 0; k < 4; ++k)
      rows_of_[i][k] =
          c.point[k] < 0 || scene_->spots().is(c.point[k]) ? no_row : row_of_[std::size_t(c.point[k])];
    rows_of_[i][4] = torque_row(c);
  }
  index_spots();
  at_point_.resize(touched_.size());
  index_places();
  make_batches();
}

// Rows of what is counted at the first corners of pairs, where these are contact points inside facets; their
// forces go to the nodes.
void Contact::index_spots() {
  const auto nodes = std::ptrdiff_t(touched_.size());
  node_rows_ = std::uint32_t(nodes);
  for (const Candidate& c : inner_)
    if (c.spot.any()) touched_.push_back(c.point[0]);
  if (touched_.size() == std::size_t(nodes)) return;
  std::sort(touched_.begin() + nodes, touched_.end());
  touched_.erase(std::unique(touched_.begin() + nodes, touched_.end()), touched_.end());
  first_.resize(touched_.size() + 1, first_.back());
  for (std::size_t i = 0; i < inner_.size(); ++i)
    if (inner_[i].spot.any())
      rows_of_[i][0] = std::uint32_t(
          std::lower_bound(touched_.begin() + nodes, touched_.end(), inner_[i].point[0]) - touched_.begin());
}

Totals Contact::add_forces(std::span<const Vec3> x, std::span<Vec3> force, const Way& way,
                           std::span<Vec3> torque) {
  prepare(x);
  const bool rubs = !way.start.empty();
  if (!rubs) torque = {};
  if (rubs) {
    tried_.begin(batches_.size());
    at_try_.clear();
    if (way.inverse_mass.empty() || (commits_ + 1) % tally_every == 0) at_try_.assign(x.begin(), x.end());
  }
  press_all(x, way, !torque.empty());
  Totals totals;
  totals.gap = narrowest_;
  totals.hard_gap = std::numeric_limits<double>::infinity();
  add_points(force, torque, rubs, totals);
  if (rubs) share_slips();
  return totals;
}

// Sums the slots that touch to the touched points from `from` to before `to`: for each point in the order of
// the slots, however many threads share the points.
void Contact::gather(std::size_t first_slot, std::size_t end, std::uint32_t from, std::uint32_t to,
                     bool torques) {
  for (std::size_t i = first_slot; i < end; ++i)
    if (active_[i] != 0) gather_slot(i, from, to, torques);
}

void Contact::gather_slot(std::size_t i, std::uint32_t from, std::uint32_t to, bool torques) {
  const PairForce& pair = forces_[i];
  const std::array<std::uint32_t, 5>& rows = rows_of_[i];
  const auto within = [from, to](std::uint32_t row) { return row >= from && row < to; };
  for (std::size_t k = 0; k < 4; ++k)
    if (within(rows[k]))
      for (int d = 0; d < 4; ++d) at_point_[rows[k]].force[d] += pair.on[k][d];
  if (rows[0] != no_row && rows[0] >= node_rows_) {
    const Spot& spot = inner_[i].spot;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t row = row_of_[std::size_t(spot.node[k])];
      if (!within(row)) continue;
      for (int d = 0; d < 3; ++d) at_point_[row].force[d] += spot.weight(k) * pair.on[0][d];
      at_point_[row].force[3] += pair.on[0][3];
    }
  }
  if (torques && within(rows[4]))
    at_point_[rows[4]].torque += Vec3(pair.torque[0], pair.torque[1], pair.torque[2]);
  if (!within(rows[0])) return;
  AtPoint& sum = at_point_[rows[0]];
  sum.energy[0] += pair.contact;
  sum.energy[1] += pair.stick;
  sum.energy[2] += pair.work;
  sum.energy[3] += pair.impact;
  sum.gap = std::min(sum.gap, pair.gap);
  ++sum.pairs;
  sum.slips += (active_[i] & facet_rubs) != 0 ? 1 : 0;
  if ((active_[i] & in_guard) == 0) return;
  const bool cloths = scene_->interactions()[std::size_t(inner_[i].interaction)].cloths;
  sum.guard += guards_[i].energy;
  sum.struck = sum.struck || (guards_[i].barrier.struck && !cloths);
  if (!eases(i)) sum.hard_gap = std::min(sum.hard_gap, pair.gap);
}

// Over all points and not only those in the lists, which depend on the skin.
void Contact::add_points(std::span<Vec3> force, std::span<Vec3> torque, bool rubs, Totals& totals) {
  if (rubs) tried_rubbing_.assign(scene_->reference().size(), 0);
  for (std::size_t row = 0; row < touched_.size(); ++row) {
    const AtPoint& sum = at_point_[row];
    if (const auto p = std::size_t(touched_[row]); p < force.size()) {
      force[p] += Vec3(sum.force[0], sum.force[1], sum.force[2]);
      if (!torque.empty()) torque[p] += sum.torque;
      if (rubs) tried_rubbing_[p] = sum.force[3];
    }
    totals.contact += sum.energy[0];
    totals.guard += sum.guard;
    totals.stick += sum.energy[1];
    totals.work += sum.energy[2];
    totals.impact += sum.energy[3];
    totals.gap = std::min(totals.gap, sum.gap);
    totals.hard_gap = std::min(totals.hard_gap, sum.hard_gap);
    totals.struck = totals.struck || sum.struck;
    totals.touching += sum.pairs;
  }
}

// Whether inertia meets the guard of the pair in a slot.
bool Contact::eases(std::size_t slot) const {
  const Interaction& it = scene_->interactions()[std::size_t(inner_[slot].interaction)];
  return eases(it) && !(it.cloths && guards_[slot].barrier.struck);
}

// An approach by a good part of the range within a planned step is an impact: inertia would err with its
// energy.
bool Contact::approaches_fast(const Candidate& c, const Force& force, const Corners& now,
                              const Way& way) const {
  if (way.start.empty()) return false;
  const Corners before = corners_of(c, way.start);
  Vec3 nearer = Vec3::Zero();
  for (std::size_t k = 0; k < 4; ++k) nearer -= force.barrier.weight[k] * (now[k] - before[k]);
  const double steps = way.dt > 0 ? std::max(1.0, planned_ / way.dt) : 1;
  return nearer.dot(force.barrier.normal) * steps >
         eased_approach * (law(c).gap() - law(c).floor()) * c.pair.scale;
}

// A body's corners do not give way, so that a pair's stiffness for one node, while all nodes of the pair move
// alike or against each other, is at most that times the node's weight: the weights on one side have the
// sum 1.
void Contact::barriers(
    const std::function<void(std::int32_t, double, const Vec3&, const BodySide&)>& visit) const {
  for (const std::uint32_t i : guarded_) {
    const Candidate& c = inner_[i];
    const Force::Barrier& barrier = guards_[i].barrier;
    const Interaction& it = scene_->interactions()[std::size_t(c.interaction)];
    if (!(barrier.stiffness > 0) || it.cloths || !eases(it)) continue;
    BodySide side;
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k)
      if (c.point[k] >= 0 && !(k == 0 && c.spot.any()) && rigid(c.point[k])) {
        side.point[k] = c.point[k];
        sum += side.share[k] = barrier.weight[k];
      }
    for (double& share : side.share) share /= sum;
    if (c.spot.any())
      for (std::size_t k = 0; k < 3; ++k)
        visit(c.spot.node[k], barrier.stiffness * c.spot.weight(k), barrier.normal, side);
    for (std::size_t k = c.spot.any() ? 1 : 0; k < 4; ++k)
      if (c.point[k] >= 0 && !rigid(c.point[k]) && barrier.weight[k] != 0)
        visit(c.point[k], barrier.stiffness * std::abs(barrier.weight[k]), barrier.normal, side);
  }
}

void Contact::barriers_between(const VisitBetween& visit) const {
  for (const std::uint32_t i : guarded_) {
    const Interaction& it = scene_->interactions()[std::size_t(inner_[i].interaction)];
    if (it.cloths && eases(i) && guards_[i].barrier.stiffness > 0) visit(inner_[i].point, guards_[i].barrier);
  }
}

// The slots of the pairs that are within reach.
std::vector<std::uint32_t> Contact::touching(std::span<const Vec3> x) const {
  const double change = change_ + rounding * skins_.inner;
  std::vector<char> touches(inner_.size(), 0);
  for_each_index(inner_.size(), inner_.size() > 256, [&](std::size_t i) {
    const Candidate& c = inner_[i];
    if (idle_[i] <= change) touches[i] = gap_of(c, corners_of(c, x)) < law(c).gap() * c.pair.scale ? 1 : 0;
  });
  std::vector<std::uint32_t> slots;
  for (std::size_t i = 0; i < inner_.size(); ++i)
    if (touches[i] != 0) slots.push_back(std::uint32_t(i));
  return slots;
}

Blocks Contact::wanted_of(const Candidate& c, const Wanted& wanted) {
  const auto corners = [&c](std::span<const char> points) {
    if (points.empty() || c.spot.any()) return Blocks().rows;
    unsigned out = 0;
    for (std::size_t k = 0; k < 4; ++k)
      out |= (c.point[k] >= 0 && points[std::size_t(c.point[k])] != 0 ? 1u : 0u) << k;
    return out;
  };
  return {corners(wanted.on), corners(wanted.by)};
}

// Threads share the pairs, some at a time, which are visited in their order.
void Contact::stiffness(std::span<const Vec3> x, const VisitStiffness& visit, const Way& way,
                        const Wanted& wanted) {
  constexpr std::size_t at_a_time = 256;
  prepare(x);
  const std::vector<std::uint32_t> slots = touching(x);
  const bool rubs = !way.start.empty();
  // Kept from call to call: a megabyte.
  thread_local std::vector<Matrix12> kept_k;
  thread_local std::vector<FrictionTangent> kept_friction;
  auto& k = kept_k;
  auto& friction = kept_friction;
  if (k.size() < std::min(at_a_time, slots.size())) k.resize(at_a_time);
  if (rubs && friction.empty()) friction.resize(at_a_time);
  const auto compute = [&](std::size_t slot, std::size_t place) {
    const Candidate& c = inner_[slot];
    const Interaction& it = scene_->interactions()[std::size_t(c.interaction)];
    const Corners corners = corners_of(c, x);
    const Blocks of = wanted_of(c, wanted);
    if (c.pair.kind == PairKind::edges && !segments_crossing(corners)) {
      k[place].setZero();
      if (rubs) friction[place] = {};
      return;
    }
    k[place] = pair_derivatives(it.law, c.pair, corners, of).hessian;
    if (!rubs || !it.rubs()) return;
    Slip slip;
    find_slip(slot, x, way, slip);
    friction[place] = friction_tangent(it.law, c.pair, corners, slip, of);
    k[place] -= friction[place].jacobian;
  };
  for (std::size_t from = 0; from < slots.size(); from += at_a_time) {
    const std::size_t n = std::min(at_a_time, slots.size() - from);
    for_each_index(n, n > 32, [&](std::size_t i) { compute(slots[from + i], i); });
    for (std::size_t i = 0; i < n; ++i) {
      const Candidate& c = inner_[slots[from + i]];
      const bool rubs_here = scene_->interactions()[std::size_t(c.interaction)].rubs();
      visit_in_nodes(c, k[i], !rubs || !rubs_here ? nullptr : &friction[i], visit);
    }
  }
}

// The stiffness of a pair whose first corner is inside a facet, by that facet's nodes and one corner of the
// body after the other, and then what two corners of the body have to do with each other.
void Contact::visit_in_nodes(const Candidate& c, const Matrix12& k, const FrictionTangent* friction,
                             const VisitStiffness& visit) {
  if (!c.spot.any()) return visit(c.point, k, friction);
  const auto block = [&k](int a, int b) { return k.block<3, 3>(3 * a, 3 * b); };
  // By the nodes, and the corner q in the last place.
  const auto in_nodes = [&c](const Matrix12& of, int q) {
    Matrix12 on = Matrix12::Zero();
    on.block<3, 3>(9, 9) = of.block<3, 3>(3 * q, 3 * q);
    for (int i = 0; i < 3; ++i) {
      const double w = c.spot.weight(std::size_t(i));
      on.block<3, 3>(3 * i, 9) = w * of.block<3, 3>(0, 3 * q);
      on.block<3, 3>(9, 3 * i) = w * of.block<3, 3>(3 * q, 0);
      for (int j = 0; j < 3 && q == 1; ++j)
        on.block<3, 3>(3 * i, 3 * j) = w * c.spot.weight(std::size_t(j)) * of.block<3, 3>(0, 0);
    }
    return on;
  };
  for (int q = 1; q < 4 && c.point[std::size_t(q)] >= 0; ++q) {
    FrictionTangent part;
    if (friction != nullptr) {
      part.apart = in_nodes(friction->apart, q);
      part.by_turn.bottomRows<3>() = friction->by_turn.middleRows<3>(3 * q);
      part.torque_by_x.rightCols<3>() = friction->torque_by_x.middleCols<3>(3 * q);
      if (q == 1) part.torque_by_turn = friction->torque_by_turn;
    }
    for (int i = 0; i < 3 && q == 1 && friction != nullptr; ++i) {
      const double w = c.spot.weight(std::size_t(i));
      part.by_turn.middleRows<3>(3 * i) = w * friction->by_turn.topRows<3>();
      part.torque_by_x.middleCols<3>(3 * i) = w * friction->torque_by_x.leftCols<3>();
    }
    const auto& node = c.spot.node;
    visit({node[0], node[1], node[2], c.point[std::size_t(q)]}, in_nodes(k, q),
          friction == nullptr ? nullptr : &part);
  }
  if (c.point[2] < 0) return;
  Matrix12 between = Matrix12::Zero();
  between.block<3, 3>(0, 3) = block(1, 2);
  between.block<3, 3>(3, 0) = block(2, 1);
  visit({c.point[1], c.point[2], -1, -1}, between, nullptr);
}

void Contact::couples(std::span<const Vec3> x,
                      const std::function<void(const std::array<std::int32_t, 4>&)>& visit) {
  prepare(x);
  for (const Candidate& c : inner_) visit(scene_->spots().with_nodes(c.point));
}

void Contact::mark_pressed(std::int32_t first, std::int32_t end, bool have, std::span<char> marked) const {
  for (std::size_t i = 0; i < inner_.size(); ++i) {
    if ((active_[i] & pressing) == 0) continue;
    const auto points = scene_->spots().with_nodes(inner_[i].point);
    if (std::any_of(points.begin(), points.end(), [&](auto p) { return p >= first && p < end; }) != have)
      continue;
    for (const auto p : points)
      if (p >= 0) marked[std::size_t(p)] = 1;
  }
}

double Contact::safe_fraction(std::span<const Vec3> x, std::span<const Vec3> by,
                              std::span<const char> among) const {
  std::vector<Vec3> end(x.begin(), x.end());
  for (std::size_t i = 0; i < end.size(); ++i) end[i] += by[i];
  double most = patches_.against_on_way(x, end);
  if (vertex_motion_bounds_surface_motion(x, end)) {
    Vec3 mean = Vec3::Zero();
    for (const Vec3& u : by) mean += u;
    mean /= double(by.size());
    double far = 0;
    for (const Vec3& u : by) far = std::max(far, (u - mean).norm());
    most = std::min(most, 2 * far);
  }
  most *= 1 + rounding;
  const OnWay way{x, by, most, among};
  if (lists_all_ && at_search_.size() == x.size() && vertex_motion_bounds_surface_motion(at_search_, x)) {
    const double room = room_of_way * most,
                 since = patches_.against(at_search_, x, room) + rounding * skins_.outer;
    if (since + room < skins_.outer + narrowest_at_first_) return share_of(way, outer_, outer_margin_, since);
  }
  return share_of(way, find(x, most, by));
}

// The inner list is of the end of the way, as of the last forces; what is there at its beginning may have
// come nearer by `most` since.
bool Contact::may_have_passed(std::span<const Vec3> x, std::span<const Vec3> by, double gap) {
  std::vector<Vec3> end(x.begin(), x.end());
  for (std::size_t i = 0; i < end.size(); ++i) end[i] += by[i];
  // If two points approach each other by `most`, each of them moves by half of it.
  const double most = patches_.against_on_way(x, end) * (1 + rounding);
  if (cannot_meet(most / 2, gap)) return false;
  const OnWay way{x, by, most, {}};
  const double since = change_ + most + rounding * skins_.inner;
  if (lists_all_ && since + room_of_way * most < skins_.inner + narrowest_at_first_)
    return share_of(way, inner_, margin_, since) < 1;
  return share_of(way, find(x, most, by)) < 1;
}

// margin: of each pair how far out of reach it was where `pairs` were listed; since: how much near gaps may
// have changed until the way begins, m.
double Contact::share_of(const OnWay& way, const std::vector<Candidate>& pairs,
                         std::span<const double> margin, double since) const {
  const auto other = [&way](std::int32_t p) { return p >= 0 && way.among[std::size_t(p)] == 0; };
  double share = 1;
#pragma omp parallel for schedule(static) reduction(min : share) if (pairs.size() > 64)
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Candidate& c = pairs[i];
    if (c.pair.scale == 0 || c.spot.any()) continue;  // crack faces that were never apart
    const double floor = law(c).floor() * c.pair.scale;
    if (!margin.empty() && margin[i] + law(c).gap() * c.whole - since - floor > room_of_way * way.most)
      continue;
    if (!way.among.empty() && std::any_of(c.point.begin(), c.point.end(), other)) continue;
    const Corners start = corners_of(c, way.x);
    if (!margin.empty() && gap_of(c, start) >= reach_on_way(c, law(c), way.by, way.most)) continue;
    const Corners step = corners_of(c, way.by);
    Corners end;
    for (std::size_t k = 0; k < 4; ++k) end[k] = start[k] + step[k];
    share = std::min(share, safe_fraction_of(c, law(c), start, end));
  }
  return share;
}

Contact::AtPoints Contact::at_points(std::span<const Vec3> x) const {
  AtPoints out{std::vector<double>(x.size(), widest_), std::vector<double>(x.size(), 0)};
  for (std::size_t row = 0; row < touched_.size(); ++row) {
    const std::int32_t p = touched_[row];
    if (scene_->spots().is(p)) break;
    Vec3 normal = Vec3::Zero();
    for (const std::int32_t t : scene_->triangles_at_point(p)) {
      const Triangle& n = scene_->triangles()[std::size_t(t)].nodes;
      const Vec3& a = x[std::size_t(n[0])];
      normal += (x[std::size_t(n[1])] - a).cross(x[std::size_t(n[2])] - a);
    }
    Vec3 face[2] = {Vec3::Zero(), Vec3::Zero()};
    for (std::uint32_t k = first_[row]; k < first_[row + 1]; ++k) {
      const std::uint32_t slot = of_point_[k] / 4;
      if (active_[slot] == 0) continue;
      const PairForce& pair = forces_[slot];
      const double energy = pair.contact + ((active_[slot] & in_guard) != 0 ? guards_[slot].energy : 0);
      out.gap[std::size_t(p)] = std::min(out.gap[std::size_t(p)], pair.gap);
      // A pair with a negative weight, which corrects for others that count twice, pulls instead of pushing.
      const Candidate& c = inner_[slot];
      const double* const on = pair.on[of_point_[k] % 4];
      Vec3 f(on[0], on[1], on[2]);
      if (c.spot.any() && of_point_[k] % 4 == 0)
        f *= c.spot.weight(
            std::size_t(std::find(c.spot.node.begin(), c.spot.node.end(), p) - c.spot.node.begin()));
      face[(f.dot(normal) < 0) == (energy < 0) ? 0 : 1] += f;
    }
    const double area = scene_->area(p);
    if (area > 0) out.pressure[std::size_t(p)] = (face[0].norm() + face[1].norm()) / area;
  }
  return out;
}

std::vector<Contact::Overlap> Contact::overlaps(std::span<const Vec3> x) const {
  std::vector<Overlap> found;
  for (const Candidate& c : find(x, 0)) {
    if (c.spot.any()) continue;  // its facet or an edge of that tells the same
    const double gap = gap_of(c, corners_of(c, x));
    if (gap <= law(c).floor() * c.pair.scale) found.push_back({c.point, gap});
  }
  for (const Overlap& crossing : crossings(x, 0)) found.push_back(crossing);
  return found;
}

std::vector<Contact::Overlap> Contact::crossings(std::span<const Vec3> x, double least) const {
  std::vector<Overlap> found;
  std::vector<Edge> edges;
  std::vector<Triangle> triangles;
  for (const EdgeRow& e : scene_->edges()) edges.push_back({e.a, e.b});
  for (const TriangleRow& t : scene_->triangles()) triangles.push_back(t.nodes);
  for (const auto& [e, t] : intersections(x, edges, triangles)) {
    const EdgeRow& edge = scene_->edges()[e];
    const TriangleRow& triangle = scene_->triangles()[t];
    const Interaction* const meet = scene_->between(edge.surface, triangle.surface);
    if (meet == nullptr) continue;
    // Sides that a seam holds together have a place in common, as those that share a corner.
    const Neighbours& near = scene_->neighbours();
    const auto sewn = [&](std::int32_t end) {
      return std::any_of(triangle.nodes.begin(), triangle.nodes.end(), [&](std::int32_t corner) {
        const bool parted = near.apart(end) >= 0 && near.apart(corner) >= 0;
        return near.are_sewn(end, corner) && !(parted && least > 0);
      });
    };
    if (sewn(edge.a) || sewn(edge.b)) continue;
    const auto& [p, q, r] = triangle.nodes;
    const Vec3 normal =
        (x[std::size_t(q)] - x[std::size_t(p)]).cross(x[std::size_t(r)] - x[std::size_t(p)]).normalized();
    const auto height = [&](std::int32_t end) {
      return std::abs(normal.dot(x[std::size_t(end)] - x[std::size_t(p)]));
    };
    const double depth = std::min(height(edge.a), height(edge.b));
    if (!(depth < least * meet->law.gap())) found.push_back({{edge.a, edge.b, p, r}, -depth});
  }
  return found;
}

Contact::Overlap Contact::nearest(std::span<const Vec3> x) {
  prepare(x);
  Overlap found{{-1, -1, -1, -1}, widest_};
  for (const Candidate& c : inner_) {
    const double gap = gap_of(c, corners_of(c, x)), scale = c.pair.scale;
    if (gap >= law(c).gap() * scale || gap - law(c).floor() * scale >= found.gap) continue;
    found = {scene_->spots().with_nodes(c.point), gap - law(c).floor() * scale};
  }
  return found;
}

}  // namespace fabricsh::contact
