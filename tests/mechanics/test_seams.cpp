// Seams and bands: what is sewn to what, and that tangents are the derivatives of forces.
#include <numbers>
#include <random>

#include "base/error.hpp"
#include "catch.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/terms/seams.hpp"
#include "tangent_error.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using mechanics::Assembly;

namespace {

// Two pieces, 4 and `cells` elements wide, the second `gap` above the first.
std::shared_ptr<model::Model> pieces(int cells, double gap, const model::Seam& seam) {
  const auto part = [](double height, int nx, double y) {
    return std::make_shared<mesh::Mesh>(mesh::rectangle(0.04, height, nx, 2, Vec3(0, y, 0)));
  };
  std::vector<model::BodyGiven> bodies;
  bodies.push_back({"low", part(0.02, 4, 0), test::svk(), {}, {}});
  bodies.push_back({"high", part(0.03, cells, 0.02 + gap), test::svk(), {}, {}});
  auto m = std::make_shared<model::Model>(std::move(bodies));
  m->fix("low.bottom", model::parse_freedoms("x y z rotation"));
  m->add(seam);
  return m;
}

model::Seam joined() { return {"low.top", "high.bottom"}; }

// The largest difference between the tangent and central differences of the residual, over the largest entry,
// in a state that is stretched along y; per unknown numbers from -1 to 1 times the amplitude more.
double tangent_error(Assembly& a, double strain, double amplitude) {
  const auto n = static_cast<std::size_t>(a.dofs().unknowns());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<double> state(n), direction(n);
  for (double& s : state) s = amplitude * number(random);
  for (std::size_t i = 0; i < a.dofs().reference().size(); ++i)
    if (const auto eq = a.dofs().freedoms().nodes[i].equation[1]; eq >= 0)
      state[static_cast<std::size_t>(eq)] += strain * a.dofs().reference()[i].y();
  for (double& d : direction) d = 1e-3 * number(random);
  a.begin_iterate();
  a.apply_increment(state, 1, a.dofs().targets(0));
  linear::Matrix K;
  REQUIRE(a.tangent({}, K, {}, {}));
  return test::tangent_error(a, K, direction, 1e-4);
}

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("the tangent through a closed seam is the derivative of the forces") {
  for (const int cells : {4, 5, 3}) {
    INFO(cells << " elements on 4");
    const auto m = pieces(cells, 0, joined());
    Assembly a(*m);
    CHECK(tangent_error(a, 0.05, 0) < 1e-6);
    CHECK(tangent_error(a, 0.02, 1e-5) < 1e-4);  // the turns of weighted directors are taken to first order
  }
}

TEST_CASE("the tangent of threads and of a band is the derivative of their forces") {
  model::Seam seam = joined();
  seam.over = 1.0;
  auto m = pieces(5, 0.002, seam);
  m->fix("high.corners", model::parse_freedoms("z"));
  m->add<model::EdgeBand>({"high.right", 300, 0.2, {}});
  Assembly a(*m);
  CHECK(tangent_error(a, 0.05, 1e-5) < 1e-6);
}

TEST_CASE("a stitch between two nodes keeps the place and the momentum of both edges") {
  const auto m = pieces(5, 0, joined());
  Assembly a(*m);
  const auto& stitches = a.dofs().stitches();
  REQUIRE(stitches.size() == 6);
  double length = 0;
  for (const auto& s : stitches) {
    double sum = 0;
    Vec3 place = Vec3::Zero();
    for (const auto& lead : s.leads) {
      sum += lead.weight;
      place += lead.weight * a.dofs().reference()[static_cast<std::size_t>(lead.node)];
    }
    length += s.length;
    CHECK(sum == Approx(1).margin(1e-14));
    CHECK((place - a.dofs().reference()[static_cast<std::size_t>(s.node)]).norm() < 1e-12);
  }
  CHECK(length == Approx(0.04));
  double lumped = 0, nodal = 0;
  const auto mass = a.lumped_mass(false);
  for (std::size_t i = 0; i < mass.size(); ++i)
    if (!a.dofs().turns(static_cast<mechanics::Index>(i))) lumped += mass[i];
  for (std::size_t n = 0; n < a.cloth().mass().size(); ++n)
    if (a.dofs().reference()[n].y() > 1e-9) nodal += 3 * a.cloth().mass()[n];
  CHECK(lumped == Approx(nodal).epsilon(1e-12));
}

TEST_CASE("edges are followed along the boundary, as a line or as a ring") {
  auto mesh = mesh::rectangle(0.03, 0.02, 3, 2);
  const auto top = model::chain_of(mesh, "top");
  CHECK(top.nodes == mesh::NodeSet{8, 9, 10, 11});
  CHECK_FALSE(top.ring);
  CHECK(top.length == Approx(0.03));
  const auto ring = model::chain_of(mesh, "boundary");
  CHECK(ring.ring);
  CHECK(ring.nodes.size() == 10);
  CHECK(ring.length == Approx(0.1));
  mesh.define("sides", mesh::NodeSet{0, 3, 4, 7, 8, 11});
  CHECK(refusal([&] { model::chain_of(mesh, "sides"); }).find("is in 2 pieces") != std::string::npos);
  CHECK(refusal([&] { model::chain_of(mesh, "all"); }).find("node 6 of set 'all' has no edge") == 0);
}
