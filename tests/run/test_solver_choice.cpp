// A linear solver that a program brings along, and terms whose tangents are not symmetric.
#include <Eigen/LU>
#include <cmath>

#include "catch.hpp"
#include "geometry/node_view.hpp"
#include "message_of.hpp"
#include "run/checkpoint.hpp"
#include "run/dynamic.hpp"
#include "run/problems.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

// Gauss' elimination of a full matrix.
class Dense final : public linear::LinearSolver {
 public:
  explicit Dense(int& count) : count_(count) {}
  bool solve(const linear::Matrix&, std::span<const double> b, std::span<double> x) override {
    const auto n = static_cast<Eigen::Index>(b.size());
    Eigen::Map<Eigen::VectorXd>(x.data(), n) = factors_.solve(Eigen::Map<const Eigen::VectorXd>(b.data(), n));
    return true;
  }
  linear::LinearReport report() const override { return {}; }

 protected:
  bool analyse(const linear::Matrix&) override { return true; }
  bool factorise_numbers(const linear::Matrix& A) override {
    ++count_;
    Eigen::MatrixXd full = Eigen::MatrixXd::Zero(A.size(), A.size());
    for (linear::Index c = 0; c < A.size(); ++c)
      for (linear::Index k = A.pattern->column[c]; k < A.pattern->column[c + 1]; ++k)
        full(A.pattern->row[k], c) = A.value[k];
    factors_.compute(full);
    return true;
  }

 private:
  int& count_;
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

run::SolverChoice dense(int& count) {
  return {"dense", [&count](bool) { return std::make_unique<Dense>(count); }};
}

// A force normal to the displacement of a node in the sheet's plane, as of a swirl; it has no energy.
class Swirl final : public mechanics::Term {
 public:
  Swirl(mechanics::Index node, double k) : node_(node), k_(k) {}
  const char* name() const override { return "swirl"; }
  mechanics::Outcome add_forces(const law::Step&, const mechanics::Trial& trial,
                                mechanics::Forces& forces) override {
    at(forces.on_x, node_) += turn() * (at(trial.configuration.x(), node_) - trial.X[node_]);
    return {};
  }
  void add_tangent(const mechanics::Trial&, mechanics::TangentSink& sink) const override {
    sink.on_positions(node_, node_, turn());
  }
  bool symmetric() const override { return false; }

 private:
  Mat3 turn() const {
    Mat3 m = Mat3::Zero();
    m(0, 1) = k_;
    m(1, 0) = -k_;
    return m;
  }
  mechanics::Index node_;
  double k_;  // N/m
};

// A sheet of 4 x 4 elements whose right side is drawn to the right.
std::shared_ptr<model::Model> sheet() {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.04, 0.04, 4, 4));
  auto m = std::make_shared<model::Model>(mesh, isotropic(1e6, 0.3, 1e-3), model::Options{});
  m->fix("left", model::parse_freedoms("x y z rotation"));
  model::Components along;
  along[0] = history::History::table({{0, 0}, {1, 0.002}});
  m->move("right", along);
  m->fix("right", model::parse_freedoms("y z rotation"));
  return m;
}

run::StaticOptions options() {
  run::StaticOptions o;
  o.duration = 1;
  o.step = 0.25;
  return o;
}

double apart(const run::Run& a, const run::Run& b) {
  const auto x = a.assembly().state().x(), y = b.assembly().state().x();
  double most = 0;
  for (std::size_t i = 0; i < x.size(); ++i) most = std::max(most, std::abs(x[i] - y[i]));
  return most;
}

}  // namespace

TEST_CASE("a run takes the linear solver that it is given, statics and implicit motion alike") {
  int count = 0;
  auto own = options();
  own.solver = dense(count);
  run::Static a(sheet(), own, quiet()), b(sheet(), options(), quiet());
  a.solve();
  b.solve();
  int iterations = 0;
  for (const auto& step : a.steps()) iterations += step.iterations;
  CHECK(count == iterations);
  CHECK(apart(a, b) < 1e-14);  // m, rounding
  // A checkpoint of one is none of the other.
  CHECK(run::difference(run::checkpoint_of(a), b).find("solver dense there") != std::string::npos);
  CHECK(run::difference(run::checkpoint_of(b), b).empty());

  run::DynamicOptions moving;
  moving.duration = 1;
  moving.step = 0.1;
  moving.scheme = run::Scheme::implicit_steps;
  const auto usual = run::make_dynamic(sheet(), moving, quiet());
  moving.solver = dense(count);
  const auto chosen = run::make_dynamic(sheet(), moving, quiet());
  count = 0;
  chosen->solve();
  usual->solve();
  CHECK(count > 0);
  CHECK(apart(*chosen, *usual) < 1e-10);  // m: the tolerance of the steps
}

TEST_CASE("a term without a symmetric tangent is added where the solver bears it, and then balances") {
  const double k = 500;  // N/m
  run::Static usual(sheet(), options(), quiet());
  CHECK(message_of([&] { usual.add(std::make_unique<Swirl>(12, k)); }) ==
        "a term 'swirl': expected one with a symmetric tangent, or the option linear = unsymmetric");
  auto general = options();
  general.linear = run::Symmetry::unsymmetric;
  run::Static a(sheet(), general, quiet());
  a.add(std::make_unique<Swirl>(12, k));
  a.solve();
  // Newton's method with the whole tangent converges in a few iterations.
  for (const auto& step : a.steps()) CHECK(step.iterations <= 5);
  // The supports hold what the swirl pushes.
  const Vec3 u = a.node(12).u, sum = a.reaction("left") + a.reaction("right");
  CHECK(std::abs(u.y()) > 1e-7);
  CHECK(std::abs(sum.x() - k * u.y()) < 1e-9);
  CHECK(std::abs(sum.y() + k * u.x()) < 1e-9);
}
