// The stiffest that a law can become, for bounds of frequencies.
#pragma once
#include <algorithm>
#include <cmath>

#include "law/law.hpp"

namespace fabricsh::law {

// Pa. axial: the largest eigenvalue of the tangent of S11, S22 on E11, E22; shear: S12 on 2 E12; transverse:
// S13 on 2 E13 and S23 on 2 E23, the larger. Coupling of shear with the axes is zero in all laws.
struct Bound {
  double axial = 0, shear = 0, transverse = 0;
};
Bound bound(const Law& law);

// The larger eigenvalue of a 2x2 matrix with real eigenvalues.
inline double larger_eigenvalue(double a, double b, double c, double d) {
  const double half = 0.5 * (a - d);
  return 0.5 * (a + d) + std::sqrt(std::max(half * half + b * c, 0.0));
}

}  // namespace fabricsh::law
