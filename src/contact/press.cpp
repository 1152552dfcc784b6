// Forces of the pairs in the list: plain ones in batches, all others one by one.
#include <omp.h>

#include <algorithm>

#include "contact/contact.hpp"

namespace fabricsh::contact {
namespace {

constexpr double rounding = 1e-9;      // as in contact.cpp
constexpr double clearly = 1 + 1e-8;   // of a squared distance that batches leave out
constexpr std::size_t kinds = 3;       // of batches
constexpr std::ptrdiff_t chunk = 512;  // slots whose plain pairs are sorted into batches at a time

std::optional<BatchKind> batch_kind(PairKind kind) {
  if (kind == PairKind::facet) return BatchKind::facet;
  if (kind == PairKind::edges) return BatchKind::edges;
  if (kind == PairKind::plane) return BatchKind::plane;
  return {};
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

bool Contact::press(std::size_t i, std::span<const Vec3> x, const Way& way) {
  const Candidate& c = inner_[i];
  const Interaction& it = scene_->interactions()[std::size_t(c.interaction)];
  const OfSlot slips(*this, i, x, way);
  const bool rubs = !way.start.empty() && it.rubs();
  const Corners corners = corners_of(c, x);
  if (!find_force(it.law, c.pair, corners, rubs ? &slips : nullptr, slots_[i])) return false;
  active_[i] = rubs ? rubbing : pressing;
  if (rubs) {
    keep_slip(i, corners, way);
    hold(i);
  }
  Force& force = slots_[i];
  force.barrier.struck = force.guard != 0 && it.eased && approaches_fast(c, force, corners, way);
  return true;
}

// --- batches

void Contact::find_plain() {
  batch_of_.assign(inner_.size(), -1);
  far_.resize(inner_.size());
  for (std::size_t i = 0; i < inner_.size(); ++i) {
    const Candidate& c = inner_[i];
    const auto kind = batch_kind(c.pair.kind);
    if (!kind || c.spot.any()) continue;
    const double reach = law(c).gap() * c.pair.scale + c.pair.offset;
    far_[i] = reach * reach * clearly;
    batch_of_[i] = std::int32_t(kinds) * c.interaction + std::int32_t(*kind);
  }
}

// Of one thread: the plain pairs of some slots, collected by their laws.
class Contact::Batches {
 public:
  Batches(Contact& contact, const BatchKernels& kernels, std::span<const BatchLaw> laws,
          std::span<const Vec3> x, const Way& way)
      : contact_(contact), kernels_(kernels), laws_(laws), x_(x), way_(way), waiting_(laws.size()) {}

  void press(std::size_t from, std::size_t to, double change) {
    for (std::size_t i = from; i < to; ++i) {
      contact_.active_[i] = 0;
      if (contact_.margin_[i] > change) continue;
      const std::int32_t law = contact_.batch_of_[i];
      if (law < 0 || laws_.empty() || laws_[std::size_t(law)].count == 0)
        contact_.press(i, x_, way_);
      else if (laws_[std::size_t(law)].kind == BatchKind::plane)
        add(i);
      else
        look_at(i);
    }
    look();
    for (std::size_t law = 0; law < waiting_.size(); ++law)
      if (waiting_[law].count > 0) press(law);
  }

 private:
  struct Row {
    std::uint32_t slot[lanes] = {};
    int count = 0;
  };

  void look_at(std::size_t i) {
    const BatchKind kind = laws_[std::size_t(contact_.batch_of_[i])].kind;
    if (near_.count == lanes || kind != kind_) look();
    kind_ = kind;
    near_.slot[near_.count++] = std::uint32_t(i);
  }
  // Those of the pairs at hand that are near go on.
  void look() {
    if (near_.count == 0) return;
    for (int lane = 0; lane < lanes; ++lane) {
      const std::uint32_t i = near_.slot[lane < near_.count ? lane : 0];
      put(contact_.corners_of_[i], lane, x_, pairs_.x);
      far_[lane] = contact_.far_[i];
    }
    const unsigned near = kernels_.near(kind_, pairs_.x, far_);
    for (int lane = 0; lane < near_.count; ++lane)
      if ((near >> lane & 1) != 0) add(near_.slot[lane]);
    near_.count = 0;
  }
  void add(std::size_t i) {
    Row& row = waiting_[std::size_t(contact_.batch_of_[i])];
    row.slot[row.count++] = std::uint32_t(i);
    if (row.count == lanes) press(std::size_t(contact_.batch_of_[i]));
  }

  static void put(const std::array<std::int32_t, 4>& points, int lane, std::span<const Vec3> from,
                  ByCorner& to) {
    for (std::size_t k = 0; k < 4; ++k)
      for (int d = 0; d < 3; ++d) to[k][d][lane] = from[std::size_t(points[k])][d];
  }

  void press(std::size_t row) {
    Row& waiting = waiting_[row];
    BatchLaw law = laws_[row];
    law.offset = contact_.inner_[waiting.slot[0]].pair.offset;
    for (int lane = 0; lane < lanes; ++lane)
      fill(waiting.slot[lane < waiting.count ? lane : 0], lane, law.coulomb || law.loss > 0);
    kernels_.press(law, pairs_, out_);
    for (int lane = 0; lane < waiting.count; ++lane) {
      const std::uint32_t i = waiting.slot[lane];
      if ((out_.touching >> lane & 1) != 0)
        take(i, lane, law);
      else if ((out_.special >> lane & 1) != 0)
        contact_.press(i, x_, way_);
    }
    waiting.count = 0;
  }

  void fill(std::size_t i, int lane, bool rubs) {
    const Candidate& c = contact_.inner_[i];
    put(c.point, lane, x_, pairs_.x);
    pairs_.area[lane] = c.pair.area;
    pairs_.scale[lane] = c.pair.scale;
    pairs_.zone[0][lane] = c.pair.fading.first;
    pairs_.zone[1][lane] = c.pair.fading.second;
    if (!rubs) return;
    put(c.point, lane, way_.start, pairs_.start);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto p = std::size_t(c.point[k]);
      const double crowd = contact_.crowd_at(p);
      pairs_.crowd[k][lane] = crowd;
      pairs_.inverse_mass[k][lane] = way_.inverse_mass[p] * crowd;
    }
    const Held* const held = contact_.held_by(i);
    const Memory& before = contact_.held_;
    const bool own =
        held != nullptr && (before.by_place ? held == &before.held[contact_.place_[i]] : held->is(c));
    for (int d = 0; d < 3; ++d) {
      pairs_.held[d][lane] = held != nullptr ? held->slip[d] : 0;
      pairs_.pull[d][lane] = own ? held->pull[d] : 0;
    }
    pairs_.damped[lane] = own ? held->damped : 0;
    pairs_.slides[lane] = held != nullptr && held->slides ? 1 : 0;
  }

  void take(std::size_t i, int lane, const BatchLaw& law) {
    contact_.active_[i] = law.rubs ? rubbing : pressing;
    Force& force = contact_.slots_[i];
    const auto vector = [lane](const ByLane* v) { return Vec3(v[0][lane], v[1][lane], v[2][lane]); };
    for (std::size_t k = 0; k < 4; ++k) force.on[k] = vector(out_.on[k]);
    force.contact = out_.contact[lane];
    force.gap = out_.gap[lane];
    force.guard = 0;
    force.active = true;
    force.barrier.stiffness = 0;
    force.barrier.struck = false;
    if (!law.rubs) {
      force.stick = force.work = force.impact = 0;
      force.torque.setZero();
      return;
    }
    force.stick = out_.stick[lane];
    force.work = out_.work[lane];
    force.impact = out_.impact[lane];
    force.torque = vector(out_.torque);
    force.slip = vector(out_.slip);
    force.pull = vector(out_.pull);
    force.damped = out_.damped[lane];
    force.slides = out_.slides[lane] != 0;
    for (std::size_t k = 0; k < 4; ++k) force.resists[k] = out_.resists[k][lane];
    contact_.hold(i);
  }

  Contact& contact_;
  const BatchKernels& kernels_;
  std::span<const BatchLaw> laws_;
  std::span<const Vec3> x_;
  const Way& way_;
  std::vector<Row> waiting_;  // by law
  Row near_;
  BatchKind kind_ = BatchKind::facet;
  ByLane far_;
  BatchPairs pairs_{};  // what is not asked for stays zero
  BatchForces out_;
};

// One thread sums the forces of a pair while they are at hand; several share the points afterwards.
void Contact::press_all(std::span<const Vec3> x, const Way& way, bool torques) {
  const double change = change_ + rounding * skins_.inner;  // pairs beyond it are still out of reach
  const auto n = std::ptrdiff_t(inner_.size());
  const auto rows = std::uint32_t(touched_.size());
  const int parts = n > 256 ? omp_get_max_threads() : 1;
  const BatchKernels kernels = batch_kernels(best_isa());
  const std::vector<BatchLaw> laws = laws_of_batches(way);
  const auto end = [n](std::ptrdiff_t from) { return std::size_t(std::min(from + chunk, n)); };
  in_use_.clear();
  if (parts == 1) {
    std::fill(at_point_.begin(), at_point_.end(), AtPoint());
    Batches batches(*this, kernels, laws, x, way);
    for (std::ptrdiff_t from = 0; from < n; from += chunk) {
      batches.press(std::size_t(from), end(from), change);
      for (std::size_t i = std::size_t(from); i < end(from); ++i) {
        if (active_[i] == 0) continue;
        in_use_.push_back(std::uint32_t(i));
        gather_slot(std::uint32_t(i), 0, rows, torques);
      }
    }
    return;
  }
#pragma omp parallel num_threads(parts)
  {
    Batches batches(*this, kernels, laws, x, way);
#pragma omp for schedule(static)
    for (std::ptrdiff_t from = 0; from < n; from += chunk)
      batches.press(std::size_t(from), end(from), change);
  }
  for (std::size_t i = 0; i < active_.size(); ++i)
    if (active_[i] != 0) in_use_.push_back(std::uint32_t(i));
#pragma omp parallel for schedule(static, 1)
  for (int part = 0; part < parts; ++part) {
    const auto share = [&](int p) {
      return std::uint32_t(std::uint64_t(rows) * std::uint64_t(p) / std::uint64_t(parts));
    };
    gather(share(part), share(part + 1), torques);
  }
}

}  // namespace fabricsh::contact
