// Newton's method for the lateral and the shear strain, until the lateral stress and the shear stress vanish.
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "law/load_frame.hpp"
#include "law/point.hpp"

namespace fabricsh::law {

namespace {

constexpr double small = 1e-6;      // strain: rounding is compared with at least this
constexpr double rounding = 1e-12;  // relative size at which a residual may stagnate

// The two unknowns in the load frame: lateral strain a and shear strain b (tensor).
struct LateralStrains {
  double a = 0, b = 0;
};

// Residual (lateral stress, shear stress) and its derivative by (a, b), Pa.
struct System {
  LateralStrains residual;
  double aa, ab, ba, bb;
  double scale;  // Pa, with which rounding is compared

  System(const LoadFrame& frame, const std::array<double, 3>& E, const std::array<double, 5>& S,
         const std::array<double, 25>& C) {
    const auto stress = frame.stress({S[0], S[1], S[4]});
    residual = {stress[1], stress[2]};
    const auto column = [&](const std::array<double, 3>& unit) {
      const auto e = frame.strain(unit);
      const auto row = [&](int i) { return C[5 * i] * e[0] + C[5 * i + 1] * e[1] + C[5 * i + 4] * 2 * e[2]; };
      return frame.stress({row(0), row(1), row(4)});
    };
    const auto by_a = column({0, 1, 0}), by_b = column({0, 0, 1});
    aa = by_a[1], ba = by_a[2], ab = by_b[1], bb = by_b[2];
    const double stiff = std::max({std::fabs(C[0]), std::fabs(C[6]), std::fabs(C[24])});
    scale = stiff * std::max({std::fabs(E[0]), std::fabs(E[1]), std::fabs(E[2]), small});
  }
  double size() const { return std::max(std::fabs(residual.a), std::fabs(residual.b)); }
  LateralStrains newton() const {
    const double det = aa * bb - ab * ba;
    return {-(bb * residual.a - ab * residual.b) / det, -(aa * residual.b - ba * residual.a) / det};
  }
  // Derivative of the potential along a step; the shear strain b counts twice.
  double slope(const LateralStrains& step) const { return step.a * residual.a + 2 * step.b * residual.b; }
  bool searching(const LateralStrains& step, double target) const {
    return std::fabs(slope(step)) > target && size() > rounding * scale;
  }
};

}  // namespace

std::array<double, 3> PointDriver::solve_uniaxial(double angle, double E) {
  const LoadFrame frame(angle);
  const auto start = frame.strain_in({strain_[0], strain_[1], 0.5 * strain_[4]});
  LateralStrains x{start[1], start[2]}, best;
  const auto strain_at = [&](const LateralStrains& p) { return frame.strain({E, p.a, p.b}); };
  const auto system_at = [&](const LateralStrains& p) {
    const auto e = strain_at(p);
    if (!update(e)) throw NumericalFailure("the law failed: strain or stress is not a finite number", 0);
    return System(frame, e, stress_, tangent_);
  };
  System now = system_at(x);
  double least = now.size(), scale = now.scale;
  best = x;
  for (int iteration = 0; iteration < 100 && now.size() > 1e-16 * now.scale; ++iteration) {
    const LateralStrains step = now.newton();
    // The potential is convex along a step: bracket the zero of its slope.
    // The search becomes more exact if Newton steps alternate between kinks.
    const double g0 = now.slope(step), sharp = iteration < 5 ? 0.5 : 1e-2;
    double low = 0, high = 0, s = 1;
    System next = system_at({x.a + step.a, x.b + step.b});
    for (int i = 0; i < 40 && next.searching(step, sharp * std::fabs(g0)); ++i) {
      (next.slope(step) * g0 > 0 ? low : high) = s;
      s = high > 0 ? 0.5 * (low + high) : 2 * s;
      next = system_at({x.a + s * step.a, x.b + s * step.b});
    }
    const bool stalled = next.size() >= 0.5 * now.size() && next.size() <= rounding * next.scale;
    x = {x.a + s * step.a, x.b + s * step.b};
    now = next;
    if (now.size() < least) {
      least = now.size();
      scale = now.scale;
      best = x;
    }
    if (stalled) break;
  }
  if (!(least <= 1e-9 * scale))
    throw NumericalFailure("no state of uniaxial stress found: take smaller steps", 0, -1, "warp");
  system_at(best);
  return strain_at(best);
}

}  // namespace fabricsh::law
