// A strip rolled by its ends between turned grips: moment and energies of separate bending, with and without
// friction.
#include <algorithm>
#include <numbers>

#include "catch.hpp"
#include "strip.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

constexpr double kLength = 0.1, kWidth = 0.02;
constexpr int kCells = 20;

// A weightless strip along x, its left end held; its right end's directors are turned about y, and it is free
// to follow.
std::shared_ptr<model::Model> roll(const card::Card& card, history::History angle) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(kLength, kWidth, kCells, 1));
  auto m = std::make_shared<model::Model>(mesh, card, model::Options{});
  m->fix("left", model::parse_freedoms("x z rotation"));
  mesh->define("inside", [](const Vec3& X) { return X.x() < kLength - 1e-6; });
  m->fix("all", model::parse_freedoms("y"));
  m->fix("inside", model::parse_freedoms("rx"));
  m->add<model::PrescribedTurn>({"right", Vec3::UnitY(), std::move(angle), std::nullopt});
  return m;
}

// The moment about y that the strip's right edge carries, N m: what its directors feel.
double end_moment(const run::Run& a) {
  double sum = 0;
  for (const auto n : a.model().mesh().set("right")) {
    const Vec3 d = a.node(n).n;
    const Vec3 f = Eigen::Map<const Vec3>(a.assembly().internal().on_d.data() + 3 * n);
    sum += d.cross(f).y();
  }
  return sum;
}

}  // namespace

TEST_CASE("bending with friction: moment and curvature of a strip follow the spring's closed form") {
  auto card = blend();
  const double B = 10e-6, Mf = 20e-6, kf = 0.5;  // N.m, N, 1/m
  card.bending = card::Bending{B, 2 * B, B, card::BendingFriction{Mf, kf}, {}};
  // Curvature up to 12 /m, back to -4 /m and to zero; kinks of the spring at 0.5, 11 and so on.
  const double deg = 180 / std::numbers::pi * kLength;
  run::Static a(roll(card, history::History::table({{0, 0}, {1, 12 * deg}, {2, -4 * deg}, {3, 0}})),
                {.duration = 3, .step = 0.05}, std::make_shared<Notices>());
  double slip = 0, lost = 0, worst = 0, worst_energy = 0;
  a.every_step([&](run::Run& run) {
    const double t = run.time(), k = t <= 1 ? 12 * t : t <= 2 ? 12 - 16 * (t - 1) : -4 + 4 * (t - 2);
    const double held = std::clamp(k - slip, -kf, kf);
    lost += Mf * std::abs(k - slip - held);
    slip = k - held;
    const double M = B * k + Mf * held / kf;
    worst = std::max(worst, std::abs(end_moment(run) - M * kWidth));
    const double area = kLength * kWidth, stored = area * (B * k * k + Mf / kf * held * held) / 2;
    const auto e = run.energy();
    worst_energy =
        std::max({worst_energy, std::abs(e.stored - stored), std::abs(e.lost_in("bending") - area * lost)});
  });
  a.solve();
  const double peak = (12 * B + Mf) * kWidth;
  INFO("moment error " << worst / peak << ", energy error " << worst_energy / (peak * 12 * kLength));
  // An element's curvature over an angle a = k h is sin(a) / h, so moments differ by a^2 / 6 from the
  // continuous strip's.
  const double a2 = std::pow(12 * kLength / kCells, 2) / 6;
  CHECK(worst < 1.1 * a2 * peak);
  CHECK(worst_energy < 1.1 * a2 * peak * 12 * kLength);
  CHECK(a.energy().lost_in("bending") > 0);
}
