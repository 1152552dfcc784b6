// Abilities of some terms beyond forces, tangent and energies. A term has a facet by deriving from it beside
// Term, or by a part that does; the assembly finds the facets when the term is added.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "mechanics/stiffness.hpp"
#include "mechanics/term.hpp"

namespace fabricsh::mechanics {

// Made of the elements of the mesh: carries its mass, and writes its tangent into the matrix itself, element
// by element in parallel. Its forces are assigned, not added, so that it is the first term.
class ElementTerm : public Facet {
 public:
  virtual std::span<const Batch> batches() const = 0;
  virtual std::span<const BatchLane> places() const = 0;  // per element
  // Lumped mass per node, kg; and rotary inertia per node, kg m^2, true or scaled.
  virtual const std::vector<double>& mass() const = 0;
  // What scaled inertia makes of the mass, for the step of explicit motion: to be called once, before
  // anything moves. keep: nothing, as where another state is gone on from.
  virtual void scale_mass(bool /*keep*/) {}
  virtual const std::vector<double>& rotary_inertia(bool scaled) const = 0;
  // Computes the elements' tangents and the forces. law_only: only K_M, the law's part [williams2010, eq.
  // 5.71]. before: kinematics before the last step, if tangent and forces are to be those of strains that it
  // predicted linearly [magisano2017]; K_M is then that before, turned with each element from there.
  virtual Outcome scatter_tangents(const law::Step& step, bool law_only, Stiffness& stiffness,
                                   const Stiffness::Target& to, std::span<const double> before) = 0;
  virtual void sum_forces(Forces& forces) const = 0;  // of the last evaluation
};

// Loads that follow the configuration. They are contained in the internal forces, with the opposite sign;
// add_follower() gives them at a given time for computing their work.
class FollowerLoad : public Facet {
 public:
  virtual bool follows_positions() const { return false; }
  virtual bool follows_directors() const { return false; }
  virtual void add_follower(double time, const Trial&, std::span<double> on_x,
                            std::span<double> on_d) const = 0;
  // Moments about axes fixed in space, N m per node. Their part about the director has an effect only on a
  // rigid set. Null: none.
  virtual const std::vector<Vec3>* moments() const { return nullptr; }
};

// Forces that depend on the motion of a step. They are not part of the internal forces. What supports have to
// overcome of them beside what on_mass() says is in on_supports(), and the work of supports that move in
// Term::step_work().
class OnMotion : public Facet {
 public:
  virtual MassFactors on_mass() const { return {}; }
  virtual std::span<const double> on_supports() const { return {}; }  // N, 3 per node, global; empty: none
  // Called at the beginning of a step, when the trial configuration is the committed one.
  virtual Outcome begin_step(const Motion&) { return {}; }
  // Subtracts forces on the unknowns, N and N m, from the residual r; and adds their derivative to K, with
  // the weight that the time scheme gives it. trial.motion is never null.
  virtual void resist(const Trial&, std::span<double> /*r*/) {}
  virtual void add_resistance(const Trial&, linear::Matrix& /*K*/) {}
  // Called before the trial state is committed: adds what the step has done to the term's accounts.
  virtual void finish_step(const Motion&) {}
};

// Forces that an implicit step takes at its end alone, `weight` times, whatever rule the scheme has for
// others [kane1999]: forces that come and go within a step then make no energy.
class AtStepEnd : public Facet {
 public:
  // Of the steps from the next one on, which are implicit; late: the weight that their rule gives to what a
  // rigid body has at the end of a step, its velocity and the forces that do not act at the end alone.
  virtual void set_weight(double weight, double late) = 0;
  virtual bool acts() const = 0;                           // in the trial state
  virtual std::span<const Vec3> nodal_forces() const = 0;  // N
  virtual double work_on_cloth() const = 0;                // J, on the nodes that move freely, in the step
  virtual double lost_by_rule() const { return 0; }        // J, of free bodies in the step, beside work
};

// s: the latest end, up to `to`, of a step from `from` on that is not too long: of one to `end`, parts(end)
// says how many times. It is never shorter than by 2^-60.
template <class Parts>
double latest_end(double from, double to, const Parts& parts) {
  constexpr int tries = 60;
  constexpr double same = 1e-9;  // shares of a limit that are the same
  for (int k = 0; k < tries; ++k) {
    const double share = parts(to);
    if (!(share > 1 + same)) break;
    to = from + (to - from) / std::clamp(std::ceil(share * (1 - same)), 2.0, 1e6);
  }
  return to;
}

// Says how far a step may go. The way from the marked positions to the trial ones is straight for the nodes.
class StepLimiter : public Facet {
 public:
  virtual bool limits() const { return true; }  // whether it can ask for less than a whole step
  virtual void mark(const Trial&) = 0;          // the trial configuration, where a step begins
  // The fraction of the way that can be judged at once; of a longer one only the beginning is looked at.
  virtual double near_share(const Trial&) { return 1; }
  // The fraction, 0 to 1, of the way that is safe. It is asked again at the end of that fraction, and has to
  // answer 1 there. 0: the step must be cut.
  virtual double safe_fraction(const Trial&) = 0;
  // s: the latest end, up to `to`, of a step from the committed state.
  virtual double latest_end(double to) const { return to; }
};

// A part U C U^T of a tangent: columns U, forces on the nodes, 3 per node, for each of a few quantities that
// depend on all of them; and a small matrix C.
struct NodalRanks {
  std::vector<std::vector<double>> on_x;
  Eigen::MatrixXd core;
  // Of each column, the sum of the forces on what moves beside the nodes, each over the root of its mass.
  // Empty: nothing does.
  std::vector<double> beside = {};
};

// Has such a part, which add_tangent() leaves out.
class FewRankTerm : public Facet {
 public:
  virtual void add_ranks(const Trial&, NodalRanks& out) const = 0;  // out is empty
};

// Moves something of its own in a step that iterates: by fractions of prescribed ways, measured from the
// iterate; and by unknowns w beside those of the matrix. All numbers about unknowns are of the last tangent.
class OwnUnknowns : public Facet {
 public:
  virtual void begin_iterate() {}
  virtual void move(double scale) = 0;             // by a fraction of the solver's step
  virtual bool at_target() const { return true; }  // whether prescribed ways are at their ends
  // Whether what it moves by a part of the solver's step does not lie on the straight way to the whole.
  virtual bool parts_leave_way() const { return false; }
  virtual void save() {}     // what move() changes
  virtual void restore() {}  // as saved last
  virtual std::size_t own_unknowns() const { return 0; }
  // Effect of a change of unknown j on the internal forces on the nodes, N, 3 per node. False: none.
  virtual bool own_push(std::size_t /*j*/, std::span<double> /*on_x*/) const { return false; }
  // The unknowns' equations: w = own_residual + own_answer(motion of the nodes, m, 3 per node) +
  // own_response w.
  virtual Eigen::VectorXd own_residual() const { return {}; }
  virtual Eigen::VectorXd own_answer(std::span<const double> /*move*/) const { return {}; }
  virtual Eigen::MatrixXd own_response() const { return {}; }
  virtual void direct(std::span<const double> /*way*/) {}    // of the next move, for the unknowns
  virtual double largest_own_residual() const { return 0; }  // N
  virtual double largest_own_force() const { return 0; }     // N, with which residuals are compared
  // Appends the places (m, 3 each) of points on what it moves freely, with which the error of a step is
  // judged: at the step's beginning, at its end, or where motion and forces at the beginning would lead.
  enum class Places { before, after, ahead };
  virtual void add_places(Places, std::vector<double>& /*x*/) const {}
  // At rest: how the unknowns resist their own change, without what holds those that nothing else holds;
  // empty: unknowns that no energy decides. With own_answer() to K^-1 own_push() it is the stiffness of all.
  virtual Eigen::MatrixXd own_stiffness() const { return {}; }
};

}  // namespace fabricsh::mechanics
