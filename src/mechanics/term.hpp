// A term makes force: cloth, gravity, loads, springs, damping, inertia and contact are terms. The assembly is
// their sum, and nothing else adds force, energy or stiffness. A term provides its forces, tangent, energies
// by name, the pairs of nodes that it couples, its part of a checkpoint, the largest stable step, and the
// fields that it shows. Further abilities of few terms are facets (mechanics/facets.hpp).
#pragma once
#include <cstdint>
#include <functional>
#include <limits>
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
#include "mechanics/step_work.hpp"

namespace fabricsh::mechanics {

using Index = std::int64_t;

// The data that a term reads: the trial configuration and the time at the end of the step.
struct Trial {
  const Configuration& configuration;
  const std::vector<Vec3>& X;      // reference positions, m
  double time = 0;                 // s, time of the loads
  const Motion* motion = nullptr;  // of the present step; null outside a run
};

// The kind of an energy in the ledger.
enum class Account {
  stored,      // a function of the state, recoverable
  moving,      // kinetic energy besides that of the cloth
  dissipated,  // a function of the state, not recoverable
  created,     // created by a law that is not dissipative
  kinetic,     // of the motion, without the driven displacements
  damping      // lost so far to forces that depend on the motion
};
struct Energy {
  std::string name;  // "membrane", "warp", "springs", ...
  Account account;
  double value = 0;  // J
};

// Receives stiffness by nodes. The implementation handles frames, supports and ties.
class TangentSink {
 public:
  virtual ~TangentSink() = default;
  // d(internal force on x_a) / d(x_b), N/m, global.
  virtual void on_positions(Index a, Index b, const Mat3& k) = 0;
  // The same with the part of it that is not symmetric, which a matrix may keep apart (linear::Matrix).
  virtual void on_positions_apart(Index a, Index b, const Mat3& k, const Mat3& /*apart*/) {
    on_positions(a, b, k);
  }
  // On the two rotations of a node's director (q1 along b1, q2 along d x b1), N m.
  virtual void on_director(Index a, const Eigen::Matrix2d& k) = 0;
  // d(internal force on x_a and the rotations of a) / d(those of b): N/m, N and N m, positions global.
  virtual void on_nodes(Index a, Index b, const Eigen::Matrix<double, 5, 5>& k) = 0;
  // Change of the internal force on x_a, N, global, when everything that the step moves besides the supports
  // goes to its final position.
  virtual void on_lead(Index a, const Vec3& force) = 0;
};

// Forces on nodes; 3 per node, global. Internal forces count negative: r = external - internal.
struct Forces {
  std::span<double> on_x;  // N, internal
  std::span<double> on_d;  // N m, internal, on directors
};

// The outcome of computing a term's forces. After a failure: an element to be named (-1: none), and the
// reason in words that can end a sentence ("the law failed"), reported when a run ends.
struct Outcome {
  Answer answer = Answer::ok;
  Index element = -1;
  std::string why = {};
  bool ok() const { return answer == Answer::ok; }
};

// The factors of a term that is a multiple of the mass: its forces on a node are m (acceleration * a +
// velocity * v), where m is the mass or rotary inertia, a the acceleration and v the velocity.
struct MassFactors {
  double acceleration = 0;  // 1 for inertia
  double velocity = 0;      // 1/s
};

// A number that a term shows of the present state for each node, or for each element. Runs offer it like a
// field of their own, in VTK files, tables and by name.
struct TermField {
  std::string name, unit, sentence;
  bool of_elements = false;
  std::function<double(Index)> value;
};

// Two nodes whose degrees of freedom are coupled in a tangent.
using NodePair = std::pair<Index, Index>;

// An ability of a term or a part of it beyond forces, tangent and energies: see mechanics/facets.hpp.
class Facet {
 public:
  virtual ~Facet() = default;
};

class Term {
 public:
  virtual ~Term() = default;
  virtual const char* name() const = 0;  // of its section in a checkpoint, and in messages
  // The parts of a term that have a facet each in its place.
  virtual std::vector<Facet*> parts() { return {}; }

  // --- forces
  virtual Outcome add_forces(const law::Step&, const Trial&, Forces&) { return {}; }  // the internal ones
  // Adds forces that depend on time only, N, 3 per node. Constant: the same at all times.
  virtual void add_dead(double /*time*/, std::span<double> /*on_x*/) const {}
  virtual bool constant() const { return true; }

  // --- tangent
  virtual void add_tangent(const Trial&, TangentSink&) const {}
  virtual bool symmetric() const { return true; }
  virtual bool symmetric_but_apart() const { return symmetric(); }  // but for what the sink may keep apart
  // Adds the pairs of nodes that the tangent at the trial configuration couples, in addition to those of the
  // elements. Called before each tangent; the pairs may differ each time. If the pattern lacks a pair, a new
  // one is made from the pairs of that moment, and the solver must analyse it. A term whose pairs come and go
  // should therefore also name pairs that may couple soon.
  virtual void couple(const Trial&, std::vector<NodePair>&) {}

  // --- energies, at the trial configuration
  // Tells whether the energies will be needed after the next forces. A term may then sum them together with
  // the forces; add_energies() gives the same numbers in either case.
  virtual void expect_energies(bool) {}
  virtual void add_energies(const Trial&, std::vector<Energy>&) const {}
  // External work in the step from the committed to the trial configuration, besides that of loads and
  // supports.
  virtual StepWork step_work() const { return {}; }

  // s, the largest stable step of central differences, with true or scaled rotary inertia.
  virtual double stable_step(bool /*scaled*/) const { return std::numeric_limits<double>::infinity(); }

  // --- joints. Called after joints have opened or closed, or a state with other joints is about to be read:
  // the unknowns are numbered anew, and what a term has of single unknowns is to be made again. The forces
  // are those of the committed state; those of a term that acts on the leaders of joints go to the new ones.
  virtual void renumbered(Forces&) {}

  // --- fields. The functions are called as long as the term exists.
  virtual std::vector<TermField> shows() const { return {}; }

  // --- state
  virtual void set_time(double /*time*/) {}  // sets the time of the next forces
  virtual void commit() {}
  virtual void rollback() {}
  virtual void keep(Archive&) {}  // the committed state
};

}  // namespace fabricsh::mechanics
