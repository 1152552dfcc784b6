// Contact of cloth with rigid bodies, other cloth and itself (share/doc/contact.md), and the rigid bodies.
//
// Static and implicit steps: friction depends on the sliding since the beginning of the step, and its
// Jacobian is exact; Newton's steps are cut to the safe share. Explicit steps: friction depends on the
// velocity half a step ago, computed from the positions.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "contact/advance.hpp"
#include "contact/contact.hpp"
#include "mechanics/freedoms.hpp"
#include "mechanics/term.hpp"
#include "mechanics/terms/bodies.hpp"
#include "mechanics/terms/cloth.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

class Contacts final : public Term {
 public:
  // Errors: sides that share nodes (see model::work_out_surfaces); an overlap at the start, with its pairs.
  Contacts(const model::Model& model, const Configuration& configuration, const Cloth& cloth,
           const Freedoms& freedoms);

  const char* name() const override { return "contact"; }
  Outcome add_forces(const law::Step& step, const Trial& trial, Forces& forces) override;
  void add_tangent(const Trial& trial, TangentSink& sink) const override;
  bool symmetric() const override { return !friction_; }
  void couple(const Trial& trial, std::vector<NodePair>& pairs) override;
  void add_energies(const Trial&, std::vector<Energy>& out) const override;
  double step_work() const override { return bodies_.step_work(); }
  void aim(double time) override { bodies_.aim(configuration_.time(), time); }
  void commit() override;
  void rollback() override;
  void keep(Archive& archive) override;

  // --- motion of the bodies in a step: Newton's iterations move them by shares of the remaining way
  void begin_iterate() { at_ = share_; }
  void move(double scale) { share_ = at_ + scale * (1 - at_); }
  bool arrived() const { return share_ >= 1 || !moves_; }
  // The share of the way from the marked positions to the trial ones without any surface passing another.
  void mark(const Trial& trial);
  double safe_share(const Trial& trial);

  // --- explicit steps
  void go_explicit() { explicit_ = true; }
  // Whether the last state is impossible, or its motion may have passed through a surface. If the largest
  // motion does not exclude that, each near pair is checked.
  bool may_have_passed();
  bool guarded() const { return trial_.guard > 0; }
  // s: the largest step: 0.6 of the cloth's own stable step, limited by the stiffest contact.
  double largest_step(bool scaled) const;
  // s: the largest step for the stiffness at the smallest gap, including that of the guard.
  double carried_step() const;
  bool blocked() const { return blocked_; }  // the state of the last forces is impossible

  // --- reading of the present state of the configuration
  const Bodies& bodies() const { return bodies_; }
  int find_body(const model::Rigid& body) const;  // -1: not in this model
  struct Nearest {
    double gap;                         // m, above the floor
    std::array<std::int32_t, 4> point;  // corners, -1: none
  };
  Nearest nearest() const;
  double gap(Index node) const;       // m, above the floor; at most the range of contact
  double pressure(Index node) const;  // Pa, without friction
  std::size_t touching() const { return read().totals.touching; }
  std::string words(const std::array<std::int32_t, 4>& points) const;  // "node 3 and sphere"
  // The parameters used for each contact, in lines of text.
  std::vector<std::string> describe() const;
  bool has_friction() const { return friction_; }

 private:
  struct Sheet {                                 // a surface of cloth
    double thickness = 0, floor = 0, areal = 0;  // m, m, kg/m2
  };
  struct Block {
    std::array<std::int32_t, 4> point;
    contact::Matrix12 k;
  };
  struct Reading {
    std::uint64_t version = 0;
    contact::Totals totals;
    std::vector<Vec3> x;
  };
  Contacts(const model::Model& model, const Configuration& configuration, const Cloth& cloth,
           const Freedoms& freedoms, const model::Surfaces& surfaces);
  Sheet sheet(const std::vector<Index>& elements) const;
  void find_masses(const Freedoms& freedoms);
  contact::Law law_of(const model::Meeting& meeting);
  void refuse_overlaps();
  void positions(std::span<const double> x, double share, std::vector<Vec3>& out) const;
  void find_motion(double dt);
  void prepare_tangent(const Trial& trial);
  const Reading& read() const;
  int surface_of(std::int32_t point) const;

  const model::Model& model_;
  const Configuration& configuration_;
  const Cloth& cloth_;
  contact::Scene scene_;
  std::vector<Sheet> sheets_;
  Bodies bodies_;
  mutable std::unique_ptr<contact::Contact> contact_;
  std::vector<std::string> words_;
  bool friction_ = false, explicit_ = false, moves_ = false, blocked_ = false;
  double least_areal_ = 0, step_ = 0;  // kg/m2; s, step for which stiffnesses are limited
  double creep_ = 0;                   // m

  std::size_t nodes_ = 0;
  std::vector<Vec3> x_, start_, marked_, force_, velocity_, by_;
  std::vector<double> inverse_mass_;
  double share_ = 0, at_ = 0;  // share of the bodies' way: trial, iterate
  double moved_ = 0;           // m, largest motion in the step
  contact::Totals trial_, committed_;
  double lost_ = 0, trial_lost_ = 0;  // J, lost by friction so far; in the step
  double power_ = 0;                  // W, at the committed state (explicit)
  bool evaluated_ = false;
  std::vector<Block> blocks_;
  std::vector<std::int64_t> pairs_;  // pairs of nodes coupled at any time: a * nodes + b, a < b, ascending
  mutable Reading reading_;
};

}  // namespace fabricsh::mechanics
