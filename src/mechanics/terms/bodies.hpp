// The rigid bodies of a model in motion: the positions of their vertices, and the work involved.
//
// A step moves them from their committed positions to those at its end: fixed bodies stay, driven ones follow
// their histories, moving surfaces change from shape to shape, and free bodies move under the forces on them
// (velocity Verlet: half a kick, the flight, half a kick with the force at the end), in a run of any kind.
// Newton's iterations take them there by shares, along straight lines, so that no contact is passed over.
#pragma once
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "contact/rigid.hpp"
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
  bool any_free() const;
  bool any_driven() const;  // a body is moved, rotated, or changes its shape

  // Sets the times of the step's beginning and end, s. Error: a history is not finite.
  void aim(double from, double to);
  std::span<const Vec3> committed() const { return committed_; }  // m, vertices of all bodies
  std::span<const Vec3> target() const { return target_; }        // at the end of the step

  // Sets the forces on the vertices at the end of the step, N.
  void load(std::span<const Vec3> force);
  void commit();
  void rollback() { loaded_ = false; }
  void keep(Archive& archive);

  // --- in the trial state if its forces are known, otherwise in the committed state
  double kinetic() const;  // J, of the free bodies
  // J, external work on cloth and bodies in the step: that of driven bodies, and that of gravity on free
  // ones.
  double step_work() const;
  Vec3 force(std::size_t i) const;  // N, of the cloth on body i
  struct State {
    Vec3 place, velocity, spin;  // of its centre, m, m/s; rad/s
  };
  State state(std::size_t i) const;
  // The motion of the body since time 0.
  contact::Pose pose(std::size_t i) const;
  // The present positions of points given for the declared body; for a moving surface, of all its vertices.
  std::vector<Vec3> moved(std::size_t i, const std::vector<Vec3>& points) const;
  // 1/kg, an upper bound of the inverse effective mass of a vertex.
  double inverse_mass(std::size_t i) const;

 private:
  struct Free {
    contact::FreeBody committed, predicted;
    contact::Wrench wrench, trial;  // on it, without gravity; N, N m about its centre
    double bound = 0;               // 1/kg
  };
  struct Body {
    model::RigidPointer given;
    int surface = -1;
    std::size_t first = 0, count = 0;  // vertices
    const model::BodyMotion* motion = nullptr;
    std::optional<contact::MovingShape> moving = {};
    int free = -1;  // index in free_, -1: not free
  };
  contact::Pose driven(const Body& body, double time) const;
  void place(const Body& body, double time, std::span<Vec3> x) const;
  Vec3 gravity(double time) const;
  contact::FreeBody flown(const Free& body, double time, double dt) const;
  contact::FreeBody kicked(const Free& body) const;
  double now() const { return loaded_ ? to_ : from_; }  // s, of the state being read

  const model::Model& model_;
  std::vector<Body> bodies_;
  std::vector<Free> free_;
  std::vector<Vec3> reference_, committed_, target_;  // m
  std::vector<Vec3> force_, trial_force_;             // N, on the vertices
  double from_ = 0, to_ = 0;                          // s
  bool loaded_ = false;                               // whether the forces in the trial state are known
};

}  // namespace fabricsh::mechanics
