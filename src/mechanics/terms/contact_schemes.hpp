// Contact in the steps of each scheme: in statics, in implicit and in explicit motion.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/facets.hpp"
#include "mechanics/terms/contact_state.hpp"

namespace fabricsh::mechanics {

// --- The points of contact where joints and seams open and close: their masses, and the faces that have
// parted.

class ContactJoints {
 public:
  ContactJoints(const model::Model& model, const Cloth& cloth, const Dofs& dofs, ContactState& state);
  // 1/kg, of each point, that of the joint that it stands for; 0: held or driven.
  const std::vector<double>& inverse_masses() const { return inverse_mass_; }
  // With planes of symmetry: those that each node lies in, or that cut the body of a rigid vertex, a bit
  // each. Inverse masses are then those of the whole model.
  const std::vector<unsigned char>& planes() const { return planes_; }
  void renumbered(Forces& forces);  // the force on a joint that has opened goes to its parts
  bool follow_faces();              // at a commit; returns whether any face is farther apart than before
  void keep(Archive& archive);

  void find_masses();

 private:
  contact::Triangle corners_of(const contact::TriangleRow& row) const;
  std::vector<double> crack_faces() const;
  std::vector<double> parted_faces() const;
  void set_apart(std::vector<double> apart);

  const model::Model& model_;
  const Cloth& cloth_;
  const Dofs& dofs_;
  const Joints& joints_;
  ContactState& state_;
  contact::Scene& scene_;
  const std::size_t nodes_;
  std::vector<double> inverse_mass_;
  std::vector<unsigned char> planes_;
  std::vector<Index> led_by_;  // per node, the leader of its joint; empty: there are no zones
};

// --- How far Newton's iterations and steps may go so that no surface passes through another.

class ContactPassing final : public StepLimiter {
 public:
  ContactPassing(ContactState& state, const Freedoms& freedoms);
  // Explicit steps have a check of their own, see ExplicitContact.
  void go_explicit() { explicit_ = true; }
  bool limits() const override { return !explicit_ && state_.surfaces.any(); }
  void mark(const Trial& trial) override;
  double safe_fraction(const Trial& trial) override;
  // The share during which nothing moves farther than a few elements, relative to the mean motion.
  double near_share(const Trial& trial) override;
  // Until then the straight ways of the bodies stand for their paths: they leave them by no more than the
  // smallest distance that contact allows, so that what a body passes over on its path it would also come
  // that near to on its straight way.
  double latest_end(double to) const override;
  // Whether points whose motion is given pass through each other in the step.
  bool given_motions_meet();
  void begin_step() { met_.reset(); }

 private:
  ContactState& state_;
  std::vector<Vec3> marked_, by_;
  double marked_gap_ = 0;  // m, the smallest where the way begins; 0: not known
  // Whether the motion of a point is given: nodes that are held or driven, vertices of bodies that are not
  // free. Empty: nothing of that kind moves towards cloth of that kind.
  std::vector<char> driven_;
  std::optional<bool> met_;  // whether such points meet in the step; empty: not yet known
  bool explicit_ = false;
};

// Statics, and what other schemes change of it.
class ContactScheme {
 public:
  explicit ContactScheme(ContactState& state) : state_(state) {}
  virtual ~ContactScheme() = default;
  // The way of friction in the trial step; dt: its length, s.
  virtual contact::Way way(double /*dt*/) { return state_.turn_bodies(); }
  virtual void evaluated() {}                                    // after the forces of the trial state
  virtual double impact() const { return state_.trial.impact; }  // J, that the trial step takes

 protected:
  ContactState& state_;
};

// Implicit steps take the forces of contact at their end, while the cloth keeps its own rule: then contact
// cannot make energy, and what it takes is the energy "impact". The tangent has their weight, too.
class ImplicitContact final : public ContactScheme, public AtStepEnd {
 public:
  ImplicitContact(ContactState& state, const SettlingOverlaps& settling,
                  const std::vector<double>& inverse_mass)
      : ContactScheme(state), settling_(settling), inverse_mass_(inverse_mass) {}
  bool used() const { return used_; }
  contact::Way way(double dt) override;
  void evaluated() override;
  double impact() const override { return taken_; }

  void set_weight(double weight, double late) override;
  bool acts() const override { return state_.acts(); }
  std::span<const Vec3> nodal_forces() const override { return state_.nodal_forces(); }
  double work_on_cloth() const override;
  double lost_by_rule() const override { return state_.surfaces.bodies().readings().lost_by_rule(); }

 private:
  const SettlingOverlaps& settling_;
  const std::vector<double>& inverse_mass_;
  bool used_ = false;
  double taken_ = 0;  // J, in the trial step
};

// Explicit steps through the barrier of contact with bodies whose motion is given (contact_eased.cpp).
class BarrierInertia {
 public:
  BarrierInertia(ContactState& state, const Cloth& cloth, const Dofs& dofs)
      : state_(state), cloth_(cloth), dofs_(dofs) {}
  void allow();  // where the inertia may act
  // Whether the barriers are met by inertia in the next steps. planned: s, see contact::Contact::ease().
  void ease(bool on, double planned) { state_.pairs.ease(on, planned); }
  // To be called with the residual of each evaluation of forces: takes from it what the inertia that meets
  // the barriers holds back, N by unknowns. masses: of the unknowns, kg.
  void hold_back(std::span<const double> masses, std::span<double> residual);
  double energy() const { return energy_ + (state_.evaluated ? work() : 0); }  // J, to be given back
  void commit();
  void rollback() { held_.clear(); }
  void keep(Archive& archive) { archive(before_, energy_); }

 private:
  // The part of the forces on a node that is held back: by a body, which has it with the other sign, or by
  // pairs of cloths.
  struct HeldBack {
    Index node = 0;
    Vec3 force = Vec3::Zero();  // N
    contact::Contact::BodySide body = {};
    void keep(Archive& archive) {
      archive(node, force[0], force[1], force[2]);
      for (std::size_t k = 0; k < 4; ++k) archive(body.point[k], body.share[k]);
    }
  };
  double work() const;
  // m/s^2, of the body at a pair, by where it is at the beginning of the step, at its end and after a further
  // one as long.
  Vec3 acceleration(const contact::Contact::BodySide& side);

  ContactState& state_;
  const Cloth& cloth_;
  const Dofs& dofs_;
  std::vector<HeldBack> held_, before_;   // in the trial and in the committed state
  std::vector<std::vector<Vec3>> later_;  // m, vertices of bodies after a further step; empty: not known
  double energy_ = 0;                     // J, up to the committed state
};

class ExplicitContact final : public ContactScheme {
 public:
  ExplicitContact(ContactState& state, const ContactJoints& joints, BarrierInertia& barriers,
                  const Cloth& cloth, const Dofs& dofs)
      : ContactScheme(state), joints_(joints), barriers_(barriers), cloth_(cloth), dofs_(dofs) {}
  void use();  // Error: a film that an explicit step does not carry
  bool used() const { return used_; }
  contact::Way way(double dt) override;
  void evaluated() override;

  // --- of the step just tried
  bool blocked() const { return state_.blocked; }  // the state of the last forces is impossible
  // Whether the last state is impossible, or its motion may have passed through a surface. If the largest
  // motion does not exclude that, each near pair is checked.
  bool may_have_passed();
  bool turns_too_far() const;  // a body
  bool guarded() const { return state_.totals().guard > 0; }
  bool enters_guard() const { return guarded() && !(state_.committed.guard > 0); }
  // Whether a barrier acts that needs shorter steps: others are met by inertia.
  bool needs_short_steps() const { return std::isfinite(state_.trial.hard_gap); }
  // Whether something has come into one of these as in an impact, whose energy inertia would err with.
  bool struck() const { return state_.trial.struck; }
  BarrierInertia& barriers() { return barriers_; }
  std::span<const Vec3> nodal_forces() const { return state_.nodal_forces(); }

  // --- the steps that contact allows, s (contact_steps.cpp)
  // The largest step with contact, as a share of the cloth's `stable` one, s: 0.6, up to 0.7 beside soft
  // contact.
  double share_of_cloth(double stable) const;
  // That share of the cloth's own stable step, limited by the stiffest contact.
  double largest_step(bool scaled) const;
  // For the stiffness at the smallest gap, including that of the barrier.
  double largest_contact_step() const;

  // --- the speeds that it stops
  // m/s: the least speed, over all contacts, that uses up the range of contact above the barrier when cloth
  // of the least areal mass meets it. Faster cloth is pressed into the barrier. `flat`: where all of it
  // is pressed at once; `anywhere`: where an element meets no more than one corner or edge of a body.
  struct Stopped {
    double flat, anywhere;
    bool given;  // the stiffness of that contact, which is then not that of smaller elements
  };
  Stopped speed_stopped() const;
  // Of each seam that is to be drawn together: the farthest of its stitches whose straight way passes through
  // a body of facets that the cloth touches.
  struct DrawnThrough {
    std::size_t stitch;
    std::string body;
    double stopped;  // m/s: as `anywhere` of what the cloth meets there
  };
  std::vector<DrawnThrough> drawn_through() const;
  // The pressure on a pair of cloth and a body, and the one that its law carries before the barrier begins.
  struct Pressed {
    double pressure, carried;  // Pa
    // Pa/m, that would carry this pressure with a margin; s, the largest step with it.
    double stiffness, step;
  };
  // Of the corners of a pair and its gap above the floor, m; empty: no more than is carried.
  std::optional<Pressed> pressed(const std::array<std::int32_t, 4>& points, double gap) const;

 private:
  void refuse_films() const;
  double stiffest() const;
  double weakest_share(const contact::Interaction& it) const;
  Stopped stopped_by(std::size_t meeting) const;
  double carried_by_bodies(double share, bool guarded) const;

  const ContactJoints& joints_;
  BarrierInertia& barriers_;
  const Cloth& cloth_;
  const Dofs& dofs_;
  bool used_ = false;
  double moved_ = 0;  // m, largest motion in the step
  std::vector<Vec3> by_;
};

}  // namespace fabricsh::mechanics
