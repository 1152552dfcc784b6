// Energy, forces and stiffness of one pair of simplices.
//
//   energy = area * sum over places of count * Phi(distance - offset)
//
// A pair has one or several places of contact. share/doc/contact.md describes
// their weights, which make a place that several facets share count only once.
#pragma once
#include "contact/law.hpp"
#include "contact/touch.hpp"

namespace fabricsh::contact {

// --- A weight from 0 to 1, with two continuous derivatives, by which two crossing segments count.
//
// It falls to zero where the segments are parallel, since their closest points are then not unique;
// and, if requested, where a closest point reaches a segment's end, since a corner takes over there.

struct Fading {
  bool at_ends = false;
  double first = 0.5, second = 0.5;  // share of each segment's length over which the weight fades, 0 to 1/2
};

struct Modulation {
  double value = 0;
  bool constant = true;  // all derivatives are zero
  Vector12 gradient = Vector12::Zero();
};

// The modulation of the segments 0-1 and 2-3. Second derivatives that are not zero go to `hessian`, if given.
Modulation modulation(const Corners& x, const Fading& fading, Matrix12* hessian = nullptr);

enum class PairKind : std::uint8_t {
  facet,    // point 0 against the triangle 1, 2, 3
  plane,    // point 0 against the whole plane through 1, 2, 3, from the side that sees them counter-clockwise
  edges,    // segment 0-1 against segment 2-3 where they cross, with a weight that fades towards their ends
  wrap,     // segment 0-1 wrapped about axis 2-3: its nearest place, and its ends where nearly parallel
  segment,  // point 0 against the segment 1-2
  centre    // point 0 against point 1
};

struct Pair {
  PairKind kind = PairKind::facet;
  double area = 0;    // m2, reference
  double scale = 1;   // factor on the law's lengths, for neighbours in a sheet
  double offset = 0;  // m: radii subtracted from the distance
  // For a facet: weights of the edge opposite to each corner and of each corner, beside the facet's 1.
  std::array<std::int8_t, 3> edge{}, corner{};
  // Factor on the stiffness of friction's spring: of what is on guard, and weighs little, that of its area.
  float grip = 1;
  Fading fading = {};  // for `edges`
};

// A film between two surfaces: it resists sliding with the speed v by the traction
// viscous v (1 + (v / speed)^2)^((exponent - 1) / 2), which is never against the sliding and grows with it;
// of a melt that shear thins, with v^exponent far above `speed` [carreau1972].
struct Film {
  double viscous = 0;   // Pa s/m: viscosity at rest over thickness; 0: there is none
  double speed = 0;     // m/s; 0: the viscosity is the same at all speeds
  double exponent = 1;  // above 0 to 1
};

// Friction by Coulomb's law with a spring that remembers [simo1992]: the elastic slip of a pair is kept over
// the steps. A step adds its sliding to it; where the spring would then pull harder than mu times the normal
// force, it is shortened to that, and the rest of the sliding is lost. A sticking pair stays, whatever
// the number and the length of the steps.
//
// While a pair approaches, a pressure of loss * sqrt(stiffness of the law) times the speed of approach is
// added: a share zeta of the critical damping, whatever the depth. A sheet that meets something flat then
// leaves with exp(-zeta acos(zeta) / sqrt(1 - zeta^2)) of its speed.
//
// A sticking pair holds up to a static coefficient, which may be larger. Once it slides, mu applies until the
// sliding of a step is no longer against the pull.
struct Slip {
  double friction = 0;                                                       // mu
  double stiffness = 0;                                                      // Pa/m, of the spring, per area
  Corners moved = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  // m, the corners in the step
  // rad, rotation of the rigid side in the step. Friction acts on it at its own surface, the pair's offset
  // from its corners, so that a ball of radius R rolls with the speed w R.
  Vec3 turn = Vec3::Zero();
  Vec3 held = Vec3::Zero();  // m, elastic slip at the beginning of the step
  Vec3 pull = Vec3::Zero();  // N, friction on the second side then
  double loss = 0;           // sqrt(kg)/m, 2 zeta sqrt(areal mass)
  double dt = 0;             // s, of the step in time; 0: no damping
  double damped = 0;         // N, of the damping of approach at the beginning of the step
  double sticking = 0;       // the static coefficient; below mu: the same as mu
  double slides = 0;         // at the beginning of the step: what has slid over the elastic slip, up to 1
  // Friction by direction: mu holds along `along`, the warp of the cloth at the pair, and `across` across it;
  // between them they are half axes of an ellipse. Below 0: mu holds in all directions.
  double across = -1;
  Vec3 along = Vec3::Zero();  // of any length, zero: unknown, then mu is that of the warp
  Film film = {};             // resists where they touch, beside Coulomb's friction
  bool rubs() const { return friction > 0 || sticking > 0; }  // by Coulomb's law
  // Explicit steps: a resistance of 0.2 m / dt to the sliding velocity below the bound of Coulomb, with the
  // effective mass m of the pair at the place and as often as the place counts, damps the vibration of what
  // sticks. It cannot reverse the sliding.
  double step = 0;                       // s; 0: an implicit or static step
  double portion = 1;                    // of that resistance
  bool eased = false;                    // whether the guard is met by inertia, see Interaction
  std::array<double, 4> inverse_mass{};  // 1/kg; 0: the corner is held or driven
  // Factors in these of what else resists at the corners, see Force::resists.
  std::array<double, 4> crowd{1, 1, 1, 1};
};

struct Force {
  std::array<Vec3, 4> on = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  // N, friction included
  double contact = 0, guard = 0;                                                      // J
  Vec3 torque = Vec3::Zero();  // N m, of friction on the rigid side about its closest point
  Vec3 slip = Vec3::Zero();    // m, elastic slip at the end of the step
  Vec3 pull = Vec3::Zero();    // N, friction on the second side
  double stick = 0;            // J, elastic energy of the slip
  double damped = 0;           // N, of the damping of approach
  double slides = 0;           // at the end of the step
  // Explicit steps: the resistance at each corner over 0.2 m / dt of its own mass, but for Slip::crowd.
  std::array<double, 4> resists{};
  // J, work that the sliding of the step does against friction: in explicit steps by the forces at both ends,
  // else by those at the end; and against the damping of approach.
  double work = 0, impact = 0;
  double gap = 0;       // m, the smallest distance above the floor
  bool active = false;  // at least one place is within the law's range
  // Where the guard acts: its stiffness, N/m, along a normal, by the corners' weights. Places with a negative
  // weight are left out, so that it is a bound.
  struct Barrier {
    double stiffness = 0;
    Vec3 normal = Vec3::Zero();
    std::array<double, 4> weight{};
    bool struck = false;  // whether the pair comes in as in an impact
  } barrier = {};
};

// Forces on the corners.
Force pair_force(const ContactLaw& law, const Pair& pair, const Corners& x, const Slip* slip = nullptr);

// Finds the slip of a pair, for those that touch alone: of the near pairs most do not.
class SlipSource {
 public:
  virtual void find(Slip& slip) const = 0;  // `slip` is as it begins

 protected:
  ~SlipSource() = default;
};
// The same where it touches; otherwise it returns false, and `force` is not changed. slips: null without
// friction.
bool find_force(const ContactLaw& law, const Pair& pair, const Corners& x, const SlipSource* slips,
                Force& force);

struct Derivatives {
  double contact = 0, guard = 0;         // J
  Vector12 gradient = Vector12::Zero();  // N; forces are its negative
  Matrix12 hessian = Matrix12::Zero();   // N/m
};
// `of`: the blocks of the Hessian that are wanted; others are zero.
Derivatives pair_derivatives(const ContactLaw& law, const Pair& pair, const Corners& x, Blocks of = {});

// Derivatives of friction and damping of an implicit or static step: of the forces on the corners by the
// corners (N/m, not symmetric) and by the turn of the rigid side, and of the torque likewise.
struct FrictionTangent {
  Matrix12 jacobian = Matrix12::Zero();
  // The part of it that is not symmetric: how friction follows the normal force, and half of what else
  // differs from its transpose. The rest is as if the normal force stayed.
  Matrix12 apart = Matrix12::Zero();
  Eigen::Matrix<double, 12, 3> by_turn = Eigen::Matrix<double, 12, 3>::Zero();
  Eigen::Matrix<double, 3, 12> torque_by_x = Eigen::Matrix<double, 3, 12>::Zero();
  Mat3 torque_by_turn = Mat3::Zero();
};
// `of`: the blocks of the Jacobian that are wanted; with less than all of them what a turn does is left out.
FrictionTangent friction_tangent(const ContactLaw& law, const Pair& pair, const Corners& x, const Slip& slip,
                                 Blocks of = {});

}  // namespace fabricsh::contact
