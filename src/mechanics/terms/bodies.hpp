// The rigid bodies of a model in motion: where their vertices are, and what that costs.
//
// A step brings them from where they are committed to where they are at its end: standing ones stay, driven
// ones follow their histories, surfaces that move go from shape to shape, free ones fly on with the force
// that they had (velocity Verlet: half a kick, the flight, half a kick from the force at the end), in a run
// of any kind. Newton's iterations come there by shares, on straight lines, so that nothing is jumped over.
#pragma once
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "contact/rigid.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

class Bodies {
 public:
  // Adds the bodies' surfaces to the scene, behind those that it has.
  Bodies(const model::Model& model, contact::Scene& scene);

  std::size_t count() const { return bodies_.size(); }
  const model::Rigid& body(std::size_t i) const { return *bodies_[i].given; }
  int surface(std::size_t i) const { return bodies_[i].surface; }
  // Rows of the vertices of body i, counted from the first vertex of all.
  std::pair<std::size_t, std::size_t> vertices(std::size_t i) const {
    return {bodies_[i].first, bodies_[i].first + bodies_[i].count};
  }
  bool any_free() const;
  bool any_driven() const;  // moved, turned, or from shape to shape

  // Where the step from `from` to `to` ends, s. Error: a history is not finite.
  void aim(double from, double to);
  std::span<const Vec3> committed() const { return committed_; }  // m, vertices of all bodies
  std::span<const Vec3> target() const { return target_; }        // at the time aimed at

  // The forces on the vertices where the step ends, N.
  void load(std::span<const Vec3> force);
  void commit();
  void rollback() { loaded_ = false; }
  void keep(Archive& archive);

  // --- of the trial state where forces are known there, else of the committed one
  double kinetic() const;  // J, of the free ones
  // J, that is done on cloth and bodies in the step from outside: by what drives bodies, by gravity on free
  // ones.
  double step_work() const;
  Vec3 force(std::size_t i) const;  // N, of the cloth on body i
  struct State {
    Vec3 place, velocity, spin;  // of its centre, m, m/s; rad/s
  };
  State state(std::size_t i) const;
  // Its motion since it was declared.
  contact::Pose pose(std::size_t i) const;
  // Points of a body, as they were declared, where they are now; of a moving surface all its vertices.
  std::vector<Vec3> moved(std::size_t i, const std::vector<Vec3>& points) const;
  // 1/kg, at most what a vertex gives way to a force by.
  double inverse_mass(std::size_t i) const;

 private:
  struct Free {
    contact::FreeBody committed, predicted;
    contact::Wrench wrench, trial;  // on it, gravity apart; N, N m about its centre
    double bound = 0;               // 1/kg
  };
  struct Body {
    model::RigidPointer given;
    int surface = -1;
    std::size_t first = 0, count = 0;  // vertices
    const model::BodyMotion* motion = nullptr;
    std::optional<contact::MovingShape> moving = {};
    int free = -1;  // of free_
  };
  contact::Pose driven(const Body& body, double time) const;
  void place(const Body& body, double time, std::span<Vec3> x) const;
  Vec3 gravity(double time) const;
  contact::FreeBody flown(const Free& body, double time, double dt) const;
  contact::FreeBody kicked(const Free& body) const;
  double now() const { return loaded_ ? to_ : from_; }  // s, of the state that is read

  const model::Model& model_;
  std::vector<Body> bodies_;
  std::vector<Free> free_;
  std::vector<Vec3> reference_, committed_, target_;  // m
  std::vector<Vec3> force_, trial_force_;             // N, on the vertices
  double from_ = 0, to_ = 0;                          // s
  bool loaded_ = false;                               // are trial forces known
};

}  // namespace fabricsh::mechanics
