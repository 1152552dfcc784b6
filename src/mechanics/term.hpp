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

#include "base/archive.hpp"
#include "fabric/law.hpp"
#include "mechanics/configuration.hpp"
#include "tensor/vec.hpp"

namespace fabricsh::mechanics {

using Index = std::int64_t;

// Velocities or accelerations of all nodes, 3 per node, global.
struct NodalRates {
  std::vector<double> x;  // m/s or m/s^2
  std::vector<double> d;  // 1/s or 1/s^2, tangent to the sphere of directors
};

// What a term sees: the trial configuration at the time that the step ends.
struct Trial {
  const Configuration& configuration;
  const std::vector<Vec3>& X;  // reference positions, m
  double time = 0;             // s, that loads are taken at
  // Motion at the trial configuration, and how it changes with the positions there (Newmark: gamma / (beta
  // dt) and 1 / (beta dt^2)). Null in statics and where forces that hang on motion are counted elsewhere.
  const NodalRates* velocity = nullptr;
  const NodalRates* acceleration = nullptr;
  double velocity_by_position = 0;      // 1/s
  double acceleration_by_position = 0;  // 1/s^2
};

// What energies are to the ledger.
enum class Account {
  stored,      // a function of the state, given back
  dissipated,  // a function of the state, lost
  created      // made by a law that is not dissipative
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
};

// Forces on nodes, 3 per node, global. Internal ones count against the residual: r = external - internal.
struct Forces {
  std::span<double> on_x;  // N, internal
  std::span<double> on_d;  // N m, internal, on directors
};

// An element that cannot be evaluated, -1: none.
struct Outcome {
  Index failed_element = -1;
  bool ok() const { return failed_element < 0; }
};

class Term {
 public:
  virtual ~Term() = default;
  virtual const char* name() const = 0;  // of its section in a checkpoint, and in messages

  // --- forces
  // Adds the internal forces. What comes first (`starts`) may set instead of add, and must set all.
  virtual Outcome add_forces(const fabric::Step&, const Trial&, Forces&) { return {}; }
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
  // Pairs of nodes, beyond those of the elements, that the tangent couples.
  virtual void couple(std::vector<std::pair<Index, Index>>&) const {}

  // --- energies, at the trial configuration
  virtual void add_energies(const Trial&, std::vector<Energy>&) const {}

  // --- steps
  // The share of a step from the iterate along delta (m, 3 per node) that is safe to take, 0 to 1.
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
