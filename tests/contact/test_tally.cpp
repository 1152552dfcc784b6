// Where sides and corners of facets are counted: sums that do not depend on it, and what cancels.
#include <map>

#include "catch.hpp"
#include "contact/places.hpp"
#include "contact/sheets.hpp"
#include "contact/tally.hpp"

using namespace fabricsh;
using namespace fabricsh::contact;
using namespace fabricsh::test;

namespace {

// A sheet over another and over a solid, all of them wavy, which it presses through several facets.
struct Thick {
  ContactLaw law{{6e-3, 0.5e-3, 1e8, {}}};
  Sheets sheets;
  Scene scene;
  std::vector<Vec3> x;
  explicit Thick(double wave) : scene(made()), x(scene.reference()) {
    Random random(5);
    for (Vec3& p : x) p += Vec3(0, 0, wave * std::sin(300 * p.x())) + random.vector(wave / 3);
  }
  Scene made() {
    sheets.add(0.06, 17, Vec3(0.002, 0.003, 3.5e-3));
    sheets.add(0.06, 13, Vec3::Zero());
    Scene out = sheets.scene();
    const mesh::Mesh ground = mesh::rectangle(0.07, 0.07, 18, 18, Vec3(-0.004, -0.005, -4e-3));
    const int solid = out.add_solid(ground.nodes, split(ground.nodes, ground.elements).triangles, 1e-3);
    out.meet(0, 1, law, 0.3);
    out.meet(0, 0, law, 0.3);
    out.meet(1, solid, law, 0.3);
    return out;
  }
};

// What all facets do to each point of each surface: energy and force on it.
struct Sum {
  double energy = 0;
  Vec3 force = Vec3::Zero();
};
using Sums = std::map<std::pair<int, int>, Sum>;
Sums sums_of(const Thick& it, const std::vector<Candidate>& pairs, int& counted) {
  Sums out;
  counted = 0;
  for (const Candidate& c : pairs) {
    if (c.pair.kind != PairKind::facet) continue;
    const Force f = pair_force(it.law, c.pair, corners_of(c, it.x));
    auto& sum = out[{c.interaction, c.point[0]}];
    sum.energy += f.contact;
    sum.force += f.on[0];
    counted += f.active;
  }
  return out;
}

}  // namespace

TEST_CASE("tally: what presses a point is the same wherever sides are counted", "[contact]") {
  for (const double wave : {0.0, 0.3e-3, 2e-3}) {
    const Thick it(wave);
    std::vector<Candidate> pairs = find_pairs(it.scene, it.x, 1e-3);
    int first = 0, counted = 0;
    const Sums stored = sums_of(it, pairs, first);
    REQUIRE(stored.size() > 500);
    for (const double away : {0.0, 1e-3, 6e-3}) {  // said where the points were before
      Random random(8);
      std::vector<Vec3> before = it.x;
      for (Vec3& p : before) p += random.vector(away);
      for (Candidate& c : pairs) tally(it.scene, before, c);
      const Sums told = sums_of(it, pairs, counted);
      double largest = 0, energy = 0, force = 0;
      for (const auto& [key, sum] : stored) {
        largest = std::max(largest, sum.force.norm());
        energy = std::max(energy, std::abs(told.at(key).energy - sum.energy) / it.law.gap());
        force = std::max(force, (told.at(key).force - sum.force).norm());
      }
      CHECK(energy < 1e-12 * largest);
      CHECK(force < 1e-12 * largest);
      if (away == 0) CHECK(counted < 0.4 * first);
    }
  }
}

TEST_CASE("tally: facets that cancel stay so while the points move by less than is said", "[contact]") {
  const Thick it(1e-3);
  Random random(2);
  int cancel = 0, least = 0;
  for (Candidate c : find_pairs(it.scene, it.x, 1e-3)) {
    if (c.shared == 0) continue;
    tally(it.scene, it.x, c);
    const double room = nothing_counts_for(c.pair, corners_of(c, it.x));
    if (room == 0) continue;
    ++cancel;
    least += room > 0.1e-3;
    for (int k = 0; k < 20; ++k) {
      Corners x = corners_of(c, it.x);
      for (Vec3& p : x) p += random.vector(1).normalized() * 0.49 * room;
      each_counted(c.pair, x, point_triangle(x), [](const Touch&, int) { FAIL("something counts"); });
    }
  }
  CHECK(cancel > 2000);
  CHECK(least > cancel / 2);
}
