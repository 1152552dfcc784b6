// Which surfaces touch, and how rigid bodies move: what m:contact, m:move and m:velocity declare.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "history/history.hpp"
#include "mesh/mesh.hpp"
#include "model/rigid.hpp"

namespace fabricsh::model {

// One side of a contact: a rigid body, or the elements of the cloth all of whose nodes are in a set ("all",
// "front": a body of several, "front.left").
struct Party {
  std::string set;
  RigidPointer body;  // null: a set
};

struct ContactGiven {
  std::vector<Party> between;  // every two of them; one: with itself
  double friction = 0;
  std::optional<double> thickness = {};  // m, of the cloth as contact sees it; default the cloth's own
  std::optional<double> stiffness = {};  // Pa/m; default from cloth and mesh
  bool settle = false;                   // is what overlaps at the start opened instead of refused
};

using Displacement = std::array<std::optional<history::History>, 3>;
struct BodyTurn {
  Vec3 axis = Vec3::UnitZ();        // any length but zero
  history::History angle;           // degrees
  std::optional<Vec3> centre = {};  // m, default the body's
};
struct BodyMotion {
  RigidPointer body;
  Displacement displacement;  // m, from where it was declared, global
  std::optional<BodyTurn> turn;
};
struct BodyVelocity {  // of a free body at time 0
  RigidPointer body;
  Vec3 linear = Vec3::Zero();  // m/s
  Vec3 spin = Vec3::Zero();    // rad/s
};

class Interactions {
 public:
  // Errors: an unknown set, a set of no whole element, fewer than two sides, two rigid bodies alone, friction
  // below 0, a thickness or stiffness that is not positive.
  void add(ContactGiven contact, const mesh::Mesh& mesh);
  // Errors: a free body, a moving surface, a body that is moved already, nothing given, no axis.
  void move(BodyMotion motion);
  // Errors: a body that is not free, one with a velocity already, a number that is not finite.
  void velocity(BodyVelocity velocity);
  // Takes back the i-th (from 0) of a kind. Error: there is none.
  enum class Part { contact, motion, velocity };
  void remove(Part part, std::size_t i);
  // Errors: bodies that are moved or have a velocity but touch nothing; a history that is not finite at time
  // 0; sets that share nodes without being the same; two sides that meet twice.
  void validate(const mesh::Mesh& mesh) const;

  bool any() const { return !contacts_.empty(); }
  const std::vector<ContactGiven>& contacts() const { return contacts_; }
  const std::vector<BodyMotion>& motions() const { return motions_; }
  const std::vector<BodyVelocity>& velocities() const { return velocities_; }
  std::vector<RigidPointer> bodies() const;      // each once, in the order in which contacts name them
  std::string name_of(const Rigid& body) const;  // its own, or "sphere", or "sphere 2" where there are more
  const BodyMotion* motion_of(const Rigid& body) const;      // null: it stands or is free
  const BodyVelocity* velocity_of(const Rigid& body) const;  // null: at rest
  std::vector<double> kinks() const;

 private:
  std::vector<ContactGiven> contacts_;
  std::vector<BodyMotion> motions_;
  std::vector<BodyVelocity> velocities_;
};

// The cloth's surfaces, none of which shares a node with another: each is what the same contacts name.
struct Meeting {
  int first, second;    // surfaces; a body is behind them, in the order of Interactions::bodies()
  std::size_t contact;  // of Interactions::contacts()
};
struct Surfaces {
  std::vector<std::vector<mesh::Index>> elements;  // of each surface, ascending
  std::vector<Meeting> meetings;
};
// Errors: as Interactions::validate().
Surfaces work_out_surfaces(const Interactions& interactions, const mesh::Mesh& mesh);

}  // namespace fabricsh::model
