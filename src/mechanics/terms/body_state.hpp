// The rigid bodies of a model: where they are at the beginning and at the end of the step, and the forces on
// them. Classes that have it as a member compute its change in a step.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "contact/rigid.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

struct BodyState {
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
    // Implicit steps: the force at the end with which it flies, that of the iterate, the change from it, and
    // that of an iterate to which the solver may return.
    contact::Wrench end = {}, iterate = {}, way = {}, saved = {};
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

  const model::Model& model;
  std::vector<Body> bodies = {};
  std::vector<Free> free = {};
  std::vector<Vec3> reference = {}, committed = {},
                    target = {};                   // m, vertices of all bodies; at the end of the step
  std::vector<Vec3> force = {}, trial_force = {};  // N, on the vertices
  std::vector<Vec3> gas = {}, trial_gas = {};      // N, of gas besides; empty: it pushes on no body
  std::vector<int> free_of = {};  // of each vertex: the number of its body among the free ones, -1: none
  double from = 0, to = 0;        // s
  bool loaded = false;            // whether the forces in the trial state are known
  bool implicit = false, statics = false;
  double late = 0.5;  // theta of implicit steps
  double rise = 0;    // s, in which statics bring up what acts at time 0 already
  double reach = 0;   // m, that a body may go in an iteration which nothing holds yet

  double flight() const { return statics ? 1 : to - from; }  // s
  double now() const { return loaded ? to : from; }          // s, of the state being read
  // The part of what acts at time 0 that does not act yet.
  double missing(double time) const { return time < rise ? 1 - time / rise : 0; }
  Vec3 gravity(double time) const;
  Vec3 displaced(const Body& body, double time) const;
  contact::Pose driven(const Body& body, double time) const;
  bool balances() const { return statics || late > 0.5; }  // whether all forces come to balance
  // Of what acts at the step's end, in what acts in the step.
  double share_of_end() const { return implicit && !statics ? late : 1; }
  // What acts in the step, from its values at both ends; and what its work is counted with.
  Vec3 in_step(const Vec3& before, const Vec3& after) const {
    return implicit && !statics ? mean(before, after) : after;
  }
  Vec3 mean(const Vec3& before, const Vec3& after) const { return (1 - late) * before + late * after; }
  std::span<const Vec3> pressed() const { return loaded ? trial_gas : gas; }  // N, by gas; empty: none
  // The unknowns before the first iteration.
  contact::Wrench start_of(const Free& body) const { return statics ? contact::Wrench{} : body.wrench; }
  contact::Wrench first_part(const Free& body) const;  // what kicks it before it flies, gravity included
  contact::FreeBody kicked(const Free& body) const;  // at the end of the step, if the forces there are known
  void fly();                                        // moves the free bodies to the end of the step

  // Of body i, in the trial state if its forces are known, otherwise in the committed one: its centre, m,
  // m/s, rad/s; of a moving surface the means over its vertices, and no spin.
  struct Kinematics {
    Vec3 place, velocity, spin;
  };
  Kinematics kinematics(std::size_t i) const;
  contact::Pose pose(std::size_t i) const;  // its motion since time 0
  // The present positions of points given for the declared body; for a moving surface, of all its vertices.
  std::vector<Vec3> moved(std::size_t i, const std::vector<Vec3>& points) const;
  static Vec3 rotation(const Mat3& from, const Mat3& to);  // rad, from one orientation to another
};

}  // namespace fabricsh::mechanics
