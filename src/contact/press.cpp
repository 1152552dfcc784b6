// Forces of the pairs in the list: most in batches, all others one by one.
#include <omp.h>

#include <algorithm>
#include <bit>

#include "base/shares.hpp"
#include "contact/contact.hpp"

namespace fabricsh::contact {
namespace {

constexpr std::int32_t kinds = 3;   // of batches
constexpr std::size_t chunk = 512;  // slots that are taken together: their forces stay in the cache
constexpr double ranks = 4;         // pairs of a batch are about as near: by so many parts of a skin

std::optional<BatchKind> batch_kind(const Candidate& c) {
  if (c.spot.any()) return {};
  if (c.pair.kind == PairKind::facet) return BatchKind::facet;
  if (c.pair.kind == PairKind::edges) return BatchKind::edges;
  if (c.pair.kind == PairKind::plane) return BatchKind::plane;
  return {};
}

template <class Visit>
void each_lane(unsigned of_lanes, Visit visit) {
  for (; of_lanes != 0; of_lanes &= of_lanes - 1) visit(std::countr_zero(of_lanes));
}

}  // namespace

// The slip of the pair in a slot.
class Contact::OfSlot final : public SlipSource {
 public:
  OfSlot(Contact& contact, std::size_t slot, std::span<const Vec3> x, const Way& way)
      : contact_(contact), slot_(slot), x_(x), way_(way) {}
  void find(Slip& slip) const override { contact_.find_slip(slot_, x_, way_, slip); }

 private:
  Contact& contact_;
  const std::size_t slot_;
  const std::span<const Vec3> x_;
  const Way& way_;
};

void Contact::press(std::size_t i, std::span<const Vec3> x, const Way& way) {
  const Candidate& c = inner_[i];
  const Interaction& it = scene_->interactions()[std::size_t(c.interaction)];
  const OfSlot slips(*this, i, x, way);
  const bool rubs = !way.start.empty() && it.rubs();
  const Corners corners = corners_of(c, x);
  Force force;
  active_[i] = 0;
  if (!find_force(it.law, c.pair, corners, rubs ? &slips : nullptr, force)) return;
  active_[i] = pressing;
  if (rubs) {
    active_[i] |= c.pair.kind == PairKind::facet ? rubbing | facet_rubs : rubbing;
    keep_slip(i, corners, way, force);
  }
  if (force.guard != 0) {
    active_[i] |= in_guard;
    force.barrier.struck = it.eased && approaches_fast(c, force, corners, way);
    guards_[i] = {force.guard, force.barrier};
  }
  PairForce& out = forces_[i];
  for (std::size_t k = 0; k < 4; ++k) {
    std::copy_n(force.on[k].data(), 3, out.on[k]);
    out.on[k][3] = force.resists[k];
  }
  out.contact = force.contact;
  out.stick = force.stick;
  out.work = force.work;
  out.impact = force.impact;
  out.gap = force.gap;
  std::copy_n(force.torque.data(), 3, out.torque);
}

// --- batches

// Pairs that are about as near stand side by side, so that batches touch or do not.
void Contact::make_batches() {
  batches_.clear();
  pairs_.clear();
  first_batch_.clear();
  place_.resize(inner_.size());
  std::vector<std::uint32_t> slots;
  std::vector<std::int32_t> law(inner_.size());
  std::vector<double> rank(inner_.size());
  for (std::size_t i = 0; i < inner_.size(); ++i) {
    rank[i] = std::max(0.0, std::ceil(ranks * idle_[i] / skins_.inner));
    const auto kind = batch_kind(inner_[i]);
    law[i] = kind ? kinds * inner_[i].interaction + std::int32_t(*kind) : -1;
  }
  for (std::size_t from = 0; from < inner_.size(); from += chunk) {
    first_batch_.push_back(std::uint32_t(batches_.size()));
    slots.resize(std::min(chunk, inner_.size() - from));
    for (std::size_t i = 0; i < slots.size(); ++i) slots[i] = std::uint32_t(from + i);
    std::stable_sort(slots.begin(), slots.end(), [&](std::uint32_t a, std::uint32_t b) {
      return law[a] != law[b] ? law[a] < law[b] : rank[a] < rank[b];
    });
    int lane = lanes;
    for (const std::uint32_t i : slots) {
      if (lane == lanes || batches_.back().law != law[i]) {
        batches_.push_back({idle_[i], inner_[i].pair.offset, law[i]});
        pairs_.emplace_back();
        for (lane = lanes; lane-- > 1;) put_pair(i, lane, pairs_.back());
        lane = 0;
      }
      Batch& batch = batches_.back();
      put_pair(i, lane, pairs_.back());
      place_[i] = std::uint32_t(lanes * (batches_.size() - 1) + std::size_t(lane));
      batch.any |= 1u << lane++;
      batch.least = std::min(batch.least, idle_[i]);
    }
  }
  first_batch_.push_back(std::uint32_t(batches_.size()));
}

void Contact::put_pair(std::uint32_t slot, int lane, BatchPairs& batch) const {
  const Pair& pair = inner_[slot].pair;
  batch.slot[lane] = slot;
  batch.area[lane] = pair.area;
  batch.scale[lane] = pair.scale;
  batch.zone[0][lane] = pair.fading.first;
  batch.zone[1][lane] = pair.fading.second;
  for (std::size_t k = 0; k < 4; ++k) batch.corner[k][lane] = rows_of_[slot][k];
  for (std::size_t k = 0; k < 3; ++k) {
    batch.at_edge[k][lane] = pair.edge[k];
    batch.at_corner[k][lane] = pair.corner[k];
  }
}

void Contact::place_points(std::span<const Vec3> x, const Way& way) {
  points_.resize(node_rows_);
  for_each_index(node_rows_, node_rows_ > 4096, [&](std::uint32_t row) {
    const auto p = std::size_t(touched_[row]);
    BatchPoint& out = points_[row];
    std::copy_n(x[p].data(), 3, out.x);
    std::copy_n(way.start[p].data(), 3, out.start);
    out.crowd = crowd_at(p);
    out.inverse_mass = way.inverse_mass[p] * out.crowd;
  });
}

// Of one thread.
class Contact::Batches {
 public:
  Batches(Contact& contact, std::span<const BatchLaw> laws, std::span<const Vec3> x, const Way& way)
      : contact_(contact), kernel_(batch_press(best_isa())), laws_(laws), x_(x), way_(way) {}

  void press(std::size_t number, double change) {
    Batch& batch = contact_.batches_[number];
    const unsigned before = std::exchange(batch.active, 0);
    if (batch.least > change) {
      if (before != 0) mark(number, before, 0);
    } else if (laws_.empty() || batch.law < 0 || laws_[std::size_t(batch.law)].count == 0) {
      each_lane(batch.any, [&](int lane) { alone(number, lane); });
    } else {
      press(number, before);
    }
  }

 private:
  void press(std::size_t number, unsigned before) {
    Batch& batch = contact_.batches_[number];
    BatchLaw law = laws_[std::size_t(batch.law)];
    law.offset = batch.offset;
    number_ = number;
    const Memory& memory = contact_.held_;
    const auto find = [](void* who, unsigned of_lanes) {
      auto& self = *static_cast<Batches*>(who);
      self.contact_.find_held(self.contact_.pairs_[self.number_], of_lanes, *self.held_);
    };
    held_ = memory.by_lane ? &contact_.held_.lane[number] : &none_;
    const BatchTouch touch =
        kernel_(law, contact_.pairs_[number],
                {contact_.points_.data(), memory.by_lane ? memory.lanes_used[number] : 0u, held_,
                 &contact_.tried_.lane[number], contact_.forces_.data(), find, this});
    batch.active = touch.touching & batch.any;
    if (law.rubs) contact_.tried_.lanes_used[number] = batch.active;
    mark(number, before & ~batch.active, 0);
    mark(number, batch.active,
         !law.rubs                      ? pressing
         : law.kind == BatchKind::facet ? pressing | rubbing | facet_rubs
                                        : pressing | rubbing);
    each_lane(touch.special & batch.any, [&](int lane) { alone(number, lane); });
  }
  void alone(std::size_t number, int lane) {
    const std::uint32_t slot = contact_.pairs_[number].slot[lane];
    contact_.press(slot, x_, way_);
    if (contact_.active_[slot] != 0) contact_.batches_[number].active |= 1u << lane;
  }
  void mark(std::size_t number, unsigned of_lanes, int as) {
    each_lane(of_lanes, [&](int lane) { contact_.active_[contact_.pairs_[number].slot[lane]] = char(as); });
  }

  Contact& contact_;
  const BatchPress kernel_;
  std::span<const BatchLaw> laws_;
  std::span<const Vec3> x_;
  const Way& way_;
  std::size_t number_ = 0;  // of the batch at hand
  BatchMemory* held_ = nullptr;
  BatchMemory none_;
};

// One thread sums the forces of pairs while they are at hand; several share the points afterwards.
void Contact::press_all(std::span<const Vec3> x, const Way& way, bool torques) {
  const double change = change_ + rounding * skins_.inner;  // pairs beyond it are still out of reach
  const std::size_t n = inner_.size();
  const auto rows = std::uint32_t(touched_.size());
  const int parts = n > 256 ? omp_get_max_threads() : 1;
  const std::vector<BatchLaw> laws = laws_of_batches(way);
  if (!laws.empty()) place_points(x, way);
  std::fill(at_point_.begin(), at_point_.end(), AtPoint());
  const auto press_chunk = [&](Batches& batches, std::size_t number) {
    for (std::size_t b = first_batch_[number]; b < first_batch_[number + 1]; ++b) batches.press(b, change);
  };
  const std::size_t chunks = (n + chunk - 1) / chunk;
  if (parts == 1) {
    Batches batches(*this, laws, x, way);
    for (std::size_t i = 0; i < chunks; ++i) {
      press_chunk(batches, i);
      gather(i * chunk, std::min(n, (i + 1) * chunk), 0, rows, torques);
    }
  } else {
#pragma omp parallel num_threads(parts)
    {
      Batches batches(*this, laws, x, way);
#pragma omp for schedule(static)
      for (std::size_t i = 0; i < chunks; ++i) press_chunk(batches, i);
    }
#pragma omp parallel for schedule(static, 1)
    for (int part = 0; part < parts; ++part) {
      const auto share = [&](int p) {
        return std::uint32_t(std::uint64_t(rows) * std::uint64_t(p) / std::uint64_t(parts));
      };
      gather(0, n, share(part), share(part + 1), torques);
    }
  }
  guarded_.clear();
  for (std::size_t i = 0; i < n; ++i)
    if ((active_[i] & in_guard) != 0) guarded_.push_back(std::uint32_t(i));
}

}  // namespace fabricsh::contact
