// Stable equilibria: a double well, whose middle is an unstable equilibrium; and a bar that swings down about
// its end, far stiffer along itself than its hinge, whose end has a closed form.
#include <array>
#include <cmath>

#include "catch.hpp"
#include "solver/scalar.hpp"
#include "solver/trust_region.hpp"

using namespace fabricsh::solver;
using fabricsh::Answer;
using fabricsh::test::Scalar;

namespace {

TrustRegion region() { return {fabricsh::linear::make_symmetric_solver(), true}; }

// Energy (u^2 - 1)^2 / 4 - p u.
Scalar double_well(double p) {
  Scalar problem;
  problem.force = [p](double u, double) { return p + u - u * u * u; };
  problem.stiffness = [](double u) { return 3 * u * u - 1; };
  return problem;
}

// A bar from the origin, in the reference along x with the length L, with the energy C L E^2 / 2 of its
// Green-Lagrange strain, k phi^2 / 2 of its hinge at the angle phi against x, and a weight w at its end.
class Bar final : public Problem {
 public:
  double C = 1e6, L = 0.5, k = 1e-3, w = 2;
  std::array<double, 2> committed{0.5, 0}, trial = committed, iterate = committed, marked = committed;

  double strain(const std::array<double, 2>& x) const {
    return (x[0] * x[0] + x[1] * x[1] - L * L) / (2 * L * L);
  }
  Index size() const override { return 2; }
  Answer predict(Matrix& K, std::span<double> r, std::span<double> lead) override {
    trial = iterate = committed;
    lead[0] = lead[1] = 0;
    residual(r);
    return tangent(K);
  }
  void apply_increment(std::span<const double> delta, double scale) override {
    for (std::size_t i = 0; i < 2; ++i) trial[i] = iterate[i] + scale * delta[i];
  }
  void accept() override { iterate = trial; }
  Answer residual(std::span<double> r) override {
    const double N = C * L * strain(trial), phi = std::atan2(trial[1], trial[0]), s = squared();
    r[0] = -N * trial[0] / (L * L) + k * phi * trial[1] / s;
    r[1] = -N * trial[1] / (L * L) - k * phi * trial[0] / s - w;
    return Answer::ok;
  }
  Answer tangent(Matrix& K) override { return tangent_for(C * L * strain(trial), K); }
  Answer extrapolated_tangent(Matrix& K) override {
    const double dx = trial[0] - iterate[0], dy = trial[1] - iterate[1];
    const double quadratic = (dx * dx + dy * dy) / (2 * L * L);
    return tangent_for(C * L * (strain(trial) - quadratic), K);
  }
  double turn_of(std::span<const double> delta) const override { return std::hypot(delta[0], delta[1]) / L; }
  void save_iterate() override { marked = iterate; }
  void restore_iterate() override { trial = marked; }
  std::pair<double, Index> largest(std::span<const double> r) const override {
    return std::abs(r[0]) > std::abs(r[1]) ? std::pair<double, Index>(std::abs(r[0]), 0)
                                           : std::pair<double, Index>(std::abs(r[1]), 1);
  }
  double force_scale() const override { return w; }
  double rounding_floor(const Matrix&) const override { return 0; }

 private:
  double squared() const { return trial[0] * trial[0] + trial[1] * trial[1]; }
  Answer tangent_for(double N, Matrix& K) {
    static const auto pattern = std::make_shared<const fabricsh::linear::Pattern>(
        std::vector<Index>{0, 2, 4}, std::vector<Index>{0, 1, 0, 1});
    K.follow(pattern);
    const double s = squared(), phi = std::atan2(trial[1], trial[0]), L4 = L * L * L * L;
    const double g[2] = {-trial[1] / s, trial[0] / s};
    const double h = phi / (s * s) * k, x = trial[0], y = trial[1];
    const double bend[2][2] = {{2 * x * y, y * y - x * x}, {y * y - x * x, -2 * x * y}};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        K.value[static_cast<std::size_t>(2 * j + i)] =
            C * L * trial[static_cast<std::size_t>(i)] * trial[static_cast<std::size_t>(j)] / L4 +
            (i == j ? N / (L * L) : 0) + k * g[i] * g[j] + h * bend[i][j];
    return Answer::ok;
  }
};

// At phi = -pi/2 + b: the hinge's moment k phi against the weight's, w l sin(b), and the stretch from
// C L E l / L^2 = w cos(b) along the bar; by a fixed point, which converges fast for a stiff bar.
std::array<double, 2> closed_form(const Bar& bar) {
  double l = bar.L, b = 0;
  for (int i = 0; i < 200; ++i) {
    b = std::asin(bar.k * (M_PI / 2 - b) / (bar.w * l));
    const double along = bar.w * std::cos(b);
    const double E = along * bar.L / (bar.C * l);
    l = bar.L * std::sqrt(1 + 2 * E);
  }
  return {l * std::sin(b), -l * std::cos(b)};
}

}  // namespace

TEST_CASE("an unstable equilibrium is left for a stable one, whatever the side") {
  for (const double p : {0.0, 0.1, -0.1}) {
    Scalar problem = double_well(p);
    problem.committed = 0;
    const auto result = region().solve(problem, {.max_iterations = 100});
    REQUIRE(result.status == NewtonStatus::converged);
    const double u = problem.trial();
    CHECK(std::abs(p + u - u * u * u) < 1e-9);
    CHECK(3 * u * u > 1);
    if (p != 0) CHECK(u * p > 0);
  }
}

TEST_CASE("a tangent that is not symmetric shows an unstable equilibrium by the sign of its determinant") {
  for (const double p : {0.0, 0.1, -0.1}) {
    // At the middle equilibrium from the beginning: nothing but the tangent tells that it is unstable.
    Scalar problem = double_well(p);
    problem.committed = 0;
    for (int i = 0; i < 50; ++i)
      problem.committed = problem.committed * problem.committed * problem.committed - p;
    TrustRegion unsymmetric(fabricsh::linear::make_unsymmetric_solver(), false);
    const auto result = unsymmetric.solve(problem, {.max_iterations = 100});
    REQUIRE(result.status == NewtonStatus::converged);
    const double u = problem.trial();
    CHECK(std::abs(p + u - u * u * u) < 1e-9);
    CHECK(3 * u * u > 1);
  }
}

TEST_CASE("where Newton's method climbs to the top of the energy, this goes down into the well") {
  // At u = 0.4 the tangent is negative: Newton's step is uphill, towards 0.
  Scalar problem = double_well(0);
  problem.committed = 0.4;
  CHECK(Newton(fabricsh::linear::make_unsymmetric_solver()).solve(problem, {}).status ==
        NewtonStatus::converged);
  CHECK(std::abs(problem.trial()) < 1e-6);
  REQUIRE(region().solve(problem, {.max_iterations = 100}).status == NewtonStatus::converged);
  CHECK(std::abs(problem.trial() - 1) < 1e-9);
}

TEST_CASE("a stiff bar swings down from the horizontal to where hinge and weight balance") {
  for (const double stiff : {1e3, 1e5, 1e7}) {
    Bar bar;
    bar.C = stiff;
    const auto result = region().solve(bar, {.tolerance = 1e-9, .max_iterations = 400});
    REQUIRE(result.status == NewtonStatus::converged);
    const auto exact = closed_form(bar);
    CHECK(std::abs(bar.trial[0] - exact[0]) < 1e-7 * bar.L);
    CHECK(std::abs(bar.trial[1] - exact[1]) < 1e-7 * bar.L);
  }
}

TEST_CASE("too many iterations end the solve, and a problem that is balanced needs at most one") {
  Bar bar;
  CHECK(region().solve(bar, {.max_iterations = 3}).status == NewtonStatus::too_many_iterations);
  Scalar still = double_well(0);
  still.committed = 1;
  const auto result = region().solve(still, {});
  CHECK(result.status == NewtonStatus::converged);
  CHECK(result.iterations <= 1);
}
