// The points of contact where joints and seams open and close: their masses, and the faces that have parted.
#pragma once
#include <vector>

#include "mechanics/terms/contact_state.hpp"

namespace fabricsh::mechanics {

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

 private:
  void find_masses();
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

}  // namespace fabricsh::mechanics
