// The tangent of an assembly against central differences of its residual.
#pragma once
#include <cmath>
#include <span>
#include <vector>

#include "catch.hpp"
#include "mechanics/assembly.hpp"

namespace fabricsh::test {

// The largest difference between the tangent K times a direction and central differences of the residual with
// the step h along it, over the largest entry. K is that of the trial state, to which increments are added.
inline double tangent_error(mechanics::Assembly& a, const linear::Matrix& K,
                            const std::vector<double>& direction, double h, const law::Step& step = {}) {
  const auto n = direction.size();
  std::vector<double> product(n);
  linear::multiply(K, direction, product);
  a.begin_iterate();
  const auto residual = [&](double along) {
    a.apply_increment(direction, along, a.dofs().targets(0));
    REQUIRE(a.forces(step));
    std::vector<double> external, r(n);
    a.terms().external(0, external);
    a.residual(external, r);
    return r;
  };
  const auto up = residual(h), down = residual(-h);
  double worst = 0, scale = 0;
  for (std::size_t i = 0; i < n; ++i) {
    worst = std::max(worst, std::abs(product[i] + (up[i] - down[i]) / (2 * h)));
    scale = std::max(scale, std::abs(product[i]));
  }
  return worst / scale;
}

}  // namespace fabricsh::test
