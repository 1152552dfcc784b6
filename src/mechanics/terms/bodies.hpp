// The rigid bodies of a model in motion: the positions of their vertices, and the work involved.
//
// A step moves them from their committed positions to those at its end: fixed bodies stay, driven ones follow
// their histories, moving surfaces change from shape to shape, and free bodies move under the forces on them:
// half a kick, the flight, half a kick. In explicit steps the first kick is from the force at the beginning
// of the step, the second from that at its end (velocity Verlet). In implicit steps both kicks are from the
// force at the end, six numbers for each body, which is solved for together with the unknowns of the cloth;
// gravity, loads and springs act with their means, so that they make no energy. In the generalised
// trapezoidal rule (see Newmark) the first kick is a part theta of the impulse, and the means have the weight
// theta at the end of the step. In static steps the six numbers are a displacement and a rotation, and the
// forces on the body balance.
// Newton's iterations take them there by shares, along straight lines, so that no contact is passed over.
#pragma once
#include <cmath>
#include <numbers>

#include "base/archive.hpp"
#include "geometry/box.hpp"
#include "mechanics/facets.hpp"
#include "mechanics/terms/body_equations.hpp"
#include "mechanics/terms/body_loads.hpp"
#include "mechanics/terms/body_state.hpp"

namespace fabricsh::mechanics {

// --- Readings of rigid bodies, in the trial state if its forces are known, otherwise in the committed state.

class BodyReadings {
 public:
  BodyReadings(const BodyState& state, const BodyLoads& loads) : state_(state), loads_(loads) {}
  double kinetic() const;  // J, of the free bodies
  // External work on cloth and bodies in the step: that of driven bodies, and that of gravity on free ones.
  StepWork step_work() const;
  // J, that an implicit step with theta over 1/2 takes from free bodies and their springs.
  double lost_by_rule() const;
  Vec3 force(std::size_t i) const;  // N, of the cloth on body i
  Vec3 held(std::size_t i) const;   // N, with which m:fix holds body i: zero in the directions left free
  // 1/kg, an upper bound of the inverse effective mass of a vertex.
  double inverse_mass(std::size_t i) const;
  // 1/kg, the same of what pressing meets; a ball has all of its mass there.
  double inverse_mass_pressed(std::size_t i) const;
  // The planes of symmetry that cut a free body, one bit each; 0 for others.
  unsigned char planes_through(std::size_t i) const;
  // m: of its surface from its centre, a rod's or disc's radius; 0 for a plane.
  double size(std::size_t i) const;
  double fastest_free() const;  // m/s, of the centres of free bodies
  // Of each free body its centre and three points, far out on its axes; see OwnUnknowns::add_places().
  void add_places(OwnUnknowns::Places which, std::vector<double>& x) const;

 private:
  StepWork work_of_gas(const BodyState::Body& body) const;

  const BodyState& state_;
  const BodyLoads& loads_;
};

// --- How long a step may be, so that contact can take the ways of rigid bodies in it for straight.

class BodyPaths {
 public:
  explicit BodyPaths(const BodyState& state) : state_(state) {}
  // The largest turn of a body in a step, rad: friction takes its direction in the step as one.
  static constexpr double largest_turn = std::numbers::pi / 6;
  // s: the latest end, up to `to`, of a step from `from` on in which body i turns by no more than that, and
  // its points stay within `near` (m) of their straight ways. `cloth`: where the cloth is; a plane has no
  // points farther out, and a free body that flies towards it may come to roll on it.
  double latest_end(std::size_t i, double from, double to, double near, const BoundingBox& cloth) const;
  double turned_most() const;  // rad, of any body in the step

 private:
  // Of a body's path from one time to another: how much more it turns and bends than contact follows, 1: just
  // as much. A step that is n times as short has a share n or n^2 times as small.
  struct Path {
    double turn = 0, bend = 0;
    double parts() const { return std::max(turn, std::sqrt(bend)); }
  };
  Path path(const BodyState::Body& body, double from, double to, double near, const BoundingBox& cloth) const;
  double lever(const BodyState::Body& body, const BoundingBox& cloth) const;

  const BodyState& state_;
};

class Bodies {
 public:
  // Adds the surfaces of the bodies to the scene, after its present ones.
  Bodies(const model::Model& model, contact::Scene& scene);
  Bodies(const Bodies&) = delete;  // its parts refer to its state

  const BodyState& state() const { return state_; }
  BodyEquations& equations() { return equations_; }
  const BodyEquations& equations() const { return equations_; }
  const BodyLoads& loads() const { return loads_; }
  const BodyReadings& readings() const { return readings_; }
  const BodyPaths& paths() const { return paths_; }

  std::size_t count() const { return state_.bodies.size(); }
  const model::Rigid& body(std::size_t i) const { return *state_.bodies[i].given; }
  // Number of the first vertex of body i, counted over all bodies, and the number after its last one.
  std::pair<std::size_t, std::size_t> vertices(std::size_t i) const {
    return {state_.bodies[i].first, state_.bodies[i].first + state_.bodies[i].count};
  }
  // Number of the first of the points that lid k of gas volume i has on its body, counted as vertices are.
  std::size_t seats(std::size_t gas, std::size_t lid) const { return seats_[gas][lid]; }
  // Nodes of the cloth that go along with a body, and the number of the point that stands for each on it.
  struct TiedNode {
    Index node;
    std::size_t point;
  };
  const std::vector<TiedNode>& tied() const { return tied_; }
  bool any_free() const { return !state_.free.empty(); }
  bool any_driven() const;  // a body is moved, rotated, or changes its shape
  const std::string& without_mass() const { return without_mass_; }  // a body that only statics can place
  // Of each free body that a plane of symmetry cuts, what that means for it.
  const std::vector<std::string>& halves() const { return halves_; }

  // Takes the driven bodies to where they are at the step's end, as if they had never been elsewhere.
  void settle();
  bool jumps() const;  // whether one would go anywhere in that
  // Sets the times of the step's beginning and end, s. Error: a history is not finite.
  void set_time(double from, double to);
  // Sets the forces of gas on the vertices, N: at the start of the run, and at the end of the step. Implicit
  // steps take their mean in the step.
  void begin_gas(std::span<const Vec3> force) {
    state_.gas.assign(force.begin(), force.end());
    state_.trial_gas = state_.gas;
  }
  void press(std::span<const Vec3> force) { state_.trial_gas.assign(force.begin(), force.end()); }
  // Sets the other forces on the vertices at the start of the run, N.
  void begin(std::span<const Vec3> force);
  // Sets the forces on the vertices at the end of the step, N, and the torques of friction, N m.
  void load(std::span<const Vec3> force, std::span<const Vec3> torque);
  // Adds to the force on a vertex of a body that is held or driven, N.
  void add(std::size_t vertex, const Vec3& force) { state_.trial_force[vertex] += force; }
  bool is_driven(std::size_t i) const {
    return state_.bodies[i].motion != nullptr || state_.bodies[i].moving.has_value();
  }
  // Where the vertices of a driven body are at a time after the step, m; where a history has no number then,
  // as far on as it came in the step.
  std::vector<Vec3> places(std::size_t i, double time) const;
  void commit();
  void rollback();
  // The forces at the step's end are sought from here on.
  void go_implicit() { state_.implicit = true; }
  void set_late(double late) { state_.late = late; }  // theta, of the implicit steps from the next one on
  // The places at which the bodies are at rest are sought from here on. reach: m, how far one may go in an
  // iteration that nothing holds yet.
  // Loads that act at time 0 rise over the first `rise` seconds, so that a body does not set out for where
  // nothing holds it; 0: they act from the beginning on.
  void go_static(double reach, double rise);
  void keep(Archive& archive);

 private:
  BodyState::Free free_body(const BodyState::Body& body, const contact::Scene& scene);
  void add_seats(const BodyState::Body& body, contact::Scene& scene);
  void add_tied(const BodyState::Body& body, contact::Scene& scene);
  void add_gas(const BodyState::Body& body, BodyState::Free& free) const;
  bool is_cut(const model::SymmetryPlane& plane, const BodyState::Body& body, const contact::Mass& mass,
              const contact::Scene& scene) const;
  void place(const BodyState::Body& body, double time, std::span<Vec3> x) const;

  BodyState state_;
  BodyLoads loads_{state_};
  BodyEquations equations_{state_, loads_};
  BodyReadings readings_{state_, loads_};
  BodyPaths paths_{state_};
  std::vector<std::vector<std::size_t>> seats_;  // of each gas volume and lid
  std::vector<TiedNode> tied_;
  std::string without_mass_;
  std::vector<std::string> halves_;
};

}  // namespace fabricsh::mechanics
