// Batches of pairs have the bits of the same pairs one by one, with every instruction set.
#include <random>

#include "catch.hpp"
#include "contact/batch.hpp"
#include "contact/law.hpp"
#include "contact/pair.hpp"

using namespace fabricsh;
using namespace fabricsh::contact;

namespace {

const ContactLaw law({1e-3, 0.2e-3, 2e9});

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
  s.stiffness = 2.0 / 7 * law.stiffest();
  s.loss = 0.1;
  s.dt = s.step = 1e-6;
  s.moved = {about({0, 0, 0}, 1e-6), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  if (kind == PairKind::edges) s.moved[1] = about({0, 0, 0}, 1e-6);
  s.held = about({0, 0, 0}, 2e-6);
  s.pull = about({0, 0, 0}, 1e-3);
  s.damped = std::abs(unit(random));
  s.slides = unit(random) > 0;
  for (std::size_t k = 0; k < 4; ++k) {
    s.crowd[k] = unit(random) > 0 ? 1 : 1.5;
    s.inverse_mass[k] = s.crowd[k] * (k == 2 ? 0 : 1e5);
  }
  return c;
}

struct Counts {
  int touching = 0, special = 0, apart = 0;
};

void compare(PairKind kind, BatchKind batch, const BatchKernels& kernels, Counts& counts) {
  std::mt19937 random(7);
  for (int repeat = 0; repeat < 200; ++repeat) {
    BatchPairs in{};
    BatchForces out;
    ByLane far;
    std::vector<Case> cases;
    for (int lane = 0; lane < lanes; ++lane) {
      const Case c = random_case(kind, random);
      for (std::size_t k = 0; k < 4; ++k) {
        for (int d = 0; d < 3; ++d) {
          in.x[k][d][lane] = c.x[k][d];
          in.start[k][d][lane] = c.x[k][d] - c.slip.moved[k][d];
        }
        in.inverse_mass[k][lane] = c.slip.inverse_mass[k];
        in.crowd[k][lane] = c.slip.crowd[k];
      }
      for (int d = 0; d < 3; ++d) {
        in.held[d][lane] = c.slip.held[d];
        in.pull[d][lane] = c.slip.pull[d];
      }
      in.area[lane] = c.pair.area;
      in.scale[lane] = c.pair.scale;
      in.zone[0][lane] = c.pair.fading.first;
      in.zone[1][lane] = c.pair.fading.second;
      in.damped[lane] = c.slip.damped;
      in.slides[lane] = c.slip.slides ? 1 : 0;
      const double reach = law.gap() * c.pair.scale;
      far[lane] = reach * reach * (1 + 1e-8);
      cases.push_back(c);
      // What the batch takes the motion from is a difference of places.
      for (std::size_t k = 0; k < 4; ++k)
        for (int d = 0; d < 3; ++d) cases.back().slip.moved[k][d] = c.x[k][d] - in.start[k][d][lane];
      cases.back().slip.sticking = 0.4;
    }
    const BatchLaw common{batch,
                          &law.knots().front().gap,
                          int(law.knots().size()),
                          law.gap(),
                          law.floor(),
                          law.guard_gap(),
                          law.stiffest(),
                          0,
                          true,
                          true,
                          0.3,
                          0.4,
                          2.0 / 7 * law.stiffest(),
                          0.1,
                          1e-6,
                          {}};
    kernels.press(common, in, out);
    const unsigned near = batch == BatchKind::plane ? ~0u : kernels.near(batch, in.x, far);
    for (int lane = 0; lane < lanes; ++lane) {
      const Case& c = cases[std::size_t(lane)];
      const Force one = pair_force(law, c.pair, c.x, &c.slip);
      const bool touching = (out.touching >> lane & 1) != 0, special = (out.special >> lane & 1) != 0;
      if (special || !touching) {
        ++(special ? counts.special : counts.apart);
        CHECK((special || !one.active));
        if (one.active) CHECK((near >> lane & 1) != 0);
        continue;
      }
      ++counts.touching;
      CHECK(one.active);
      CHECK((near >> lane & 1) != 0);
      for (std::size_t k = 0; k < 4; ++k) {
        for (int d = 0; d < 3; ++d) CHECK(out.on[k][d][lane] == one.on[k][d]);
        CHECK(out.resists[k][lane] == one.resists[k]);
      }
      for (int d = 0; d < 3; ++d) {
        CHECK(out.pull[d][lane] == one.pull[d]);
        CHECK(out.torque[d][lane] == one.torque[d]);
        if (kind != PairKind::edges) CHECK(out.slip[d][lane] == one.slip[d]);
      }
      CHECK(out.contact[lane] == one.contact);
      CHECK(one.guard == 0);
      CHECK(out.gap[lane] == one.gap);
      CHECK(out.stick[lane] == one.stick);
      CHECK(out.damped[lane] == one.damped);
      CHECK(out.work[lane] == one.work);
      CHECK(out.impact[lane] == one.impact);
      CHECK((out.slides[lane] != 0) == one.slides);
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
      compare(kind, batch, batch_kernels(isa), counts);
      CHECK(counts.touching > 200);
      CHECK(counts.apart > 100);
      CHECK(counts.special > (kind == PairKind::plane ? 0 : 100));
    }
}
