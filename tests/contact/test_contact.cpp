// Forces of contact on whole surfaces: closed forms, what counts once, the same bits for any list and any
// number of threads, stiffness by slope, how far a step may go.
#include <omp.h>

#include <cstring>
#include <iostream>

#include "base/hash.hpp"
#include "catch.hpp"
#include "contact/rigid.hpp"
#include "contact/sheets.hpp"

using namespace fabricsh;
using namespace fabricsh::contact;
using namespace fabricsh::test;

namespace {

std::uint64_t bits(const std::vector<Vec3>& f, const Totals& t) {
  std::string bytes(reinterpret_cast<const char*>(f.data()), f.size() * sizeof(Vec3));
  for (const double x : {t.contact, t.guard, t.work, t.stick, t.gap})
    bytes.append(reinterpret_cast<const char*>(&x), sizeof x);
  return hash(bytes);
}

// Two wavy sheets on a ball, all of it touching here and there, with a motion.
struct Heap {
  Sheets sheets;
  Scene scene = [this] {
    sheets.add(0.1, 20, Vec3::Zero());
    sheets.add(0.1, 17, Vec3(0.003, 0.002, 0.00035));
    Scene out = sheets.scene();
    const int ball = out.add_ball(Vec3(0.05, 0.05, -0.0304), 0.03);
    for (const int s : {0, 1}) out.meet(s, s, blend_law(), 0.3);
    out.meet(0, 1, blend_law(), 0.2);
    for (const int s : {0, 1}) out.meet(s, ball, blend_law(), 0.4);
    return out;
  }();
  std::vector<Vec3> x, v;
  std::vector<double> inverse_mass;
  Heap() : x(scene.reference()), v(x.size()), inverse_mass(x.size(), 1e5) {
    Random random(1);
    for (std::size_t i = 0; i < scene.nodes(); ++i)
      x[i].z() += 8e-5 * std::sin(90 * x[i].x()) + random(-4e-5, 4e-5);
    for (Vec3& u : v) {
      u = random.vector(1);
      u.z() *= 0.1;  // so that nothing comes to its floor
    }
  }
};

}  // namespace

TEST_CASE("contact: aligned layers press exactly as the law says, whatever is shared", "[contact]") {
  for (const int n : {1, 2, 7}) {
    const ContactLaw law = blend_law();
    const double d = 0.31e-3, side = 0.05;
    Sheets sheets;
    for (int layer = 0; layer < 4; ++layer) sheets.add(side, n, Vec3(0, 0, layer * d));
    Scene scene = sheets.scene();
    for (int layer = 0; layer + 1 < 4; ++layer) scene.meet(layer, layer + 1, law, 0);
    Contact contact(scene);
    auto f = none(scene.reference().size());
    const Totals totals = contact.add_forces(scene.reference(), f);
    const std::size_t each = f.size() / 4;
    const double whole = side * side * law(d).pressure;
    CHECK(sum(f, 0, each).z() == Approx(-whole).epsilon(1e-12));
    CHECK(std::fabs(sum(f, each, 2 * each).z()) < 1e-12 * whole);
    CHECK(sum(f, 3 * each, 4 * each).z() == Approx(whole).epsilon(1e-12));
    CHECK(totals.contact == Approx(3 * side * side * law(d).contact).epsilon(1e-12));
    CHECK(totals.gap == Approx(d - law.floor()).epsilon(1e-10));
    for (std::size_t i = 0; i < each; ++i)
      CHECK(f[i].z() == Approx(-scene.area(std::int32_t(i)) * law(d).pressure).epsilon(1e-11));
  }
}

TEST_CASE("contact: layers out of line press no more than a fifth too much, from crossing edges",
          "[contact]") {
  const ContactLaw law = blend_law();
  const double d = 0.31e-3;
  for (const double shift : {0.1, 0.3, 0.5}) {
    Sheets sheets;
    sheets.add(0.1, 20, Vec3::Zero());
    sheets.add(0.05, 13, Vec3(0.02 + shift * 0.005, 0.021, d));  // over the inside of the first
    Scene scene = sheets.scene();
    scene.meet(0, 1, law, 0);
    Contact contact(scene);
    auto f = none(scene.reference().size());
    contact.add_forces(scene.reference(), f);
    const double excess = sum(f, 441, f.size()).z() / (0.05 * 0.05 * law(d).pressure) - 1;
    INFO("excess " << excess);
    std::cout << "layers out of line by " << shift << ": pressure exceeds the law's by " << 100 * excess
              << " %\n";
    CHECK(excess > -0.12);
    CHECK(excess < 0.2);
  }
}

TEST_CASE("contact: a node over a flat surface of many facets counts once wherever it is", "[contact]") {
  const ContactLaw law = blend_law();
  Sheets sheets;
  sheets.add(0.001, 1, Vec3::Zero());
  Scene scene = sheets.scene();
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  const int n = 30;  // finer than the reach of contact
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) vertices.emplace_back(1e-4 * (i - 10), 1e-4 * (j - 10), 0);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      triangles.push_back({a, a + 1, a + n + 2});
      triangles.push_back({a, a + n + 2, a + n + 1});
    }
  scene.meet(0, scene.add_solid(vertices, triangles, 0), law, 0);
  Random random(2);
  for (int k = 0; k < 40; ++k) {
    const double d = random(0.2e-3, 0.37e-3);
    std::vector<Vec3> x = scene.reference();
    for (std::size_t i = 0; i < 4; ++i)
      x[i] += Vec3(k == 0 ? 0 : random(-2e-4, 2e-4), k == 0 ? 0 : random(-2e-4, 2e-4), d);
    double energy = 0, force = 0;
    for (const Candidate& c : find_pairs(scene, x, 0)) {
      if (c.pair.kind != PairKind::facet || c.point[0] != 0) continue;
      const Force one = pair_force(law, c.pair, corners_of(c, x));
      energy += one.contact;
      force += one.on[0].z();
    }
    // Hundreds of facets, edges and corners within reach cancel to one.
    CHECK(energy == Approx(scene.area(0) * law(x[0].z()).contact).epsilon(1e-10));
    CHECK(force == Approx(scene.area(0) * law(x[0].z()).pressure).epsilon(1e-10));
  }
}

namespace {

// A sheet with its middle there, thrown down at random from above a body, each in a frame: where contact lets
// it go on its way, nothing has come too near to any edge of the body.
void check_kept_out(const Scene& scene, const Scene& all_edges, const Mat3& frame, const Vec3& middle,
                    const Vec3& above, Random& random) {
  const Contact contact(scene), looks_at_all(all_edges);
  int stopped = 0;
  for (int k = 0; k < 60; ++k) {
    std::vector<Vec3> x = scene.reference(), by = none(x.size());
    const Mat3 tilt = Pose::about(random.vector(1), random(0, 3));
    for (std::size_t i = 0; i < scene.nodes(); ++i) {
      x[i] = frame * (tilt * (x[i] - middle) + above + random.vector(0.004));
      by[i] = frame * (Vec3(0, 0, -0.12) + random.vector(0.02));
    }
    if (!looks_at_all.overlaps(x).empty()) continue;
    const double share = contact.safe_fraction(x, by);
    stopped += share < 1;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += share * by[i];
    CHECK(looks_at_all.overlaps(x).empty());
  }
  CHECK(stopped > 30);
}

}  // namespace

TEST_CASE("contact: cloth over a disc is pressed as the law says, and kept out by its facets and its rim",
          "[contact]") {
  const ContactLaw law = blend_law();
  const double edge = 0.002;
  Sheets inside;
  inside.add(0.02, 4, Vec3(0.004, 0.003, edge + 0.3e-3));
  Scene level = inside.scene();
  level.meet(0, add_disc(level, Vec3::Zero(), Vec3::UnitZ(), 0.05, edge), law, 0);
  std::vector<Vec3> force = none(level.reference().size());
  const Totals totals = Contact(level).add_forces(level.reference(), force);
  CHECK(totals.contact == Approx(0.02 * 0.02 * law(0.3e-3).contact).epsilon(1e-9));

  Sheets sheets;
  sheets.add(0.08, 4, Vec3(-0.04, -0.04, 0.03));
  Scene scene = sheets.scene(), all_edges = sheets.scene();
  const int disc = add_disc(scene, Vec3::Zero(), Vec3::UnitZ(), 0.03, edge);
  scene.meet(0, disc, law, 0);
  const auto vertices = std::span(scene.reference()).subspan(scene.nodes());
  std::vector<Triangle> triangles;
  for (const TriangleRow& t : scene.triangles())
    if (t.surface == disc) {
      const auto first = std::int32_t(scene.nodes());
      triangles.push_back({t.nodes[0] - first, t.nodes[1] - first, t.nodes[2] - first});
    }
  all_edges.meet(0, all_edges.add_solid(vertices, triangles, edge, true), law, 0);
  Random random(3);
  check_kept_out(scene, all_edges, Mat3::Identity(), Vec3(0, 0, 0.03), Vec3(0, 0, 0.05), random);
}

TEST_CASE("contact: cloth on flat facets is pressed as the law says, and kept out by the rim of the plate",
          "[contact]") {
  const ContactLaw law = blend_law();
  Random random(5);
  // A plate with a hole, of facets of any shape, turned in space.
  const int n = 9;
  const double cell = 0.007;
  const Mat3 turn = Pose::about(random.vector(1), 1);
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double jitter = i % n == 0 || j % n == 0 ? 0 : 0.3 * cell;
      vertices.push_back(turn *
                         Vec3(cell * i + random(-jitter, jitter), cell * j + random(-jitter, jitter), 0));
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      if (i == 7 && j == 7) continue;
      const int a = j * (n + 1) + i;
      triangles.push_back({a, a + 1, a + n + 2});
      triangles.push_back({a, a + n + 2, a + n + 1});
    }
  for (const int elements : {2, 5, 20}) {
    INFO("elements " << elements);
    Sheets sheets;
    sheets.add(0.03, elements, Vec3(0.008, 0.009, 0.3e-3));
    for (Vec3& x : sheets.nodes) x = turn * x;
    Scene scene = sheets.scene();
    scene.meet(0, scene.add_solid(vertices, triangles, 0), law, 0);
    std::vector<Vec3> force = none(scene.reference().size());
    const Totals totals = Contact(scene).add_forces(scene.reference(), force);
    CHECK(totals.contact == Approx(0.03 * 0.03 * law(0.3e-3).contact).epsilon(1e-9));
    CHECK((sum(force, 0, scene.nodes()) - 0.03 * 0.03 * law(0.3e-3).pressure * turn.col(2)).norm() <
          1e-9 * 0.03 * 0.03 * law(0.3e-3).pressure);
  }

  Sheets sheets;
  sheets.add(0.08, 4, Vec3::Zero());
  Scene scene = sheets.scene(), all_edges = sheets.scene();
  scene.meet(0, scene.add_solid(vertices, triangles, 0), law, 0);
  all_edges.meet(0, all_edges.add_solid(vertices, triangles, 0, true), law, 0);
  CHECK(scene.surfaces()[1].points.size() == 4 * n + 4);  // of the rims
  CHECK(all_edges.surfaces()[1].points.size() == vertices.size());
  check_kept_out(scene, all_edges, turn, Vec3(0.04, 0.04, 0), Vec3(0.03, 0.03, 0.05), random);
}

TEST_CASE("contact: a sheet at rest on a wall has the pressure of its weight", "[contact]") {
  const ContactLaw law = blend_law();
  Sheets sheets;
  sheets.add(0.05, 6, Vec3::Zero());
  Scene scene = sheets.scene();
  const Vec3 normal = Vec3(1, 2, 3).normalized();
  const int wall = scene.add_wall(Vec3(0.3, 0.1, -0.2), normal);
  scene.meet(wall, 0, law, 0);
  const double p = 0.23 * 9.81, d = gap_at(law, p);  // areal mass times gravity
  std::vector<Vec3> x = scene.reference();
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), normal);
  for (std::size_t i = 0; i < scene.nodes(); ++i) x[i] = Vec3(0.3, 0.1, -0.2) + turn * x[i] + d * normal;
  Contact contact(scene);
  auto f = none(x.size());
  contact.add_forces(x, f);
  const auto at = contact.at_points(x);
  for (std::size_t i = 0; i < scene.nodes(); ++i) {
    CHECK((f[i] - scene.area(std::int32_t(i)) * p * normal).norm() < 1e-8 * p * scene.area(std::int32_t(i)));
    CHECK(at.gap[i] + law.floor() == Approx(d).epsilon(1e-9));
    CHECK(at.pressure[i] == Approx(p).epsilon(1e-8));
  }
  CHECK(sum(f, 0, f.size()).norm() < 1e-12 * p);  // the wall takes it
}

TEST_CASE("contact: the same bits for any skin and any number of threads", "[contact]") {
  const Heap heap;
  std::vector<std::uint64_t> found;
  for (const int threads : {1, 2, 4})
    for (const double skin : {0.3e-3, 1e-3, 1.5e-3, 2.2e-3}) {
      omp_set_num_threads(threads);
      Contact contact(heap.scene, {skin, skin / 2.5});
      std::vector<Vec3> x = heap.x, start = x;
      std::string all;
      for (int step = 0; step < 70; ++step) {  // the lists age, are refined and made anew at different steps
        auto f = none(x.size());
        const Totals totals = contact.add_forces(x, f, {start, {}, 5e-6, heap.inverse_mass});
        contact.commit();  // the slips of friction are handed on from list to list
        REQUIRE(totals.touching > 50);
        REQUIRE((step == 0 || (totals.work > 0 && totals.stick > 0)));
        all += std::to_string(bits(f, totals));
        start = x;
        for (std::size_t i = 0; i < heap.scene.nodes(); ++i) x[i] += 5e-6 * heap.v[i];
      }
      found.push_back(hash(all));
    }
  omp_set_num_threads(omp_get_num_procs());
  for (const std::uint64_t h : found) CHECK(h == found[0]);
}

TEST_CASE("contact: forces of cloth on cloth and on bodies balance", "[contact]") {
  const Heap heap;
  std::vector<Vec3> start = heap.x;
  for (std::size_t i = 0; i < start.size(); ++i) start[i] -= 1e-6 * heap.v[i];
  for (const bool slides : {false, true}) {
    Contact contact(heap.scene);
    auto f = none(heap.x.size());
    contact.add_forces(heap.x, f, slides ? Way{start, {}, 1e-6, heap.inverse_mass} : Way{});
    double size = 0;
    Vec3 moment = Vec3::Zero();
    for (std::size_t i = 0; i < f.size(); ++i) {
      size += f[i].norm();
      moment += heap.x[i].cross(f[i]);
    }
    CHECK(sum(f, 0, f.size()).norm() < 1e-12 * size);
    // Friction acts across the distance of the midsurfaces, so its moment is a couple; pressing has none.
    if (!slides) CHECK(moment.norm() < 1e-12 * size);
  }
}

TEST_CASE("contact: friction turns a ball with its radius as the lever", "[contact]") {
  Sheets sheets;
  sheets.add(0.1, 20, Vec3::Zero());
  Scene scene = sheets.scene();
  const int ball = scene.add_ball(Vec3(0.052, 0.047, -0.0302), 0.03);
  scene.meet(0, ball, blend_law(), 0.4);
  const auto& x = scene.reference();
  std::vector<Vec3> turn = none(x.size());
  turn.back() = 1e-6 * Vec3(30, -20, 10);
  const std::vector<double> inverse_mass(x.size(), 1e5);
  for (const bool steps : {true, false}) {
    Contact contact(scene);
    auto f = none(x.size()), torque = none(x.size()), pressed = none(x.size());
    contact.add_forces(x, pressed);
    const Way way = steps ? Way{x, turn, 1e-6, inverse_mass} : Way{x, turn};
    // The first explicit step has half of the work, because it begins without friction.
    const double lost = (steps ? 2 : 1) * contact.add_forces(x, f, way, torque).work;
    REQUIRE(lost > 0);
    // The ball of 30 mm is below the sheet, so that drag and torque are across. The rest of the moment is
    // the couple of friction over the distance of the cloth's middle from the ball's surface.
    Vec3 moment = torque.back();
    for (std::size_t i = 0; i < f.size(); ++i) moment += x[i].cross(f[i]);
    const Vec3 drag = f.back() - pressed.back(), couple = Vec3::UnitZ().cross(drag);
    CHECK(torque.back().norm() == Approx(0.03 * drag.norm()).epsilon(0.01));
    CHECK(moment.dot(couple) < 0);
    CHECK(moment.norm() > 0.2e-3 * drag.norm());
    CHECK(moment.norm() < blend_law().gap() * drag.norm());
    // The work of friction is the one that the torque and the pull take from the body's turning.
    CHECK(lost == Approx(-torque.back().dot(turn.back())).epsilon(1e-12));
  }
}

TEST_CASE("contact: what friction holds does not grow as the cloth stretches", "[contact]") {
  Sheets sheets;
  sheets.add(0.02, 4, Vec3(-0.0103, -0.0098, 0));
  Scene scene = sheets.scene();
  scene.meet(0, scene.add_ball(Vec3(0, 0, -0.0302), 0.03), blend_law(), 1e3);
  const std::vector<double> inverse_mass(scene.reference().size(), 1e5);
  for (const bool explicitly : {true, false}) {
    INFO((explicitly ? "explicit" : "implicit"));
    Contact contact(scene);
    std::vector<Vec3> x = scene.reference(), start = x;
    double lost = 0, stick = 0;
    const auto step = [&] {
      auto f = none(x.size());
      const Totals totals =
          contact.add_forces(x, f, explicitly ? Way{start, {}, 1e-6, inverse_mass} : Way{start});
      contact.commit();
      lost = totals.work - (totals.stick - stick);
      stick = totals.stick;
      start = x;
    };
    step();
    for (std::size_t i = 0; i < scene.nodes(); ++i) x[i].x() += 1e-4;
    step();
    REQUIRE(stick > 0);
    // The sheet stretches and shears about the place that the ball presses: what is held there stays.
    for (int k = 0; k < 10; ++k) {
      for (std::size_t i = 0; i < scene.nodes(); ++i) x[i].x() *= 1.02;
      for (std::size_t i = 0; i < scene.nodes(); ++i) x[i].y() += 0.02 * x[i].x();
      step();
      CHECK(lost > -1e-6 * stick);
    }
  }
}

TEST_CASE("contact: a pair that begins too near is opened smoothly, and stores the work of it", "[contact]") {
  const ContactLaw law = blend_law();
  Sheets sheets;
  sheets.add(0.02, 4, Vec3::Zero());
  sheets.add(0.02, 4, Vec3(0, 0, 0.1 * law.floor()));
  Scene scene = sheets.scene();
  scene.meet(0, 1, law, 0);
  const double start = 0.1 * law.floor() / law.gap(), area = 0.02 * 0.02;
  scene.interaction(0).opening.assign(scene.reference().size(), start);
  Contact contact(scene);
  const auto at = [&](double share) {
    contact.open_to(std::vector<double>{share});
    auto f = none(scene.reference().size());
    const Totals totals = contact.add_forces(scene.reference(), f);
    const double scale = start + (1 - start) * share;
    const auto wanted = law.scaled(0.1 * law.floor(), scale);
    CHECK(totals.contact == Approx(area * wanted.contact).epsilon(1e-10));
    CHECK(sum(f, 25, 50).z() == Approx(area * wanted.pressure).epsilon(1e-10));
    return totals.gap;
  };
  CHECK(at(0) == Approx(0.1 * law.floor() * (1 - law.floor() / law.gap())).epsilon(1e-10));
  CHECK(at(0.05) > 0);
  CHECK(contact.overlaps(scene.reference()).empty());
  contact.open_to(std::vector<double>{1.0});
  CHECK(contact.overlaps(scene.reference()).size() > 25);
}

TEST_CASE(
    "contact: where overlaps are opened, sheets of one surface are no neighbours, one sheet's places are",
    "[contact]") {
  const ContactLaw law = blend_law();
  mesh::Mesh two = mesh::rectangle(0.02, 0.02, 4, 4);
  const auto n = static_cast<mesh::Index>(two.nodes.size());
  const auto elements = two.elements;
  for (mesh::Index i = 0; i < n; ++i) two.nodes.push_back(two.nodes[i] + Vec3(0, 0, 0.5 * law.gap()));
  for (auto e : elements) {
    for (auto& id : e) id = id < 0 ? id : id + n;
    two.elements.push_back(e);
  }
  Scene scene(two.nodes);
  scene.add_cloth(two.elements);
  scene.meet(0, 0, law, 0);
  const auto scales = [&] {
    double least = 1;
    for (const Candidate& c : find_pairs(scene, scene.reference(), 0.1 * law.gap()))
      least = std::min(least, c.pair.scale);
    return least;
  };
  CHECK(scales() == Approx(0.45).epsilon(1e-12));
  scene.interaction(0).opening.assign(scene.reference().size(), 0.5);
  CHECK(scales() == 1);
}

TEST_CASE("contact: the stiffness of wanted points is a part of the whole", "[contact]") {
  const Heap heap;
  Contact contact(heap.scene);
  Random random(7);
  std::vector<Vec3> start = heap.x;
  for (Vec3& p : start) p += random.vector(1e-4);
  const std::vector<Vec3> turn = none(start.size());
  std::vector<char> cloth(start.size(), 0);
  std::fill_n(cloth.begin(), heap.scene.nodes(), char(1));
  struct Of {
    std::array<std::int32_t, 4> points;
    Matrix12 k;
  };
  const auto all = [&](const Wanted& wanted) {
    std::vector<Of> found;
    const auto keep = [&](const auto& points, const Matrix12& k, const FrictionTangent*) {
      found.push_back({points, k});
    };
    contact.stiffness(heap.x, keep, {start, turn}, wanted);
    return found;
  };
  const std::vector<Of> whole = all({}), part = all({cloth, cloth}), rows = all({cloth, {}});
  REQUIRE((whole.size() > 100 && part.size() == whole.size() && rows.size() == whole.size()));
  bool same = true, left_out = false;
  for (std::size_t n = 0; n < whole.size(); ++n)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        const auto block = [&](const Of& of) { return Mat3(of.k.block<3, 3>(3 * int(i), 3 * int(j))); };
        const auto is_cloth = [&](std::size_t k) {
          const std::int32_t p = whole[n].points[k];
          return p >= 0 && cloth[std::size_t(p)] != 0;
        };
        if (is_cloth(i)) same = same && block(rows[n]) == block(whole[n]);
        if (is_cloth(i) && is_cloth(j)) same = same && block(part[n]) == block(whole[n]);
        left_out = left_out || block(part[n]) != block(whole[n]);
      }
  CHECK(same);
  CHECK(left_out);
}

TEST_CASE("contact: the lists limit a step as a search does", "[contact]") {
  const Heap heap;
  Contact listed(heap.scene);
  const Contact unlisted(heap.scene);
  auto force = none(heap.x.size());
  listed.add_forces(heap.x, force);
  Random random(11);
  std::size_t limited = 0;
  for (const double size : {1e-5, 1e-4, 3e-4, 1e-3, 1e-2}) {
    std::vector<Vec3> x = heap.x, by(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (i < heap.scene.nodes()) x[i] += random.vector(1e-5);
      by[i] = random.vector(size);
    }
    const double share = listed.safe_fraction(x, by);
    CHECK(share == unlisted.safe_fraction(x, by));
    limited += share < 1 ? 1 : 0;
  }
  CHECK((limited > 0 && limited < 5));
}

TEST_CASE("contact: stiffness is the derivative of the forces, friction's unsymmetric part included",
          "[contact]") {
  const Heap heap;
  Contact contact(heap.scene);
  const std::size_t n = heap.x.size();
  Random random(4);
  std::vector<Vec3> start = heap.x, by(n), product = none(n);
  for (std::size_t i = 0; i < n; ++i) {
    start[i] += random.vector(1e-4);
    by[i] = random.vector(1);
  }
  std::vector<Vec3> turn = none(n);
  turn.back() = Vec3(2e-3, -1e-3, 3e-3);  // of the ball
  const Way way{start, turn};
  contact.stiffness(
      heap.x,
      [&](const std::array<std::int32_t, 4>& p, const Matrix12& k, const FrictionTangent*) {
        for (int i = 0; i < 4; ++i)
          for (int j = 0; j < 4; ++j)
            if (p[std::size_t(i)] >= 0 && p[std::size_t(j)] >= 0)
              product[std::size_t(p[std::size_t(i)])] +=
                  k.block<3, 3>(3 * i, 3 * j) * by[std::size_t(p[std::size_t(j)])];
      },
      way);
  const auto error = [&](double h) {
    auto up = none(n), down = none(n);
    for (const double sign : {1.0, -1.0}) {
      std::vector<Vec3> x = heap.x;
      for (std::size_t i = 0; i < n; ++i) x[i] += sign * h * by[i];
      contact.add_forces(x, sign > 0 ? up : down, way);
    }
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < n; ++i) {
      sum += ((up[i] - down[i]) / (2 * h) + product[i]).squaredNorm();
      size += product[i].squaredNorm();
    }
    return std::sqrt(sum / size);
  };
  // Hundreds of pairs: within the smallest steps none changes its pieces.
  CHECK(error(1e-9) < 1e-4);
  CHECK(error(2.5e-8) < 1e-2);
}

TEST_CASE("contact: a sheet with nothing near lists nothing and feels nothing", "[contact]") {
  Sheets sheets;
  sheets.add(0.1, 20, Vec3::Zero());
  Scene scene = sheets.scene();
  scene.meet(0, 0, blend_law(), 0.3);
  Contact contact(scene);
  auto f = none(scene.reference().size());
  std::vector<Vec3> x = scene.reference();
  for (int step = 0; step < 100; ++step) {
    for (Vec3& p : x) p += Vec3(0.01, 0.02, -0.05);  // it flies as a whole: the lists last
    const Totals totals = contact.add_forces(x, f);
    CHECK(totals.touching == 0);
    CHECK(totals.gap == blend_law().gap() - blend_law().floor());
  }
  CHECK(sum(f, 0, f.size()).norm() == 0);
  CHECK(contact.listed() == 0);
  CHECK(contact.searches() == 1);
}

TEST_CASE("contact: a sheet thicker than its elements rests in its reference and resists being folded up",
          "[contact]") {
  Sheets sheets;
  sheets.add(0.002, 20, Vec3::Zero());  // elements of 0.1 mm, contact from 0.38 mm
  Scene scene = sheets.scene();
  scene.meet(0, 0, blend_law(), 0);
  Contact contact(scene);
  const auto totals = [&](double shrink) {
    std::vector<Vec3> x = scene.reference();
    for (Vec3& p : x) p.x() *= shrink;
    auto f = none(x.size());
    return contact.add_forces(x, f);
  };
  CHECK(totals(1).touching == 0);
  CHECK(totals(0.95).touching == 0);
  CHECK(totals(0.8).contact > 0);
}

TEST_CASE("contact: a step stops before cloth passes cloth, a ball, a rod and a wall", "[contact]") {
  const ContactLaw law = blend_law();
  Sheets sheets;
  sheets.add(0.05, 5, Vec3::Zero());
  sheets.add(0.05, 7, Vec3(0.001, 0.002, 0.01));
  Scene scene = sheets.scene();
  scene.meet(0, 1, law, 0);
  scene.meet(0, scene.add_ball(Vec3(0.023, 0.027, -0.006), 0.002), law, 0);
  scene.meet(0, scene.add_rod(Vec3(-1, 0.012, -0.004), Vec3(1, 0.013, -0.004), 0.001), law, 0);
  scene.meet(0, scene.add_wall(Vec3(0, 0, -0.02), Vec3::UnitZ()), law, 0);
  Contact contact(scene);
  // (who moves, how far along z, the clear way before the floor is reached)
  struct Case {
    std::size_t from, to;
    double by, clear;
  };
  const std::size_t first = 36, all = scene.reference().size();
  for (const Case& c : {Case{first, scene.nodes(), -0.02, 0.01}, Case{0, first, 0.02, 0.01},
                        Case{scene.nodes(), scene.nodes() + 1, 0.02, 0.004}, Case{0, first, -0.02, 0.003},
                        Case{scene.nodes() + 3, all, 0.03, 0.02}}) {
    std::vector<Vec3> by = none(all);
    for (std::size_t i = c.from; i < c.to; ++i) by[i].z() = c.by;
    const double share = contact.safe_fraction(scene.reference(), by), way = share * std::fabs(c.by);
    INFO("moves " << c.from << " to " << c.to << " by " << c.by);
    CHECK(way < c.clear - law.floor());
    CHECK(way > 0.89 * (c.clear - law.floor()));
  }
  CHECK(contact.safe_fraction(scene.reference(), std::vector<Vec3>(all, Vec3(1, 2, 3))) == 1);
}

TEST_CASE("contact: overlaps at the start are found, pair by pair", "[contact]") {
  Sheets sheets;
  sheets.add(0.05, 4, Vec3::Zero());
  sheets.add(0.05, 4, Vec3(0.003, 0.004, 0.1));
  Scene scene = sheets.scene();
  scene.meet(0, 1, blend_law(), 0);
  const Contact contact(scene);
  CHECK(contact.overlaps(scene.reference()).empty());
  std::vector<Vec3> x = scene.reference();
  for (std::size_t i = 25; i < 50; ++i) x[i].z() = 0.1e-3;
  for (const auto& o : contact.overlaps(x)) CHECK(o.gap <= blend_law().floor());
  CHECK(contact.overlaps(x).size() > 25);
  for (std::size_t i = 25; i < 50; ++i) x[i].z() = x[i].x() - 0.026;  // it cuts through
  bool cut = false;
  for (const auto& o : contact.overlaps(x)) cut = cut || o.gap < 0;
  CHECK(cut);
}
