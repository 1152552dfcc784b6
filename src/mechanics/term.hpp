// A term: something that makes force. Cloth, gravity, loads, springs, damping, inertia and contact are terms;
// the assembly is their sum, and nothing else adds force, energy or stiffness. A term brings all of its own:
// forces, tangent, energies by name, the pairs of nodes that it couples, its part of a checkpoint, the
// largest stable step, and how much of a step is safe.
#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/answer.hpp"
#include "base/archive.hpp"
#include "geometry/vec.hpp"
#include "law/law.hpp"
#include "linear/matrix.hpp"
#include "mechanics/configuration.hpp"
#include "mechanics/motion.hpp"

namespace fabricsh::mechanics {

using Index = std::int64_t;

// What a term sees: the trial configuration at the time that the step ends.
struct Trial {
  const Configuration& configuration;
  const std::vector<Vec3>& X;      // reference positions, m
  double time = 0;                 // s, that loads are taken at
  const Motion* motion = nullptr;  // of the step under way; null where no run steps the assembly
};

// What energies are to the ledger.
enum class Account {
  stored,      // a function of the state, given back
  moving,      // kinetic, beside that of the cloth
  dissipated,  // a function of the state, lost
  created,     // made by a law that is not dissipative
  kinetic,     // of the motion, without the displacements that are driven
  damping      // lost to forces that hang on the motion, so far
};
struct Energy {
  std::string name;  // "membrane", "warp", "springs", ...
  Account account;
  double value = 0;  // J
};

// Stiffness goes here, by nodes; who fills the matrix minds frames, supports and ties.
class TangentSink {
 public:
  virtual ~TangentSink() = default;
  // d(internal force on x_a) / d(x_b), N/m, global.
  virtual void on_positions(Index a, Index b, const Mat3& k) = 0;
  // On the two rotations of a node's director (q1 along b1, q2 along d x b1), N m.
  virtual void on_director(Index a, const Eigen::Matrix2d& k) = 0;
  // Change of the internal force on x_a, N, global, when what the step drives beside the supports has come to
  // where it ends.
  virtual void on_lead(Index a, const Vec3& force) = 0;
};

// Forces on nodes, 3 per node, global. Internal ones count against the residual: r = external - internal.
struct Forces {
  std::span<double> on_x;  // N, internal
  std::span<double> on_d;  // N m, internal, on directors
};

// What came of a term's forces. Where they could not be had: an element to name, -1: none; and why, in words
// that end a sentence ("the law failed"), which a run that is broken off tells.
struct Outcome {
  Answer answer = Answer::ok;
  Index element = -1;
  std::string why = {};
  bool ok() const { return answer == Answer::ok; }
};

// What a term that is a multiple of the mass multiplies it with: forces m (acceleration * a + velocity * v)
// on a node, m its mass or rotary inertia, a and v its acceleration and velocity.
struct OnMass {
  double acceleration = 0;  // 1 for inertia
  double velocity = 0;      // 1/s
};

// Two nodes whose freedoms a tangent couples.
using NodePair = std::pair<Index, Index>;

class Term {
 public:
  virtual ~Term() = default;
  virtual const char* name() const = 0;  // of its section in a checkpoint, and in messages

  // --- forces
  // Adds the internal forces. What comes first (`starts`) may set instead of add, and must set all.
  virtual Outcome add_forces(const law::Step&, const Trial&, Forces&) { return {}; }
  virtual bool starts() const { return false; }
  // Forces that hang on time alone, N, 3 per node: added. Constant: the same at all times.
  virtual void add_dead(double /*time*/, std::span<double> /*on_x*/) const {}
  virtual bool constant() const { return true; }
  // Loads that follow the configuration, at a time, for the work that they do: added. They are among the
  // internal forces already, with the other sign.
  virtual bool follows_positions() const { return false; }
  virtual bool follows_directors() const { return false; }
  virtual void add_follower(double /*time*/, const Trial&, std::span<double> /*on_x*/,
                            std::span<double> /*on_d*/) const {}
  // Moments about axes fixed in space, N m per node: where they act on a rigid set, their part about the
  // director works on the set alone. Null: none.
  virtual const std::vector<Vec3>* moments() const { return nullptr; }

  // --- tangent
  virtual void add_tangent(const Trial&, TangentSink&) const {}
  virtual bool symmetric() const { return true; }
  // Adds the pairs of nodes, beyond those of the elements, that the tangent at the trial configuration
  // couples. Asked before each tangent, and never where none is wanted; the pairs may be others each time.
  // Where the pattern lacks one it is made anew, of the pairs wanted then, and the solver analyses again: a
  // term whose pairs come and go had better name those too that may come soon.
  virtual void couple(const Trial&, std::vector<NodePair>&) {}

  // --- forces that hang on the motion of a step (trial.motion, never null here). They are counted beside the
  // internal ones: supports do not feel them, and the work of loads and supports has none of them in it.
  virtual OnMass on_mass() const { return {}; }
  // A step from the committed configuration, which is the trial one, begins.
  virtual Outcome begin_step(const Motion&) { return {}; }
  // Takes forces on the unknowns, N and N m, from the residual r; and adds their derivative to K, as much of
  // it as the scheme weighs it with.
  virtual void resist(const Trial&, std::span<double> /*r*/) {}
  virtual void add_resistance(const Trial&, linear::Matrix& /*K*/) {}
  // The trial state is about to be committed: what the step did goes to the account.
  virtual void finish_step(const Motion&) {}

  // --- energies, at the trial configuration
  // Will the energies be asked for after the next forces? A term may then sum them on its way through those;
  // add_energies() gives the same numbers all the same.
  virtual void expect_energies(bool) {}
  virtual void add_energies(const Trial&, std::vector<Energy>&) const {}
  // J, done from outside in the step from the committed to the trial configuration, beside what loads and
  // supports do.
  virtual double step_work() const { return 0; }

  // --- steps
  // Does limit() ever say less than 1?
  virtual bool limits() const { return false; }
  // The share of a step that is safe to take, 0 to 1, from the trial configuration along delta, m, 3 per
  // node. 0: none is, the step has to be cut.
  virtual double limit(const Trial&, std::span<const double> /*delta*/) { return 1; }
  // s, the largest stable step of central differences; rotary inertia scaled or as it is.
  virtual double stable_step(bool /*scaled*/) const { return std::numeric_limits<double>::infinity(); }

  // --- state
  virtual void aim(double /*time*/) {}  // the time of the next forces
  virtual void commit() {}
  virtual void rollback() {}
  virtual void keep(Archive&) {}  // the committed state
};

}  // namespace fabricsh::mechanics
