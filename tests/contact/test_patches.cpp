// Lists of pairs that last until near surfaces have moved against each other: nothing within reach is left
// out.
#include <random>

#include "catch.hpp"
#include "contact/sheets.hpp"

using namespace fabricsh;
using namespace fabricsh::contact;
using namespace fabricsh::test;

namespace {

// Forces with lists that are kept, against those with lists made anew in each step as after a restart, to
// the bit. Returns how often the kept ones were searched.
template <class Move>
std::size_t compare(const Scene& scene, int steps, Move move) {
  std::vector<Vec3> x = scene.reference();
  Contact kept(scene);
  std::size_t touching = 0;
  for (int step = 0; step < steps; ++step) {
    move(step, x);
    auto f = none(x.size()), g = f;
    Contact fresh(scene);
    Archive written;
    kept.keep(written);
    Archive read(written.bytes());
    fresh.keep(read);
    const Totals a = kept.add_forces(x, f), b = fresh.add_forces(x, g);
    REQUIRE(a.contact == b.contact);
    REQUIRE(a.gap == b.gap);
    REQUIRE(a.touching == b.touching);
    REQUIRE(f == g);
    touching += a.touching;
  }
  CHECK(touching > 0);
  return kept.searches();
}

}  // namespace

TEST_CASE("patches: cloth that folds up fast is searched seldom, and nothing is left out", "[contact]") {
  Sheets sheets;
  sheets.add(0.1, 20, Vec3::Zero());
  Scene scene = sheets.scene();
  scene.meet(0, 0, ContactLaw({1e-3, 0.15e-3, 2e10, {}}), 0);
  // It is rolled about x = 0.05 until its edges meet: all of it flies by 60 mm a step, the far ends
  // move against each other by a millimetre.
  const std::size_t searches = compare(scene, 300, [&](int step, std::vector<Vec3>& x) {
    const double angle = 3.12 * (step + 1) / 300;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vec3& at = scene.reference()[i];
      const double s = at.x() - 0.05, r = 0.1 / (2 * angle), a = s / r;
      x[i] = {r * std::sin(a) + 0.06 * step, at.y(), r * (1 - std::cos(a))};
    }
  });
  CHECK(searches < 100);
}

TEST_CASE("patches: motion at random, balls and a wall that turns leave nothing out", "[contact]") {
  Sheets sheets;
  sheets.add(0.05, 8, Vec3::Zero());
  sheets.add(0.05, 7, Vec3(0.001, 0.002, 0.6e-3));
  Scene scene = sheets.scene();
  const int ball = scene.add_ball(Vec3(0.02, 0.02, 0.0115), 0.01),
            wall = scene.add_wall(Vec3(-2, 0, -0.4e-3), Vec3::UnitZ());
  const ContactLaw law({1e-3, 0.15e-3, 2e10, {}});
  for (const int s : {0, 1}) {
    scene.meet(s, s, law, 0);
    scene.meet(s, ball, law, 0);
  }
  scene.meet(0, 1, law, 0);
  scene.meet(0, wall, law, 0);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> some(-1, 1);
  const auto v = std::size_t(scene.surfaces()[std::size_t(wall)].first_vertex);
  compare(scene, 200, [&](int step, std::vector<Vec3>& x) {
    for (std::size_t i = 0; i < v; ++i) x[i] += 2e-5 * Vec3(some(random), some(random), 0.1 * some(random));
    // The wall turns about a point two metres away: its own three points hardly move.
    const double angle = 1.5e-7 * step;
    const Vec3 along(std::cos(angle), 0, std::sin(angle));
    x[v + 1] = x[v] + along;
    x[v + 2] = x[v] + Vec3::UnitY();
  });
}
