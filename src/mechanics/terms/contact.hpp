// Contact of cloth with rigid bodies, other cloth and itself (share/doc/contact.md), and the rigid bodies.
//
// Friction remembers its elastic slip from step to step (contact/pair.hpp). In static and implicit steps its
// Jacobian is exact, and Newton's steps are cut to the safe share.
//
// The term puts together: the surfaces and their laws, the state (positions, forces, pairs), what each scheme
// of steps does with it, the bodies' unknowns and the tangent, and the readings.
#pragma once
#include <string>
#include <vector>

#include "mechanics/terms/contact_bodies.hpp"
#include "mechanics/terms/contact_readings.hpp"
#include "mechanics/terms/contact_schemes.hpp"

namespace fabricsh::mechanics {

class Contacts final : public Term {
 public:
  // Error: sides that share nodes (see model::work_out_surfaces). Overlaps are found by check_start().
  Contacts(const model::Model& model, const Configuration& configuration, const Cloth& cloth,
           const Dofs& dofs);

  const char* name() const override { return "contact"; }
  std::vector<Facet*> parts() override { return {&passing_, &unknowns_, &implicit_}; }
  Outcome add_forces(const law::Step& step, const Trial& trial, Forces& forces) override;
  void add_tangent(const Trial&, TangentSink& sink) const override { tangent_.add(sink); }
  bool symmetric() const override { return !surfaces_.friction(); }
  bool symmetric_but_apart() const override { return true; }
  void couple(const Trial& trial, std::vector<NodePair>& pairs) override;
  void add_energies(const Trial&, std::vector<Energy>& out) const override;
  // Of what drives bodies, of gravity on free ones, and of what opens overlaps.
  StepWork step_work() const override;
  void set_time(double time) override;
  void commit() override;
  void rollback() override;
  void renumbered(Forces& forces) override;
  void keep(Archive& archive) override;

  // Error: an overlap at the start, with its pairs; cloth inside a solid. Of a run that goes on from a state
  // both are looked for there, when the bodies have gone where they are at its time.
  void check_start() const;
  void begin_here();
  void masses_changed() { joints_.find_masses(); }  // of the cloth's nodes
  void take_stiffness(const Contacts& other) { surfaces_.take_stiffness(other.surfaces_); }
  // The scheme of the steps from here on; without either call they are static, and bodies do not move freely.
  // Implicit ones call set_weight() of the facet AtStepEnd.
  void go_static(double rise) { unknowns_.go_static(rise); }  // s, see Bodies
  ExplicitContact& go_explicit();

  std::span<const Vec3> nodal_forces() const { return state_.nodal_forces(); }  // N
  std::vector<char> pressed_by_bodies() const;                                  // of all nodes
  const ContactSurfaces& surfaces() const { return surfaces_; }
  const Bodies& bodies() const { return surfaces_.bodies(); }
  const BodyUnknowns& unknowns() const { return unknowns_; }
  const ContactReadings& readings() const { return readings_; }
  GasOnBodies& gas() { return gas_; }

 private:
  ContactScheme& scheme();
  const ContactScheme& scheme() const { return const_cast<Contacts*>(this)->scheme(); }
  void find_overlaps(double time);
  std::string overlaps_at(double time);
  std::string inside() const;

  const model::Model& model_;
  const Cloth& cloth_;
  ContactSurfaces surfaces_;
  ContactState state_;
  ContactJoints joints_;
  SettlingOverlaps settling_;
  ContactPassing passing_;
  GasOnBodies gas_;
  BodyUnknowns unknowns_;
  ContactTangent tangent_;
  ContactReadings readings_;
  BarrierInertia barriers_;
  ContactScheme static_;
  ImplicitContact implicit_;
  ExplicitContact explicit_;
};

}  // namespace fabricsh::mechanics
