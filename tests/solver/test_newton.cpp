// Newton's line search, and the guard of a step along an arc, on problems of one unknown whose every number
// is known beforehand.
#include <cmath>
#include <functional>
#include <limits>

#include "catch.hpp"
#include "solver/arc_length.hpp"

using namespace fabricsh::solver;

namespace {

std::shared_ptr<const fabricsh::linear::Pattern> one_by_one() {
  static const auto pattern =
      std::make_shared<const fabricsh::linear::Pattern>(std::vector<Index>{0, 1}, std::vector<Index>{0});
  return pattern;
}

// r(u, t) = 0 for one unknown u; the solvers get the stiffness that they are told. Without a time, t is 0.
class Scalar final : public PathProblem {
 public:
  std::function<double(double u, double t)> force;  // r; not a number: the law fails
  std::function<double(double u)> stiffness;
  double committed = 0;
  std::vector<double> shares;  // of its increments that were tried

  double trial() const { return trial_; }
  void set_trial(double u) { trial_ = u; }

  Index size() const override { return 1; }
  void aim(double time) override { time_ = time; }
  bool predict(Matrix& K, std::span<double> r) override {
    trial_ = iterate_ = committed;
    return tangent(K) && residual(r);
  }
  bool start(Matrix& K, std::span<double> r, std::span<double> q) override {
    q[0] = 1;
    return predict(K, r);
  }
  bool tangent_and_rate(Matrix& K, std::span<double> q) override {
    q[0] = 1;
    return tangent(K);
  }
  void retract(std::span<const double> delta, double scale) override {
    shares.push_back(scale);
    trial_ = iterate_ + scale * delta[0];
  }
  void accept() override { iterate_ = trial_; }
  bool residual(std::span<double> r) override {
    r[0] = force(trial_, time_);
    return !std::isnan(r[0]);
  }
  bool tangent(Matrix& K) override {
    K.follow(one_by_one());
    K.value[0] = stiffness(trial_);
    return true;
  }
  double product(std::span<const double> a, std::span<const double> b) const override { return a[0] * b[0]; }
  std::pair<double, Index> largest(std::span<const double> r) const override { return {std::abs(r[0]), 0}; }
  double force_scale() const override { return 1; }
  double rounding_floor(const Matrix&) const override { return 0; }

 private:
  double trial_ = 0, iterate_ = 0, time_ = 0;
};

NewtonResult correct(Scalar& problem, NewtonOptions options) {
  problem.shares.clear();
  problem.set_trial(problem.committed);
  return Newton(fabricsh::linear::make_unsymmetric_solver()).correct(problem, options);
}

// The shares tried in one iteration from u = 0 with K = 1 and so with the increment r(0) = 1.
std::vector<double> shares(const std::function<double(double u)>& force, bool line_search = true) {
  Scalar problem;
  problem.force = [&](double u, double) { return force(u); };
  problem.stiffness = [](double) { return 1.0; };
  correct(problem, {.max_iterations = 1, .line_search = line_search});
  CHECK(problem.trial() == problem.shares.back());
  return problem.shares;
}

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("the line search goes back to where the bracketed force vanishes, and no further than it must") {
  const auto line = [](double slope) { return [slope](double u) { return 1 - slope * u; }; };
  CHECK(shares(line(1)) == std::vector{1.0});
  // g(1) = -0.5 g(0) is enough, a little more is not.
  CHECK(shares(line(1.5)) == std::vector{1.0});
  const auto over = shares(line(1.6));
  REQUIRE(over.size() == 2);
  CHECK(std::abs(over[1] - 1 / 1.6) < 1e-15);
  CHECK(shares(line(5)) == std::vector{1.0, 0.2});
  CHECK(shares(line(5), false) == std::vector{1.0});
  // Still falling at the whole step: Newton goes on from there.
  CHECK(shares(line(0.2)) == std::vector{1.0});
  CHECK(shares(line(-3)) == std::vector{1.0});
  // One try takes at most nine tenths off.
  const auto far = shares(line(50));
  REQUIRE(far.size() == 3);
  CHECK(far[1] == 0.1);
  CHECK(std::abs(far[2] - 0.02) < 1e-15);
}

TEST_CASE("the line search takes a quarter of a step on which the law fails, ten times at most") {
  for (const double failure : {kNone, std::numeric_limits<double>::infinity()})
    CHECK(shares([=](double u) { return u > 0.3 ? failure : 1 - u; }) == std::vector{1.0, 0.25});
  Scalar problem;
  problem.force = [](double u, double) { return u == 0 ? 1 : kNone; };
  problem.stiffness = [](double) { return 1.0; };
  CHECK(correct(problem, {}).status == NewtonStatus::law_failed);
  REQUIRE(problem.shares.size() == 10);
  CHECK(problem.shares.back() == std::pow(0.25, 9));
}

TEST_CASE("from where Newton's method alone overshoots for ever, the line search brings it home") {
  Scalar problem;
  problem.force = [](double u, double) { return -std::atan(u); };
  problem.stiffness = [](double u) { return 1 / (1 + u * u); };
  problem.committed = 2;
  CHECK(correct(problem, {}).status == NewtonStatus::converged);
  CHECK(std::abs(problem.trial()) < 1e-10);
  CHECK(correct(problem, {.line_search = false}).status != NewtonStatus::converged);
}

TEST_CASE("the first step of a predicted solve is taken whole, the later ones are searched") {
  Scalar problem;
  problem.force = [](double u, double) { return 1 - 5 * u; };
  problem.stiffness = [](double u) { return u == 0 ? 1.0 : 2.0; };
  Newton newton(fabricsh::linear::make_unsymmetric_solver());
  CHECK(newton.solve(problem, {.max_iterations = 2}).status == NewtonStatus::converged);
  REQUIRE(problem.shares.size() == 3);
  CHECK(problem.shares[0] == 1);
  CHECK(problem.shares[1] == 1);
  CHECK(std::abs(problem.shares[2] - 0.4) < 1e-15);
}

// A path t = f(u) from u = 0.9 that lands at t = 1.05; its predictor goes to u = 1.05. What lies beyond u = 1
// decides where the corrector ends.
TEST_CASE("a step along an arc that ends off its path is refused, however well it balances") {
  const auto land = [](const std::function<double(double)>& f, double beyond) {
    Scalar problem;
    problem.committed = 0.9;
    problem.force = [&](double u, double t) { return t - f(u); };
    problem.stiffness = [&](double u) { return u > 1 ? beyond : 1.0; };
    ArcLength arc(fabricsh::linear::make_unsymmetric_solver());
    const auto result = arc.solve(problem, {.tolerance = 1e-9, .line_search = false},
                                  {.time = 0.9, .landing = 1.05, .length = 1, .largest_step = 1});
    CHECK(result.landed);
    CHECK(result.residuals.back() < 1e-9);  // it balances
    CHECK(std::abs(f(problem.trial()) - 1.05) < 1e-9);
    return result.status;
  };
  // Softer by a half: the increment grows to 0.2, which is near enough.
  CHECK(land([](double u) { return u < 1 ? u : 1 + 0.5 * (u - 1); }, 0.5) == NewtonStatus::converged);
  // 2.9 times the predictor's increment, and 3.1 times.
  const auto soft = [](double end) {
    const double slope = 0.05 / (end - 1);
    return std::pair([slope](double u) { return u < 1 ? u : 1 + slope * (u - 1); }, slope);
  };
  const auto near = soft(0.9 + 2.9 * 0.15), far = soft(0.9 + 3.1 * 0.15);
  CHECK(land(near.first, near.second) == NewtonStatus::converged);
  CHECK(land(far.first, far.second) == NewtonStatus::diverged);
  // Round the back: the corrector jumps to another branch, at u = 0.5, against the predictor's way.
  const auto back = [](double u) { return u > 1 ? 1 - 0.1 * (u - 1) : u > 0.6 ? u : 1.55 - u; };
  CHECK(land(back, -0.1) == NewtonStatus::diverged);
}
