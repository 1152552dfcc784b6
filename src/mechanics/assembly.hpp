// A model compiled: its configuration, its degrees of freedom and the sum of its terms. Gives forces and
// tangents for the trial configuration, the same bits for any number of threads.
//
// An explicit step: begin_iterate(), retract(), aim(time), forces(), residual(), commit(time). No matrix and
// no pattern is made unless a tangent is asked for.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "linear/matrix.hpp"
#include "mechanics/dofs.hpp"
#include "mechanics/stiffness.hpp"
#include "mechanics/term.hpp"
#include "mechanics/terms/cloth.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

// What does work on the cloth from outside, 3 per node, global.
struct WorkingForces {
  std::vector<double> on_x;  // N
  std::vector<double> on_d;  // N m, on directors; empty where no load and no moving support acts on them
};

class Assembly {
 public:
  // Errors: a degenerate element (named); warp without a direction.
  explicit Assembly(const model::Model& model);
  ~Assembly();

  Index unknowns() const { return dofs_.unknowns(); }
  Dofs& dofs() { return dofs_; }
  const Dofs& dofs() const { return dofs_; }
  const Freedoms& freedoms() const { return dofs_.freedoms(); }
  const Cloth& cloth() const { return *cloth_; }
  const std::vector<Vec3>& reference() const { return dofs_.reference(); }
  Configuration& state() { return configuration_; }
  const Configuration& state() const { return configuration_; }
  const std::vector<std::unique_ptr<Term>>& terms() const { return terms_; }

  // --- configurations: see Dofs
  void begin_iterate() { dofs_.begin_iterate(); }
  void retract(std::span<const double> delta, double scale, std::span<const double> targets) {
    dofs_.retract(delta, scale, targets);
  }
  std::vector<double> targets(double time) const { return dofs_.targets(time); }
  void commit(double time);
  void rollback();
  void aim(double time);  // of the next forces and tangents, whose loads are taken then

  // --- at the trial configuration. False: some term failed (see failed_element).
  bool forces(const fabric::Step& step);  // internal forces, trial states
  // Tangent into K, which takes the pattern. With `lead` (increments of the driven freedoms) also the product
  // of the coupling block with them, one number per unknown, into `product`.
  bool tangent(const fabric::Step& step, linear::Matrix& K, std::span<const double> lead,
               std::span<double> product);
  // K_M, the law's part of the tangent at the trial configuration [williams2010, eq. 5.71]; forces stay as
  // they are. lead, product: as tangent().
  bool material_tangent(linear::Matrix& K, std::span<const double> lead, std::span<double> product);
  Index failed_element() const { return failed_element_; }
  // c_x on the diagonal of the nodes' displacements, c_d on that of their rotations, through ties.
  void add_diagonal(std::span<const double> c_x, std::span<const double> c_d, linear::Matrix& K);
  const std::shared_ptr<const linear::Pattern>& pattern();  // made when first asked for
  bool symmetric() const;                                   // is every term's tangent symmetric

  // Dead loads at a time, 3 per node, N, global.
  void external(double time, std::vector<double>& out) const;
  // Loads that follow the configuration, at a time, at the trial configuration, 3 per node, N, global.
  void follower(double time, std::vector<double>& on_x) const;
  bool constant_loads() const;  // dead loads: the same at all times
  bool symmetric_loads() const;
  // r = f_ext - f_int on the unknowns, along the nodes' frames. on_d: N m, further forces on directors.
  void residual(std::span<const double> external, std::span<double> r,
                std::span<const double> on_d = {}) const {
    dofs_.residual(external, force_x_, force_d_, on_d, moments_, r);
  }
  std::span<const double> internal_on_x() const { return force_x_; }  // 3 per node, N, global
  std::span<const double> internal_on_d() const { return force_d_; }  // 3 per node, N m
  std::pair<double, Index> largest_residual(std::span<const double> r) const {
    return dofs_.largest_residual(r);
  }
  double largest_force() const { return dofs_.largest_force(force_x_, force_d_); }
  double rounding_floor(const linear::Matrix& K) const { return dofs_.rounding_floor(K); }
  // Force of the supports on one node, N, global: internal minus external along the held and driven
  // directions.
  Vec3 support_force(Index node, std::span<const double> external) const {
    return dofs_.support_force(node, force_x_, external);
  }
  // Dead loads, follower loads and the forces of supports that move, at the trial configuration (its forces
  // computed, aimed at its time).
  void working_forces(std::span<const double> dead, WorkingForces& out);
  // Are the working forces the dead loads alone, the same at all times?
  bool constant_work() const;
  // Energies of all terms by name, at the trial configuration.
  std::vector<Energy> energies() const;

  double largest_share() const { return cloth_->largest_share(); }
  Strained most_strained() const { return cloth_->most_strained(); }

  // --- motion
  // kg per unknown displacement, kg m^2 per unknown rotation, lumped. Error: ties whose lumped mass is not
  // positive.
  std::vector<double> lumped_mass(bool scaled) const {
    return dofs_.lump(cloth_->mass(), cloth_->rotary_inertia(scaled));
  }
  const std::vector<double>& rotary_inertia(bool scaled) const { return cloth_->rotary_inertia(scaled); }
  const std::vector<double>& nodal_mass() const { return cloth_->mass(); }  // kg, lumped
  void spread_rates(std::span<const double> rates, std::span<const double> driven, NodalRates& out) const {
    dofs_.spread_rates(rates, driven, out);
  }
  std::vector<double> collect_rates(const NodalRates& nodal) const { return dofs_.collect_rates(nodal); }
  // s: the largest stable step of central differences, the smallest of the terms', for the reference
  // configuration.
  double stable_step(bool scaled) const;
  double smallest_size() const { return cloth_->smallest_size(); }
  double largest_stretch() const { return cloth_->largest_stretch(); }

  // --- reading a state
  using PointVisitor = Cloth::PointVisitor;
  void visit(Index element, const PointVisitor& f) const { cloth_->visit(element, f); }
  std::pair<Vec3, Vec3> yarns(Index element) const { return cloth_->yarns(element); }
  Vec3 centre(Index element) const { return cloth_->centre(element); }
  Index inverted_element() const { return cloth_->inverted_element(); }
  Index elements() const { return cloth_->elements(); }
  bool turns(Index unknown) const { return dofs_.turns(unknown); }
  Index node_of_unknown(Index unknown) const { return dofs_.node_of(unknown); }
  Index element_of_unknown(Index unknown) const { return cloth_->element_at(dofs_.node_of(unknown)); }

  // The committed state and its internal forces. Error when reading: of another model.
  void keep(Archive& archive);

 private:
  template <class T, class... Arguments>
  T* add(Arguments&&... arguments);
  Trial trial() const { return {configuration_, dofs_.reference(), aimed_}; }
  Forces sums() { return {force_x_, force_d_}; }
  Outcome add_rest(const fabric::Step& step, Forces& forces);
  void need_stiffness();

  const model::Model& model_;
  Configuration configuration_;
  Dofs dofs_;
  std::vector<std::unique_ptr<Term>> terms_;  // the cloth first
  Cloth* cloth_ = nullptr;
  const std::vector<Vec3>* moments_ = nullptr;  // of the term that has them
  std::unique_ptr<Stiffness> stiffness_;
  std::vector<double> force_x_, force_d_;  // internal, 3 per node
  double aimed_ = 0;                       // s
  Index failed_element_ = -1;
};

}  // namespace fabricsh::mechanics
