// Batches of pairs have the bits of the same pairs one by one, with every instruction set.
#include <random>

#include "catch.hpp"
#include "contact/batch.hpp"
#include "contact/law.hpp"
#include "contact/pair.hpp"

using namespace fabricsh;
using namespace fabricsh::contact;

namespace {

const ContactLaw stiff_law({1e-3, 0.2e-3, 2e9});

struct Case {
  Pair pair;
  Corners x;
  Slip slip;
};

// Corners of a pair at a distance around the gap, above or beside each other.
Case random_case(PairKind kind, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto about = [&](const Vec3& at, double size) {
    return Vec3(at + size * Vec3(unit(random), unit(random), 0.1 * unit(random)));
  };
  Case c;
  c.pair.kind = kind;
  c.pair.area = 1e-5 * (1.5 + unit(random));
  c.pair.scale = unit(random) > 0 ? 1 : 0.8;
  c.pair.fading = {kind == PairKind::edges, 0.1, 0.15};
  c.pair.edge = {-1, 0, -1};
  c.pair.corner = {1, 0, 0};
  const double h = 0.7e-3 * (1 + 0.6 * unit(random));
  if (kind == PairKind::edges)
    c.x = {about({-3e-3, 0, h}, 1e-3), about({3e-3, 0, h}, 1e-3), about({0, -3e-3, 0}, 1e-3),
           about({0, 3e-3, 0}, 1e-3)};
  else
    c.x = {about({1e-3, 1e-3, h}, 2e-3), about({0, 0, 0}, 1e-4), about({5e-3, 0, 0}, 1e-4),
           about({0, 5e-3, 0}, 1e-4)};
  Slip& s = c.slip;
  s.friction = 0.3;
  s.sticking = unit(random) > 0 ? 0.4 : 0.3;
  s.stiffness = 2.0 / 7 * stiff_law.stiffest();
  s.loss = 0.1;
  s.dt = s.step = 1e-6;
  s.moved = {about({0, 0, 0}, 1e-6), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  if (kind == PairKind::edges) s.moved[1] = about({0, 0, 0}, 1e-6);
  s.held = about({0, 0, 0}, 2e-6);
  s.pull = about({0, 0, 0}, 1e-3);
  s.damped = std::abs(unit(random));
  s.slides = unit(random) > 0 ? 1 : 0.5 + unit(random) / 2;
  for (std::size_t k = 0; k < 4; ++k) {
    s.crowd[k] = unit(random) > 0 ? 1 : 1.5;
    s.inverse_mass[k] = s.crowd[k] * (k == 2 ? 0 : 1e5);
  }
  return c;
}

struct Counts {
  int touching = 0, special = 0, apart = 0;
};

// A batch with points of its own.
struct Packed {
  BatchPairs pairs{};
  BatchPoint points[4 * lanes]{};
  BatchMemory held{}, tried{};
  PairForce forces[lanes]{};

  void put(int lane, Case& c) {
    for (std::size_t k = 0; k < 4; ++k) {
      const auto row = std::uint32_t(4 * lane) + std::uint32_t(k);
      BatchPoint& point = points[row];
      for (int d = 0; d < 3; ++d) {
        point.x[d] = c.x[k][d];
        point.start[d] = c.x[k][d] - c.slip.moved[k][d];
        // What the batch takes the motion from is a difference of places.
        c.slip.moved[k][d] = point.x[d] - point.start[d];
      }
      point.inverse_mass = c.slip.inverse_mass[k];
      point.crowd = c.slip.crowd[k];
      pairs.corner[k][lane] = row;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      pairs.at_edge[k][lane] = c.pair.edge[k];
      pairs.at_corner[k][lane] = c.pair.corner[k];
    }
    pairs.slot[lane] = std::uint32_t(lanes - 1 - lane);
    pairs.area[lane] = c.pair.area;
    pairs.scale[lane] = c.pair.scale;
    pairs.zone[0][lane] = c.pair.fading.first;
    pairs.zone[1][lane] = c.pair.fading.second;
    for (int d = 0; d < 3; ++d) {
      held.slip[d][lane] = c.slip.held[d];
      held.pull[d][lane] = c.slip.pull[d];
    }
    held.damped[lane] = c.slip.damped;
    held.slides[lane] = c.slip.slides;
  }
};

void check(const Case& c, const Packed& batch, int lane) {
  const Force one = pair_force(stiff_law, c.pair, c.x, &c.slip);
  const PairForce& out = batch.forces[batch.pairs.slot[lane]];
  CHECK(one.active);
  for (std::size_t k = 0; k < 4; ++k) {
    for (int d = 0; d < 3; ++d) CHECK(out.on[k][d] == one.on[k][d]);
    CHECK(out.on[k][3] == one.resists[k]);
  }
  for (int d = 0; d < 3; ++d) {
    CHECK(batch.tried.pull[d][lane] == one.pull[d]);
    CHECK(out.torque[d] == one.torque[d]);
    if (c.pair.kind != PairKind::edges) CHECK(batch.tried.slip[d][lane] == one.slip[d]);
  }
  CHECK(out.contact == one.contact);
  CHECK(one.guard == 0);
  CHECK(out.gap == one.gap);
  CHECK(batch.tried.gap[lane] == one.gap);
  CHECK(out.stick == one.stick);
  CHECK(batch.tried.damped[lane] == one.damped);
  CHECK(out.work == one.work);
  CHECK(out.impact == one.impact);
  CHECK(batch.tried.slides[lane] == Approx(one.slides).epsilon(1e-9));
}

void compare(PairKind kind, BatchKind batch_kind, const BatchPress press, Counts& counts) {
  std::mt19937 random(7);
  for (int repeat = 0; repeat < 200; ++repeat) {
    Packed batch;
    std::vector<Case> cases;
    Case wall;  // planes: all lanes meet the same one
    for (int lane = 0; lane < lanes; ++lane) {
      Case c = random_case(kind, random);
      if (lane == 0) wall = c;
      if (kind == PairKind::plane)
        for (std::size_t k = 1; k < 4; ++k) {
          c.x[k] = wall.x[k];
          c.slip.inverse_mass[k] = wall.slip.inverse_mass[k];
          c.slip.crowd[k] = wall.slip.crowd[k];
        }
      c.slip.sticking = 0.4;
      batch.put(lane, c);
      cases.push_back(c);
    }
    const BatchLaw common{batch_kind,
                          &stiff_law.knots().front().gap,
                          int(stiff_law.knots().size()),
                          stiff_law.gap(),
                          stiff_law.floor(),
                          stiff_law.guard_gap(),
                          stiff_law.stiffest(),
                          0,
                          true,
                          true,
                          0.3,
                          0.4,
                          2.0 / 7 * stiff_law.stiffest(),
                          0.1,
                          1e-6,
                          {}};
    // One lane held no slip before.
    unsigned asked = 0;
    const BatchTouch touch =
        press(common, batch.pairs,
              {batch.points, 0xfe, &batch.held, &batch.tried, batch.forces,
               [](void* who, unsigned of_lanes) { *static_cast<unsigned*>(who) |= of_lanes; }, &asked});
    CHECK(asked == (touch.touching & 1u));
    for (int lane = 0; lane < lanes; ++lane) {
      const bool touching = (touch.touching >> lane & 1) != 0, special = (touch.special >> lane & 1) != 0;
      ++(special ? counts.special : touching ? counts.touching : counts.apart);
      const Case& c = cases[std::size_t(lane)];
      if (touching)
        check(c, batch, lane);
      else
        CHECK((special || !pair_force(stiff_law, c.pair, c.x, &c.slip).active));
    }
  }
}

}  // namespace

TEST_CASE("a batch of pairs has the bits of its pairs") {
  const std::pair<PairKind, BatchKind> kinds[] = {{PairKind::facet, BatchKind::facet},
                                                  {PairKind::edges, BatchKind::edges},
                                                  {PairKind::plane, BatchKind::plane}};
  for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512})
    for (const auto& [kind, batch] : kinds) {
      if (isa > best_isa()) continue;
      CAPTURE(name(isa), int(kind));
      Counts counts;
      compare(kind, batch, batch_press(isa), counts);
      CHECK(counts.touching > 200);
      CHECK(counts.apart > 100);
      CHECK(counts.special > 50);
    }
}
