// The state of contact: where its points are, the forces on them, and the sums over the pairs that touch, in
// the committed and in the trial state. Points are the nodes of the cloth and then the vertices of the
// bodies.
#pragma once
#include <string>
#include <vector>

#include "contact/contact.hpp"
#include "mechanics/terms/contact_surfaces.hpp"

namespace fabricsh::mechanics {

inline constexpr std::size_t many_nodes = 4096;  // from which loops use several threads

// Nodes that go along with a body, held to their places on it by springs that are stiff beside the cloth. The
// body moves freely or as it is driven; the nodes turn freely there.
class BodyTies {
 public:
  BodyTies(const ContactSurfaces& surfaces, const Cloth& cloth);
  struct Tie {
    std::size_t node, point;
    double carried;  // N/m, by an explicit step
    // Of a ball or rod that does not move freely: the ends of its axis, and the share of the second in the
    // point on it that is nearest to the place of the node.
    const BodyState::Body* body = nullptr;  // null: of another body
    std::size_t from = 0, to = 0;
    double share = 0;
  };
  const std::vector<Tie>& all() const { return ties_; }
  bool any() const { return !ties_.empty(); }
  double stiffness(const Tie& tie) const { return stiffness_ * tie.carried; }  // N/m
  void go_explicit() { stiffness_ = kMovingTie; }
  // Adds the forces of the springs, N; returns their energy, J.
  double add_forces(std::span<const Vec3> x, std::span<Vec3> force) const;
  // J, in an implicit step from `start` to `x`: what the body's pressure works on nodes that turn with it,
  // where nothing else presses them. It acts at the step's end, across an arc, while balls and rods feel it
  // at their axis. The forces of the springs, which answer it, work as much less. force: on all points, at
  // the end, of the pairs.
  double work_of_pressure(std::span<const Vec3> start, std::span<const Vec3> x, std::span<const Vec3> force,
                          const contact::Contact& pairs) const;

 private:
  // Of what an explicit step would carry beside the cloth; explicit steps are half as long then.
  static constexpr double kMovingTie = 10, kStiffTie = 1000;
  std::vector<Tie> ties_;
  double stiffness_ = kStiffTie;
};

struct ContactState {
  ContactState(ContactSurfaces& surfaces, const Configuration& configuration, const Cloth& cloth);

  // m: of all points, the bodies at a share of their way in the step.
  void positions(std::span<const double> of_nodes, double share, std::vector<Vec3>& out) const;
  void place(const Trial& trial);  // sets the positions at the start of the step and in the trial state
  double dt() const { return time - configuration.time(); }  // s
  // Data of the step that friction needs: from its beginning to the present share of the bodies' motion.
  contact::Way turn_bodies();
  // Adds the forces of the pairs at the present positions to `force`, with a way also those of friction.
  contact::Totals add_forces(const contact::Way& way);
  // Pairs that start within the range of contact have their energy and forces from the start.
  void begin();
  const contact::Totals& totals() const { return evaluated ? trial : committed; }
  std::span<const Vec3> nodal_forces() const { return std::span(force).first(surfaces.nodes()); }  // N
  bool acts() const { return totals().touching > 0 || ties.any(); }
  // J, lost by friction in the trial step: its work less what the springs of what sticks take up.
  double lost_in_step() const { return evaluated ? trial.work - (trial.stick - committed.stick) : 0; }

  ContactSurfaces& surfaces;
  const Configuration& configuration;
  mutable contact::Contact pairs;  // searched anew as they are read
  BodyTies ties;
  double time = 0;                           // s, at the end of the step
  double share = 0, iterate = 0;             // of the bodies' way: trial, iterate
  std::vector<Vec3> x, start;                // m: trial, at the start of the step
  std::vector<Vec3> force, torque, turning;  // N, N m, rad, in the step
  contact::Totals trial, committed;
  double trial_tied = 0, committed_tied = 0;  // J, of the springs
  double lost = 0, impact = 0;                // J, by friction and by impacts, up to the committed state
  double weight = 1;                          // of the forces at the end of an implicit step
  bool evaluated = false;                     // whether the forces of the trial state are known
  struct Moment {
    std::uint64_t version = 0;  // of the configuration
    double time = 0, share = 0, dt = 0;
    bool operator==(const Moment&) const = default;
  } evaluated_at;        // what the last forces are of
  bool blocked = false;  // whether the state of the last forces is impossible
  std::string overlaps;  // at the start, as a message; empty: there are none
};

// Overlaps at the start that are opened smoothly from time 0 to the end of their settling, and the work of
// it.
class SettlingOverlaps {
 public:
  explicit SettlingOverlaps(ContactState& state) : state_(state) {}
  void open_to(double time);
  // The work of opening in the step, by the trapezoid rule from its rates at both ends of the step. Returns
  // false if there is not enough room for the opening. Afterwards contact is opened as at the step's end.
  bool find_work();
  bool opens() const;                             // in the step
  const StepWork& work() const { return work_; }  // in the step

 private:
  double energy(std::span<const Vec3> x, double time);
  double pace(std::span<const Vec3> x, double time, double dt);

  ContactState& state_;
  StepWork work_;
  std::vector<double> shares_;  // by interaction
};

}  // namespace fabricsh::mechanics
