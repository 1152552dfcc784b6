// Gas in a closed volume: its tangent is the derivative of its forces, also where it flows, with lids on free
// rims and with a state that is kept.
#include <random>

#include "catch.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/terms/gas.hpp"
#include "mesh/generators.hpp"
#include "tangent_error.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using mechanics::Assembly;

namespace {

std::shared_ptr<model::Model> tube(const model::GasGiven& gas) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::cylinder({0.05, 0.12, 7, 3}));
  model::Options options;
  options.warp = [](const Vec3&) { return model::Direction(Vec3(Vec3::UnitZ())); };
  auto m = std::make_shared<model::Model>(mesh, test::svk(), options);
  m->fix("bottom", model::parse_freedoms("x y z rotation"));
  m->add(std::make_shared<const model::GasGiven>(gas));
  return m;
}

// The largest difference between the tangent, ranks included, and central differences, over the largest
// force.
double tangent_error(const model::GasGiven& gas, double time) {
  const auto m = tube(gas);
  Assembly a(*m);
  const auto n = static_cast<std::size_t>(a.dofs().unknowns());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<double> way(n), direction(n);
  for (std::size_t i = 0; i < n; ++i) {
    way[i] = 3e-4 * number(random);
    direction[i] = 1e-3 * number(random);
  }
  a.set_time(time);
  a.begin_iterate();
  a.apply_increment(way, 1, a.dofs().targets(0));
  linear::Matrix K;
  REQUIRE(a.tangent({0, time}, K, {}, {}));
  REQUIRE(K.ranks.columns.size() == 1);
  return test::tangent_error(a, K, direction, 1e-4, {0, time});
}

}  // namespace

TEST_CASE("the tangent of gas is the derivative of its forces") {
  model::GasGiven gas;
  gas.lids = {"bottom", "top"};
  gas.initial = 4000;
  gas.exponent = 1.4;
  CHECK(tangent_error(gas, 0) < 1e-6);  // of the differences
  gas.inflow = history::History::constant(1e-4);
  model::GasVent vent;
  vent.area = 1e-4;
  gas.vents = {vent};
  gas.leakage = [](double difference) { return 1e-3 * difference; };
  CHECK(tangent_error(gas, 0.01) < 1e-6);
}

TEST_CASE("the gradient of the volume is what the gas pushes with") {
  model::GasGiven gas;
  gas.lids = {"bottom", "top"};
  const auto m = tube(gas);
  const auto surface = model::enclosure_of(*m, *m->all<model::GasPointer>()[0]);
  CHECK(surface.lids.size() == 2);
  CHECK(surface.cloth.size() == 21);
  Assembly a(*m);
  const auto* const term = a.terms().find<mechanics::Gas>();
  const auto state = term->read(*m->all<model::GasPointer>()[0]);
  CHECK(state.volume == Approx(7 / 2.0 * 0.05 * 0.05 * std::sin(2 * M_PI / 7) * 0.12).epsilon(1e-12));
  mechanics::NodalRanks ranks;
  term->add_ranks(a.trial(), ranks);
  // Nothing turns or moves the whole; growing by a share changes the volume by three times that.
  Vec3 force = Vec3::Zero();
  double growth = 0;
  for (std::size_t i = 0; i < m->mesh().nodes.size(); ++i) {
    const Vec3 push = at(ranks.on_x[0], static_cast<std::ptrdiff_t>(i));
    force += push;
    growth += push.dot(m->mesh().nodes[i]);
  }
  CHECK(force.norm() < 1e-15);
  CHECK(growth == Approx(3 * state.volume).epsilon(1e-12));
  CHECK(ranks.core(0, 0) == Approx(101325 / state.volume).epsilon(1e-12));
}
