// The rigid bodies of a model in motion: the positions of their vertices, and the work involved.
//
// A step moves them from their committed positions to those at its end: fixed bodies stay, driven ones follow
// their histories, moving surfaces change from shape to shape, and free bodies move under the forces on them:
// half a kick, the flight, half a kick. In explicit steps the first kick is from the force at the beginning
// of the step, the second from that at its end (velocity Verlet). In implicit steps both kicks are from the
// force at the end, six numbers for each body, which is solved for together with the unknowns of the cloth;
// gravity, loads and springs act with their means, so that they make no energy. In static steps the six
// numbers are a displacement and a rotation, and the forces on the body balance.
// Newton's iterations take them there by shares, along straight lines, so that no contact is passed over.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "contact/rigid.hpp"
#include "geometry/box.hpp"
#include "mechanics/step_work.hpp"
#include "mechanics/term.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

class Bodies {
 public:
  // Adds the surfaces of the bodies to the scene, after its present ones.
  Bodies(const model::Model& model, contact::Scene& scene);

  std::size_t count() const { return bodies_.size(); }
  const model::Rigid& body(std::size_t i) const { return *bodies_[i].given; }
  int surface(std::size_t i) const { return bodies_[i].surface; }
  // Number of the first vertex of body i, counted over all bodies, and the number after its last one.
  std::pair<std::size_t, std::size_t> vertices(std::size_t i) const {
    return {bodies_[i].first, bodies_[i].first + bodies_[i].count};
  }
  // Number of the first of the points that lid k of gas volume i has on its body, counted as vertices are.
  std::size_t seats(std::size_t gas, std::size_t lid) const { return seats_[gas][lid]; }
  // Nodes of the cloth that go along with a body, and the number of the point that stands for each on it.
  struct TiedNode {
    Index node;
    std::size_t point;
  };
  const std::vector<TiedNode>& tied() const { return tied_; }
  bool any_free() const;
  bool any_driven() const;  // a body is moved, rotated, or changes its shape

  // The largest turn of a body in a step, rad: friction takes its direction in the step as one.
  static constexpr double largest_turn = std::numbers::pi / 6;
  // s: the latest end, up to `to`, of a step from `from` on in which body i turns by no more than that, and
  // its points stay within `near` (m) of their straight ways. `cloth`: where the cloth is; a plane has no
  // points farther out, and a free body that flies towards it may come to roll on it.
  double follows(std::size_t i, double from, double to, double near, const BoundingBox& cloth) const;
  double turned_most() const;  // rad, of any body in the step

  // Takes the driven bodies to where they are at the step's end, as if they had never been elsewhere.
  void settle();
  bool jumps() const;  // whether one would go anywhere in that
  // Sets the times of the step's beginning and end, s. Error: a history is not finite.
  void set_time(double from, double to);
  std::span<const Vec3> committed() const { return committed_; }  // m, vertices of all bodies
  std::span<const Vec3> target() const { return target_; }        // at the end of the step

  // rad: rotation of body i in the step; zero for a surface that changes from shape to shape.
  const Vec3& turned(std::size_t i) const { return bodies_[i].turned; }

  // Sets the forces of gas on the vertices, N: at the start of the run, and at the end of the step. Implicit
  // steps take their mean in the step.
  void begin_gas(std::span<const Vec3> force) {
    gas_.assign(force.begin(), force.end());
    trial_gas_ = gas_;
  }
  void press(std::span<const Vec3> force) { trial_gas_.assign(force.begin(), force.end()); }
  double share_of_gas() const { return implicit_ && !static_ ? 0.5 : 1; }  // of its force at the step's end
  // Sets the other forces on the vertices at the start of the run, N.
  void begin(std::span<const Vec3> force);
  // Sets the forces on the vertices at the end of the step, N, and the torques of friction, N m.
  void load(std::span<const Vec3> force, std::span<const Vec3> torque);
  void commit();
  void rollback();
  // The forces at the step's end are sought from here on.
  void go_implicit() { implicit_ = true; }
  // The places at which the bodies are at rest are sought from here on. reach: m, how far one may go in an
  // iteration that nothing holds yet.
  // What acts at time 0 already comes up over the first `rise` seconds, so that a body does not set out for
  // where nothing holds it; 0: it acts from the beginning on.
  void go_static(double reach, double rise);
  bool any_loaded() const { return !loads_.empty() || !springs_.empty(); }
  const std::string& without_mass() const { return without_mass_; }  // a body that only statics can place
  // --- of free bodies in implicit steps: force (N) and torque (N m) on each at the step's end, six numbers a
  // body: those that act, less those with which its flight was computed.
  std::size_t unknowns() const { return implicit_ ? 6 * free_.size() : 0; }
  Eigen::VectorXd residual() const;
  double largest_force() const;              // N, torques over the body's size
  double largest_residual() const;           // N, torques over the body's size
  void direct(std::span<const double> way);  // the change that move() takes shares of
  void begin_iterate();
  void move(double scale);
  // Of a free body, by its number: the derivative of its position and rotation by the force and torque at
  // the step's end, 6 x 6.
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  Matrix6 compliance(std::size_t free) const;
  // Of a free body, by its number: kg and kg m2; 1 for what it may do, its places and turns, else 0.
  Matrix6 mass_matrix(std::size_t free) const;
  Vector6 freedom(std::size_t free) const;
  Eigen::MatrixXd spring_stiffness() const;  // N/m, by the places of all free bodies, 6 numbers each
  // Adds to the derivative of the residual by the unknowns what springs and dampers give.
  void add_response(Eigen::MatrixXd& response) const;
  // Adds in static steps the unknowns themselves, and what holds a body that is held by nothing else.
  void hold(Eigen::MatrixXd& response) const;
  // Which of the unknowns are of directions in which a support holds a body.
  std::vector<bool> held() const;
  // The number of vertex row v's body among the free ones, -1: none; and its lever from the centre, m.
  int free_of(std::size_t v) const { return free_of_[v]; }
  std::span<const Vec3> pressed() const { return loaded_ ? trial_gas_ : gas_; }  // N, by gas; empty: none
  Vec3 lever(std::size_t v) const { return target_[v] - free_[free_of_[v]].predicted.centre(); }
  void keep(Archive& archive);

  // --- in the trial state if its forces are known, otherwise in the committed state
  double kinetic() const;  // J, of the free bodies
  // External work on cloth and bodies in the step: that of driven bodies, and that of gravity on free ones.
  StepWork step_work() const;
  Vec3 force(std::size_t i) const;  // N, of the cloth on body i
  Vec3 held(std::size_t i) const;   // N, with which m:fix holds body i: zero in the directions left free
  struct BodyKinematics {
    Vec3 place, velocity, spin;  // of its centre, m, m/s; rad/s
  };
  // Of a moving surface: the means over its vertices, and no spin.
  BodyKinematics state(std::size_t i) const;
  // The motion of the body since time 0.
  contact::Pose pose(std::size_t i) const;
  // The present positions of points given for the declared body; for a moving surface, of all its vertices.
  std::vector<Vec3> moved(std::size_t i, const std::vector<Vec3>& points) const;
  // 1/kg, an upper bound of the inverse effective mass of a vertex.
  double inverse_mass(std::size_t i) const;
  // The planes of symmetry that cut a free body, one bit each; 0 for others.
  unsigned char planes_through(std::size_t i) const;
  // 1/kg, the same of what pressing meets; a ball has all of its mass there.
  double inverse_mass_pressed(std::size_t i) const;
  // m: of its surface from its centre, a rod's or disc's radius; 0 for a plane.
  double size(std::size_t i) const;
  double fastest_free() const;   // m/s, of the centres of free bodies
  double spring_energy() const;  // J, stored
  double damped() const;         // J, lost in dampers so far
  double stable_step() const;    // s, of explicit steps, for springs and dampers
  // Of each free body that a plane of symmetry cuts, what that means for it.
  const std::vector<std::string>& halves() const { return halves_; }

 private:
  struct Free {
    contact::FreeBody committed, predicted;
    contact::Wrench wrench, trial;  // on it, without gravity; N, N m about its centre
    double bound = 0;               // 1/kg
    double size = 0;                // m, of what is farthest from its centre
    double arm = 0;                 // m, the same of its points, without their radius
    // The diagonals of what supports and planes of symmetry that cut the body leave of forces and torques.
    bool cut = false;
    int planes = 0;  // of symmetry that cut it
    Vec3 moves = Vec3::Ones(), turns = Vec3::Ones();
    contact::Wrench left(const contact::Wrench& all) const {
      return cut ? contact::Wrench{all.force.cwiseProduct(moves), all.torque.cwiseProduct(turns)} : all;
    }
    contact::Wrench load = {};  // of loads, springs and dampers, in `trial` already
    double largest = 0;         // N, of what pushes it
    // Implicit steps: the force at the end with which it flies, that of the iterate, and the change from it.
    contact::Wrench end = {}, iterate = {}, way = {};
  };
  struct Body {
    model::RigidPointer given;
    int surface = -1;
    std::size_t first = 0, count = 0;  // vertices
    const model::BodyMotion* motion = nullptr;
    std::optional<contact::MovingShape> moving = {};
    int free = -1;                                            // index in free_, -1: not free
    Vec3 turned = Vec3::Zero();                               // rad, in the step
    Vec3 torque = Vec3::Zero(), trial_torque = Vec3::Zero();  // N m, that friction turns it with
  };
  // What loads a free body, and what ties its centre.
  struct Load {
    std::size_t body;  // in bodies_
    const model::BodyLoad* given;
  };
  struct Spring {
    std::size_t body = 0;  // in bodies_
    int to = -1;           // in bodies_; -1: the ground
    // N/m or N s/m; m, the displacement of the body from the other end at which it is slack
    Vec3 stiffness = Vec3::Zero(), slack = Vec3::Zero();
    bool damper = false;
    Vec3 force = Vec3::Zero(), trial_force = Vec3::Zero();  // N, of a damper on the body
    double lost = 0;                                        // J, up to the committed state
  };
  Free free_body(const Body& body, const contact::Scene& scene);
  void add_seats(const Body& body, contact::Scene& scene);
  void add_tied(const Body& body, contact::Scene& scene);
  void add_gas(const Body& body, Free& free) const;
  StepWork work_of_gas(const Body& body) const;
  void add_loads();
  void add_springs();
  Vec3 displacement_of(std::size_t body, bool end) const;  // m, of its centre since time 0
  Vec3 stretch(const Spring& spring, bool end) const;
  Vec3 total(const Load& load, double time) const;
  Vec3 pull(const Spring& spring) const;
  void push(const Spring& spring, const Vec3& force);
  void push(const Load& load, const Vec3& total);
  double lost_in(const Spring& spring) const;
  void begin_loads();
  void apply_loads();
  StepWork work_of_loads() const;
  double flight() const { return static_ ? 1 : to_ - from_; }  // s
  bool is_cut(const model::SymmetryPlane& plane, const Body& body, const contact::Mass& mass,
              const contact::Scene& scene) const;
  contact::Pose driven(const Body& body, double time) const;
  Vec3 displaced(const Body& body, double time) const;
  // Of a body's path from one time to another: how much more it turns and bends than contact follows, 1: just
  // as much. A step that is n times as short has a share n or n^2 times as small.
  struct BodyPath {
    double turn = 0, bend = 0;
    double parts() const { return std::max(turn, std::sqrt(bend)); }
  };
  BodyPath path(const Body& body, double from, double to, double near, const BoundingBox& cloth) const;
  double lever(const Body& body, const BoundingBox& cloth) const;
  void place(const Body& body, double time, std::span<Vec3> x) const;
  Vec3 gravity(double time) const;
  // The part of what acts at time 0 that does not act yet.
  double missing(double time) const { return time < rise_ ? 1 - time / rise_ : 0; }
  // The unknowns before the first iteration.
  contact::Wrench start_of(const Free& body) const { return static_ ? contact::Wrench{} : body.wrench; }
  contact::Wrench first_half(const Free& body) const;  // what kicks it before it flies, gravity included
  void fly();
  contact::FreeBody kicked(const Free& body) const;
  double now() const { return loaded_ ? to_ : from_; }  // s, of the state being read

  const model::Model& model_;
  std::vector<Body> bodies_;
  std::vector<Free> free_;
  std::vector<Vec3> reference_, committed_, target_;  // m
  std::vector<Vec3> force_, trial_force_;             // N, on the vertices
  std::vector<Vec3> gas_, trial_gas_;                 // N, of gas besides; empty: it pushes on no body
  std::vector<std::vector<std::size_t>> seats_;       // of each gas volume and lid
  std::vector<TiedNode> tied_;
  double from_ = 0, to_ = 0;  // s
  bool loaded_ = false;       // whether the forces in the trial state are known
  bool implicit_ = false, static_ = false;
  double rise_ = 0;   // s
  double reach_ = 0;  // m
  std::vector<Load> loads_;
  std::vector<Spring> springs_;
  std::string without_mass_;
  std::vector<int> free_of_;  // of each vertex, -1
  std::vector<std::string> halves_;
};

}  // namespace fabricsh::mechanics
