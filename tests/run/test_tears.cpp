// Yarns that break in motion: what it costs, at which force a tear runs, and that it does so again with the
// same bits.
#include <random>

#include "base/error.hpp"
#include "catch.hpp"
#include "problems.hpp"
#include "run/dynamic.hpp"
#include "run/static.hpp"

using namespace fabricsh;
using run::Run;

namespace {

constexpr double kTornModulus = 1e8, kThickness = 5e-4;   // Pa, m
constexpr double kStiffness = kTornModulus * kThickness;  // N/m; E' is the same without cross contraction

card::Card cloth(double strength, double energy) {
  card::Card card = test::isotropic(kTornModulus, 0, kThickness);
  card.density = 500;
  card.rupture = card::Rupture{{}, card::YarnBreak{strength, energy, {}}};
  return card;
}

std::shared_ptr<Run> motion(const std::shared_ptr<model::Model>& m, double duration, double damping,
                            const std::shared_ptr<Notices>& notices = test::quiet()) {
  run::DynamicOptions o;
  o.duration = duration;
  o.mass_damping = damping;
  o.ledger_limit = 1;
  return run::make_dynamic(m, o, notices);
}

void pull(model::Model& m, std::vector<std::pair<double, double>> way) {
  model::Components up;
  up[1] = history::History::table(std::move(way));
  m.move("top", up);
}

// A bar of n elements, 10 mm wide and 40 mm long, whose uppermost element is joined to the next one, or to
// the support of its lower end if there is none, by weft that can break.
struct Bar {
  double strength = 5000, energy = 40;
  int elements = 4;
  static constexpr double width = 0.01, length = 0.04, duration = 0.12, way = 0.024;
  std::shared_ptr<model::Model> model() const {
    const double h = length / elements;
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(width, length, 1, elements));
    mesh->define("end", [&](const Vec3& X) { return X.y() > length - 1.01 * h; });
    auto m = std::make_shared<model::Model>(mesh, cloth(strength, energy), model::Options{});
    m->add<model::Zone>({"end"});
    m->fix("all", model::parse_freedoms("x z rotation"));
    m->fix("bottom", model::parse_freedoms("y"));
    std::vector<std::pair<double, double>> smooth;  // begins without a jump of the speed
    for (int i = 0; i <= 20; ++i) smooth.emplace_back(duration / 3 * i / 20, way / 5 * std::pow(i / 20.0, 2));
    smooth.emplace_back(duration, way);
    pull(*m, smooth);
    return m;
  }
};

}  // namespace

TEST_CASE("a bar with one weak joint loses the energy of its yarns, however many elements it has") {
  Bar bar;
  bar.elements = GENERATE(2, 4, 8, 16);
  auto a = motion(bar.model(), Bar::duration, 0);
  double peak = 0, before = 0;
  bool falls = false;
  a->every_step([&](Run& run) {
    peak = std::max(peak, run.reaction("top").y());
    const double fracture = run.energy().lost_in("fracture");
    falls = falls || fracture < before;
    before = fracture;
  });
  a->solve();
  CAPTURE(bar.elements, peak, a->energy().error);
  CHECK_FALSE(falls);
  CHECK(a->assembly().dofs().joints().open() == 2);
  CHECK(a->energy().lost_in("fracture") == Approx(bar.energy * Bar::width).epsilon(1e-6));
  CHECK(peak == Approx(bar.strength * Bar::width).epsilon(5e-3));
  CHECK(a->energy().error < 1e-3);
}

namespace {

// A wide strip with a long cut, held by its long edges, which are drawn apart until the cut runs on.
struct Strip {
  double h = 2e-3, strength = 3857, energy = 2.5;
  bool lower = true;
  double fast = 5e-3, slow = 15e-3;  // s, to 0.85 and on to 1.15 of the way at which it should run
  static constexpr double height = 0.04, length = 0.1, cut = 0.036;
  // By Rivlin and Thomas: the energy of the strip far before the tip, per area, times its height, is G.
  double way() const {
    const double strain = std::sqrt(2 * energy / (kStiffness * height));
    return height * (std::sqrt(1 + 2 * strain) - 1);
  }
  double released(double moved) const {
    const double stretch = 1 + moved / height, strain = (stretch * stretch - 1) / 2;
    return kStiffness * strain * strain / 2 * height;
  }
  std::shared_ptr<model::Model> model() const {
    const auto rows = static_cast<int>(std::lround(height / h)),
               columns = static_cast<int>(std::lround(length / h));
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(length, height, columns, rows));
    mesh->define("middle", [&](const Vec3& X) { return std::abs(X.y() - height / 2) < 1.01 * h; });
    auto m = std::make_shared<model::Model>(mesh, cloth(strength, energy), model::Options{});
    m->add<model::Zone>({"middle", lower});
    m->fix("all", model::parse_freedoms("z rotation"));
    m->fix("bottom", model::parse_freedoms("x y"));
    m->fix("top", model::parse_freedoms("x"));
    pull(*m, {{0, 0}, {fast, 0.85 * way()}, {fast + slow, 1.15 * way()}});
    return m;
  }
  std::shared_ptr<Run> run() const {
    auto a = motion(model(), fast + slow, 2000);
    a->cut({"", {{0, height / 2, 0}, {cut, height / 2, 0}}});
    return a;
  }
  static double tip(const Run& a) {  // m, how far the cut reaches
    double far = 0;
    for (mesh::Index n = 0; n < static_cast<mesh::Index>(a.model().mesh().whole->nodes.size()); ++n)
      if (a.assembly().dofs().joints().is_open(n))
        far = std::max(far, a.assembly().dofs().reference()[n].x());
    return far;
  }
};

}  // namespace

TEST_CASE("a long cut in a wide strip runs on when the strip stores its energy per area over the height") {
  Strip strip;
  strip.h = GENERATE(2e-3, 4e-3);  // the second is too coarse: its strength is lowered
  auto a = strip.run();
  double at = 0;
  a->every_step([&](Run& run) {
    if (at > 0 || Strip::tip(run) < Strip::cut + 0.016) return;
    at = strip.released(run.node(run.model().mesh().set("top").front()).u.y());
    run.stop("the cut runs");
  });
  a->solve();
  CAPTURE(strip.h, at / strip.energy);
  CHECK(at == Approx(strip.energy).epsilon(0.05));
  CHECK(a->energy().error < 1e-2);
}

TEST_CASE("a tear that is interrupted and taken up goes on with the same bits") {
  Strip strip;
  strip.h = 4e-3;
  strip.slow = 5e-3;
  const auto numbers = [](const Run& a) {
    std::vector<double> all = a.field("displacement");
    for (const char* name : {"velocity", "rupture_weft", "joint_open"})
      for (const double v : a.field(name)) all.push_back(v);
    all.insert(all.end(), {a.energy().lost_in("fracture"), a.energy().stored, a.energy().kinetic});
    return all;
  };
  auto a = strip.run();
  std::shared_ptr<const Run::Snapshot> there;
  std::string kept;
  a->every_step([&](Run& run) {
    if (Strip::tip(run) > Strip::cut + 0.009) run.stop("under way");
  });
  a->solve();
  REQUIRE(a->stopped());
  there = a->snapshot();
  kept = a->kept();
  const double open = Strip::tip(*a);
  const auto go_on = [&](Run& run) {
    for (int i = 0; i < 150; ++i) run.step();
  };
  go_on(*a);
  const auto first = numbers(*a);
  CHECK(Strip::tip(*a) > open);
  CHECK(a->energy().lost_in("fracture") > 0);
  a->restore(*there);
  CHECK(Strip::tip(*a) == open);
  go_on(*a);
  CHECK((numbers(*a) == first));
  auto b = motion(strip.model(), strip.fast + strip.slow, 2000);
  b->resume(kept);
  go_on(*b);
  CHECK((numbers(*b) == first));
}

TEST_CASE("a zone that is too coarse is refused or lowers the strength with a line") {
  Strip strip;
  strip.h = 4e-3;
  strip.lower = false;
  CHECK_THROWS_WITH(
      strip.run(),
      Catch::Contains("its elements, 0.004 m along the tear, are coarse for tears across the weft, "
                      "which want 0.0024") &&
          Catch::Contains(" N/m in place of 3857 N/m"));
}

TEST_CASE("a static bar with one weak joint loses the energy of its yarns, and carries their strength") {
  Bar bar;
  bar.elements = GENERATE(2, 5);
  run::StaticOptions o;
  o.duration = Bar::duration;
  o.step = Bar::duration / 30;
  auto a = std::make_shared<run::Static>(bar.model(), o, test::quiet());
  double peak = 0;
  a->every_step([&](Run& run) { peak = std::max(peak, run.reaction("top").y()); });
  a->solve();
  CHECK(peak == Approx(bar.strength * Bar::width).epsilon(1e-3));
  CHECK(a->energy().lost_in("fracture") == Approx(bar.energy * Bar::width).epsilon(1e-9));
}

namespace {

// Force over strength of the elements of a square sheet of `cells` x `cells` that is pulled evenly, and the
// force, N/m. At the supports nothing breaks.
std::pair<std::vector<double>, double> even_pull(const card::Card& card, int cells, std::uint64_t seed) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.1, 0.1, cells, cells));
  auto m = std::make_shared<model::Model>(mesh, card, model::Options{});
  m->add(model::Zone{"all", true, seed, {}, true});
  m->fix("all", model::parse_freedoms("x z rotation"));
  m->fix("bottom", model::parse_freedoms("y"));
  pull(*m, {{0, 0}, {1, 1e-4}});
  run::StaticOptions o;
  o.duration = 1;
  o.step = 1;
  run::Static a(m, o, test::quiet());
  a.solve();
  const double stretch = 1 + 1e-4 / 0.1;
  return {a.field("rupture_weft"), kStiffness * (stretch * stretch - 1) / 2 * stretch};
}

// Mean and deviation over the mean of the strength of elements, the weakest of their four joints each.
std::pair<double, double> weakest(const std::vector<double>& shares, double force, int cells) {
  double sum = 0, squares = 0, count = 0;
  for (std::size_t e = 0; e < shares.size(); ++e) {
    const auto row = e / static_cast<std::size_t>(cells), column = e % static_cast<std::size_t>(cells);
    const auto last = static_cast<std::size_t>(cells) - 1;
    if (row == 0 || row == last || column == 0 || column == last) continue;
    const double one = force / shares[e];
    sum += one, squares += one * one, ++count;
  }
  const double mean = sum / count;
  return {mean, std::sqrt(squares / count - mean * mean) / mean};
}

}  // namespace

TEST_CASE("strengths that scatter are drawn by place and seed, with mean and spread after Weibull") {
  constexpr int cells = 50;
  constexpr double strength = 1e5, modulus = 5;
  card::Card card = cloth(strength, 1e5);
  card.rupture->weft->scatter = card::StrengthScatter{modulus, {}, {}};
  const auto [one, force] = even_pull(card, cells, 1);
  CHECK((even_pull(card, cells, 1).first == one));
  CHECK((even_pull(card, cells, 2).first != one));
  // The weakest of four joints around an element: the mean is less by 4^(-1/m), the spread stays.
  const auto [weak, spread] = weakest(one, force, cells);
  const double mean = weak / strength;
  const double g1 = std::tgamma(1 + 1 / modulus), g2 = std::tgamma(1 + 2 / modulus);
  CHECK(mean == Approx(std::pow(4, -1 / modulus)).epsilon(0.02));
  CHECK(spread == Approx(std::sqrt(g2 / (g1 * g1) - 1)).epsilon(0.05));
}

TEST_CASE("a place has the mean of the strengths of its yarns, so that more of them scatter less") {
  constexpr int cells = 50, yarns = 6;
  constexpr double strength = 1e5, modulus = 5;
  card::Card card = cloth(strength, 1e5);
  card.rupture->weft->scatter = card::StrengthScatter{modulus, {}, {}};
  card.rupture->weft->yarns = yarns * cells / 0.1;
  const auto [one, force] = even_pull(card, cells, 1);
  const auto [weak, spread] = weakest(one, force, cells);
  // The weakest of four places of six yarns each, drawn by another generator.
  std::mt19937 generator(7);
  std::weibull_distribution<> yarn(modulus, 1 / std::tgamma(1 + 1 / modulus));
  constexpr int draws = 100000;
  double sum = 0, squares = 0;
  for (int i = 0; i < draws; ++i) {
    double least = 1e9;
    for (int place = 0; place < 4; ++place) {
      double of_place = 0;
      for (int k = 0; k < yarns; ++k) of_place += yarn(generator) / yarns;
      least = std::min(least, of_place);
    }
    sum += least, squares += least * least;
  }
  const double mean = sum / draws;
  CHECK(weak / strength == Approx(mean).epsilon(0.01));
  CHECK(spread == Approx(std::sqrt(squares / draws - mean * mean) / mean).epsilon(0.05));
}

TEST_CASE("cloth that pulls at a support beyond its strength is told of, since nothing breaks there") {
  Bar bar;
  bar.elements = 4;
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(Bar::width, Bar::length, 1, bar.elements));
  mesh->define("jaw", [](const Vec3& X) { return X.y() < 1.01 * Bar::length / 4; });
  // The row of elements in the jaw is the zone: the first place where a yarn could break is the jaw's edge.
  mesh->define("zone", [](const Vec3& X) { return X.y() < 1.01 * Bar::length / 4; });
  auto m = std::make_shared<model::Model>(mesh, cloth(1e3, 40), model::Options{});
  m->add<model::Zone>({"zone"});
  m->fix("all", model::parse_freedoms("x z rotation"));
  m->fix("jaw", model::parse_freedoms("y"));
  const bool moves = GENERATE(false, true);
  pull(*m, {{0, 0}, {0.02, 2e-3}});
  std::shared_ptr<Run> a;
  if (moves) {
    a = motion(m, 0.02, 500);
  } else {
    run::StaticOptions o;
    o.duration = 0.02;
    o.step = 2e-3;
    a = std::make_shared<run::Static>(m, o, test::quiet());
  }
  a->solve();
  CHECK(a->energy().lost_in("fracture") == 0);
  const auto& warnings = a->warnings();
  CHECK(std::count_if(warnings.begin(), warnings.end(), [](const auto& w) { return w.code == "held"; }) == 1);
}

TEST_CASE("in explicit steps the share of strength that is read is that of static ones") {
  // Shares far below one are not measured at each explicit step, but when they are read.
  Strip strip;
  strip.h = 4e-3;
  auto moving = motion(strip.model(), strip.fast + strip.slow, 2000);
  moving->advance(0.3 * strip.fast);
  const auto shares = moving->field("rupture_weft");
  const auto found = std::max_element(shares.begin(), shares.end());
  REQUIRE(*found > 0.05);
  REQUIRE(*found < 0.4);
  const std::string kept = moving->kept();
  auto other = motion(strip.model(), strip.fast + strip.slow, 2000);
  other->resume(kept);
  CHECK((other->field("rupture_weft") == shares));
}
