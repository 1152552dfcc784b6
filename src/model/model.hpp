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

#include "base/error.hpp"
#include "base/notice.hpp"
#include "card/card.hpp"
#include "history/history.hpp"
#include "mesh/mesh.hpp"
#include "model/bands.hpp"
#include "model/gas.hpp"
#include "model/interaction.hpp"
#include "model/loads.hpp"
#include "model/reference.hpp"
#include "model/seams.hpp"
#include "model/ties.hpp"
#include "section/section.hpp"

namespace fabricsh::model {

using mesh::Index;

// Warp direction at a point of the reference surface: an angle (degrees, counter-clockwise about the shell
// normal, from global +x projected on the surface), or a vector to be projected on the surface.
using Direction = std::variant<double, Vec3>;
using WarpField = std::function<Direction(const Vec3& X)>;

// Degrees of freedom of a node: three translations, three rotation axes. A director has only two rotations;
// an axis acts on its part tangent to the sphere of directors. rotation = both.
struct FixedFreedoms {
  std::array<bool, 3> translation{};
  std::array<bool, 3> axis{};
  bool rotation = false;
};
// "x y z rx ry rz rotation", blanks or commas between. Error: unknown or empty word, with the accepted list.
FixedFreedoms parse_freedoms(const std::string& words, const std::string& call = "fix");

struct Support {
  std::string set;
  FixedFreedoms fixed;
  Mat3 frame;
  int symmetry =
      -1;  // 0, 1, 2: the set lies in a plane of symmetry normal to this global axis; -1: it does not
};
struct PrescribedMotion {
  std::string set;
  Components displacement;  // m, from the reference position, along the frame
  Mat3 frame;
};
// Rigid rotation of directors, and with a centre also of nodes, about a fixed axis: d = R(angle) D, x = c + R
// (X - c).
struct PrescribedTurn {
  std::string set;
  Vec3 axis = Vec3::UnitZ();   // unit
  History angle;               // degrees
  std::optional<Vec3> centre;  // m
};

// Velocity of a rigid body: linear + spin x (X - centre); a director rotates with the spin.
struct RigidVelocity {
  Vec3 linear = Vec3::Zero();  // m/s
  Vec3 spin = Vec3::Zero();    // rad/s
  Vec3 centre = Vec3::Zero();  // m
};
// Velocity at time 0 of the nodes and directors of a set: one rigid motion for all, or for each node X the
// motion that a function returns for it.
struct InitialVelocity {
  std::string set;
  Vec3 linear = Vec3::Zero();  // m/s
  Vec3 spin = Vec3::Zero();    // rad/s
  Vec3 centre = Vec3::Zero();  // m
  std::function<RigidVelocity(const Vec3& X)> place = {};
  RigidVelocity at(const Vec3& X) const { return place ? place(X) : RigidVelocity{linear, spin, centre}; }
};

// equal     the nodes of the set have equal displacements
// straight  the nodes stay on the line between the two extreme nodes of the set, on which they lie initially
// rigid     nodes and directors move as one rigid body
// periodic  u_b - u_a is equal for all pairs of the set and its partner; both directors of a pair are equal
enum class TieKind { equal, straight, rigid, periodic };
struct Tie {
  TieKind kind;
  std::string set, partner;  // partner: only for periodic
  FixedFreedoms freedoms;    // along global axes; empty for a rigid set
};

struct Options {
  std::optional<double> thickness;        // m; takes precedence over the card's
  std::optional<WarpField> warp;          // required unless the mesh is flat
  std::string warp_text;                  // for the printed model
  int points = 3;                         // through the thickness, 1 to 9
  std::vector<section::Ply> plies;        // if given, they replace the card and its thickness
  double offset = 0;                      // reference surface at zeta_bar in [-1, 1]; 0: middle surface
  std::optional<card::Folds> folds = {};  // takes precedence over the card's
  bool membrane = false;                  // without bending and transverse shear; all directors are held
  bool full_yarns = false;                // the strain of oblique yarns as interpolated (element/shell4.hpp)
};

// A set of elements with its own card, thickness, plies or warp.
struct RegionGiven {
  std::string set;  // of the mesh of the body
  card::Card card;
  Options options;
};
struct BodyGiven {
  std::string name;  // empty: the only body of its model; its sets keep their names
  std::shared_ptr<mesh::Mesh> mesh;
  card::Card card;
  Options options;
  std::vector<RegionGiven> regions;
  ReferenceGiven reference = {};
};

// Material data of a part of the elements, compiled: one region of a body, or the rest of it.
struct Region {
  std::string name;  // "", "front", "pocket", "front.pocket"
  card::Card card;
  Options options;
  Index body = 0;
};

// A set whose joints may open. Where the mesh is too coarse for the card's strength, it is lowered, the model
// refused, or the strength kept (which is right where no tear runs, as in a strip without a notch).
struct Zone {
  std::string set;
  bool lower = true;
  std::uint64_t seed = 1;  // of the scatter of strengths
  std::string path = {};   // a set of nodes: yarns break there only; empty: everywhere in the zone
  bool keep = false;
};

// The strength of the yarns at the elements of a set, over that of their card: for cards whose yarns soften.
struct StrengthGiven {
  std::string set;
  double factor = 1;       // mean over the set
  double modulus = 0;      // of Weibull, with which it differs from element to element; 0: it does not
  std::uint64_t seed = 1;  // of that
};

// Error: there is no i-th declaration.
template <class Declaration>
void remove_at(std::vector<Declaration>& all, std::size_t i) {
  if (i >= all.size()) throw Error("remove: there is no such support or load");
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
}

class Model {
 public:
  // Errors: points outside 1..9; a thickness that is not positive; no warp on a mesh that is not flat; a card
  // that its law refuses (with the reason).
  Model(std::shared_ptr<mesh::Mesh> mesh, card::Card card, Options options);
  // Several bodies, or one with regions. Further errors: no body; several without different names; a region
  // without a whole element; an element in two regions (named).
  explicit Model(std::vector<BodyGiven> bodies);

  // Common errors: unknown set; model already compiled; no component given.
  void fix(const std::string& set, const FixedFreedoms& fixed, const Mat3& frame = global_frame());
  void move(const std::string& set, Components displacement, const Mat3& frame = global_frame());
  // One of the kinds of Loads. Further errors: those of check_load().
  template <class Load>
  void add(Load load) {
    check_open(Load::call);
    check_load(*mesh_, load);
    std::get<std::vector<Load>>(loads_).push_back(std::move(load));
  }
  void force(const std::string& set, Components total, const Mat3& frame = global_frame()) {
    add(ForceLoad{set, std::move(total), frame});
  }
  void moment(const std::string& set, Components total, const Mat3& frame = global_frame()) {
    add(MomentLoad{set, std::move(total), frame});
  }
  void traction(const std::string& set, Components intensity, const Mat3& frame = global_frame()) {
    add(TractionLoad{set, std::move(intensity), frame});
  }
  void gravity(Components acceleration);  // m/s^2
  void pressure(const std::string& set, History value) { add(PressureLoad{set, std::move(value)}); }
  void spring(const std::string& set, const std::array<double, 3>& stiffness,
              const Mat3& frame = global_frame()) {
    add(GroundSpring{set, stiffness, frame});
  }
  void turn(const std::string& set, const Vec3& axis, History angle, std::optional<Vec3> centre);
  // At time 0, for dynamic runs. Error: a number that is not finite.
  void velocity(InitialVelocity velocity);
  void symmetry(const std::string& set,
                int axis);  // plane normal to axis 0, 1 or 2: that displacement, two rotations

  // Errors: a degree of freedom that this kind does not tie; no freedom given; a rigid set of one node; a
  // periodic tie without a partner.
  void tie(Tie tie);

  // The joints between the elements of the set may open and close during a run: each corner of these elements
  // gets a node of its own. Errors: the set has no whole element; an unknown path; later, in validate(): the
  // zone has nodes of a periodic tie.
  void tearable(const std::string& set, bool lower = true, std::uint64_t seed = 1) {
    tearable(Zone{set, lower, seed});
  }
  void tearable(Zone zone);
  const std::vector<Zone>& zones() const { return zones_; }

  // Where sets overlap, the factors multiply. Errors: a set without a whole element, or of cards none of
  // which has a law that softens; a number out of range.
  void strength(StrengthGiven strength);
  const std::vector<StrengthGiven>& strengths() const { return strengths_; }

  // Sews two edges together: see Seam. Errors: unknown set; a time, ease, stiffness, strength or energy out
  // of range; strength without energy, or energy without strength; later, in validate(): those of
  // work_out_seams.
  void seam(Seam seam);
  const std::vector<Seam>& seams() const { return seams_; }

  // A band along an edge: see EdgeBand. Errors: unknown set; a stiffness, ease or time out of range; later,
  // in validate(): those of chain_of.
  void band(EdgeBand band);
  const std::vector<EdgeBand>& bands() const { return bands_of_edges_; }

  // An angle at which the sheet rests: see CreaseGiven. Errors: those of edges_of.
  void crease(CreaseGiven crease);
  const std::vector<CreaseGiven>& creases() const { return creases_; }

  // Gas in a closed volume: see GasGiven. Errors: unknown sets; numbers out of range; a vent to a volume of
  // another model or with another gas; later, in validate(): those of enclosure_of.
  GasPointer gas(GasGiven gas);
  const std::vector<GasPointer>& gases() const { return gases_; }

  // Removes the i-th declaration (from 0) of a kind; for gravity i is ignored. Error: it does not
  // exist.
  enum class DeclarationKind {
    fix,
    move,
    turn,
    tie,
    gravity,
    velocity,
    contact,
    body_move,
    body_velocity,
    body_load,
    body_spring,
    body_fix,
    tearable,
    seam,
    band,
    strength,
    gas,
    crease
  };
  void remove(DeclarationKind kind, std::size_t i);
  template <class Load>
  void remove(std::size_t i) {
    check_open("remove");
    remove_at(std::get<std::vector<Load>>(loads_), i);
  }
  // Contacts and rigid bodies: see Interactions.
  void contact(ContactGiven contact);
  void move(BodyMotion motion);
  void velocity(BodyVelocity velocity);
  void load(BodyLoad load);
  void spring(BodySpring spring);
  void support(BodySupport support);

  // Error: a degree of freedom that is both fixed and moved, or moved twice (naming node and calls); a node
  // held in two frames; the errors of work_out_ties and work_out_seams.
  void validate() const;
  // Called by the analysis that compiles the model, after validate(): from here on mesh() has the nodes of
  // the tearable zones.
  void divide_zones();
  // Called by the analysis that compiles the model: later changes of the model or its mesh are Errors.
  void seal();
  // The same declarations over the same mesh, to be changed and compiled anew.
  std::shared_ptr<Model> copy() const;

  const mesh::Mesh& mesh() const { return *mesh_; }
  std::shared_ptr<const mesh::Mesh> mesh_pointer() const { return mesh_; }
  const std::vector<BodyGiven>& bodies() const { return bodies_; }
  // For each body: the body's own region first, then its other regions.
  const std::vector<Region>& regions() const { return regions_; }
  const card::Card& card() const { return regions_.front().card; }  // of the first region
  // One section per region; each element belongs to exactly one.
  const std::vector<section::Section>& sections() const { return sections_; }
  bool membrane() const { return regions_.front().options.membrane; }  // as a whole
  int region_of(mesh::Index element) const { return region_of_.empty() ? 0 : region_of_[element]; }
  std::string element_name(mesh::Index element) const;  // "12", or "12 of body front" if there are several
  const section::Section& section() const { return sections_.front(); }
  const Options& options() const { return regions_.front().options; }  // of the first region
  double thickness() const { return section().thickness; }
  // The card of the element's region; of the first region for element -1 (none).
  const card::Card& card_of(mesh::Index element) const {
    return regions_[element < 0 ? 0 : region_of(element)].card;
  }
  // The number of a ply in the element's section, from 0, by its name or as ply1, ply2, ... from below; -1:
  // the section has no such ply. A sheet without plies is one.
  int ply_of(mesh::Index element, const std::string& ply) const;
  std::vector<std::string> plies() const;  // the names that ply_of() accepts in any section
  card::Folds folds_of(mesh::Index element) const {
    const Region& region = regions_[element < 0 ? 0 : region_of(element)];
    return region.options.folds.value_or(region.card.folds);
  }
  double thickness_of(mesh::Index element) const { return sections_[region_of(element)].thickness; }
  const std::vector<Support>& supports() const { return supports_; }
  const std::vector<PrescribedMotion>& motions() const { return motions_; }
  const Loads& loads() const { return loads_; }
  template <class Load>
  const std::vector<Load>& loads() const {
    return std::get<std::vector<Load>>(loads_);
  }
  const Components& gravity() const { return gravity_; }
  const std::vector<InitialVelocity>& velocities() const { return velocities_; }
  const std::vector<PrescribedTurn>& turns() const { return turns_; }
  const std::vector<Tie>& ties() const { return ties_; }
  const Interactions& interactions() const { return interactions_; }
  // Times at which a step must end: the kinks of all histories.
  std::vector<double> kinks() const;
  // Whether the cloth is free of stress in another shape than that of the mesh.
  bool has_rest() const;
  const ReferenceGiven& reference_of(mesh::Index element) const {
    return bodies_[static_cast<std::size_t>(regions_[region_of(element)].body)].reference;
  }
  // m, a node of the mesh without its zones in the stress-free shape, but for a prestress.
  const Vec3& rest_node(mesh::Index place) const {
    const auto& nodes = rest_nodes_.empty() ? mesh_->uncut().nodes : rest_nodes_;
    return nodes[static_cast<std::size_t>(place)];
  }
  // The same of a corner of an element.
  const Vec3& rest_corner(mesh::Index element, int corner) const {
    const auto& nodes = mesh_->elements[static_cast<std::size_t>(element)];
    return rest_node(mesh_->place_of(nodes[static_cast<std::size_t>(corner)]));
  }
  // Warp direction as a vector, not yet projected, at X on the stress-free shape with the unit normal n.
  // Error: not finite, or zero after projection.
  Vec3 warp_at(mesh::Index element, const Vec3& X, const Vec3& n) const;
  // The same at x on the mesh: carried there by the sides of the element where that is another shape.
  Vec3 warp_as_placed(mesh::Index element, const Vec3& x, const Vec3& n) const;
  std::string describe() const;  // a few lines: mesh, card, warp, thickness, points, supports

 private:
  void check_open(const char* call) const;
  void close_with_bodies();
  void add_body(Index body);
  void take_reference(const BodyGiven& body, const std::string& of);
  void assign(Index region, Index body, const std::string& set);
  std::vector<Index> elements_of_zones() const;  // ascending
  void check_zones() const;
  std::vector<BodyGiven> bodies_;
  std::shared_ptr<mesh::Mesh> mesh_;  // that of the only body, or all bodies joined
  std::vector<Region> regions_;
  std::vector<section::Section> sections_;  // one per region
  std::vector<int> region_of_;              // per element; empty: all elements are in the first
  std::vector<Support> supports_;
  std::vector<PrescribedMotion> motions_;
  Loads loads_;
  std::vector<PrescribedTurn> turns_;
  std::vector<Tie> ties_;
  std::vector<Zone> zones_;
  std::vector<StrengthGiven> strengths_;
  std::vector<Seam> seams_;
  std::vector<EdgeBand> bands_of_edges_;
  std::vector<GasPointer> gases_;
  std::vector<CreaseGiven> creases_;
  std::vector<Vec3> rest_nodes_;  // of the mesh without its zones; empty: those of the mesh
  std::vector<Vec3> rest_warp_;   // per element, as Mesh::warp, of the stress-free shapes; empty: of the mesh
  Components gravity_;
  std::vector<InitialVelocity> velocities_;
  Interactions interactions_;
  bool sealed_ = false;
};

// A plane of symmetry: x, y or z (axis 0, 1, 2) = at.
struct SymmetryPlane {
  int axis = 0;
  double at = 0;              // m
  std::string set;            // that lies in it, the first of several
  std::string words() const;  // "the plane of symmetry x = 0 m of set 'left'"
};
// Each once. Errors: a set that lies in no plane normal to the axis; cloth that is not symmetric about it
// where it meets it, because its yarns run neither along nor across it (symmetry.cpp).
std::vector<SymmetryPlane> symmetry_planes(const Model& model);
void check_symmetry(const Model& model);

}  // namespace fabricsh::model
