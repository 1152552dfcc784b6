// Newmark's formulas for nodes and directors: accelerations and velocities that a trial configuration means.
#pragma once
#include <span>
#include <vector>

#include "mechanics/assembly.hpp"

namespace fabricsh::analysis {

struct NewmarkScheme {
  double gamma = 0.5, beta = 0.25, hht = 0;
};

// Velocities and accelerations of all nodes, 3 per node, global; those of directors are tangent to the
// sphere.
struct NodalMotion {
  mechanics::NodalRates v, a;  // m/s and 1/s; m/s^2 and 1/s^2
  void keep(Archive& archive) { archive(v.x, v.d, a.x, a.d); }
};

// What the increment from the committed to the trial configuration makes of the motion, after a time dt.
void newmark_update(const NewmarkScheme& scheme, double dt, const mechanics::Configuration& state,
                    const NodalMotion& before, NodalMotion& after);

// The tangent vector u at d carried along the arc from d to e, unit vectors, e != -d.
Vec3 carry(const Vec3& u, const Vec3& d, const Vec3& e);
// The arc from d to e as a tangent vector at d, rad.
Vec3 arc(const Vec3& d, const Vec3& e);

}  // namespace fabricsh::analysis
