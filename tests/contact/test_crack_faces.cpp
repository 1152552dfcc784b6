// Crack faces of a cut: two strips of one surface that lie edge to edge and part.
#include <limits>

#include "catch.hpp"
#include "sheets.hpp"

using namespace fabricsh;
using namespace fabricsh::contact;

namespace {

constexpr double kSide = 0.01;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

// One row of 3 squares beside another; nodes 4 to 7 of the first and 8 to 11 of the second are at the same
// places.
struct Rows {
  std::vector<Vec3> nodes;
  std::vector<std::array<mesh::Index, 4>> elements;
  Rows() {
    for (const double y : {0.0, 1.0, 1.0, 2.0})
      for (int i = 0; i < 4; ++i) nodes.emplace_back(i * kSide, y * kSide, 0);
    for (const mesh::Index row : {0, 8})
      for (mesh::Index i = 0; i < 3; ++i)
        elements.push_back({row + i, row + i + 1, row + i + 5, row + i + 4});
  }
  Scene scene() const {
    Scene out(nodes);
    out.add_cloth(elements);
    out.meet(0, 0, test::blend_law(), 0);
    return out;
  }
  std::vector<double> crack_faces(double apart) const {
    std::vector<double> all(nodes.size(), -1);
    std::fill(all.begin() + 4, all.begin() + 12, apart);
    return all;
  }
  // The second row moved by `by`.
  std::vector<Vec3> moved(const Vec3& by) const {
    std::vector<Vec3> x = nodes;
    for (std::size_t i = 8; i < x.size(); ++i) x[i] += by;
    return x;
  }
};

Totals forces(Contact& contact, const std::vector<Vec3>& x, Vec3* on_second = nullptr) {
  std::vector<Vec3> force = test::none(x.size());
  const Totals totals = contact.add_forces(x, force);
  if (on_second != nullptr) *on_second = test::sum(force, 8, 16);
  return totals;
}

}  // namespace

TEST_CASE(
    "contact: crack faces are not pressed when they part, and are held up at 0.9 of how far they have been") {
  const Vec3 way = GENERATE(Vec3(0, 1, 0), Vec3(0, 0, 1));  // in the plane, and out of it
  const Rows rows;
  const ContactLaw law = test::blend_law();
  Scene scene = rows.scene();
  scene.neighbours().set_apart(rows.crack_faces(0));
  Contact contact(scene);
  CHECK(forces(contact, rows.nodes).touching == 0);
  // As they move apart nothing is pressed, and the distance is remembered.
  std::vector<double> apart = scene.neighbours().apart();
  const double far = 0.4 * law.gap();
  for (int i = 1; i <= 8; ++i) {
    const auto x = rows.moved(far * i / 8 * way);
    CHECK(forces(contact, x).touching == 0);
    CHECK(contact.widen(x, apart));
    for (std::size_t p = 4; p < 12; ++p) CHECK(apart[p] == Approx(far * i / 8).epsilon(1e-9));
    CHECK(apart[0] == -1);
    scene.neighbours().set_apart(apart);
    contact.apart_changed();
    CHECK(forces(contact, x).touching == 0);
  }
  // Back again: pressed from 0.9 of it on, apart from each other, and not through.
  CHECK_FALSE(contact.widen(rows.moved(0.95 * far * way), apart));
  CHECK(forces(contact, rows.moved(0.901 * far * way)).touching == 0);
  Vec3 on_second;
  CHECK(forces(contact, rows.moved(0.8 * far * way), &on_second).touching > 0);
  CHECK(on_second.dot(way) > 0);
  CHECK(on_second.cross(way).norm() < 1e-9 * on_second.norm());
  const auto x = rows.moved(0.95 * far * way);
  const std::vector<Vec3> end = rows.moved(-far * way);
  std::vector<Vec3> by(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) by[i] = end[i] - x[i];
  const double share = contact.safe_fraction(x, by), at = 0.95 - 1.95 * share;
  CHECK(at * far > 0.9 * far * law.floor() / law.gap());
  CHECK(share > 0);
}

TEST_CASE(
    "contact: crack faces that have been farther apart than the gap touch as sheets that never were one") {
  const Rows rows;
  const ContactLaw law = test::blend_law();
  Scene scene = rows.scene();
  scene.neighbours().set_apart(rows.crack_faces(0));
  Contact contact(scene);
  std::vector<double> apart = scene.neighbours().apart();
  CHECK(contact.widen(rows.moved({0, 1.2 * law.gap(), 0}), apart));
  for (std::size_t p = 4; p < 12; ++p) CHECK(apart[p] == kInfinite);
  scene.neighbours().set_apart(apart);
  contact.apart_changed();
  // The same two rows as two surfaces.
  Scene two(rows.nodes);
  two.add_cloth(std::span(rows.elements).first(3));
  two.add_cloth(std::span(rows.elements).subspan(3));
  two.meet(0, 1, law, 0);
  Contact other(two);
  const double gap = 0.5 * (law.gap() + law.floor());
  for (const Vec3& by : {Vec3(0, gap, 0), Vec3(0, 0.3 * gap, 0.8 * gap), Vec3(0, 0, gap)}) {
    Vec3 a, b;
    const double one = forces(contact, rows.moved(by), &a).contact,
                 same = forces(other, rows.moved(by), &b).contact;
    CHECK(one == Approx(same).epsilon(1e-12));
    CHECK((a - b).norm() <= 1e-12 * b.norm());
  }
}

TEST_CASE("contact: a scene whose triangles get other nodes is the scene made with them") {
  const Rows rows;
  auto joined = rows.elements;  // the second row with the nodes of the first
  for (auto& e : joined)
    for (auto& n : e)
      if (n >= 8 && n < 12) n -= 4;
  Scene whole(rows.nodes);
  whole.add_cloth(joined);
  whole.add_ball({0, 0, 1}, 0.1);
  whole.meet(0, 0, test::blend_law(), 0);
  whole.meet(0, 1, test::blend_law(), 0.2);
  const Scene parted = whole.with_corners([&](const TriangleRow& row) {
    Triangle out = row.nodes;
    for (auto& n : out)
      if (row.element >= 3 && n < 8) n += 4;
    return out;
  });
  Scene made = rows.scene();
  made.add_ball({0, 0, 1}, 0.1);
  REQUIRE(parted.reference().size() == made.reference().size());
  REQUIRE(parted.edges().size() == made.edges().size());
  REQUIRE(parted.interactions().size() == 2);
  for (std::size_t e = 0; e < made.edges().size(); ++e) {
    CHECK(parted.edges()[e].a == made.edges()[e].a);
    CHECK(parted.edges()[e].b == made.edges()[e].b);
    CHECK(parted.edges()[e].area == made.edges()[e].area);
  }
  for (std::size_t t = 0; t < made.triangles().size(); ++t) {
    CHECK(parted.triangles()[t].nodes == made.triangles()[t].nodes);
    CHECK(parted.triangles()[t].edge == made.triangles()[t].edge);
    CHECK(parted.triangles()[t].corner == made.triangles()[t].corner);
  }
  for (std::int32_t p = 0; p < 16; ++p) CHECK(parted.area(p) == made.area(p));
  CHECK(parted.surfaces()[1].first_vertex == made.surfaces()[1].first_vertex);
  CHECK(parted.neighbours().same_sheet(4, 8));  // as it was
}
