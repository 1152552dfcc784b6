// Contacts and the motion of rigid bodies, as declared by m:contact, m:move and m:velocity.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "history/history.hpp"
#include "mesh/mesh.hpp"
#include "model/rigid.hpp"

namespace fabricsh::model {

// One side of a contact: a rigid body, or the elements of the cloth whose nodes all lie in a set ("all";
// "front" for one of several bodies; "front.left").
struct Party {
  std::string set;
  RigidPointer body;  // null: a set of the cloth
};

struct ContactGiven {
  std::vector<Party> between;  // every two of them meet; a single one meets itself
  double friction = 0;
  std::optional<double> thickness = {};  // m, thickness of the cloth in contact; default the cloth's own
  std::optional<double> stiffness = {};  // Pa/m; default computed from cloth and mesh
  // Speed after over speed before of a sheet that meets something flat, 0.4 to 1.
  double restitution = usual_restitution;
  static constexpr double usual_restitution = 0.5;
  std::optional<double> settle = {};  // s, time in which an overlap at the start is opened; default: refused
  // Static friction, at least `friction`, which is that of what slides; default: the same.
  std::optional<double> sticking = {};
  // Friction across the warp of the cloth that comes first in the model; `friction` is then that along it.
  std::optional<double> across = {};
  // A film between the surfaces, which resists sliding with viscosity times speed over thickness; with a
  // speed it thins from there on, see contact::Film.
  std::optional<double> viscosity = {}, film = {};                         // Pa s, m
  double film_speed = 0, film_exponent = 1;                                // m/s; above 0 to 1
  double film_drag() const { return viscosity ? *viscosity / *film : 0; }  // Pa s/m
};

using Displacement = std::array<std::optional<history::History>, 3>;
struct BodyTurn {
  Vec3 axis = Vec3::UnitZ();        // of any nonzero length
  history::History angle;           // degrees
  std::optional<Vec3> centre = {};  // m, default the body's
};
struct BodyMotion {
  RigidPointer body;
  Displacement displacement;  // m, from the declared position, global
  std::optional<BodyTurn> turn;
};
struct BodyVelocity {  // initial velocity of a free body
  RigidPointer body;
  Vec3 linear = Vec3::Zero();  // m/s
  Vec3 spin = Vec3::Zero();    // rad/s
};

// What loads a body at its centre: a force, or a moment about it, along global axes.
struct BodyLoad {
  RigidPointer body;
  Displacement total;  // N or N m
  bool moment = false;
};
// Ties the centre of a body to the ground or to the centre of another body, along global axes: a spring, or a
// damper, which resists the difference of their velocities.
struct BodySpring {
  RigidPointer body;
  Vec3 stiffness = Vec3::Zero();  // N/m; of a damper N s/m
  bool damper = false;
  RigidPointer to;                 // null: the ground
  std::optional<Vec3> place = {};  // m, of the centre when a spring to the ground is slack; default at time 0
};
// Directions in which the centre of a body is held, and axes about which it does not turn, global.
struct BodySupport {
  RigidPointer body;
  std::array<bool, 3> moves{}, turns{};  // whether held
};

class Interactions {
 public:
  // Errors: an unknown set, a set without a whole element, fewer than two sides, only bodies whose places are
  // given, a free body with another one that it does not meet or with friction between them, negative
  // friction, a thickness or stiffness that is not positive.
  void add(ContactGiven contact, const mesh::Mesh& mesh);
  // Errors: a free body, a moving surface, a body that is moved already, nothing given, a zero axis.
  void move(BodyMotion motion);
  // Errors: a body that is not free, a body that has a velocity already, a number that is not finite.
  void velocity(BodyVelocity velocity);
  // Errors: a body that is moved, or a moving surface; nothing given; a number that is not finite; a spring
  // to itself; a plane that may turn; two axes of turning held but not the third.
  void load(BodyLoad load);
  void spring(BodySpring spring);
  void support(BodySupport support);
  // The bodies that close volumes of gas, which need not touch anything; the same ones several times or once.
  void close(std::vector<RigidPointer> bodies) { closing_ = std::move(bodies); }
  // Removes the i-th declaration (from 0) of a kind. Error: it does not exist.
  enum class InteractionKind { contact, motion, velocity, load, spring, support };
  void remove(InteractionKind part, std::size_t i);
  // Errors: a body that is moved or has a velocity but is in no contact; a history that is not finite at time
  // 0; sets that share nodes without being equal; two sides that meet twice.
  void validate(const mesh::Mesh& mesh) const;

  bool any() const { return !contacts_.empty() || !closing_.empty(); }
  const std::vector<ContactGiven>& contacts() const { return contacts_; }
  const std::vector<BodyMotion>& motions() const { return motions_; }
  const std::vector<BodyVelocity>& velocities() const { return velocities_; }
  const std::vector<BodyLoad>& loads() const { return loads_; }
  const std::vector<BodySpring>& springs() const { return springs_; }
  const std::vector<BodySupport>& supports() const { return supports_; }
  // Each once, in the order in which the contacts name them; then those that close volumes of gas.
  std::vector<RigidPointer> bodies() const;
  std::string name_of(const Rigid& body) const;  // its own; else "sphere", or "sphere 2" if there are several
  const BodyMotion* motion_of(const Rigid& body) const;      // null: it is at rest or free
  const BodyVelocity* velocity_of(const Rigid& body) const;  // null: at rest
  // Whether forces decide where the body is: it has a mass, or is loaded, on springs, or held in part.
  bool floats(const Rigid& body) const;
  BodySupport held(const Rigid& body) const;  // all of its supports together
  std::vector<double> kinks() const;

 private:
  std::vector<ContactGiven> contacts_;
  std::vector<BodyMotion> motions_;
  std::vector<BodyVelocity> velocities_;
  std::vector<BodyLoad> loads_;
  std::vector<BodySpring> springs_;
  std::vector<BodySupport> supports_;
  std::vector<RigidPointer> closing_;
};

// The surfaces of the cloth. No two share a node; each consists of the elements that the same contacts name.
struct SurfacePair {
  int first, second;    // numbers of surfaces; those of bodies follow, in the order of Interactions::bodies()
  std::size_t contact;  // index in Interactions::contacts()
};
struct Surfaces {
  std::vector<std::vector<mesh::Index>> elements;  // of each surface, ascending
  std::vector<SurfacePair> meetings;
};
// Errors: those of Interactions::validate().
Surfaces work_out_surfaces(const Interactions& interactions, const mesh::Mesh& mesh);

}  // namespace fabricsh::model
