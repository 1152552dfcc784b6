// A body that moves by fractions: equilibrium before it has reached its position is not accepted, in any
// solver.
#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "solver/descent.hpp"
#include "solver/relaxation.hpp"
#include "solver/scalar.hpp"
#include "solver/trust_region.hpp"

using namespace fabricsh::solver;
using fabricsh::Answer;

namespace {

// A spring of 3 N/m to a body that goes to 1.7 m, and one of 2 N/m to the ground: at rest u = 3 * 1.7 / 5
// = 1.02 m. The body goes 0.6 m in an iteration at most, so that it comes with the third, and the unknown
// goes along with it: every place on the way is in balance to rounding.
class Late final : public Problem {
 public:
  static constexpr double pull = 3, ground = 2, way = 1.7, stride = 0.6;
  double trial() const { return trial_; }
  double body() const { return body_; }

  Index size() const override { return 1; }
  Answer predict(Matrix& K, std::span<double> r, std::span<double> lead) override {
    lead[0] = 0;
    trial_ = iterate_ = body_ = body_iterate_ = 0;
    tangent(K);
    return residual(r);
  }
  double limit(std::span<const double>, double) override {
    return std::min(1.0, stride / (way - body_iterate_));
  }
  void apply_increment(std::span<const double> delta, double scale) override {
    trial_ = iterate_ + scale * delta[0];
    body_ = body_iterate_ + (at_target() ? 0 : scale * (way - body_iterate_));
  }
  bool finish_direction(const Solve& solve, std::span<double> delta) override {
    const double lead = pull * (way - body_iterate_);
    double along = 0;
    if (!solve({&lead, 1}, {&along, 1})) return false;
    delta[0] += along;
    return true;
  }
  double turn_of(std::span<const double> delta) const override { return 1e-3 * std::abs(delta[0]); }
  void save_iterate() override { marked_ = iterate_; }
  void restore_iterate() override { trial_ = marked_; }
  void accept() override {
    iterate_ = trial_;
    body_iterate_ = body_;
  }
  bool at_target() const override { return body_iterate_ >= way - 1e-12; }
  Answer residual(std::span<double> r) override {
    r[0] = pull * (body_ - trial_) - ground * trial_;
    return Answer::ok;
  }
  Answer tangent(Matrix& K) override {
    K.follow(fabricsh::test::one_by_one());
    K.value[0] = pull + ground;
    return Answer::ok;
  }
  std::pair<double, Index> largest(std::span<const double> r) const override { return {std::abs(r[0]), 0}; }
  double force_scale() const override { return 1; }
  double rounding_floor(const Matrix&) const override { return 1e-12; }

 private:
  double trial_ = 0, iterate_ = 0, body_ = 0, body_iterate_ = 0, marked_ = 0;
};

void check_arrived(const Late& problem, const NewtonResult& result, double tolerance) {
  CHECK(result.status == NewtonStatus::converged);
  CHECK(problem.at_target());
  CHECK(std::abs(problem.trial() - 1.02) <= tolerance / (Late::pull + Late::ground));
}

}  // namespace

TEST_CASE("equilibrium before a body has reached its position is not accepted: all solvers go on") {
  Late one;
  const auto newton = Newton(fabricsh::linear::make_unsymmetric_solver()).solve(one, {});
  check_arrived(one, newton, 1e-10);
  CHECK(newton.iterations == 3);  // each of them in balance
  for (const double residual : newton.residuals) CHECK(residual < 1e-12);

  Late two;
  check_arrived(two,
                Descent(fabricsh::linear::make_symmetric_solver())
                    .solve(two, {.tolerance = 1e-2, .max_iterations = 20000}),
                1e-2);

  Late four;
  auto region = TrustRegion(fabricsh::linear::make_symmetric_solver(), true);
  check_arrived(four, region.solve(four, {}), 1e-10);

  Late three;  // at rest from the beginning, but for the body
  check_arrived(three, Relaxation().solve(three, {.tolerance = 1e-2}), 1e-2);
}
