// A compiled model: its configuration, its degrees of freedom and its terms. It computes forces and tangents
// for the trial configuration, equal bit for bit for any number of threads. No matrix or pattern
// is made unless a tangent is computed.
//
// An explicit step: begin_iterate(), apply_increment(), set_time(time), forces(), residual(), commit(time).
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "linear/matrix.hpp"
#include "mechanics/dofs.hpp"
#include "mechanics/term_list.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

class Cloth;

class Assembly {
 public:
  // Errors: a degenerate element (named); a warp direction that is not defined.
  explicit Assembly(const model::Model& model);

  const Dofs& dofs() const { return dofs_; }
  const Cloth& cloth() const;
  Configuration& state() { return configuration_; }
  const Configuration& state() const { return configuration_; }
  TermList& terms() { return terms_; }
  const TermList& terms() const { return terms_; }

  // For runs whose tangents are symmetric and go to a solver of symmetric matrices alone: they keep the upper
  // triangle. To be called before the first tangent.
  void keep_upper() { upper_ = true; }
  // For runs whose solver knows of entries that a matrix keeps apart.
  void keep_apart() { apart_ = true; }

  // --- configurations: see Dofs
  void begin_iterate();
  void save_iterate();     // the trial configuration
  void restore_iterate();  // trial = the one saved last; bodies stay if that is safe
  // share: of the ways of what terms move themselves, where that is not `scale`, as in a step that does not
  // iterate: there the unknowns move by their rates times the time.
  void apply_increment(std::span<const double> delta, double scale, std::span<const double> targets,
                       std::optional<double> share = {});
  void commit(double time);
  void rollback();
  void set_time(double time);  // sets the time of the loads for the next forces and tangents

  // The solver's direction, delta = K^-1 r at the trial configuration, with what terms solve for beside it
  // (OwnUnknowns), which moves by the same fractions. solve: K x = b; weight: of the forces' tangent in K.
  // False: no solution.
  using Solve = std::function<bool(std::span<const double> b, std::span<double> x)>;
  bool finish_direction(const Solve& solve, double weight, std::span<double> delta);
  // At rest: the stiffness of the terms' own unknowns, the nodes following them, over some that is positive:
  // it has as many negative eigenvalues. Empty: there are none of which an energy decides, or no solution.
  Eigen::MatrixXd own_stiffness(const Solve& solve);
  // From the iterate, which is the trial configuration: the share, 0 to 1, of `way` times a step along delta,
  // with the supports at their targets, that all terms consider safe. If one of them limits steps, the trial
  // configuration is left somewhere along it.
  double limit(std::span<const double> delta, std::span<const double> targets, double way = 1);
  bool limits() const;  // whether any does
  // The same for a part of that way, which leaves it where terms move other than by its share. Leaves the
  // trial configuration there.
  bool is_safe(std::span<const double> delta, double part, std::span<const double> targets);
  bool parts_leave_way() const;

  // --- at the trial configuration. False: a term failed (see outcome).
  bool forces(const law::Step& step);  // internal forces and trial states
  // Computes the tangent K, which takes over the pattern. `lead` has the increments of the driven degrees of
  // freedom; `product` receives the product of their coupling block with these, one number per unknown.
  // extrapolated: for the stresses of the strains that the step from the iterate predicts linearly. The
  // internal forces are then of these stresses, until they are computed again.
  bool tangent(const law::Step& step, linear::Matrix& K, std::span<const double> lead,
               std::span<double> product, bool extrapolated = false);
  // K_M, the law's part of the tangent at the trial configuration [williams2010, eq. 5.71]; in motion that of
  // the committed one, turned with each element from there. lead and product as for tangent(), read as for
  // Stiffness::Target.
  bool material_tangent(linear::Matrix& K, std::span<const double> lead, std::span<double> product,
                        const Stiffness::Reader* read = nullptr);
  const Outcome& outcome() const {
    return outcome_;
  }  // of the last forces or tangent: the worst of all terms
  // Adds c_x to the diagonal of the nodes' displacements and c_d to that of their rotations, through ties.
  void add_diagonal(std::span<const double> c_x, std::span<const double> c_d, linear::Matrix& K);
  // Created at the first call, and again when terms couple nodes that it does not contain (see Term::couple).
  // A rollback restores the pairs of the last commit.
  const std::shared_ptr<const linear::Pattern>& pattern();

  // The present state, as the terms read it.
  Trial trial() const { return {configuration_, dofs_.reference(), trial_time_, motion_}; }
  // r = f_ext - f_int on the unknowns, in the nodes' frames, less what depends on the motion, if there is one
  // (OnMotion). on_d: additional forces on directors, N m.
  void residual(std::span<const double> external, std::span<double> r, std::span<const double> on_d = {});
  // Of the forces alone: internal, 3 per node, global: N on positions, N m on directors.
  struct InternalForces {
    std::span<const double> on_x, on_d;
  };
  InternalForces internal() const { return {force_x_, force_d_}; }
  // N: the largest residual of the unknowns, and which one has it; or that of a term's own unknowns (-1).
  std::pair<double, Index> largest_residual(std::span<const double> r) const;
  double largest_force() const { return dofs_.largest_force(force_x_, force_d_); }
  // Energies of all terms by name, at the trial configuration.
  std::vector<Energy> energies() const;

  // --- motion
  // Sets the motion of a run's steps, by reference; null: none. The run adds the terms that depend on it.
  void set_motion(const Motion* motion) { motion_ = motion; }
  bool begin_step();                                    // see OnMotion; false: a term failed (see outcome)
  void finish_step() { terms_.finish_step(*motion_); }  // before commit()
  // Lumped masses: kg per unknown displacement, kg m^2 per unknown rotation. Error: ties that have no
  // positive lumped mass.
  std::vector<double> lumped_mass(bool scaled) const {
    return dofs_.lump(terms_.elements().mass(), terms_.elements().rotary_inertia(scaled));
  }

  // --- joints (see Dofs). To be called at the committed state. Empty: nothing changes.
  std::optional<Transfer> open(std::vector<Joints::Edge> edges, double within);
  std::optional<Transfer> sew(Sewn next, double within);
  // J, kinetic energy lost as joints closed.
  void lose(double energy) { lost_ += energy; }

  // The committed state and its internal forces. Returns whether reading has numbered the unknowns anew.
  // Error when reading: the state of another model.
  bool keep(Archive& archive);
  // Takes the committed state of an assembly of the same cloth, which may have other supports and loads: what
  // is held stays where it is. Terms of the same name take over what they keep; contact does if that is the
  // same, and else begins anew. The forces are those of the present loads. Error: the law fails.
  void begin_from(const Assembly& other, bool same_contact);

 private:
  template <class T, class... Arguments>
  T& make(Arguments&&... arguments);
  Forces sums() { return {force_x_, force_d_}; }
  bool take(Outcome outcome);  // stores the outcome; returns whether it is ok
  bool all_safe();             // whether the way since the limiters' marks is
  void add_ranks(const FewRankTerm& term, linear::Matrix& K, std::span<const double> lead,
                 std::span<double> product);
  void couple();
  void couple(std::vector<NodePair> pairs);
  void renumbered();
  bool keep_joints(Archive& archive);
  bool keep_seams(Archive& archive);
  void balance(const char* call);

  Configuration configuration_;
  Dofs dofs_;
  TermList terms_;
  bool upper_ = false, apart_ = false;
  std::unique_ptr<Stiffness> stiffness_;
  linear::Matrix kept_apart_;                          // room for the entries that a tangent keeps apart
  std::vector<NodePair> coupled_, committed_coupled_;  // pairs in the pattern, ascending; at the last commit
  std::vector<double> force_x_, force_d_;              // internal, 3 per node
  std::vector<double> saved_;                          // kinematics of an iterate
  double lost_ = 0;                                    // J, in joints
  double trial_time_ = 0;                              // s
  const Motion* motion_ = nullptr;
  Outcome outcome_;
};

}  // namespace fabricsh::mechanics
