// Energy, forces and stiffness of one pair of simplices.
//
//   energy = area * sum over places of count * Phi(distance - offset)
//
// A pair has one or several places of contact. share/doc/contact.md describes
// their weights, which make a place that several facets share count only once.
#pragma once
#include "contact/law.hpp"
#include "contact/modulation.hpp"
#include "contact/touch.hpp"

namespace fabricsh::contact {

enum class Kind : std::uint8_t {
  facet,    // point 0 against the triangle 1, 2, 3
  plane,    // point 0 against the whole plane through 1, 2, 3, from the side that sees them counter-clockwise
  edges,    // segment 0-1 against segment 2-3 where they cross, with a weight that fades towards their ends
  wrap,     // segment 0-1 wrapped about axis 2-3: its nearest place, and its ends where nearly parallel
  segment,  // point 0 against the segment 1-2
  centre    // point 0 against point 1
};

struct Pair {
  Kind kind = Kind::facet;
  double area = 0;    // factor on the law's lengths, for neighbours in a sheet
  double scale = 1;   // m: radii subtracted from the distance
  double offset = 0;  // m: radii taken off the distance
  // For a facet: weights of the edge opposite to each corner and of each corner, beside the facet's 1.
  std::array<std::int8_t, 3> edge{}, corner{};
  Fading fading = {};  // for `edges`
};

// Friction of an explicit step, against the sliding velocity v of the places: min(mu
// * normal force, 0.2 m v / dt), where m is the effective mass of the pair at the
// place. The second bound lets friction stop the sliding but never reverse it.
struct Sliding {
  double friction = 0;                                                                      // mu
  double step = 0;                                                                          // s
  std::array<Vec3, 4> velocity = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  // m/s
  std::array<double, 4> inverse_mass{};  // 1/kg; 0: the corner is held or driven
  // 1/s, rotation of the rigid side. Its surface velocity is taken at the place of the cloth, so that the two
  // forces of friction act at one place and angular momentum is conserved.
  Vec3 spin = Vec3::Zero();
};

struct Force {
  std::array<Vec3, 4> on = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  // N, friction included
  double contact = 0, guard = 0;                                                      // J
  double lost = 0;                                                                    // W, lost by friction
  Vec3 torque = Vec3::Zero();  // N m, of friction on the rigid side about its closest point
  double gap = 0;              // m, the smallest distance above the floor
  bool active = false;         // at least one place is within the law's range
};

// Forces on the corners.
Force pair_force(const Law& law, const Pair& pair, const Corners& x, const Sliding* sliding = nullptr);

struct Derivatives {
  double contact = 0, guard = 0;         // J
  Vector12 gradient = Vector12::Zero();  // N; forces are its negative
  Matrix12 hessian = Matrix12::Zero();   // N/m
};
Derivatives pair_derivatives(const Law& law, const Pair& pair, const Corners& x);
// The nearest matrix (in the Frobenius norm) without negative eigenvalues.
Matrix12 positive_part(const Matrix12& hessian);

// Friction of an implicit or static step: mu * normal force at the end of the step, against
// the sliding since its beginning. Below `creep` it rises smoothly, f(y) = 2 y - y^2.
struct Slip {
  double friction = 0;       // mu
  double creep = 0;          // m
  Corners start;             // m, corners at the beginning of the step
  Vec3 turn = Vec3::Zero();  // rad, of the rigid side since then (see Sliding::spin)
};
struct Friction {
  Vector12 force = Vector12::Zero();     // N
  Matrix12 jacobian = Matrix12::Zero();  // d force / d x, N/m, not symmetric; only if requested
  double lost = 0;                       // J over the step
  Vec3 torque = Vec3::Zero();            // N m, see Force::torque
  // Where it was asked for: d force / d turn, d torque / d x and d torque / d turn.
  Eigen::Matrix<double, 12, 3> by_turn = Eigen::Matrix<double, 12, 3>::Zero();
  Eigen::Matrix<double, 3, 12> torque_by_x = Eigen::Matrix<double, 3, 12>::Zero();
  Mat3 torque_by_turn = Mat3::Zero();
};
Friction pair_friction(const Law& law, const Pair& pair, const Corners& x, const Slip& slip,
                       bool with_jacobian);

}  // namespace fabricsh::contact
