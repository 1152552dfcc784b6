// The term of contact: its tangent is the derivative of its forces, friction and moving bodies too; the same
// bits for any number of threads.
#include <omp.h>

#include <random>

#include "catch.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/terms/contact.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using test::svk;

namespace {

// Two sheets, one a little above the other, over a ball; or over one or a rod that is small against the
// elements.
enum class Under { ball, small_ball, thin_rod };
struct Pile {
  std::shared_ptr<model::Model> model;
  model::RigidPointer ball;
  explicit Pile(double friction, const model::Components& moved = {}, Under under = Under::ball) {
    const double t = svk().thickness;
    const auto sheet = [&](double side, int n, const Vec3& origin) {
      auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(side, side, n, n));
      mesh->map([&](const Vec3& X) { return Vec3(X + origin); });
      return mesh;
    };
    model::Options options;
    options.warp = [](const Vec3&) { return model::Direction(0.0); };
    std::vector<model::BodyGiven> bodies;
    bodies.push_back({"low", sheet(0.03, 4, Vec3::Zero()), svk(), options, {}});
    bodies.push_back({"high", sheet(0.02, 3, Vec3(0.004, 0.006, 0.97 * t)), svk(), options, {}});
    model = std::make_shared<model::Model>(std::move(bodies));
    model->fix("low.left", model::parse_freedoms("x y z rotation"));
    const double z = -(under == Under::ball ? 0.02 + 0.47 * t : 0.006 + 0.4 * t);
    if (under == Under::thin_rod)
      ball = std::make_shared<const model::Rigid>(
          model::Cylinder{0.006, Vec3(-0.01, 0.011, z), Vec3(0.05, 0.016, z)}, std::nullopt, "", "cylinder");
    else
      ball = std::make_shared<const model::Rigid>(
          model::Sphere{under == Under::ball ? 0.02 : 0.006, Vec3(0.014, 0.013, z)}, std::nullopt, "",
          "sphere");
    model->add<model::ContactGiven>({{{"", ball}, {"all", nullptr}}, friction});
    model->add<model::ContactGiven>({{{"low", nullptr}, {"high", nullptr}}, friction, 1.0 * t, 1e9});
    if (moved[0] || moved[1] || moved[2]) model->add<model::BodyMotion>({ball, moved, std::nullopt});
  }
};

std::vector<double> directions(std::size_t n, double size) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-size, size);
  std::vector<double> d(n);
  for (double& x : d) x = number(random);
  return d;
}

std::vector<double> internal_at(mechanics::Assembly& a, const std::vector<double>& direction, double scale) {
  a.rollback();
  a.begin_iterate();
  a.apply_increment(direction, scale, a.dofs().targets(0));
  REQUIRE(a.forces({0, 1}));
  std::vector<double> r(a.dofs().unknowns());
  const std::vector<double> none(3 * a.dofs().reference().size(), 0);
  a.residual(none, r);
  return r;
}

}  // namespace

TEST_CASE("contact: the term's tangent is the derivative of its forces, with friction and without") {
  const auto under = GENERATE(Under::ball, Under::small_ball, Under::thin_rod);
  for (const double friction : {0.0, 0.3}) {
    const Pile pile(friction, {}, under);
    mechanics::Assembly a(*pile.model);
    CHECK(a.terms().symmetric() == (friction == 0));
    const auto n = static_cast<std::size_t>(a.dofs().unknowns());
    a.set_time(1);
    const auto start = directions(n, 1e-5), direction = directions(n, 1e-2);
    // The state that slid from the committed one by `start`.
    const auto at = [&](double h) {
      std::vector<double> step = start;
      for (std::size_t i = 0; i < n; ++i) step[i] += h * direction[i];
      return internal_at(a, step, 1);
    };
    at(0);
    REQUIRE(a.terms().find<mechanics::Contacts>()->readings().touching() > 20);
    linear::Matrix K;
    REQUIRE(a.tangent({0, 1}, K, {}, {}));
    std::vector<double> product(n, 0);
    for (std::size_t c = 0; c < n; ++c)
      for (auto k = K.pattern->column[c]; k < K.pattern->column[c + 1]; ++k)
        product[K.pattern->row[k]] += K.value[k] * direction[c];
    double worst = 1e300;
    for (const double h : {1e-5, 1e-6, 1e-7}) {
      const auto up = at(h), down = at(-h);
      double error = 0, scale = 0;
      for (std::size_t i = 0; i < n; ++i) {
        if (a.dofs().turns(static_cast<mechanics::Index>(i))) continue;
        error = std::max(error, std::abs(product[i] + (up[i] - down[i]) / (2 * h)));
        scale = std::max(scale, std::abs(product[i]));
      }
      worst = std::min(worst, error / scale);
    }
    CHECK(worst < 2e-6);  // the second derivative of a closest point jumps between facets
  }
}

TEST_CASE("contact: a moving body leads the predictor as its forces change") {
  model::Components up;
  up[2] = model::History::table({{0, 0}, {1, 1e-7}});
  const Pile pile(0.2, up);
  mechanics::Assembly a(*pile.model);
  const auto n = static_cast<std::size_t>(a.dofs().unknowns());
  a.set_time(1);
  a.rollback();
  a.begin_iterate();
  linear::Matrix K;
  std::vector<double> product(n, 0), before(n), after(n);
  const std::vector<double> none(3 * a.dofs().reference().size(), 0), still(n, 0);
  REQUIRE(a.tangent({0, 1}, K, {}, product));
  a.residual(none, before);
  a.apply_increment(still, 1, {});
  CHECK(a.terms().at_target());
  REQUIRE(a.forces({0, 1}));
  a.residual(none, after);
  double error = 0, scale = 0;
  for (std::size_t i = 0; i < n; ++i) {
    error = std::max(error, std::abs(after[i] - before[i] + product[i]));
    scale = std::max(scale, std::abs(product[i]));
  }
  REQUIRE(scale > 0);
  CHECK(error < 0.02 * scale);  // friction's rise is a parabola, contact's onset too
  // A step of the cloth onto the ball is cut, one away from it is not.
  a.begin_iterate();
  std::vector<double> down(n, 0);
  for (std::size_t i = 0; i < n; ++i)
    if (!a.dofs().turns(static_cast<mechanics::Index>(i)) && i % 5 == 2) down[i] = -0.01;
  const double share = a.limit(down, {});
  CHECK(share > 0);
  CHECK(share < 0.1);
}

TEST_CASE("contact: forces and energies have the same bits for one, two and four threads") {
  std::vector<double> first;
  const int most = omp_get_max_threads();
  for (const int threads : {1, 2, 4}) {
    omp_set_num_threads(threads);
    const Pile pile(0.3);
    mechanics::Assembly a(*pile.model);
    a.set_time(1);
    std::vector<double> all =
        internal_at(a, directions(static_cast<std::size_t>(a.dofs().unknowns()), 1e-5), 1);
    for (const auto& energy : a.energies()) all.push_back(energy.value);
    if (first.empty()) first = all;
    CHECK(all == first);
  }
  omp_set_num_threads(most);
}

TEST_CASE("contact: a rollback takes back the couplings of the states that were tried") {
  // A ball just below a sheet; a step that brings them together couples nodes of the sheet with each other.
  const Pile pile(0.2);
  mechanics::Assembly a(*pile.model), untried(*pile.model);
  const auto n = static_cast<std::size_t>(a.dofs().unknowns());
  const auto pattern_at = [&](mechanics::Assembly& b, const std::vector<double>& step) {
    b.set_time(1);
    b.begin_iterate();
    b.apply_increment(step, 1, b.dofs().targets(1));
    linear::Matrix K;
    b.tangent({0, 1}, K, {}, {});
    return std::pair(K.pattern->column, K.pattern->row);
  };
  // The upper sheet slides by several elements, so that other nodes are near each other.
  std::vector<double> slide(n, 0);
  const auto first = a.dofs().freedoms().nodes.size() - 16;
  for (std::size_t i = first; i < a.dofs().freedoms().nodes.size(); ++i) {
    slide[static_cast<std::size_t>(a.dofs().freedoms().nodes[i].equation[0])] = 0.009;
    slide[static_cast<std::size_t>(a.dofs().freedoms().nodes[i].equation[1])] = -0.007;
  }
  const std::vector<double> still(n, 0);
  const auto clean = pattern_at(untried, still), tried = pattern_at(a, slide);
  REQUIRE(tried != clean);
  a.rollback();
  CHECK(pattern_at(a, still) == clean);
  // The committed pattern stays.
  a.rollback();
  pattern_at(a, slide);
  a.commit(1);
  const auto kept = pattern_at(a, still);
  a.rollback();
  CHECK(pattern_at(a, still) == kept);
  CHECK(kept != clean);
}
