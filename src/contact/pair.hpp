// The energy of one pair of simplices, its forces and its stiffness.
//
//   energy = area * sum over places of count * Phi(distance - offset)
//
// A pair has one place of contact or several; see share/doc/contact.md for how they are counted, so that a
// place that several facets share counts once.
#pragma once
#include "contact/law.hpp"
#include "contact/modulation.hpp"
#include "contact/touch.hpp"

namespace fabricsh::contact {

enum class Kind : std::uint8_t {
  facet,    // point 0 against the triangle 1, 2, 3
  plane,    // point 0 against the whole plane through 1, 2, 3, on the side that sees them counter-clockwise
  edges,    // segment 0-1 against segment 2-3 where they cross, fading towards their ends
  wrap,     // segment 0-1 lying about the axis 2-3: its nearest place, and its ends as far as it is parallel
  segment,  // point 0 against the segment 1-2
  centre    // point 0 against point 1
};

struct Pair {
  Kind kind = Kind::facet;
  double area = 0;    // m2, reference area that the pair stands for
  double scale = 1;   // of the law's lengths, for neighbours in a sheet
  double offset = 0;  // m: radii taken off the distance
  // Of a facet: how often its edge opposite to each corner and each corner itself count beside the facet.
  std::array<std::int8_t, 3> edge{}, corner{};
  Fading fading = {};  // of edges
};

// Friction in an explicit step, against the velocity with which the places slide:
// min(mu * normal force, 0.2 m v / dt), where m is the mass that the pair has at the place, so that it stops
// sliding and never turns it round.
struct Sliding {
  double friction = 0;                                                                      // mu
  double step = 0;                                                                          // s
  std::array<Vec3, 4> velocity = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  // m/s
  std::array<double, 4> inverse_mass{};  // 1/kg; 0: held or driven
};

struct Force {
  std::array<Vec3, 4> on = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  // N, friction included
  double contact = 0, guard = 0;                                                      // J
  double lost = 0;                                                                    // W, to friction
  double gap = 0;       // m, the smallest distance above the floor
  bool active = false;  // some place is within the law's gap
};

// Forces on the corners.
Force pair_force(const Law& law, const Pair& pair, const Corners& x, const Sliding* sliding = nullptr);

struct Derivatives {
  double contact = 0, guard = 0;         // J
  Vector12 gradient = Vector12::Zero();  // N; forces are its negative
  Matrix12 hessian = Matrix12::Zero();   // N/m
};
Derivatives pair_derivatives(const Law& law, const Pair& pair, const Corners& x);
// The nearest matrix (Frobenius) without negative eigenvalues.
Matrix12 positive_part(const Matrix12& hessian);

// Friction of an implicit or static step: mu * normal force at the end of the step, against what the places
// slide from the step's start; below `creep` it comes up smoothly, f(y) = 2 y - y^2.
struct Slip {
  double friction = 0;  // mu
  double creep = 0;     // m
  Corners start;        // m, corners at the start of the step
};
struct Friction {
  Vector12 force = Vector12::Zero();     // N
  Matrix12 jacobian = Matrix12::Zero();  // d force / d x, N/m, not symmetric; where it was asked for
  double lost = 0;                       // J over the step
};
Friction pair_friction(const Law& law, const Pair& pair, const Corners& x, const Slip& slip,
                       bool with_jacobian);

}  // namespace fabricsh::contact
