// The declared problem: a mesh, a card, supports, motions, loads. Nothing is computed here; validate() checks
// the whole once, and an analysis compiles it.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/notice.hpp"
#include "card/card.hpp"
#include "history/history.hpp"
#include "mesh/mesh.hpp"
#include "model/interaction.hpp"
#include "model/ties.hpp"
#include "section/section.hpp"

namespace fabricsh::model {

using history::History;
using mesh::Index;

// Warp direction at a point of the reference surface: an angle in degrees, counter-clockwise about the shell
// normal from global +x projected on the surface, or a vector (projected on the surface).
using Direction = std::variant<double, Vec3>;
using WarpField = std::function<Direction(const Vec3& X)>;

// Orthonormal frame of an oblique support or load: rows e1 e2 e3, global components; x y z of the call count
// along them.
Mat3 frame_from(const Vec3& e1,
                const Vec3& e2);  // Error unless they span a plane; e2 is made orthogonal to e1
inline Mat3 global_frame() { return Mat3::Identity(); }

// Freedoms of a node: three translations, three rotation axes (a director has two rotations; a rotation axis
// acts on the part of it that is tangent to the sphere of directors). rotation = both director rotations.
struct Freedoms {
  std::array<bool, 3> translation{};
  std::array<bool, 3> axis{};
  bool rotation = false;
};
// "x y z rx ry rz rotation", blanks or commas between. Error: unknown or empty word, with the accepted list.
Freedoms parse_freedoms(const std::string& words, const std::string& call = "fix");

using Components = std::array<std::optional<History>, 3>;
// The same at all times.
inline Components steady(const Vec3& v) {
  return {History::constant(v.x()), History::constant(v.y()), History::constant(v.z())};
}

struct Support {
  std::string set;
  Freedoms fixed;
  Mat3 frame;
};
struct Motion {
  std::string set;
  Components displacement;  // m, from the reference position, along the frame
  Mat3 frame;
};
struct Force {
  std::string set;
  Components total;  // N, shared by tributary length (edges) or area; a single node takes it whole
  Mat3 frame;
};

struct Moment {
  std::string set;
  Components total;  // N m about the frame's axes, which stay fixed in space; shared like a force
  Mat3 frame;
};
struct Traction {
  std::string set;
  Components intensity;  // dead: N/m^2 of reference area where the set holds whole elements, else N/m of edge
  Mat3 frame;
};
struct Pressure {
  std::string set;
  History value;  // Pa, along the shell normal, following the surface
};
struct Spring {
  std::string set;
  std::array<double, 3>
      stiffness{};  // N/m along the frame, to ground, total for the set, shared like a force
  Mat3 frame;
};
// Directors, and with a centre the nodes too, turned rigidly about a fixed axis: d = R(angle) D, x = c + R (X
// - c).
struct Turn {
  std::string set;
  Vec3 axis = Vec3::UnitZ();   // unit
  History angle;               // degrees
  std::optional<Vec3> centre;  // m
};

// A rigid body's velocity: linear + spin x (X - centre); a director turns with the spin.
struct RigidVelocity {
  Vec3 linear = Vec3::Zero();  // m/s
  Vec3 spin = Vec3::Zero();    // rad/s
  Vec3 centre = Vec3::Zero();  // m
};
// Velocity at time 0 of a set's nodes and directors: the same rigid one for all, or at each node X the one
// that the function of place gives there.
struct InitialVelocity {
  std::string set;
  Vec3 linear = Vec3::Zero();  // m/s
  Vec3 spin = Vec3::Zero();    // rad/s
  Vec3 centre = Vec3::Zero();  // m
  std::function<RigidVelocity(const Vec3& X)> place = {};
  RigidVelocity at(const Vec3& X) const { return place ? place(X) : RigidVelocity{linear, spin, centre}; }
};

// equal     the nodes of the set share their displacements
// straight  they stay on the line between the set's two extreme nodes, where they lie on it in the reference
// rigid     nodes and directors move as one rigid body
// periodic  u_b - u_a is the same for all pairs of the set and its partner; directors of a pair are the same
enum class TieKind { equal, straight, rigid, periodic };
struct Tie {
  TieKind kind;
  std::string set, partner;  // partner: periodic only
  Freedoms freedoms;         // along global axes; a rigid set has none of its own
};

struct Options {
  std::optional<double> thickness;  // m; wins over the card's
  std::optional<WarpField> warp;    // required unless the mesh is flat
  std::string warp_text;            // for the printed model
  int points = 3;                   // through the thickness, 1 to 9
  std::vector<section::Ply> plies;  // given: they stand in for the card and the thickness
  double offset = 0;                // reference surface at zeta_bar in [-1, 1] (0: middle surface)
};

// A set of elements with a card, thickness, plies or warp of its own.
struct RegionGiven {
  std::string set;  // of the body's mesh
  card::Card card;
  Options options;
};
struct BodyGiven {
  std::string name;  // empty: the only body of its model, whose sets keep their names
  std::shared_ptr<mesh::Mesh> mesh;
  card::Card card;
  Options options;
  std::vector<RegionGiven> regions;
};

// What a part of the elements is made of, compiled: the rest of a body, or one of its regions.
struct Region {
  std::string name;  // "", "front", "pocket", "front.pocket"
  card::Card card;
  Options options;
  Index body = 0;
};

class Model {
 public:
  // Errors: points outside 1..9; thickness not positive; warp missing on a mesh that is not flat; a card that
  // the law refuses (with its reason).
  Model(std::shared_ptr<mesh::Mesh> mesh, card::Card card, Options options);
  // Several bodies, or one with regions. Errors, besides: no body; several without names of their own; a
  // region of no whole element; an element in two regions (named).
  explicit Model(std::vector<BodyGiven> bodies);

  // Errors of all: unknown set; model already compiled; no component given.
  void fix(const std::string& set, const Freedoms& fixed, const Mat3& frame = global_frame());
  void move(const std::string& set, Components displacement, const Mat3& frame = global_frame());
  void force(const std::string& set, Components total, const Mat3& frame = global_frame());
  void gravity(Components acceleration);  // m/s^2
  void moment(const std::string& set, Components total, const Mat3& frame = global_frame());
  void traction(const std::string& set, Components intensity, const Mat3& frame = global_frame());
  void pressure(const std::string& set, History value);
  void spring(const std::string& set, const std::array<double, 3>& stiffness,
              const Mat3& frame = global_frame());
  void turn(const std::string& set, const Vec3& axis, History angle, std::optional<Vec3> centre);
  // At time 0, for a run in motion. Error: a number that is not finite.
  void velocity(InitialVelocity velocity);
  void symmetry(const std::string& set,
                int axis);  // plane normal to axis 0, 1 or 2: that displacement, two rotations

  // Errors: a freedom that the kind does not tie; none named; a rigid set of one node; a periodic tie without
  // a partner.
  void tie(Tie tie);

  // Takes back the i-th (from 0) of what was told of a kind; the i of gravity is not looked at. Error: there
  // is none.
  enum class Told {
    fix,
    move,
    turn,
    spring,
    tie,
    force,
    moment,
    traction,
    pressure,
    gravity,
    velocity,
    contact,
    body_move,
    body_velocity
  };
  void remove(Told kind, std::size_t i);
  // Contacts and rigid bodies: see Interactions.
  void contact(ContactGiven contact);
  void move(BodyMotion motion);
  void velocity(BodyVelocity velocity);

  // Error: a freedom fixed and moved or moved twice (names node and both calls); a node held in two frames at
  // once; what work_out_ties refuses.
  void validate() const;
  // By the analysis that compiles it: any change of it or its mesh after that is an Error.
  void seal();

  const mesh::Mesh& mesh() const { return *mesh_; }
  std::shared_ptr<const mesh::Mesh> mesh_pointer() const { return mesh_; }
  const std::vector<BodyGiven>& bodies() const { return bodies_; }
  // The body's own part first, then its regions, body after body.
  const std::vector<Region>& regions() const { return regions_; }
  const card::Card& card() const { return regions_.front().card; }  // of the first
  // One section per region; an element belongs to one of them.
  const std::vector<section::Section>& sections() const { return sections_; }
  int region_of(mesh::Index element) const { return region_of_.empty() ? 0 : region_of_[element]; }
  std::string element_name(mesh::Index element) const;  // "12", or "12 of body front" where there are several
  const section::Section& section() const { return sections_.front(); }
  const Options& options() const { return regions_.front().options; }  // of the first region
  double thickness() const { return section().thickness; }
  // Of one element's region; of the first where the element is -1 (none).
  const card::Card& card_of(mesh::Index element) const {
    return regions_[element < 0 ? 0 : region_of(element)].card;
  }
  double thickness_of(mesh::Index element) const { return sections_[region_of(element)].thickness; }
  const std::vector<Support>& supports() const { return supports_; }
  const std::vector<Motion>& motions() const { return motions_; }
  const std::vector<Force>& forces() const { return forces_; }
  const Components& gravity() const { return gravity_; }
  const std::vector<InitialVelocity>& velocities() const { return velocities_; }
  const std::vector<Moment>& moments() const { return moments_; }
  const std::vector<Traction>& tractions() const { return tractions_; }
  const std::vector<Pressure>& pressures() const { return pressures_; }
  const std::vector<Spring>& springs() const { return springs_; }
  const std::vector<Turn>& turns() const { return turns_; }
  const std::vector<Tie>& ties() const { return ties_; }
  const Interactions& interactions() const { return interactions_; }
  // Times on which a step must land: the kinks of every history.
  std::vector<double> kinks() const;
  // Warp direction as a vector (not yet projected), at X on a surface with unit normal n. Error: not finite,
  // or no direction left after projection.
  Vec3 warp_at(mesh::Index element, const Vec3& X, const Vec3& n) const;
  std::string describe() const;  // a few lines: mesh, card, warp, thickness, points, supports

 private:
  void check_open(const char* call) const;
  void add_body(Index body);
  void assign(Index region, Index body, const std::string& set);
  std::vector<BodyGiven> bodies_;
  std::shared_ptr<mesh::Mesh> mesh_;  // the body's own, or the bodies' joined
  std::vector<Region> regions_;
  std::vector<section::Section> sections_;  // one per region
  std::vector<int> region_of_;              // per element; empty: all in the first
  std::vector<Support> supports_;
  std::vector<Motion> motions_;
  std::vector<Force> forces_;
  std::vector<Moment> moments_;
  std::vector<Traction> tractions_;
  std::vector<Pressure> pressures_;
  std::vector<Spring> springs_;
  std::vector<Turn> turns_;
  std::vector<Tie> ties_;
  Components gravity_;
  std::vector<InitialVelocity> velocities_;
  Interactions interactions_;
  bool sealed_ = false;
};

}  // namespace fabricsh::model
