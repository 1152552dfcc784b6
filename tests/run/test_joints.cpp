// Cutting and joining during a run: what is conserved, and that a run goes back over it and on again with the
// same bits.
#include "base/error.hpp"
#include "catch.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/terms/cloth.hpp"
#include "problems.hpp"
#include "run/dynamic.hpp"
#include "run/static.hpp"

using namespace fabricsh;
using run::Run;

namespace {

constexpr double kWidth = 0.03, kHeight = 0.08;

enum class Kind { still, implicit, motion };

// A strip of 3 x 8 elements that is pulled at its top.
std::shared_ptr<model::Model> strip(bool touches = false) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(kWidth, kHeight, 3, 8));
  card::Card card = test::isotropic(1e6, 0.3, 5e-4);
  card.density = 500;
  auto m = std::make_shared<model::Model>(mesh, card, model::Options{});
  m->add<model::Zone>({"all"});
  m->fix("all", model::parse_freedoms("z"));
  m->fix("bottom", model::parse_freedoms("x y"));
  m->fix("top", model::parse_freedoms("x"));
  model::Components pull;
  pull[1] = history::History::table({{0, 0}, {0.01, 2e-3}});
  m->move("top", pull);
  if (touches) m->add<model::ContactGiven>({{{"all", nullptr}}, 0.0});
  return m;
}

std::shared_ptr<Run> make(Kind kind, const std::shared_ptr<model::Model>& m, double damping = 0) {
  if (kind == Kind::still) {
    run::StaticOptions o;
    o.duration = 0.02;
    o.step = 1e-3;
    return std::make_shared<run::Static>(m, o, test::quiet());
  }
  run::DynamicOptions o;
  o.duration = 0.02;
  o.scheme = kind == Kind::implicit ? run::Scheme::implicit_steps : run::Scheme::explicit_steps;
  if (kind == Kind::implicit)
    o.step = 1e-4, o.hht = 0;  // no damping, which would begin where steps make energy
  o.ledger_limit = 1;
  o.mass_damping = damping;
  return run::make_dynamic(m, o, test::quiet());
}

const Run::Along kMiddle{"", {{-1, kHeight / 2, 0}, {1, kHeight / 2, 0}}};

std::vector<double> all_numbers(const Run& a) {
  std::vector<double> all;
  for (const char* name : {"displacement", "director", "E", "S"})
    for (const double v : a.field(name)) all.push_back(v);
  if (a.moves())
    for (const double v : a.field("velocity")) all.push_back(v);
  const run::EnergyAccount e = a.energy();
  all.insert(all.end(), {e.kinetic, e.stored, e.dissipated, e.external, a.reaction("bottom").y()});
  return all;
}

// Without printing them all.
bool same(const Run& a, const std::vector<double>& numbers) { return all_numbers(a) == numbers; }

Vec3 momentum(const Run& a) {
  Vec3 sum = Vec3::Zero();
  const auto v = a.field("velocity");
  const auto& mass = a.assembly().cloth().mass();
  for (std::size_t n = 0; n < mass.size(); ++n) sum += mass[n] * at(v, static_cast<std::ptrdiff_t>(n));
  return sum;
}

}  // namespace

TEST_CASE("a strip under tension is cut in two: restored and cut again it has the same bits") {
  const Kind kind = GENERATE(Kind::still, Kind::implicit, Kind::motion);
  auto a = make(kind, strip());
  a->advance(0.01);
  const auto snapshot = a->snapshot();
  const double pulled = a->reaction("bottom").y();
  CHECK(pulled < 0);
  CHECK(a->cut(kMiddle) == 4);
  const auto after_cut = a->snapshot();
  a->advance(0.012);
  const auto first = all_numbers(*a);
  a->solve();
  const auto end = all_numbers(*a);
  // Back over the cut, and to where it has just been made.
  a->restore(*snapshot);
  CHECK(a->assembly().dofs().joints().open() == 0);
  CHECK(a->reaction("bottom").y() == pulled);
  a->cut(kMiddle);
  a->advance(0.012);
  CHECK(same(*a, first));
  a->solve();
  CHECK(same(*a, end));
  a->restore(*snapshot);
  a->restore(*after_cut);
  CHECK(a->assembly().dofs().joints().open() == 4);
  a->advance(0.012);
  a->solve();
  CHECK(same(*a, end));
  // Another run of the same model takes the state over.
  a->restore(*after_cut);
  a->advance(0.012);
  auto b = make(kind, strip());
  b->resume(a->kept());
  CHECK(same(*b, first));
  b->solve();
  CHECK(same(*b, end));
}

TEST_CASE("cutting in statics takes the force out of the strip") {
  auto a = make(Kind::still, strip());
  a->advance(0.01);
  const run::EnergyAccount before = a->energy();
  a->cut(kMiddle);
  CHECK(a->energy().stored == before.stored);
  a->advance(0.011);
  CHECK(std::abs(a->reaction("bottom").y()) < 1e-9);
  CHECK(a->energy().stored < 1e-12 * before.stored);
  // The energy that the strip had stored has been taken away, nothing has been made.
  CHECK(a->energy().relaxed - before.relaxed == Approx(before.stored).epsilon(1e-9));
}

TEST_CASE("a cut in motion leaves momentum and energy as they are, and the ledger closes on") {
  const Kind kind = GENERATE(Kind::implicit, Kind::motion);
  auto a = make(kind, strip());
  a->advance(0.01);
  const run::EnergyAccount before = a->energy();
  const Vec3 p = momentum(*a);
  REQUIRE(before.kinetic > 0);
  CHECK(a->cut(kMiddle) == 4);
  const run::EnergyAccount after = a->energy();
  CHECK((momentum(*a) - p).norm() <= 1e-12 * p.norm());
  CHECK(std::abs(after.kinetic - before.kinetic) <= 1e-12 * before.kinetic);
  CHECK(after.stored == before.stored);
  CHECK(after.external == before.external);
  a->solve();
  CHECK(a->energy().error < 2e-3);
  CHECK(a->energy().kinetic > before.kinetic);  // the halves recoil
  const auto& X = a->assembly().dofs().reference();
  for (mesh::Index n = 0; n < static_cast<mesh::Index>(X.size()); ++n)
    if (a->model().mesh().place_of(n) == n && X[n].y() == kHeight / 2 &&
        a->assembly().dofs().joints().is_open(n))
      CHECK(a->node(n).u.y() != 0);
}

TEST_CASE("joints that close lose the kinetic energy of the halves against each other, and no momentum") {
  const Kind kind = GENERATE(Kind::implicit, Kind::motion);
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(kWidth, kHeight, 3, 8));
  mesh->define("upper", [](const Vec3& X) { return X.y() > kHeight / 2 + 1e-9; });
  card::Card card = test::isotropic(1e6, 0.3, 5e-4);
  card.density = 500;
  auto m = std::make_shared<model::Model>(mesh, card, model::Options{});
  m->add<model::Zone>({"all"});
  model::InitialVelocity up{"upper", Vec3(0.2, 0.1, -0.1)};
  m->add(up);
  auto a = make(kind, m);
  CHECK(a->cut(kMiddle) == 4);  // before the run begins
  a->advance(2e-3);
  const run::EnergyAccount before = a->energy();
  const Vec3 p = momentum(*a);
  CHECK_THROWS_WITH(a->join(kMiddle), Catch::StartsWith("join: nodes ") && Catch::Contains("m apart"));
  CHECK(a->join(kMiddle, 1e-3) == 4);
  CHECK(a->assembly().dofs().joints().open() == 0);
  const run::EnergyAccount after = a->energy();
  CHECK((momentum(*a) - p).norm() <= 1e-12 * p.norm());
  CHECK(after.lost_in("joints") > 0);
  CHECK(after.lost_in("joints") == Approx(before.kinetic - after.kinetic).epsilon(1e-12));
  // The energy stored by pulling the crack faces together is work from outside.
  const double work = after.external - before.external, stored = after.stored - before.stored;
  CHECK(std::abs(work - stored) <= 1e-12 * (before.kinetic + after.stored));
  a->advance(0.005);
  CHECK((momentum(*a) - p).norm() <= 1e-9 * p.norm());
  CHECK(a->energy().error < (kind == Kind::implicit ? 1e-3 : 5e-3));
}

TEST_CASE("halves that were cut and come back touch, and do not pass") {
  const Kind kind = GENERATE(Kind::implicit, Kind::motion);
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(kWidth, kHeight, 3, 8));
  mesh->define("upper", [](const Vec3& X) { return X.y() > kHeight / 2 - 1e-9; });
  mesh->define("lower", [](const Vec3& X) { return X.y() < kHeight / 2 + 1e-9; });
  card::Card card = test::isotropic(1e6, 0.3, 5e-4);
  card.density = 500;
  auto m = std::make_shared<model::Model>(mesh, card, model::Options{});
  m->add<model::Zone>({"all"});
  m->fix("all", model::parse_freedoms("x z rx ry rz"));
  m->fix("bottom", model::parse_freedoms("y"));
  model::Components pull;  // apart, and back by as much as the strip is long to be pressed together
  pull[1] = history::History::table({{0, 0}, {0.006, 1e-3}, {0.02, -5e-4}});
  m->move("top", pull);
  m->add<model::ContactGiven>({{{"all", nullptr}}, 0.0});
  auto a = make(kind, m, 1000);
  const auto& X = a->assembly().dofs().reference();
  a->advance(0.0005);
  CHECK(a->cut(kMiddle) == 4);
  CHECK(a->energy().contact + a->energy().guard == 0);
  double least = 1, most = 0, energy = 0;
  a->every_step([&](Run& run) {
    const auto& joints = run.assembly().dofs().joints();
    for (mesh::Index n = 0; n < static_cast<mesh::Index>(X.size()); ++n) {
      const mesh::Index place = run.model().mesh().place_of(n);
      if (!joints.is_open(n) || joints.leader(n) == joints.leader(place)) continue;
      const double apart = run.node(n).x.y() - run.node(place).x.y();
      least = std::min(least, apart);
      most = std::max(most, apart);
    }
    energy = std::max(energy, run.energy().contact);
  });
  a->solve();
  CHECK(least >= 0);   // never through each other
  CHECK(most > 5e-4);  // they were apart
  CHECK(energy > 0);   // and were pressed together again
  CHECK(a->energy().error < 2e-2);
}

TEST_CASE("cut and join say what they need") {
  auto a = make(Kind::still, strip());
  CHECK_THROWS_WITH(a->cut({"", {{0, 0.043, 0}, {1, 0.043, 0}}}),
                    Catch::StartsWith("cut: no edge between two elements of a zone lies on the line"));
  CHECK_THROWS_WITH(a->cut({"top", {}}),
                    Catch::StartsWith("cut: set 'top' has no edge between two elements"));
  auto m = strip();
  m->remove<model::Zone>(0);
  auto b = make(Kind::still, m);
  CHECK_THROWS_WITH(b->cut(kMiddle),
                    "cut: the model has no tearable zone: expected m:tearable(set) before the run");
  a->event([&](Run& run) { return run.cut(kMiddle), 1.0; }, 1e-3, {});
  CHECK_THROWS_WITH(a->solve(), Catch::StartsWith("cut: expected between two steps"));
}
