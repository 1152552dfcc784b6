// Motion against closed forms: free flight, frequencies, orders, agreement of the schemes, the ledger.
#include <omp.h>

#include <algorithm>
#include <numbers>

#include "catch.hpp"
#include "mechanics/terms/cloth.hpp"
#include "message_of.hpp"
#include "run/dynamic.hpp"
#include "run/explicit.hpp"
#include "run/problems.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using namespace fabricsh::test;
using run::DynamicOptions;
using run::make_dynamic;
using run::Run;
using run::Scheme;

namespace {

struct Momenta {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
};

// From the velocities of nodes and directors.
Momenta momenta(const Run& a, const mechanics::NodalRates& rates) {
  Momenta sum;
  const auto& mass = a.assembly().cloth().mass();
  const auto& rotary = a.assembly().cloth().rotary_inertia(true);
  for (std::size_t n = 0; n < mass.size(); ++n) {
    const auto node = a.node(static_cast<mesh::Index>(n));
    const Eigen::Map<const Vec3> w(rates.d.data() + 3 * n);
    sum.linear += mass[n] * node.v;
    sum.angular += mass[n] * node.x.cross(node.v) + rotary[n] * node.n.cross(Vec3(w));
  }
  return sum;
}

std::shared_ptr<model::Model> make_flight(int n) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(1, 1, n, n));
  auto m = std::make_shared<model::Model>(mesh, blend(), model::Options{});
  m->add<model::InitialVelocity>({"all", Vec3(0.3, -0.2, 0.5), Vec3(2, 1, 5), Vec3(0.5, 0.5, 0)});
  return m;
}

// The time of the n-th return of a value through zero upwards, by linear interpolation.
struct Crossings {
  std::vector<double> times;
  double last_time = 0, last = 0;
  void see(double time, double value) {
    if (last < 0 && value >= 0) times.push_back(last_time + (time - last_time) * -last / (value - last));
    last_time = time;
    last = value;
  }
  double period() const { return (times.back() - times.front()) / static_cast<double>(times.size() - 1); }
};

// A set of its own for a node, so that it can be given its own motion.
std::string only(mesh::Mesh& mesh, std::size_t node) {
  const std::string name = "node " + std::to_string(node);
  mesh.define(name, mesh::NodeSet{static_cast<mesh::Index>(node)});
  return name;
}

constexpr double kGreen = 0.05, kModulus = 1e6, kDensity = 1000;

// A string: a narrow strip of unit length, every node of which is driven along x so that its Green-Lagrange
// strain is kGreen; plucked with its first mode.
std::shared_ptr<model::Model> make_string(int cells, double width) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(1, width, cells, 1));
  auto card = isotropic(kModulus, 0, 1e-4);
  card.density = kDensity;
  std::vector<std::string> sets;
  for (std::size_t i = 0; i < mesh->nodes.size(); ++i) sets.push_back(only(*mesh, i));
  auto m = std::make_shared<model::Model>(mesh, card, model::Options{});
  m->fix("all", model::parse_freedoms("y rx rz"));
  for (const char* end : {"left", "right"}) m->fix(end, model::parse_freedoms("z"));
  const double stretch = std::sqrt(1 + 2 * kGreen);
  for (std::size_t i = 0; i < mesh->nodes.size(); ++i) {
    const double X = mesh->nodes[i].x();
    model::Components along;
    along[0] = history::History::constant((stretch - 1) * X);
    m->move(sets[i], along);
    m->add<model::InitialVelocity>(
        {sets[i], Vec3(0, 0, 1e-4 * std::sin(std::numbers::pi * X)), Vec3::Zero(), Vec3::Zero()});
  }
  return m;
}

double measured_period(run::Dynamic& a, mesh::Index node) {
  Crossings crossings;
  a.every_step([&](Run& r) { crossings.see(r.time(), r.node(node).u.z()); });
  a.solve();
  REQUIRE(crossings.times.size() >= 3);
  return crossings.period();
}

// A simply supported square plate of unit side, in its first mode.
constexpr double kPlate = 0.02;  // thickness
std::shared_ptr<model::Model> make_plate(int n) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(1, 1, n, n));
  auto card = isotropic(kModulus, 0.3, kPlate);
  card.density = kDensity;
  std::vector<std::string> sets;
  for (std::size_t i = 0; i < mesh->nodes.size(); ++i) sets.push_back(only(*mesh, i));
  auto m = std::make_shared<model::Model>(mesh, card, model::Options{});
  m->fix("all", model::parse_freedoms("x y"));
  for (const char* edge : {"left", "right"}) m->fix(edge, model::parse_freedoms("z rx"));
  for (const char* edge : {"bottom", "top"}) m->fix(edge, model::parse_freedoms("z ry"));
  for (std::size_t i = 0; i < mesh->nodes.size(); ++i) {
    const Vec3& X = mesh->nodes[i];
    m->add<model::InitialVelocity>(
        {sets[i], Vec3(0, 0, 1e-5 * std::sin(std::numbers::pi * X.x()) * std::sin(std::numbers::pi * X.y())),
         Vec3::Zero(), Vec3::Zero()});
  }
  return m;
}

// A strip of the blend, held at its left edge, level, that falls.
std::shared_ptr<model::Model> make_swing(int cells) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.2, 0.05, cells, 1));
  auto m = std::make_shared<model::Model>(mesh, blend(), model::Options{});
  m->fix("left", model::parse_freedoms("x y z"));
  m->gravity(model::steady({0, 0, -9.81}));
  return m;
}

Vec3 tip(const Run& a) { return a.node(static_cast<mesh::Index>(a.model().mesh().nodes.size()) - 1).x; }

}  // namespace

TEST_CASE("free flight: momentum and angular momentum to rounding, energy to 1e-8") {
  const auto a = make_dynamic(make_flight(4), {.duration = 0.1, .step = 1e-5}, quiet());
  a->advance(1e-5);
  const Momenta before = momenta(*a, a->rates());
  a->solve();
  CHECK(a->steps().size() >= 10000);
  const Momenta after = momenta(*a, a->rates());
  CHECK((after.linear - before.linear).norm() < 1e-12 * before.linear.norm());
  CHECK((after.angular - before.angular).norm() < 1e-12 * before.angular.norm());
  const auto e = a->energy();
  CHECK(e.internal() > 0);
  CHECK(std::abs(e.surplus()) < 1e-8 * e.initial);
}

TEST_CASE("a taut strip's first frequency; second order in the step, explicit and implicit", "[many]") {
  // w_tt = (S / rho) w_XX; the chain of lumped masses has sin; rotary inertia of directors adds I k^2.
  const int cells = 16;
  const double width = 0.002, h = 1.0 / cells, speed = std::sqrt(kModulus * kGreen / kDensity);
  const double chain = 2 / h * speed * std::sin(std::numbers::pi * h / 2);
  const auto period = [&](Scheme scheme, double step) {
    const double k = std::numbers::pi,
                 I = scheme == Scheme::explicit_steps ? 5.0 / 12 * width * width / 4 : 1e-8 / 12;
    const double omega = chain / std::sqrt(1 + I * k * k);
    const auto a = make_dynamic(
        make_string(cells, width),
        {.duration = 3.3 * 2 * std::numbers::pi / omega, .step = step, .scheme = scheme}, quiet());
    return measured_period(*a, cells / 2) * omega / (2 * std::numbers::pi) - 1;
  };
  for (const auto& [scheme, step] :
       {std::pair{Scheme::explicit_steps, 6e-5}, std::pair{Scheme::implicit_steps, 8e-3}}) {
    const double coarse = period(scheme, step), fine = period(scheme, step / 2);
    INFO(coarse << " " << fine);
    CHECK(std::abs(fine) < 2e-3);
    if (scheme == Scheme::implicit_steps)
      CHECK(std::abs(coarse / fine - 4) < 0.3);
    else
      CHECK(std::abs(fine) < 2e-5);  // directors are not quite the chain's slopes
  }
}

TEST_CASE("a plate's first frequency: Kirchhoff's, corrected for shear and rotary inertia", "[many]") {
  const double D = kModulus * std::pow(kPlate, 3) / (12 * (1 - 0.09)),
               k2 = 2 * std::numbers::pi * std::numbers::pi;
  const double shear = 5.0 / 6 * kModulus / 2.6 * kPlate;
  const double omega =
      std::sqrt(D / (kDensity * kPlate) / (1 + k2 * D / shear + k2 * kPlate * kPlate / 12)) * k2;
  double error[2];
  int i = 0;
  for (const int n : {8, 16}) {
    const auto a = make_dynamic(make_plate(n),
                                {.duration = 3.3 * 2 * std::numbers::pi / omega, .scaled = false}, quiet());
    error[i++] = measured_period(*a, (n / 2) * (n + 1) + n / 2) * omega / (2 * std::numbers::pi) - 1;
  }
  INFO(error[0] << " " << error[1]);
  CHECK(std::abs(error[1]) < 1e-2);
  CHECK(std::abs(error[0] / error[1]) > 3.5);
  CHECK(std::abs(error[0] / error[1]) < 4.5);
}

TEST_CASE("explicit and implicit agree on a swinging strip, the closer the smaller the steps", "[many]") {
  const auto end = [](Scheme scheme, double step) {
    const auto a = make_dynamic(make_swing(8),
                                {.duration = 0.1, .step = step, .scheme = scheme, .scaled = true}, quiet());
    a->solve();
    CHECK(a->energy().error < 2e-3);
    return tip(*a);
  };
  const Vec3 fine = end(Scheme::explicit_steps, 5e-6);
  const double far = (end(Scheme::implicit_steps, 8e-3) - fine).norm();
  const double near = (end(Scheme::implicit_steps, 1.25e-4) - fine).norm();
  INFO(far << " " << near);
  // m, of a strip of 0.2 m. By 0.15 s yarns have become slack and taut again so often that the last digits
  // decide which implicit steps are cut, and the tip differs by up to 6e-5 m for steps from 1e-4 to 2e-3 s.
  // Steps of 1, 0.5, 0.25, 0.125, 0.0625 ms are off by 1.5, 4.5, 4.2, 1.4, 0.03 um.
  CHECK(near < 2.5e-6);
  CHECK(near < far / 25);
}

// A strip of the blend, 8 x 4 elements, level or turned in space, its left edge or both ends pinned, that
// falls; or the part of it that planes of symmetry leave.
struct Cut {
  bool both_ends = false;              // pinned
  bool along = false, across = false;  // cut in the middle of the width, of the length
  bool turned = false;
  int cells() const { return across ? 4 : 8; }  // along the strip
};

std::unique_ptr<run::Dynamic> make_cut(const Cut& cut, const DynamicOptions& options) {
  const double length = cut.across ? 0.1 : 0.2, width = cut.along ? 0.05 : 0.1;
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(length, width, cut.cells(), cut.along ? 2 : 4));
  Mat3 R = Mat3::Identity();
  if (cut.turned) R = Eigen::AngleAxisd(1.9, Vec3(0.5, -0.3, 0.8).normalized()).toRotationMatrix();
  mesh->map([&](const Vec3& X) { return Vec3(R * X); });
  model::Options along;
  along.warp = [R](const Vec3&) { return model::Direction(Vec3(R.col(0))); };
  auto m = std::make_shared<model::Model>(mesh, blend(), along);
  m->fix("left", model::parse_freedoms("x y z"));
  if (cut.both_ends && !cut.across) m->fix("right", model::parse_freedoms("x y z"));
  if (cut.along) m->fix("top", model::parse_freedoms("y rx rz"), R.transpose());
  if (cut.across) m->fix("right", model::parse_freedoms("x ry rz"), R.transpose());
  m->gravity(model::steady(R * Vec3(0, 0, -9.81)));
  return std::make_unique<run::Explicit>(m, options, quiet());
}

namespace {

void check_cuts(int steps) {
  for (const bool both_ends : {false, true})
    for (const auto& options : {DynamicOptions{.duration = steps * 1e-5, .step = 1e-5, .scaled = true},
                                DynamicOptions{.duration = steps * 6e-6, .step = 4e-6, .scaled = false}}) {
      Cut cut{.both_ends = both_ends};
      const auto whole = make_cut(cut, options);
      whole->solve();
      CHECK(whole->energy().error < 1e-6);
      cut.along = true;
      cut.across = both_ends;
      for (const bool turned : {false, true}) {
        CAPTURE(both_ends, *options.scaled, turned);
        cut.turned = turned;
        const auto part = make_cut(cut, options);
        part->solve();
        CHECK(part->steps().size() >= static_cast<std::size_t>(steps));
        double worst = 0;
        const int row = cut.cells() + 1, rows = 3;
        for (int n = 0; n < row * rows; ++n) {
          const double moved = whole->node(n / row * 9 + n % row).u.norm();
          worst = std::max(worst, std::abs(part->node(n).u.norm() - moved));
        }
        CHECK(worst < 1e-10);  // m: what rounding grows to
        CHECK(std::abs(part->energy().error - whole->energy().error) < 1e-10);
      }
    }
}

}  // namespace

TEST_CASE("half and quarter move as the whole does through 4,000 steps, turned in space too", "[many]") {
  check_cuts(4000);
}

TEST_CASE("half and quarter move as the whole does through 20,000 steps, turned in space too", "[long]") {
  check_cuts(20000);
}

TEST_CASE("restored, a run in motion gives the same bits as if it had never gone on") {
  for (const auto scheme : {Scheme::explicit_steps, Scheme::implicit_steps}) {
    std::vector<double> ends[2], work;
    for (const bool detour : {false, true}) {
      const auto a = make_dynamic(make_swing(4), {.duration = 0.03, .scheme = scheme}, quiet());
      a->advance(0.01);
      const auto s = a->snapshot();
      if (detour) {
        a->advance(0.02);
        a->restore(*s);
      }
      a->solve();
      ends[detour] = positions(*a);
      work.push_back(a->energy().external);
    }
    CHECK(ends[0] == ends[1]);
    CHECK(work[0] == work[1]);
  }
}

TEST_CASE("one, two and four threads give the same bits") {
  const int before = omp_get_max_threads();
  std::vector<double> ends[3];
  int i = 0;
  for (const int threads : {1, 2, 4}) {
    omp_set_num_threads(threads);
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(2, 2, 64, 64));
    auto m = std::make_shared<model::Model>(mesh, blend(), model::Options{});
    m->fix("corners", model::parse_freedoms("x y z"));
    m->gravity(model::steady({0, 0, -9.81}));
    const auto a = make_dynamic(m, {.duration = 3e-3}, quiet());
    a->solve();
    ends[i++] = positions(*a);
  }
  omp_set_num_threads(before);
  CHECK(ends[0] == ends[1]);
  CHECK(ends[0] == ends[2]);
}

TEST_CASE("the step rule: warned once above 0.7 of the stable step, refused above it") {
  std::vector<std::string> said;  // of the step
  const auto notices = std::make_shared<Notices>([&](const std::string& text) {
    if (text.find("stable") != std::string::npos) said.push_back(text);
  });
  const double stable = make_dynamic(make_swing(4), {.duration = 1}, notices)->stable_step();
  CHECK(said.empty());
  // h over the wave speed of the stiffest tangent: blend [[Du1 + c nu12, c], [c, Du2 + c nu21]].
  const double c = 0.42 * 8e6 / (1 - 0.25 * 0.42), a = 864e6 + 0.25 * c, b = 1080e6 + 0.42 * c;
  const double K = (a + b) / 2 + std::sqrt((a - b) * (a - b) / 4 + c * c);
  CHECK(std::abs(stable / (0.05 / std::sqrt(K / 590)) - 1) < 1e-12);
  make_dynamic(make_swing(4), {.duration = 1, .step = 0.8 * stable}, notices);
  REQUIRE(said.size() == 1);
  says(said[0], "above 0.7 of the stable one");
  says(message_of([&] { make_dynamic(make_swing(4), {.duration = 1, .step = 1.1 * stable}, notices); }),
       "force=true");
  make_dynamic(make_swing(4), {.duration = 1, .step = 1.1 * stable, .force = true}, notices);
  CHECK(said.size() == 1);
}

TEST_CASE("stretch that brings the stable step below the one in use splits it, said once") {
  std::vector<std::string> said;
  const auto notices = std::make_shared<Notices>([&](const std::string& text) { said.push_back(text); });
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(1, 1, 4, 4));
  auto card = isotropic(1e9, 0.3, 0.01);
  card.density = 1000;
  auto m = std::make_shared<model::Model>(mesh, card, model::Options{});
  m->fix("all", model::parse_freedoms("z rotation"));
  m->fix("left", model::parse_freedoms("x y"));
  model::Components out;
  out[0] =
      history::History::callback([](double t) { return 0.3 * (1 - std::cos(std::numbers::pi * t / 0.2)); });
  m->move("right", out);
  const auto probe = make_dynamic(m, {.duration = 0.2}, quiet());
  const double step = 0.95 * probe->stable_step();
  const auto a = make_dynamic(m, {.duration = 0.2, .step = step}, notices);
  a->solve();
  CHECK(std::count_if(said.begin(), said.end(), [](const std::string& text) {
          return text.find("is split from here on") != std::string::npos;
        }) == 1);
  CHECK(a->steps().front().step > 0.9 * step);
  // By eighths, not by halves.
  CHECK(a->steps().back().step > 0.505 * step);
  CHECK(a->steps().back().step < 0.9 * step);
}

TEST_CASE("a step above the stable one, forced, is stopped by the ledger or as a runaway") {
  auto m = make_swing(16);
  const double stable = make_dynamic(m, {.duration = 1}, quiet())->stable_step();
  const auto a = make_dynamic(m, {.duration = 1, .step = 3 * stable, .force = true}, quiet());
  try {
    a->solve();
    FAIL("no failure");
  } catch (const NumericalFailure& failure) {
    const std::string message = failure.what();
    INFO(message);
    says(message, "dynamic: stopped at time");
    says(message, "\nTry: ");
  }
}

TEST_CASE("damping loses what its ledger says, explicit and implicit") {
  for (const auto scheme : {Scheme::explicit_steps, Scheme::implicit_steps}) {
    DynamicOptions options{.duration = 0.1, .scheme = scheme, .mass_damping = 20};
    if (scheme == Scheme::implicit_steps) options.step = 2e-4;
    const auto a = make_dynamic(make_swing(4), options, quiet());
    a->solve();
    const auto e = a->energy();
    INFO(e.damping << " of " << e.external);
    CHECK(e.damping > 0.1 * e.external);
    CHECK(e.error < 1e-3);
  }
}

TEST_CASE(
    "stiffness damping loses what its ledger says, takes from the stable step, and leaves rigid motion "
    "alone") {
  const double plain = make_dynamic(make_swing(4), {.duration = 1}, quiet())->stable_step();
  const double b = 0.5 * plain, xi = b / plain;
  for (const auto scheme : {Scheme::explicit_steps, Scheme::implicit_steps}) {
    DynamicOptions options{.duration = 0.1, .scheme = scheme, .stiffness_damping = b};
    if (scheme == Scheme::implicit_steps) {
      options.step = 2e-4;
      options.stiffness_damping = 1e-3;
    }
    const auto a = make_dynamic(make_swing(4), options, quiet());
    if (scheme == Scheme::explicit_steps)
      CHECK(std::abs(a->stable_step() / (plain * (std::sqrt(1 + xi * xi) - xi)) - 1) < 1e-12);
    a->solve();
    const auto e = a->energy();
    INFO(e.damping << " of " << e.external << ", error " << e.error);
    CHECK(e.damping > 0);
    CHECK(e.error < 1e-3);
  }
  // A free fall strains nothing.
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(1, 1, 4, 4));
  auto m = std::make_shared<model::Model>(mesh, blend(), model::Options{});
  m->gravity(model::steady({0, 0, -9.81}));
  const auto a = make_dynamic(m, {.duration = 0.01, .stiffness_damping = 1e-3}, quiet());
  a->solve();
  CHECK(std::abs(a->energy().damping) < 1e-12 * a->energy().external);
}

TEST_CASE("damped integrators lose energy, and the ledger counts it") {
  for (const auto& options :
       {DynamicOptions{.duration = 0.1, .gamma = 0.6},
        DynamicOptions{.duration = 0.1, .step = 5e-4, .scheme = Scheme::implicit_steps, .beta = 0.4},
        DynamicOptions{.duration = 0.1, .step = 5e-4, .scheme = Scheme::implicit_steps, .hht = -0.3}}) {
    const auto a = make_dynamic(make_swing(4), options, quiet());
    a->solve();
    const auto e = a->energy();
    INFO(e.damping << " of " << e.external << ", error " << e.error);
    CHECK(e.damping > 0);
    CHECK(e.error < 5e-3);
  }
}

TEST_CASE("loads that begin from nothing do not trip the ledger") {
  for (const auto scheme : {Scheme::explicit_steps, Scheme::implicit_steps}) {
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.4, 0.1, 8, 2));
    auto m = std::make_shared<model::Model>(mesh, blend(), model::Options{});
    m->fix("left", model::parse_freedoms("x y z rotation"));
    model::Components g;
    g[2] = history::History::ramp(-9.81, 0.01);
    m->gravity(g);
    m->pressure("all", history::History::ramp(5, 0.005));
    const auto a = make_dynamic(m, {.duration = 0.02, .scheme = scheme}, quiet());
    a->solve();
    CHECK(a->energy().error < 1e-4);
  }
}

TEST_CASE("velocities can be read before the first step") {
  for (const auto scheme : {Scheme::explicit_steps, Scheme::implicit_steps})
    CHECK(make_dynamic(make_swing(2), {.duration = 1, .scheme = scheme}, quiet())->node(3).v.norm() == 0);
}

TEST_CASE("the support of accelerated nodes overcomes their inertia and weight") {
  for (const auto scheme : {Scheme::explicit_steps, Scheme::implicit_steps}) {
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.4, 0.1, 4, 1));
    auto m = std::make_shared<model::Model>(mesh, blend(), model::Options{});
    model::Components up;
    up[2] = history::History::callback([](double t) { return 50 * t * t; });
    m->move("all", up);
    m->gravity(model::steady({0, 0, -9.81}));
    const auto a = make_dynamic(m, {.duration = 0.01, .scheme = scheme}, quiet());
    a->solve();
    const double weight = 0.04 * 590 * 0.38e-3 * (100 + 9.81);
    CHECK(std::abs(a->reaction("all").z() / weight - 1) < 1e-6);  // the motion is differenced twice
  }
}

TEST_CASE("the support of driven nodes overcomes the damping of their mass too") {
  const double damping = 30, speed = 2;
  for (const auto scheme : {Scheme::explicit_steps, Scheme::implicit_steps}) {
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.4, 0.1, 4, 1));
    auto m = std::make_shared<model::Model>(mesh, blend(), model::Options{});
    model::Components up;
    up[2] = history::History::callback([=](double t) { return speed * t; });
    m->move("all", up);
    const auto a = make_dynamic(m, {.duration = 0.01, .scheme = scheme, .mass_damping = damping}, quiet());
    a->advance(0.005);
    const double mass = 0.04 * 590 * 0.38e-3;
    CHECK(std::abs(a->reaction("all").z() / (mass * damping * speed) - 1) < 1e-5);  // differenced twice
  }
}

TEST_CASE("a rigid sheet falls freely: tied nodes accelerate from the start") {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.4, 0.1, 4, 1));
  auto m = std::make_shared<model::Model>(mesh, blend(), model::Options{});
  m->add<model::Tie>({model::TieKind::rigid, "all", "", {}});
  m->gravity(model::steady({0, 0, -9.81}));
  const auto a = make_dynamic(m, {.duration = 0.02, .step = 1e-3, .scheme = Scheme::implicit_steps}, quiet());
  a->solve();
  CHECK(std::abs(a->node(0).v.z() / (-9.81 * 0.02) - 1) < 1e-9);  // Newton's tolerance
  CHECK(a->energy().error < 1e-8);
}

TEST_CASE("an event on a velocity is landed on") {
  for (const auto scheme : {Scheme::explicit_steps, Scheme::implicit_steps}) {
    const auto a = make_dynamic(make_swing(4), {.duration = 0.02, .scheme = scheme}, quiet());
    double seen = 0;
    a->event([](Run& r) { return r.node(4).v.z() + 0.05; }, 1e-9, [&](Run& r) { seen = r.node(4).v.z(); });
    a->solve();
    CHECK(std::abs(seen + 0.05) < 1e-9);
  }
}

TEST_CASE("a motion with kinks leaves no ringing behind") {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.2, 0.05, 4, 1));
  auto m = std::make_shared<model::Model>(mesh, blend(), model::Options{});
  model::Components z;
  z[2] = history::History::table({{0, 0}, {0.002, 0}, {0.006, -4e-4}});
  m->fix("left", model::parse_freedoms("x y"));
  m->move("left", z);
  const auto a = make_dynamic(m, {.duration = 0.01, .step = 5e-4, .scheme = Scheme::implicit_steps}, quiet());
  a->advance(0.004);
  CHECK(std::abs(a->node(0).v.z() + 0.1) < 1e-9);
  a->solve();
  CHECK(std::abs(a->node(0).v.z()) < 1e-9);
}

TEST_CASE(
    "scaled rotary inertia is what the membrane's step takes, and no more; a run says what it is worth") {
  // Where the thickness has enough of its own there is nothing to scale.
  for (const auto& [side, thickness] : {std::pair{0.4, 1e-4}, std::pair{0.4, 1e-3}, std::pair{0.004, 1e-3}}) {
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(side, side, 4, 4));
    auto card = isotropic(kModulus, 0.3, thickness);
    const model::Model m(mesh, card, model::Options{});
    m.validate();
    const mechanics::Assembly a(m);
    const mechanics::Cloth& cloth = a.cloth();
    const double h = side / 4, E = kModulus / (1 - 0.3), G = 5.0 / 6 * kModulus / 2.6;  // largest eigenvalue
    const double step = h / std::sqrt(E / card.density), needed = G / card.density * step * step / 4;
    const double own = thickness * thickness / 12;
    for (std::size_t n = 0; n < mesh->nodes.size(); ++n) {
      CHECK(std::abs(cloth.rotary_inertia(false)[n] / cloth.mass()[n] / own - 1) < 1e-12);
      CHECK(std::abs(cloth.rotary_inertia(true)[n] / cloth.mass()[n] / std::max(own, needed) - 1) < 1e-12);
    }
    CHECK(std::abs(a.terms().stable_step(true) / step - 1) < 1e-12);
    CHECK((a.terms().stable_step(false) < step) == (needed > own));
  }
  // A sheet of the comparison law that spins about an axis in its plane, as a whole: what its directors have
  // is known.
  for (const bool scaled : {true, false}) {
    std::vector<std::string> said;
    auto notices = std::make_shared<Notices>([&](const std::string& text) { said.push_back(text); });
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.4, 0.4, 2, 2));
    auto m = std::make_shared<model::Model>(mesh, isotropic(kModulus, 0.3, 1e-3), model::Options{});
    m->add<model::InitialVelocity>({"all", Vec3::Zero(), Vec3(0.1, 0, 0), Vec3(0.2, 0.2, 0)});
    const auto a = make_dynamic(m, {.duration = 0.01, .scaled = scaled}, notices);
    a->solve();
    const auto& more = a->assembly().cloth().rotary_inertia(true);
    const auto& own = a->assembly().cloth().rotary_inertia(false);
    double worth = 0;
    for (std::size_t n = 0; n < own.size(); ++n) worth += (more[n] - own[n]) * 0.1 * 0.1 / 2;
    const auto e = a->energy();
    CHECK(std::abs(e.scaled - (scaled ? worth : 0)) < 1e-3 * worth);
    CHECK(std::abs(a->scaled_share() - (scaled ? worth / e.kinetic : 0)) < 1e-3 * worth / e.kinetic);
    REQUIRE(said.size() == (scaled ? 1 : 0));
    if (scaled)
      CHECK(said[0].find("% of the kinetic energy is in rotary inertia that is scaled up") !=
            std::string::npos);
  }
}

// The largest frequency of a mesh in its reference configuration, 1/s, by the power method.
double highest_frequency(mechanics::Assembly& a, bool scaled) {
  const auto mass = a.lumped_mass(scaled);
  fabricsh::linear::Matrix K;
  a.begin_iterate();
  REQUIRE(a.tangent({}, K, {}, {}));
  std::vector<double> v(mass.size());
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = std::sin(1.0 + 7.0 * static_cast<double>(i));
  double squared = 0;
  for (int k = 0; k < 2000; ++k) {
    std::vector<double> Kv(v.size(), 0);
    const auto& pattern = *K.pattern;
    for (mechanics::Index c = 0; c < K.size(); ++c)
      for (auto e = pattern.column[c]; e < pattern.column[c + 1]; ++e)
        Kv[pattern.row[e]] += K.value[e] * v[c];
    double above = 0, below = 0, length = 0;
    for (std::size_t i = 0; i < v.size(); ++i) {
      above += v[i] * Kv[i];
      below += v[i] * mass[i] * v[i];
      v[i] = Kv[i] / mass[i];
      length = std::max(length, std::abs(v[i]));
    }
    for (double& x : v) x /= length;
    squared = above / below;
  }
  return std::sqrt(squared);
}

TEST_CASE("the usual step is stable for every mode of a sheet with scaled inertia, thin to thick, skew too") {
  for (const double thickness : {1e-4, 1e-3, 1e-2, 0.05, 0.1})
    for (const double skew : {0.0, 0.5})
      for (const bool scaled : {true, false}) {
        auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.5, 0.4, 5, 4));
        mesh->map([&](const Vec3& X) { return Vec3(X.x() + skew * X.y(), X.y(), 0); });
        model::Options along;
        along.warp = [](const Vec3&) { return model::Direction(Vec3::UnitX()); };
        const model::Model m(mesh, isotropic(kModulus, 0.3, thickness), along);
        m.validate();
        mechanics::Assembly a(m);
        CAPTURE(thickness, skew, scaled);
        CHECK(0.7 * a.terms().stable_step(scaled) * highest_frequency(a, scaled) < 2);
      }
}

TEST_CASE("an implicit run that makes energy is stopped by the second step that does, however early") {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.2, 0.1, 4, 2));
  auto m = std::make_shared<model::Model>(mesh, blend(), model::Options{});
  m->fix("left", model::parse_freedoms("x y z"));
  m->gravity(model::steady({0, 0, -9.81}));
  m->add<model::InitialVelocity>({"right", Vec3(0, 0, -20), Vec3::Zero(), Vec3::Zero()});
  std::vector<std::string> said;
  auto notices = std::make_shared<Notices>([&](const std::string& text) { said.push_back(text); });
  // Steps of a hundred times what the wave takes through an element, which halves do not mend.
  const auto a =
      make_dynamic(m, {.duration = 0.031, .step = 8e-3, .scheme = Scheme::implicit_steps}, notices);
  int beyond = 0;
  a->every_step([&](Run& r) {
    const auto e = r.energy();
    if (std::abs(e.surplus()) > 0.05 * std::max({e.initial, std::abs(e.external), e.kinetic + e.internal()}))
      ++beyond;
  });
  std::string why;
  try {
    a->solve();
  } catch (const NumericalFailure& failure) {
    why = failure.what();
  }
  CHECK(why.find("the ledger's error is") != std::string::npos);
  CHECK(beyond == 2);
  CHECK(a->steps().size() < 8);
  CHECK(std::count_if(said.begin(), said.end(), [](const std::string& text) {
          return text.find("dynamic: the ledger's error is") == 0;
        }) == 1);
}

TEST_CASE("options of a run in motion that cannot be") {
  const auto message = [](const DynamicOptions& options) {
    return message_of([&] { make_dynamic(make_swing(2), options, quiet()); });
  };
  says(message({.duration = 0}), "dynamic: field 'duration': expected a positive time in s, got 0");
  says(message({.duration = 1, .step = -1.0}),
       "dynamic: field 'step': expected a positive number in s or 'auto', got -1");
  says(message({.duration = 1, .gamma = 0.4}),
       "dynamic: field 'gamma': expected a number from 0.5 to 1, got 0.4");
  says(message({.duration = 1, .beta = 0.25}),
       "dynamic: field 'beta': expected 0 (scheme=\"explicit\"), got 0.25");
  says(message({.duration = 1, .hht = -0.1}),
       "dynamic: field 'hht': expected 0 (scheme=\"explicit\"), got -0.1");
  says(message({.duration = 1, .scheme = Scheme::implicit_steps, .hht = -0.5}),
       "dynamic: field 'hht': expected a number from -0.333333 to 0, got -0.5");
}

TEST_CASE("velocities of held nodes and motions that jump are said by name") {
  const auto said_by = [](run::Scheme scheme, bool jump) {
    std::string said;
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.2, 0.1, 2, 1));
    auto m = std::make_shared<model::Model>(mesh, blend(), model::Options{});
    m->fix("left", model::parse_freedoms("x z rotation"));
    model::Components up;
    up[1] = history::History::callback([jump](double t) { return jump && t > 5e-4 ? 0.15 : 0; });
    m->move("left", up);
    m->add<model::InitialVelocity>({"all", Vec3(0.1, 0, 0)});
    const auto notices = std::make_shared<Notices>([&](const std::string& text) { said += text + "\n"; });
    run::DynamicOptions options{.duration = 1e-3, .scheme = scheme, .ledger_limit = 1e9};
    const auto a = run::make_dynamic(m, options, notices);
    try {
      a->solve();
    } catch (const NumericalFailure&) {  // what a jump may come to
    }
    return said;
  };
  for (const auto scheme : {run::Scheme::explicit_steps, run::Scheme::implicit_steps}) {
    const std::string still = said_by(scheme, false), jumps = said_by(scheme, true);
    says(still,
         "the velocity of set 'all' is dropped along x at 2 of its nodes, which are fixed or moved there");
    CHECK(still.find("jumps") == std::string::npos);
    if (scheme == run::Scheme::explicit_steps) says(jumps, "jumps by 0.15 m within the step that ends at");
  }
}
