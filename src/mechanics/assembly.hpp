// A compiled model: its configuration, its degrees of freedom and the sum of its terms. It computes forces
// and tangents for the trial configuration, equal bit for bit for any number of threads. No matrix or pattern
// is made unless a tangent is computed.
//
// An explicit step: begin_iterate(), apply_increment(), set_time(time), forces(), residual(), commit(time).
#pragma once
#include <functional>
#include <memory>
#include <optional>
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

class Contacts;
class Directors;
class Seams;
class Tears;

// The external forces that do work on the cloth; 3 per node, global.
struct WorkingForces {
  std::vector<double> on_x;  // N
  std::vector<double> on_d;  // N m, on directors; empty if no load and no moving support acts on them
};

class Assembly {
 public:
  // Errors: a degenerate element (named); a warp direction that is not defined.
  explicit Assembly(const model::Model& model);
  ~Assembly();

  Index unknowns() const { return dofs_.unknowns(); }
  Dofs& dofs() { return dofs_; }
  const Dofs& dofs() const { return dofs_; }
  const Freedoms& freedoms() const { return dofs_.freedoms(); }
  const Cloth& cloth() const { return *cloth_; }
  Contacts* contact() { return contact_; }  // null: the model has no contact
  const Contacts* contact() const { return contact_; }
  Tears* tears() { return tears_; }  // null: no yarns of the model can break
  const Tears* tears() const { return tears_; }
  Seams* seams() { return seams_; }  // null: the model has no seams
  const Seams* seams() const { return seams_; }
  const std::vector<Vec3>& reference() const { return dofs_.reference(); }
  Configuration& state() { return configuration_; }
  const Configuration& state() const { return configuration_; }
  const std::vector<std::unique_ptr<Term>>& terms() const { return terms_; }
  // Adds and returns a further term; to be called before forces are first computed.
  template <class T>
  T& add(std::unique_ptr<T> term) {
    T& made = *term;
    terms_.push_back(std::move(term));
    return made;
  }

  // For runs that compute the forces once in a step: see Cloth. To be called before the first forces.
  void update_in_place() { cloth_->update_in_place(); }
  // For runs whose tangents are symmetric and go to a solver of symmetric matrices alone: they keep the upper
  // triangle. To be called before the first tangent.
  void keep_upper() { upper_ = true; }

  // --- configurations: see Dofs
  void begin_iterate();
  void apply_increment(std::span<const double> delta, double scale, std::span<const double> targets);
  // The whole way of a step that does not iterate: the unknowns move by their rates times the time, s.
  void advance_explicit(std::span<const double> rates, double time, std::span<const double> targets);
  // Whether everything that the step moves besides the supports has reached its final position.
  bool at_target() const;
  std::vector<double> targets(double time) const { return dofs_.targets(time); }
  void commit(double time);
  void rollback();
  void set_time(double time);  // sets the time of the loads for the next forces and tangents

  // The solver's direction, delta = K^-1 r at the trial configuration, with what free bodies do beside it,
  // which move by the same fractions. solve: K x = b; weight: of the forces' tangent in K. False: no
  // solution.
  using Solve = std::function<bool(std::span<const double> b, std::span<double> x)>;
  bool finish_direction(const Solve& solve, double weight, std::span<double> delta);
  double largest_body_residual() const;  // N, of free bodies: as largest_residual()
  // The fraction, 0 to 1, of a step from the iterate along delta, with the supports at their targets, that
  // all terms consider safe. The trial configuration is left somewhere along the step. limit_of_terms omits
  // contact, since explicit steps have their own check for contact.
  double limit(std::span<const double> delta, std::span<const double> targets);
  double limit_of_terms(std::span<const double> delta, std::span<const double> targets);
  bool limits() const;  // whether a term can ask for less than a whole step

  // --- at the trial configuration. False: a term failed (see outcome).
  bool forces(const law::Step& step);  // internal forces and trial states
  // Computes the tangent K, which takes over the pattern. `lead` has the increments of the driven degrees of
  // freedom; `product` receives the product of their coupling block with these, one number per unknown.
  // extrapolated: for the stresses of the strains that the step from the iterate predicts linearly. The
  // internal forces are then of these stresses, until they are computed again.
  bool tangent(const law::Step& step, linear::Matrix& K, std::span<const double> lead,
               std::span<double> product, bool extrapolated = false);
  // K_M, the law's part of the tangent at the trial configuration [williams2010, eq. 5.71]. The forces are
  // not changed. lead and product as for tangent().
  bool material_tangent(linear::Matrix& K, std::span<const double> lead, std::span<double> product);
  const Outcome& outcome() const {
    return outcome_;
  }  // of the last forces or tangent: the worst of all terms
  // Adds c_x to the diagonal of the nodes' displacements and c_d to that of their rotations, through ties.
  void add_diagonal(std::span<const double> c_x, std::span<const double> c_d, linear::Matrix& K);
  // Created at the first call, and again when terms couple nodes that it does not contain (see Term::couple).
  // A rollback restores the pairs of the last commit.
  const std::shared_ptr<const linear::Pattern>& pattern();
  bool symmetric() const;  // whether the tangents of all terms are symmetric

  // What the terms read of the present.
  Trial trial() const { return {configuration_, dofs_.reference(), trial_time_, motion_}; }
  // Dead loads at the given time, 3 per node, N, global.
  void external(double time, std::vector<double>& out) const;
  // Loads that follow the configuration, at a time and the trial configuration, 3 per node, N, global.
  void follower(double time, std::vector<double>& on_x) const;
  bool constant_loads() const;  // whether the dead loads are constant in time
  bool symmetric_loads() const;
  bool is_rate_dependent() const { return cloth_->is_rate_dependent(); }  // whether stresses change at rest
  // r = f_ext - f_int on the unknowns, in the nodes' frames. on_d: additional forces on directors, N m.
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
  // The force of the supports on one node, N, global: internal minus external along the held and driven
  // directions.
  Vec3 support_force(Index node, std::span<const double> external) const {
    return dofs_.support_force(node, force_x_, external);
  }
  // Dead loads, follower loads and the forces of moving supports at the trial configuration, whose forces
  // must have been computed after set_time() at its time.
  void working_forces(std::span<const double> dead, WorkingForces& out);
  // Whether the working forces are only dead loads that are constant in time.
  bool constant_work() const;
  void expect_energies(bool expected);  // see Term
  // J, external work in the step that is done neither by loads nor by supports.
  double step_work() const;
  // Energies of all terms by name, at the trial configuration.
  std::vector<Energy> energies() const;

  double largest_strain_ratio() const { return cloth_->largest_strain_ratio(); }
  Strained most_strained() const { return cloth_->most_strained(); }
  double strain_ratio(Index element) const { return cloth_->strain_ratio(element); }

  // --- motion
  // Sets the motion of a run's steps, by reference; null: none. The run adds the terms that depend on it.
  void set_motion(const Motion* motion) { motion_ = motion; }
  OnMass on_mass() const;                  // the sum over the terms
  bool begin_step();                       // see Term; false: a term failed (see outcome)
  void resist(std::span<double> r);        // see Term
  void add_resistance(linear::Matrix& K);  // see Term
  void finish_step();                      // before commit()
  // Lumped masses: kg per unknown displacement, kg m^2 per unknown rotation. Error: ties that have no
  // positive lumped mass.
  std::vector<double> lumped_mass(bool scaled) const {
    return dofs_.lump(cloth_->mass(), cloth_->rotary_inertia(scaled));
  }
  const std::vector<double>& rotary_inertia(bool scaled) const { return cloth_->rotary_inertia(scaled); }
  const std::vector<double>& nodal_mass() const { return cloth_->mass(); }  // kg, lumped
  void spread_rates(std::span<const double> rates, std::span<const double> driven, NodalRates& out) const {
    dofs_.spread_rates(rates, driven, out);
  }
  std::vector<double> collect_rates(const NodalRates& nodal) const { return dofs_.collect_rates(nodal); }
  // s: the largest stable step of central differences for the reference configuration, the smallest over the
  // terms.
  double stable_step(bool scaled) const;
  double smallest_size() const { return cloth_->smallest_size(); }
  double largest_turn(const NodalRates& way) const { return cloth_->largest_turn(way); }
  double largest_stretch() const { return cloth_->largest_stretch(); }

  // --- reading of the state
  using PointVisitor = Cloth::PointVisitor;
  void visit(Index element, const PointVisitor& f) const { cloth_->visit(element, f); }
  std::pair<Vec3, Vec3> yarns(Index element, int ply = Cloth::all_plies) const {
    return cloth_->yarns(element, ply);
  }
  Vec3 centre(Index element) const { return cloth_->centre(element); }
  // The first element whose directors are on the wrong side of it at one of its points; -1: none.
  Index inverted_element() const { return cloth_->inverted_element({}); }
  // The two separately: the first element that is turned inside out, and the first node whose director is
  // turned over, more than 90 degrees from the normal of sound elements. -1: none.
  struct OverturnedParts {
    Index inverted = -1, turned = -1;
  };
  OverturnedParts shape() const;
  Index elements() const { return cloth_->elements(); }
  bool turns(Index unknown) const { return dofs_.turns(unknown); }
  Index node_of_unknown(Index unknown) const { return dofs_.node_of(unknown); }
  Index element_of_unknown(Index unknown) const { return cloth_->element_at(dofs_.node_of(unknown)); }

  // --- joints (see Dofs). To be called at the committed state. Empty: nothing changes.
  const Joints& joints() const { return dofs_.joints(); }
  std::optional<Transfer> open(std::vector<Joints::Edge> edges, double within);
  std::optional<Transfer> sew(Sewn next, double within);
  // J, kinetic energy lost as joints closed.
  void lose(double energy) { lost_ += energy; }
  // Changes whenever the unknowns are numbered anew.
  std::uint64_t numbering() const { return numbering_; }

  // The committed state and its internal forces. Error when reading: the state of another model.
  void keep(Archive& archive);

 private:
  template <class T, class... Arguments>
  T* make(Arguments&&... arguments);
  Forces sums() { return {force_x_, force_d_}; }
  bool take(Outcome outcome);  // stores the outcome; returns whether it is ok
  Outcome with_rest(Outcome cloth, const law::Step& step, Forces& forces);
  void couple();
  void couple(std::vector<NodePair> pairs);
  void renumbered();
  void keep_joints(Archive& archive);
  void keep_seams(Archive& archive);
  void balance(const char* call);

  Configuration configuration_;
  Dofs dofs_;
  std::vector<std::unique_ptr<Term>> terms_;  // the cloth is the first
  Cloth* cloth_ = nullptr;
  Directors* directors_ = nullptr;
  Contacts* contact_ = nullptr;
  Tears* tears_ = nullptr;
  Seams* seams_ = nullptr;
  const std::vector<Vec3>* moments_ = nullptr;  // those of the term that has moments
  bool upper_ = false;
  std::unique_ptr<Stiffness> stiffness_;
  std::vector<NodePair> coupled_, committed_coupled_;  // pairs in the pattern, ascending; at the last commit
  std::vector<double> force_x_, force_d_;              // internal, 3 per node
  std::uint64_t numbering_ = 0;
  double lost_ = 0;        // J, in joints
  double trial_time_ = 0;  // s
  const Motion* motion_ = nullptr;
  Outcome outcome_;
};

}  // namespace fabricsh::mechanics
