// The loads of a model, one term each: gravity, forces and tractions (dead), pressure and moments (which
// follow the configuration), springs to ground.
#pragma once
#include <vector>

#include "mechanics/facets.hpp"
#include "mechanics/freedoms.hpp"
#include "mechanics/mesh_tools.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

// Weight on the nodes; also on their directors if the reference surface is not the middle surface.
class Gravity final : public Term, public FollowerLoad {
 public:
  // mass: kg per node; mass_moment: its first moment about the reference surface, kg m.
  Gravity(const model::Model& model, const std::vector<double>& mass, const std::vector<double>& mass_moment);
  const char* name() const override { return "gravity"; }
  void set_time(double time) override { at_trial_time_ = at(time); }
  void add_dead(double time, std::span<double> on_x) const override;
  bool constant() const override;
  bool follows_directors() const override { return turns_; }
  void add_follower(double time, const Trial&, std::span<double> on_x, std::span<double> on_d) const override;
  Outcome add_forces(const law::Step&, const Trial&, Forces& forces) override;
  void add_tangent(const Trial& trial, TangentSink& sink) const override;

 private:
  Vec3 at(double time) const;
  model::Components acceleration_;
  const std::vector<double>&mass_, &mass_moment_;
  bool turns_ = false;  // whether it acts on directors
  Vec3 at_trial_time_ = Vec3::Zero();
};

// A vector history distributed over the nodes of a set.
struct DistributedLoad {
  mesh::NodeSet nodes;
  std::vector<double> weight;
  model::Components value;
  Mat3 frame;
  Vec3 at(double time) const;
};

// Forces and tractions with constant direction, per reference area. Error: a traction on a set that has
// neither whole elements nor whole edges.
class DeadLoads final : public Term {
 public:
  explicit DeadLoads(const model::Model& model);
  const char* name() const override { return "forces"; }
  void add_dead(double time, std::span<double> on_x) const override;
  bool constant() const override;

 private:
  std::vector<DistributedLoad> loads_;
};

// Pressure along the normal of the present surface: f_A = p sum_g N_A a1 x a2. It has a potential, p times
// the volume that the surface sweeps, and a symmetric stiffness, where its edges stay or move in planes.
class Pressure final : public Term, public FollowerLoad {
 public:
  Pressure(const model::Model& model, const Freedoms& freedoms);
  const char* name() const override { return "pressure"; }
  void set_time(double time) override;
  bool follows_positions() const override { return true; }
  void add_follower(double time, const Trial&, std::span<double> on_x, std::span<double> on_d) const override;
  bool symmetric() const override { return edges_are_held_; }
  Outcome add_forces(const law::Step&, const Trial& trial, Forces& forces) override;
  void add_tangent(const Trial& trial, TangentSink& sink) const override;

 private:
  struct Faces {
    std::vector<std::array<Index, 4>> elements;
    model::History value;
  };
  std::vector<Faces> faces_;
  std::vector<double> at_trial_time_;  // Pa
  bool edges_are_held_ = false;
};

// Moments about axes fixed in space: the work M . (d x delta d) gives M x d on a director. Not symmetric.
class Moments final : public Term, public FollowerLoad {
 public:
  explicit Moments(const model::Model& model);
  const char* name() const override { return "moments"; }
  void set_time(double time) override;
  bool follows_directors() const override { return true; }
  void add_follower(double time, const Trial&, std::span<double> on_x, std::span<double> on_d) const override;
  bool symmetric() const override { return false; }
  const std::vector<Vec3>* moments() const override { return &at_trial_time_; }
  Outcome add_forces(const law::Step&, const Trial& trial, Forces& forces) override;
  void add_tangent(const Trial& trial, TangentSink& sink) const override;

 private:
  std::vector<Vec3> at_time(double time) const;
  std::vector<DistributedLoad> loads_;
  std::vector<Vec3> at_trial_time_;  // N m per node
};

// Linear springs to ground.
class Springs final : public Term {
 public:
  explicit Springs(const model::Model& model);
  const char* name() const override { return "springs"; }
  Outcome add_forces(const law::Step&, const Trial& trial, Forces& forces) override;
  void add_tangent(const Trial& trial, TangentSink& sink) const override;
  void add_energies(const Trial& trial, std::vector<Energy>& out) const override;

 private:
  struct Grounded {
    Index node;
    Mat3 stiffness;
  };
  std::vector<Grounded> springs_;
};

}  // namespace fabricsh::mechanics
