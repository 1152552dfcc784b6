// The loads of a model, compiled: dead ones, follower ones with their stiffness, springs to ground.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "model/model.hpp"

namespace fabricsh::assembly {

using Index = std::int64_t;

// What a set's nodes carry of something spread over it: by area where the set holds whole elements (m^2),
// else by length where it holds whole element edges (m), else by count.
struct Tributary {
  enum class Kind { area, length, count };
  Kind kind = Kind::count;
  std::vector<double> measure;  // per node of the set
  double total = 0;
};
Tributary tributary(const mesh::Mesh& mesh, const mesh::NodeSet& nodes);

// Unit normals at the nodes: the mean of the elements' corner normals, weighted by area.
std::vector<Vec3> reference_directors(const mesh::Mesh& mesh);

class Loads {
 public:
  // mass: kg per node; mass_moment: kg m, first moment about the reference surface (zero on a middle
  // surface). Error: a traction on a set that holds neither whole elements nor whole edges.
  Loads(const model::Model& model, const std::vector<double>& mass, const std::vector<double>& mass_moment);

  void aim(double time);  // evaluates the histories of the follower loads
  bool symmetric() const { return pressures_.empty() && moments_.empty(); }
  double aimed() const { return aimed_; }
  // Aimed moment on a node, N m, about axes fixed in space; null without moments.
  const Vec3* moment_on(Index node) const { return aimed_moment_.empty() ? nullptr : &aimed_moment_[node]; }
  // Dead forces on x: gravity, forces, tractions. 3 per node, N, global.
  void dead(double time, std::vector<double>& out) const;
  bool constant() const;  // are the dead loads the same at all times
  bool pushes() const { return !pressures_.empty(); }
  bool on_directors() const;  // can loads act on directors
  // Adds the loads on directors at the aimed time, N m.
  void add_director_loads(std::span<const double> d, std::span<double> out) const;
  // out += scale * follower forces on x (pressure) at a time.
  void add_follower(double time, std::span<const double> x, std::span<double> out, double scale) const;
  // Counts follower loads and springs against the internal forces on x and d, at the aimed time.
  void add_to_internal(std::span<const double> x, std::span<const double> d, const std::vector<Vec3>& X,
                       std::span<double> force_x, std::span<double> force_d) const;
  // Stiffness of what add_to_internal adds: `on_x(A, B, 3x3)` on displacements, `on_q(A, 2x2)` on a node's
  // rotations (q1 along b1, q2 along b2 = d x b1).
  using OnX = std::function<void(Index, Index, const Mat3&)>;
  using OnQ = std::function<void(Index, const Eigen::Matrix2d&)>;
  void add_stiffness(std::span<const double> x, std::span<const double> d, std::span<const double> b1,
                     const OnX& on_x, const OnQ& on_q) const;
  double spring_energy(std::span<const double> x, const std::vector<Vec3>& X) const;

 private:
  struct Spread {  // a vector history shared by the nodes of a set
    mesh::NodeSet nodes;
    std::vector<double> share;
    model::Components value;
    Mat3 frame;
    Vec3 at(double time) const;
  };
  struct Faces {
    std::vector<std::array<Index, 4>> elements;
    model::History value;
  };
  struct Grounded {
    Index node;
    Mat3 stiffness;
  };
  Vec3 director_load(std::size_t node, const Vec3& d) const;

  std::vector<Spread> dead_, moments_;
  std::vector<Faces> pressures_;
  std::vector<Grounded> springs_;
  std::vector<double> mass_, mass_moment_;
  model::Components gravity_;
  Vec3 gravity_at(double time) const;
  double aimed_ = 0;
  std::vector<double> aimed_pressure_;
  Vec3 aimed_gravity_ = Vec3::Zero();
  std::vector<Vec3> aimed_moment_;  // per node, N m; empty without moments
};

}  // namespace fabricsh::assembly
