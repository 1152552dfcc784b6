// Joints of tearable zones: which nodes move as one, what a cut divides, and what the unknowns become.
#include <algorithm>
#include <numeric>
#include <random>

#include "base/error.hpp"
#include "catch.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/terms/cloth.hpp"
#include "mesh/corners.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using mechanics::Index;
using mechanics::Joints;

namespace {

// Nodes 1 to 9 row by row, elements 1 to 4.
std::shared_ptr<mesh::Mesh> cut_square(Index n = 2) {
  return std::make_shared<mesh::Mesh>(mesh::rectangle(0.1, 0.1, n, n));
}

mesh::Mesh split(const std::shared_ptr<mesh::Mesh>& whole, std::vector<Index> elements) {
  return *mesh::split_corners(whole, elements);
}

std::vector<Index> all_elements(const mesh::Mesh& mesh) {
  std::vector<Index> all(mesh.elements.size());
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

std::size_t count(const Joints& joints) {
  std::size_t number = 0;
  for (Index n = 0; n < static_cast<Index>(joints.leaders().size()); ++n) number += joints.leads(n) ? 1 : 0;
  return number;
}

}  // namespace

TEST_CASE("each corner of a zone's elements gets a node, and the elements beside it keep theirs") {
  const auto whole = cut_square();
  whole->define("middle", mesh::NodeSet{4});
  const mesh::Mesh every = split(whole, all_elements(*whole));
  CHECK(every.nodes.size() == 16);
  for (std::size_t e = 0; e < 4; ++e)
    for (std::size_t a = 0; a < 4; ++a) {
      const Index n = every.elements[e][a];
      CHECK(every.place_of(n) == whole->elements[e][a]);
      CHECK(every.nodes[n] == whole->nodes[whole->elements[e][a]]);
    }
  CHECK(every.set("middle").size() == 4);
  CHECK(every.set("all").size() == 16);
  // One element alone: its corner on the outside is the node of the mesh, those it shares are further ones.
  const mesh::Mesh one = split(whole, {0});
  CHECK(one.nodes.size() == 12);
  CHECK(one.elements[0][0] == 0);
  CHECK(one.elements[3] == whole->elements[3]);
  // A set that is defined later is found with all nodes at its places.
  whole->define("later", mesh::NodeSet{0, 4});
  CHECK(one.set("later") == mesh::NodeSet{0, 4, 11});  // further nodes: 9, 10, 11 at the places 1, 3, 4
}

TEST_CASE("a cut opens where the elements around a place no longer hang together, and its tip stays whole") {
  const auto whole = cut_square(4);  // 5 x 5 nodes
  const mesh::Mesh mesh = split(whole, all_elements(*whole));
  Joints joints(mesh);
  CHECK(count(joints) == 25);
  CHECK(joints.places() == 25 - 4);
  const auto row = [&](Index from, Index to) {  // along the middle, y = 0.05
    std::vector<Index> nodes;
    for (Index i = from; i <= to; ++i) nodes.push_back(10 + i);
    return joints.edges_between(nodes);
  };
  CHECK(row(0, 4).size() == 8);  // both ends of four edges
  // From the left border to the centre: the border and the place after it open, the tip does not.
  CHECK(joints.set_opened(row(0, 2)));
  CHECK(count(joints) == 27);
  CHECK(joints.open() == 2);
  CHECK(joints.is_open(10));
  CHECK(joints.is_open(11));
  CHECK_FALSE(joints.is_open(12));
  // One edge inside opens nothing by itself, but counts later.
  CHECK(joints.set_opened({}));
  CHECK(count(joints) == 25);
  CHECK_FALSE(joints.set_opened(row(1, 2)));
  auto both = row(1, 2);
  const auto next = row(2, 3);
  both.insert(both.end(), next.begin(), next.end());
  CHECK(joints.set_opened(both));
  CHECK(count(joints) == 26);
  CHECK(joints.is_open(12));
  // All through: every place of the row in two; all edges: each corner by itself.
  joints.set_opened(row(0, 4));
  CHECK(count(joints) == 30);
  std::vector<Index> everywhere(25);
  std::iota(everywhere.begin(), everywhere.end(), Index{0});
  joints.set_opened(joints.edges_between(everywhere));
  CHECK(count(joints) == 64);
  CHECK(joints.edges_on(std::vector<Vec3>{{-1, 0.05, 0}, {0.0501, 0.05, 0}}) == row(0, 2));
  CHECK(joints.edges_on(std::vector<Vec3>{{0, 0.06, 0}, {0.1, 0.06, 0}}).empty());
}

TEST_CASE("a zone nowhere open has the residual and the tangent of the sheet without it") {
  const auto make = [](bool tearable) {
    auto model = std::make_shared<model::Model>(cut_square(3), test::blend(), model::Options{});
    model->fix("left", model::parse_freedoms("x y z rotation"));
    model::Components load;
    load[2] = history::History::constant(0.3);
    model->force("right", load);
    model->add<model::TractionLoad>({"top", load});
    model->add<model::GroundSpring>({"corners", {1, 2, 3}});
    if (tearable) model->add<model::Zone>({"all"});
    model->validate();
    model->divide_zones();
    return model;
  };
  const auto plain = make(false), zone = make(true);
  mechanics::Assembly a(*plain), b(*zone);
  REQUIRE(b.dofs().unknowns() == a.dofs().unknowns());
  REQUIRE(b.state().nodes() > a.state().nodes());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> some(-1, 1);
  std::vector<double> delta(a.dofs().unknowns());
  for (double& d : delta) d = 1e-3 * some(random);
  linear::Matrix K[2];
  std::vector<double> r[2];
  for (const int i : {0, 1}) {
    mechanics::Assembly& one = i == 0 ? a : b;
    one.begin_iterate();
    one.apply_increment(delta, 1, {});
    one.set_time(0);
    std::vector<double> external, product(one.dofs().unknowns());
    one.terms().external(0, external);
    REQUIRE(one.tangent({}, K[i], {}, product));
    r[i].resize(one.dofs().unknowns());
    one.residual(external, r[i]);
  }
  double force = 0, stiffness = 0;
  for (const double f : r[0]) force = std::max(force, std::abs(f));
  for (const double k : K[0].value) stiffness = std::max(stiffness, std::abs(k));
  REQUIRE(K[1].value.size() == K[0].value.size());
  for (std::size_t i = 0; i < r[0].size(); ++i) CHECK(std::abs(r[1][i] - r[0][i]) < 1e-13 * force);
  for (std::size_t i = 0; i < K[0].value.size(); ++i)
    CHECK(std::abs(K[1].value[i] - K[0].value[i]) < 1e-13 * stiffness);
  CHECK(b.largest_force() == Approx(a.largest_force()).epsilon(1e-12));
  const auto mass_a = a.lumped_mass(true), mass_b = b.lumped_mass(true);
  for (std::size_t i = 0; i < mass_a.size(); ++i) CHECK(mass_b[i] == Approx(mass_a[i]).epsilon(1e-13));
}

TEST_CASE("opening copies rates, closing takes their mean by mass, and a tangent follows each") {
  auto model = std::make_shared<model::Model>(cut_square(2), test::blend(), model::Options{});
  model->add<model::Zone>({"all"});
  model->divide_zones();
  mechanics::Assembly a(*model);
  const auto before = a.dofs().unknowns();
  CHECK(before == 45);
  const auto edges = a.dofs().joints().edges_between(std::vector<Index>{3, 4, 5});
  std::vector<double> rates(before);
  std::iota(rates.begin(), rates.end(), 1.0);
  const auto opened = a.open(edges, 0);
  REQUIRE(opened);
  CHECK_FALSE(opened->closes());
  CHECK(a.dofs().unknowns() == before + 15);
  auto parted = opened->apply(rates);
  mechanics::NodalRates nodal;
  a.dofs().spread_rates(parted, {}, nodal);
  const auto& mesh = model->mesh();
  for (std::size_t n = 9; n < mesh.nodes.size(); ++n)  // each node moves as the one of its place did
    for (int c = 0; c < 3; ++c) CHECK(nodal.x[3 * n + c] == nodal.x[3 * mesh.place[n] + c]);
  // Any rates then: momentum before and after closing, with the lumped masses of each.
  std::mt19937 random(2);
  std::uniform_real_distribution<double> some(-1, 1);
  for (double& v : parted) v = some(random);
  const auto momentum = [&](const std::vector<double>& v) {
    a.dofs().spread_rates(v, {}, nodal);
    Vec3 sum = Vec3::Zero();
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
      sum += a.cloth().mass()[n] * Vec3(nodal.x[3 * n], nodal.x[3 * n + 1], nodal.x[3 * n + 2]);
    return sum;
  };
  const Vec3 first = momentum(parted);
  const auto closed = a.open({}, 0);
  REQUIRE(closed);
  CHECK(closed->closes());
  CHECK(a.dofs().unknowns() == before);
  CHECK((momentum(closed->apply(parted)) - first).norm() < 1e-14 * first.norm());
  linear::Matrix K;
  std::vector<double> product(a.dofs().unknowns());
  CHECK(a.tangent({}, K, {}, product));
  CHECK(K.size() == before);
}

TEST_CASE("nodes that are apart do not become one, and nothing is changed then") {
  auto model = std::make_shared<model::Model>(cut_square(2), test::blend(), model::Options{});
  model->add<model::Zone>({"all"});
  model->divide_zones();
  mechanics::Assembly a(*model);
  REQUIRE(a.open(a.dofs().joints().edges_between(std::vector<Index>{3, 4, 5}), 0));
  std::vector<double> delta(a.dofs().unknowns(), 0);
  const Index other =
      a.dofs().joints().leader(model->mesh().elements[2][0]);  // of the upper crack face at the left
  delta[a.dofs().freedoms().nodes[other].equation[1]] = 1e-4;
  a.begin_iterate();
  a.apply_increment(delta, 1, {});
  REQUIRE(a.forces({}));
  a.commit(0);
  const auto unknowns = a.dofs().unknowns();
  CHECK_THROWS_WITH(a.open({}, 5e-5), Catch::Contains("m apart: expected at most 5e-05 m (field 'within')"));
  CHECK(a.dofs().unknowns() == unknowns);
  CHECK(a.dofs().joints().open() == 3);
  REQUIRE(a.open({}, 2e-4));
  // The two corners have the same mass: they meet half way.
  CHECK(std::as_const(a).state().x()[3 * other + 1] == Approx(0.05 + 0.5e-4).epsilon(1e-14));
}

TEST_CASE("a zone without an element, and one in a periodic tie, are refused") {
  auto mesh = cut_square(2);
  mesh->define("line", mesh::NodeSet{3, 4, 5});
  model::Model m(mesh, test::blend(), {});
  CHECK_THROWS_WITH(m.add<model::Zone>({"line"}), "tearable: set 'line' holds no whole element");
  m.add<model::Tie>({model::TieKind::periodic, "left", "right", model::parse_freedoms("x", "tie")});
  m.add<model::Zone>({"all"});
  CHECK_THROWS_WITH(m.validate(),
                    Catch::StartsWith("tearable: node 1 of a zone is in the periodic tie of set 'left'"));
}
