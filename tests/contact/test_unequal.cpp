// Contact where nothing is symmetric: moments on rods and solids, a capsule's inertia against that of its
// surface, a bound on a measured stiffness between its points, edges of different length and width.
#include <algorithm>
#include <numbers>

#include "catch.hpp"
#include "contact/rigid.hpp"
#include "contact/search.hpp"
#include "contact/sheets.hpp"

using namespace fabricsh;
using namespace fabricsh::contact;
using namespace fabricsh::test;

namespace {

// A box whose lower corner is at `low`: eight corners, twelve triangles seen counter-clockwise from outside.
int add_box(Scene& scene, const Vec3& low, const Vec3& size) {
  std::vector<Vec3> x;
  for (int i = 0; i < 8; ++i)
    x.push_back(low + size.cwiseProduct(Vec3(double(i & 1), double(i >> 1 & 1), double(i >> 2))));
  const std::vector<Triangle> t = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return scene.add_solid(x, t, 0);
}

// Friction of a sheet on a body that turns: all forces together have no moment but that of friction over the
// distance of the cloth's middle from the surface of the body, and what friction takes is what the torque on
// the body takes from its turning. `lever`: m, the body's radius.
void check_moment(const char* name, int (*add)(Scene&), double lever) {
  INFO(name);
  Sheets sheets;
  sheets.add(0.1, 20, Vec3::Zero());
  Scene scene = sheets.scene();
  const std::size_t nodes = scene.reference().size();
  scene.meet(0, add(scene), blend_law(), 0.4);
  const auto& x = scene.reference();
  const Vec3 spin(30, -20, 10);
  std::vector<Vec3> v = none(x.size()), turn = none(x.size());
  const Vec3 about(0.03, 0.06, -0.05);  // the body turns about this point: its corners have velocities
  for (std::size_t i = nodes; i < x.size(); ++i) {
    turn[i] = spin;
    v[i] = spin.cross(x[i] - about);
  }
  const std::vector<double> inverse_mass(x.size(), 1e5);
  const double step = 1e-6;
  std::vector<Vec3> start = x, turned = turn;
  for (std::size_t i = nodes; i < x.size(); ++i) {
    start[i] = x[i] - step * v[i];
    turned[i] = step * spin;
  }
  for (const bool explicitly : {true, false}) {
    INFO((explicitly ? "explicit" : "implicit"));
    Contact contact(scene);
    auto all = none(x.size()), torque = none(x.size()), pressed = none(x.size());
    contact.add_forces(x, pressed);
    const Way way = explicitly ? Way{start, turned, step, inverse_mass} : Way{start, turned};
    // The first explicit step has half of the work, because it begins without friction.
    const double lost = (explicitly ? 2 : 1) * contact.add_forces(x, all, way, torque).work;
    REQUIRE(lost > 0);
    Vec3 moment = Vec3::Zero(), couple = Vec3::Zero();
    double size = 0, drag = 0, taken = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vec3 rubbed = all[i] - pressed[i];
      moment += x[i].cross(all[i]) + torque[i];
      couple += torque[i];
      size += all[i].norm();
      drag += rubbed.norm();
      taken -= rubbed.dot(x[i] - start[i]) + torque[i].dot(i < nodes ? Vec3(Vec3::Zero()) : turned[i]);
    }
    // The drag of both sides; that of places beside each other is not quite parallel.
    CHECK(couple.norm() == Approx(lever * drag / 2).epsilon(0.05).margin(1e-12 * drag));
    CHECK(moment.norm() < blend_law().gap() * drag / 2);
    CHECK(taken == Approx(lost).epsilon(1e-9));
  }
}

}  // namespace

TEST_CASE("contact: friction turns a ball and a rod with their radius, a solid at its surface", "[contact]") {
  check_moment(
      "ball", [](Scene& s) { return s.add_ball(Vec3(0.052, 0.047, -0.0302), 0.03); }, 0.03);
  check_moment(
      "rod", [](Scene& s) { return s.add_rod(Vec3(0.02, 0.03, -0.0202), Vec3(0.09, 0.06, -0.0202), 0.02); },
      0.02);
  check_moment(
      "solid", [](Scene& s) { return add_box(s, Vec3(0.013, 0.024, -0.0503), Vec3(0.052, 0.033, 0.05)); }, 0);
}

TEST_CASE("rigid: a capsule twice as long as thick has the inertia of slices, and of its surface",
          "[contact]") {
  // l = 2 r between the centres of the ends. Slices of radius R(z): moment along the axis pi R^4/2, across it
  // pi R^4/4 + pi R^2 z^2. With R^2 = r^2 in the middle, r^2 - (z - l/2)^2 = r^2 - s^2 in the caps:
  //   volume                            pi (l r^2 + 4/3 r^3)                                     = 10/3 pi
  //   r^3 int R^4        = l r^4 + 2 int (r^2 - s^2)^2            = 2 r^5 + 16/15 r^5                = 46/15
  //   r^5 int R^2 z^2    = r^2 l^3/12 + 2 int (r^2 - s^2)(s + r)^2 = 2/3 r^5 + 2 (2/15 + 1/2 + 2/3) r^5 =
  //   49/15 r^5
  const double r = 0.7, mass = 3, density = mass / (10.0 / 3 * r * r * r);  // over pi
  const double along = density * 23.0 / 15 * std::pow(r, 5),
               across = density * (23.0 / 30 + 49.0 / 15) * std::pow(r, 5);
  const Vec3 axis = Vec3(1, -2, 2) / 3, middle(0.3, -0.2, 0.5);
  const Mass rod = rod_mass(middle - r * axis, middle + r * axis, r, mass);
  CHECK((rod.centre - middle).norm() < 1e-14);
  CHECK(axis.dot(rod.inertia * axis) == Approx(along).epsilon(1e-13));
  const Vec3 side = axis.unitOrthogonal();
  CHECK(side.dot(rod.inertia * side) == Approx(across).epsilon(1e-13));
  CHECK(std::abs(side.dot(rod.inertia * axis)) < 1e-14);

  // The surface in triangles, n around; inscribed facets leave out a part of the order 1 / n^2 of the radius.
  const auto surface = [&](int n) {
    const Vec3 e1 = side, e2 = axis.cross(side);
    std::vector<std::pair<double, double>> profile;  // z, R; the first and the last are the poles
    for (int i = 0; i <= n / 2; ++i) {
      const double a = -std::numbers::pi / 2 + std::numbers::pi * i / (n / 2);
      profile.emplace_back((a < 1e-9 ? -r : r) + r * std::sin(a), r * std::cos(a));
      if (std::abs(a) < 1e-9) profile.insert(profile.end() - 1, {-r, r}), profile.back() = {r, r};
    }
    const auto rows = int(profile.size());
    std::vector<Vec3> x;
    for (const auto& [z, R] : profile)
      for (int k = 0; k < n; ++k) {
        const double a = 2 * std::numbers::pi * k / n;
        x.push_back(middle + z * axis + R * (std::cos(a) * e1 + std::sin(a) * e2));
      }
    const auto at = [&](int row, int k) {
      if (row == 0 || row == rows - 1) k = 0;
      return std::int32_t(row * n + k % n);
    };
    std::vector<Triangle> t;
    for (int i = 0; i + 1 < rows; ++i)
      for (int k = 0; k < n; ++k) {
        if (i > 0) t.push_back({at(i, k), at(i, k + 1), at(i + 1, k)});
        if (i + 2 < rows) t.push_back({at(i, k + 1), at(i + 1, k + 1), at(i + 1, k)});
      }
    return solid_mass(x, t, mass);
  };
  for (const auto& [n, relative] : {std::pair(40, 6e-3), std::pair(80, 1.5e-3)}) {
    const Mass solid = surface(n);
    INFO(n);
    CHECK((solid.centre - middle).norm() < 1e-12);
    CHECK((solid.inertia - rod.inertia).norm() < relative * rod.inertia.norm());
  }
}

TEST_CASE("law: a bounded curve is as stiff as the unbounded one or the bound, whichever is less",
          "[contact]") {
  LawData data;
  data.floor = 0.15e-3;
  data.curve = {{0.3e-3, 5000}, {0.35e-3, 1200}, {0.45e-3, 300}, {0.6e-3, 49}};
  const ContactLaw whole(data);
  for (const double bound : {3e6, 2e7, 5e7, 1e8}) {
    data.stiffness = bound;
    const ContactLaw law(data);
    INFO(bound);
    CHECK(law.gap() == whole.gap());
    bool below = false, above = false;
    double pressure = 0, before = 0, last = law.gap();
    for (int i = 0; i <= 4000; ++i) {
      const double d = law.gap() - (law.gap() - law.guard_gap()) * i / 4000;
      const double free = whole(d).stiffness, k = std::min(free, bound);
      (free < bound ? below : above) = true;
      CHECK(law(d).stiffness == Approx(k).epsilon(1e-9));
      pressure += (before + k) / 2 * (last - d);
      before = k;
      last = d;
    }
    CHECK(below);
    CHECK(above);
    // Trapezoids over knots: the square of 1 / 4000, many times over where the curve is soft.
    CHECK(law(last).pressure == Approx(pressure).epsilon(1e-5));
  }
}

TEST_CASE(
    "contact: two crossing edges press over the narrower strip, and fade at the law's gap from either end",
    "[contact]") {
  // Two triangles above each other whose long edges cross, of lengths 8 and 3 mm and heights 1 and 4 mm.
  const ContactLaw law = blend_law();
  const double la = 8e-3, ha = 1e-3, lb = 3e-3, hb = 4e-3, z = 0.6 * law.gap();
  const auto pair_at = [&](double s, double t) {  // where they cross, in m from the first end of each
    Scene scene({Vec3(-s, 0, 0), Vec3(la - s, 0, 0), Vec3(0.5 * la - s, -ha, 0), Vec3(0, -t, z),
                 Vec3(0, lb - t, z), Vec3(hb, 0.5 * lb - t, z)});
    scene.add_cloth(std::vector<std::array<mesh::Index, 4>>{{0, 1, 2, -1}});
    scene.add_cloth(std::vector<std::array<mesh::Index, 4>>{{3, 4, 5, -1}});
    scene.meet(0, 1, law, 0);
    for (const Candidate& c : find_pairs(scene, scene.reference(), 0)) {
      const bool both = c.pair.kind == PairKind::edges && c.point == std::array<std::int32_t, 4>{0, 1, 3, 4};
      if (both) return std::pair(c.pair, pair_force(law, c.pair, corners_of(c, scene.reference())));
    }
    return std::pair(Pair{}, Force{});
  };
  // A third of each triangle belongs to the edge: strips of a sixth of the heights. Half of the narrower
  // one's square.
  const double area = 0.5 * (ha / 6) * (ha / 6);
  const auto [pair, force] = pair_at(0.4 * la, 0.45 * lb);
  CHECK(pair.area == Approx(area).epsilon(1e-12));
  CHECK(force.on[2].z() + force.on[3].z() == Approx(area * law(z).pressure).epsilon(1e-12));
  CHECK(force.on[1].z() / (force.on[0].z() + force.on[1].z()) == Approx(0.4).epsilon(1e-12));
  CHECK(force.on[3].z() / (force.on[2].z() + force.on[3].z()) == Approx(0.45).epsilon(1e-12));
  // The quintic 10 x^3 - 15 x^4 + 6 x^5 in the distance from the end over the gap, for the long and for the
  // short edge.
  const auto full = pair_at(0.5 * la, 0.5 * lb).second.contact;
  for (const double x : {0.2, 0.5, 0.9}) {
    const double share = x * x * x * (10 + x * (6 * x - 15)), way = x * law.gap();
    CHECK(pair_at(way, 0.5 * lb).second.contact == Approx(share * full).epsilon(1e-10));
    CHECK(pair_at(la - way, 0.5 * lb).second.contact == Approx(share * full).epsilon(1e-10));
    CHECK(pair_at(0.5 * la, way).second.contact == Approx(share * full).epsilon(1e-10));
    CHECK(pair_at(0.5 * la, lb - way).second.contact == Approx(share * full).epsilon(1e-10));
  }
  for (const double x : {1.01, 1.5}) {
    CHECK(pair_at(x * law.gap(), 0.5 * lb).second.contact == Approx(full).epsilon(1e-10));
    CHECK(pair_at(0.5 * la, x * law.gap()).second.contact == Approx(full).epsilon(1e-10));
  }
}
