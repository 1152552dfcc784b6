// Whatever is declared of a model, one struct for each call of a deck. A struct has the name of its call and
// tells its members to a visitor, with their names, units and words; from that come its checks, m:list(),
// m:declared(), removal, the printed model, the times of kinks, the fingerprint in checkpoints and the notice
// of a load that begins with a jump. With a sentence and an example also its call is made from that: the
// arguments, their checks and messages, reference and completion. A new load is a struct here, in
// Declarations, and a term.
#pragma once
#include <array>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "base/error.hpp"
#include "base/range.hpp"
#include "geometry/vec.hpp"
#include "history/history.hpp"
#include "mesh/mesh.hpp"
#include "model/gas.hpp"
#include "model/reference.hpp"
#include "model/rigid.hpp"
#include "model/seams.hpp"

namespace fabricsh::model {

using history::History;

// Orthonormal frame of an oblique support or load: rows e1 e2 e3 in global components. The x y z of the call
// are components along them.
Mat3 frame_from(const Vec3& e1,
                const Vec3& e2);  // Error unless they span a plane; e2 is made orthogonal to e1
inline Mat3 global_frame() { return Mat3::Identity(); }

using Components = std::array<std::optional<History>, 3>;
// The same vector at all times.
inline Components steady(const Vec3& v) {
  return {History::constant(v.x()), History::constant(v.y()), History::constant(v.z())};
}

// Degrees of freedom of a node: three translations, three rotation axes. A director has only two rotations;
// an axis acts on its part tangent to the sphere of directors. rotation = both.
struct FixedFreedoms {
  std::array<bool, 3> translation{};
  std::array<bool, 3> axis{};
  bool rotation = false;
};
inline constexpr std::array freedom_names = {"x", "y", "z", "rx", "ry", "rz"};
// "x y z rx ry rz rotation", blanks or commas between. Error: unknown or empty word, with the accepted list.
FixedFreedoms parse_freedoms(const std::string& words, const std::string& call = "fix");
std::vector<std::string> held_words(const FixedFreedoms& freedoms);  // these words of what is held

// One side of a contact: a rigid body, or the elements of the cloth whose nodes all lie in a set ("all";
// "front" for one of several bodies; "front.left").
struct Party {
  std::string set;
  RigidPointer body;  // null: a set of the cloth
};

// The argument of a call that gives a number: its sentence, unit and range.
struct NumberRow {
  const char* sentence = "";
  const char* unit = "";
  Range range = {};
};

// Parts of a declaration, in the order of m:list(). A visitor hides what it wants to hear by functions
// of the same names and passes over the rest. `words` are those of m:list(), where # stands for the value;
// without words the value is not listed. What follows words and units describes the argument of the call, for
// calls that are made from tell(), and most visitors pass over it.
struct DeclarationVisitor {
  void set(const std::string&, const char* /*sentence*/ = "") {}
  void set(const std::string&, const std::string&) {}  // two edges
  void place(const char*) {}                           // in place of a set
  void sets(const std::vector<std::string>&) {}
  void sides(const std::vector<Party>&) {}
  void body(const RigidPointer&) {}
  void to(const RigidPointer&) {}  // the other end; null: the ground
  void freedoms(const FixedFreedoms&) {}
  void components(const Components&, const char* /*unit*/, const char* /*sentence*/ = "") {}
  void history(const char* /*name*/, const std::optional<History>&, const char* /*unit*/,
               const char* /*words*/ = "#", const char* /*sentence*/ = "") {}
  void time(const char* /*name*/, const std::optional<double>&, const char* /*words*/,
            const char* /*without*/ = "", const NumberRow& = {}) {}  // s, at which a step must end
  void number(const char* /*name*/, const std::optional<double>&, const char* /*words*/, double = 1,
              const NumberRow& = {}) {}
  void flag(const char* /*name*/, const std::optional<bool>&, const std::string& /*yes*/ = "",
            const std::string& /*no*/ = "") {}
  void text(const char* /*name*/, const std::string&, const std::string& /*words*/) {}
  void vector(const char* /*name*/, const std::optional<Vec3>&, const char* /*words*/,
              const NumberRow& /*range: of its length*/ = {}) {}
  void stiffness(const std::array<double, 3>&, const char* /*unit*/) {}
  void frame(const Mat3&) {}
};

struct Support {
  static constexpr const char* call() { return "fix"; }
  std::string set;
  FixedFreedoms fixed;
  Mat3 frame = global_frame();
  int symmetry =
      -1;  // 0, 1, 2: the set lies in a plane of symmetry normal to this global axis; -1: it does not
  static void tell(auto& d, auto& v) {
    v.set(d.set);
    v.freedoms(d.fixed);
    v.frame(d.frame);
  }
};
// In a plane of symmetry normal to axis 0, 1 or 2: that displacement and two rotations are fixed.
Support symmetry(const std::string& set, int axis);

struct PrescribedMotion {
  static constexpr const char* call() { return "move"; }
  std::string set;
  Components displacement;  // m, from the reference position, along the frame
  Mat3 frame = global_frame();
  static void tell(auto& d, auto& v) {
    v.set(d.set);
    v.components(d.displacement, "m");
    v.frame(d.frame);
  }
};
// Rigid rotation of directors, and with a centre also of nodes, about a fixed axis: d = R(angle) D, x = c + R
// (X - c).
struct PrescribedTurn {
  static constexpr const char* call() { return "turn"; }
  std::string set;
  Vec3 axis = Vec3::UnitZ();   // a model makes it a unit vector
  History angle;               // degrees
  std::optional<Vec3> centre;  // m
  static void tell(auto& d, auto& v) {
    v.set(d.set);
    v.history("angle", d.angle, "degrees");
    v.vector("axis", d.axis, " about #");
    v.vector("centre", d.centre, " through #");
  }
};
struct GroundSpring {
  static constexpr const char* call() { return "spring"; }
  static constexpr bool shared = true;  // by area or length
  std::string set;
  std::array<double, 3>
      stiffness{};  // N/m along the frame, to ground, total of the set, distributed like a force
  Mat3 frame = global_frame();
  static void tell(auto& d, auto& v) {
    v.set(d.set);
    v.frame(d.frame);
    v.stiffness(d.stiffness, "N/m");
  }
};

// A set whose joints may open: each corner of its elements gets a node of its own. Where the mesh is too
// coarse for the card's strength, it is lowered, the model refused, or the strength kept (which is right
// where no tear runs, as in a strip without a notch).
struct Zone {
  static constexpr const char* call() { return "tearable"; }
  static constexpr bool on_elements = true;
  std::string set;
  bool lower = true;
  std::uint64_t seed = 1;  // of the scatter of strengths
  std::string path = {};   // a set of nodes: yarns break there only; empty: everywhere in the zone
  bool keep = false;
  static void tell(auto& d, auto& v) {
    v.set(d.set);
    v.text("", "its joints may open", "#");
    v.text("path", d.path, d.path.empty() ? "" : "; yarns break at the nodes of # only");
  }
};

// The strength of the yarns at the elements of a set, over that of their card: for cards whose yarns soften.
// Where sets overlap, the factors multiply.
struct StrengthGiven {
  static constexpr const char* call() { return "strength"; }
  static constexpr bool on_elements = true;
  std::string set;
  double factor = 1;       // mean over the set
  double modulus = 0;      // of Weibull, with which it differs from element to element; 0: it does not
  std::uint64_t seed = 1;  // of that
  static void tell(auto& d, auto& v) {
    v.set(d.set);
    v.number("factor", d.factor, "# times the card's");
    v.number("modulus", d.modulus, d.modulus > 0 ? "Weibull modulus #" : "");
  }
};

// A band along an edge of cloth: elastic in a hem, or a cord that is drawn tight.
struct EdgeBand {
  static constexpr const char* call() { return "band"; }
  static constexpr bool by_name = true;
  static constexpr const char* sentence =
      "Puts a band along an edge: elastic in a hem, or with a high stiffness a cord that is drawn tight. It "
      "pulls and never pushes.";
  static constexpr const char* example =
      "m:band{ set='bottom', stiffness=20, ease=0.2, over=0.1 }\nassert(m:list()[1].kind == 'band')";
  std::string set;                  // nodes of an edge
  double stiffness = 0;             // N, force per strain of the band
  double ease = 0;                  // by what share of the edge the band is shorter
  std::optional<double> over = {};  // s, in which it becomes that short; empty: it is from the start
  static void tell(auto& d, auto& v) {
    v.set(d.set, "the nodes of an edge");
    v.number("stiffness", d.stiffness, "# N", 1, NumberRow{"force per strain of the band", "N", positive});
    v.number(
        "ease", d.ease, "# % shorter", 100,
        NumberRow{"by what share of the edge the band is shorter without force", "", {0, 1, false, true}});
    v.time("over", d.over, " over # s", "",
           NumberRow{"time in which it becomes that short; without it, it is from the start", "s", positive});
  }
};

// equal     the nodes of the set have equal displacements
// straight  the nodes stay on the line between the two extreme nodes of the set, on which they lie initially
// rigid     nodes and directors move as one rigid body
// periodic  u_b - u_a is equal for all pairs of the set and its partner; both directors of a pair are equal
enum class TieKind { equal, straight, rigid, periodic };
inline constexpr std::array tie_words = {"equal", "straight", "rigid", "periodic"};
struct Tie {
  static constexpr const char* call() { return "tie"; }
  TieKind kind;
  std::string set, partner;  // partner: only for periodic, and the name of a body for rigid
  FixedFreedoms freedoms;    // along global axes; empty for a rigid set
  static void tell(auto& d, auto& v) {
    v.set(d.set);
    v.text("tie", tie_words.at(static_cast<std::size_t>(d.kind)),
           d.partner.empty() ? "#" : "# with " + d.partner);
    v.text("partner", d.partner, "");
    v.freedoms(d.freedoms);
  }
};

// A load on a body at its centre: a force, or a moment about it, along global axes.
struct BodyLoad {
  const char* call() const { return moment ? "moment" : "force"; }
  RigidPointer body;
  Components total = {};  // N or N m
  bool moment = false;
  static void tell(auto& d, auto& v) {
    v.body(d.body);
    v.components(d.total, d.moment ? "N m" : "N");
  }
};

struct ForceLoad {
  static constexpr const char* call() { return "force"; }
  static constexpr bool is_load = true, shared = true;
  static constexpr const char* sentence =
      "Loads a node set with a total force; a single node takes it whole. Loads a rigid body at its centre "
      "(dynamic runs need its mass), which then moves in the directions that m:fix does not hold.";
  static constexpr const char* example = "m:force('top', { y=fabric.ramp(10, 1) })";
  static BodyLoad of_body(RigidPointer body) { return {std::move(body)}; }
  std::string set;
  Components total;  // N, distributed by tributary length (edges) or area; a single node gets all of it
  Mat3 frame = global_frame();
  static void tell(auto& d, auto& v) {
    v.set(d.set);
    v.components(d.total, "N", "{x=, y=, z=}: the total force, shared by length or area");
    v.frame(d.frame);
  }
};
struct MomentLoad {
  static constexpr const char* call() { return "moment"; }
  static constexpr bool is_load = true, shared = true;
  static constexpr const char* sentence =
      "Loads the directors of a node set with a moment, shared by length or area; or a rigid body about its "
      "centre.";
  static constexpr const char* example = "m:moment('top', { x=fabric.ramp(1e-3, 1) })";
  static BodyLoad of_body(RigidPointer body) { return {std::move(body), {}, true}; }
  std::string set;
  Components total;  // N m about the axes of the frame, which stay fixed in space; distributed like a force
  Mat3 frame = global_frame();
  static void tell(auto& d, auto& v) {
    v.set(d.set);
    v.components(d.total, "N m", "{x=, y=, z=}: the total moment about axes that stay fixed in space");
    v.frame(d.frame);
  }
};
struct TractionLoad {
  static constexpr const char* call() { return "traction"; }
  static constexpr bool is_load = true, shared = true;
  static constexpr const char* sentence =
      "Loads a node set with a dead traction on its reference area, or a line load on its reference edges.";
  static constexpr const char* example = "m:traction('top', { y=100 })";
  std::string set;
  Components intensity;  // dead load: N/m^2 of reference area if the set has whole elements, else N/m of edge
  Mat3 frame = global_frame();
  static void tell(auto& d, auto& v) {
    v.set(d.set);
    v.components(d.intensity, "N/m^2 or N/m",
                 "{x=, y=, z=}: per area where the set holds whole elements, else per edge length");
    v.frame(d.frame);
  }
};
struct PressureLoad {
  static constexpr const char* call() { return "pressure"; }
  static constexpr bool is_load = true;
  static constexpr bool on_elements = true;
  static constexpr const char* sentence =
      "Loads elements with a pressure that follows the surface (its load stiffness is in the tangent).";
  static constexpr const char* example = "m:pressure(fabric.ramp(50, 1))";
  std::string set = "all";
  History value = {};  // Pa, along the shell normal, which follows the surface
  static void tell(auto& d, auto& v) {
    v.set(d.set, "name of a node set; the elements all of whose nodes are in it");
    v.history("value", d.value, "Pa", "#", "pressure, positive along the shell normal");
  }
};
struct CentrifugalLoad {
  static constexpr const char* call() { return "centrifuge"; }
  static constexpr bool is_load = true, by_name = true;
  static constexpr const char* sentence =
      "Loads cloth with centrifugal forces, as in a frame that turns steadily: mass times distance from the "
      "axis times the square of the speed. They follow the cloth (their stiffness is in the tangent). Forces "
      "of Coriolis and of a changing speed are not among them.";
  static constexpr const char* example =
      "m:fix('bottom', 'x y z'):centrifuge{ speed=fabric.ramp(3600, 1), axis={0, 0, 1} }";
  std::string set = "all";
  History speed = {};               // degrees/s
  Vec3 axis = Vec3::UnitZ();        // of any nonzero length
  std::optional<Vec3> centre = {};  // m, default the origin
  static void tell(auto& d, auto& v) {
    v.set(d.set, "name of a set of nodes, with their mass");
    v.history("speed", d.speed, "degrees/s", "#", "of turning");
    v.vector("axis", d.axis, " about #", NumberRow{"{x, y, z}: direction of the axis", "", positive});
    v.vector("centre", d.centre, " through #",
             NumberRow{"{x, y, z}, m: a point of the axis; default {0, 0, 0}"});
  }
};
// The last one declared replaces those before.
struct Gravity {
  static constexpr const char* call() { return "gravity"; }
  Components acceleration;  // m/s^2
  static void tell(auto& d, auto& v) {
    v.set("all");
    v.components(d.acceleration, "m/s^2");
  }
};

// Velocity of a rigid body: linear + spin x (X - centre); a director rotates with the spin.
struct RigidVelocity {
  Vec3 linear = Vec3::Zero();  // m/s
  Vec3 spin = Vec3::Zero();    // rad/s
  Vec3 centre = Vec3::Zero();  // m
};
inline Vec3 in_degrees(const Vec3& radians) { return radians * 180 / std::numbers::pi; }
// Velocity at time 0 of the nodes and directors of a set, for dynamic runs: one rigid motion for all, or for
// each node X the motion that a function returns for it.
struct InitialVelocity {
  static constexpr const char* call() { return "velocity"; }
  std::string set;
  Vec3 linear = Vec3::Zero();  // m/s
  Vec3 spin = Vec3::Zero();    // rad/s
  Vec3 centre = Vec3::Zero();  // m
  std::function<RigidVelocity(const Vec3& X)> place = {};
  RigidVelocity at(const Vec3& X) const { return place ? place(X) : RigidVelocity{linear, spin, centre}; }
  static void tell(auto& d, auto& v) {
    v.set(d.set);
    v.flag("by_place", static_cast<bool>(d.place), "function of place");
    if (d.place) return;
    v.vector("linear", d.linear, "# m/s");
    v.vector("spin", in_degrees(d.spin), d.spin.isZero() ? "" : "spin # degrees/s");
    v.vector("centre", d.centre, d.spin.isZero() ? "" : " about #");
  }
};

struct BodyTurn {
  Vec3 axis = Vec3::UnitZ();        // of any nonzero length
  History angle;                    // degrees
  std::optional<Vec3> centre = {};  // m, default the body's
};
struct BodyMotion {
  static constexpr const char* call() { return "move"; }
  RigidPointer body;
  Components displacement;  // m, from the declared position, global
  std::optional<BodyTurn> turn;
  static void tell(auto& d, auto& v) {
    v.body(d.body);
    v.components(d.displacement, "m");
    if (!d.turn) return;
    v.history("angle", d.turn->angle, "degrees", "turn #");
    v.vector("axis", d.turn->axis, " about #");
    v.vector("centre", d.turn->centre, "");
  }
};
// Ties the centre of a body to the ground or to the centre of another body, along global axes: a spring, or a
// damper, which resists the difference of their velocities.
struct BodySpring {
  const char* call() const { return damper ? "damper" : "spring"; }
  RigidPointer body;
  Vec3 stiffness = Vec3::Zero();  // N/m; of a damper N s/m
  bool damper = false;
  RigidPointer to;                 // null: the ground
  std::optional<Vec3> place = {};  // m, of the centre when a spring to the ground is slack; default at time 0
  static void tell(auto& d, auto& v) {
    v.body(d.body);
    v.stiffness({d.stiffness[0], d.stiffness[1], d.stiffness[2]}, d.damper ? "N s/m" : "N/m");
    v.vector("slack", d.place, d.to ? "" : ", slack at # m");
    v.to(d.to);
  }
};
// Directions in which the centre of a body is held, and axes about which it does not turn, global.
struct BodySupport {
  static constexpr const char* call() { return "fix"; }
  RigidPointer body;
  std::array<bool, 3> moves{}, turns{};  // whether held
  static void tell(auto& d, auto& v) {
    v.body(d.body);
    v.freedoms({d.moves, d.turns, false});
  }
};
struct BodyVelocity {  // initial velocity of a free body
  static constexpr const char* call() { return "velocity"; }
  RigidPointer body;
  Vec3 linear = Vec3::Zero();  // m/s
  Vec3 spin = Vec3::Zero();    // rad/s
  static void tell(auto& d, auto& v) {
    v.body(d.body);
    v.vector("linear", d.linear, "# m/s");
    v.vector("spin", in_degrees(d.spin), "spin # degrees/s");
  }
};

struct ContactGiven {
  static constexpr const char* call() { return "contact"; }
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
  static void tell(auto& d, auto& v) {
    v.sides(d.between);
    v.number("friction", d.friction, d.across ? "friction # along the warp" : "friction #");
    v.number("static_friction", d.sticking, "static #");
    v.number("weft_friction", d.across, "# across");
    v.number("film_viscosity", d.viscosity, "film of # Pa s");
    v.number("film_thickness", d.film, "# m");
    if (d.film_speed > 0) v.number("film_speed", d.film_speed, "thinner above # m/s");
    if (d.film_speed > 0) v.number("film_exponent", d.film_exponent, "exponent #");
    v.number("thickness", d.thickness, "thickness # m");
    v.number("stiffness", d.stiffness, "stiffness # Pa/m");
    v.number("restitution", d.restitution, d.restitution != usual_restitution ? "restitution #" : "");
    v.number("settle", d.settle, "settles over # s");
  }
};

// The one list of what a model is told, in the order of m:list(). A new kind comes last.
class Declarations {
 public:
  template <class D>
  std::vector<D>& all() {
    return std::get<std::vector<D>>(lists_);
  }
  template <class D>
  const std::vector<D>& all() const {
    return std::get<std::vector<D>>(lists_);
  }
  // look(all) for the list of each kind.
  template <class Look>
  void each_kind(Look look) const {
    std::apply([&look](const auto&... all) { (look(all), ...); }, lists_);
  }

 private:
  std::tuple<std::vector<Support>, std::vector<PrescribedMotion>, std::vector<PrescribedTurn>,
             std::vector<GroundSpring>, std::vector<Zone>, std::vector<StrengthGiven>,
             std::vector<CreaseGiven>, std::vector<EdgeBand>, std::vector<Seam>, std::vector<Tie>,
             std::vector<ForceLoad>, std::vector<MomentLoad>, std::vector<TractionLoad>,
             std::vector<PressureLoad>, std::vector<GasPointer>, std::vector<Gravity>,
             std::vector<InitialVelocity>, std::vector<BodyMotion>, std::vector<BodyLoad>,
             std::vector<BodySpring>, std::vector<BodySupport>, std::vector<BodyVelocity>,
             std::vector<ContactGiven>, std::vector<CentrifugalLoad>>
      lists_;
};

// A declaration itself: that of gas is kept by a pointer, which a deck has too.
template <class D>
const D& plain(const D& declaration) {
  return declaration;
}
inline const GasGiven& plain(const GasPointer& gas) { return *gas; }

template <class D>
void tell(const D& declaration, auto& visitor) {
  std::decay_t<decltype(plain(declaration))>::tell(plain(declaration), visitor);
}

template <class D>
constexpr bool is_load = requires {
  D::is_load;
};

// Tells the visitor each declaration of the kinds that are loads of sets.
template <class Visitor>
void tell_loads(const Declarations& declarations, Visitor& visitor) {
  declarations.each_kind([&visitor]<class D>(const std::vector<D>& all) {
    if constexpr (is_load<D>)
      for (const D& load : all) {
        visitor.about(load);
        D::tell(load, visitor);
      }
  });
}

// Throws what is wrong with the values of a declaration by itself.
class DeclarationCheck : public DeclarationVisitor {
 public:
  DeclarationCheck(const mesh::Mesh& mesh, std::string call, bool on_elements, bool shared)
      : mesh_(mesh), call_(std::move(call)), on_elements_(on_elements), shared_(shared) {}
  void set(const std::string& name, const char* = "");
  void components(const Components& value, const char* unit, const char* = "");
  void stiffness(const std::array<double, 3>& value, const char* unit);
  void number(const char* name, const std::optional<double>& value, const char* = "", double = 1,
              const NumberRow& row = {});
  void time(const char* name, const std::optional<double>& value, const char* = "", const char* = "",
            const NumberRow& row = {}) {
    number(name, value, "", 1, row);
  }
  void vector(const char* name, const std::optional<Vec3>& value, const char* = "",
              const NumberRow& row = {});

 private:
  const mesh::Mesh& mesh_;
  std::string call_;
  bool on_elements_;  // the set has to have whole ones
  bool shared_;       // among the nodes of the set, by area or length
};

// Errors: an unknown set, or one without a whole element for what is of elements, or with nodes that would
// get no share of what is shared by area or length; no component given; a stiffness below 0; a number out of
// its row's range, or a vector whose length is.
template <class D>
void check_values(const mesh::Mesh& mesh, const D& declaration) {
  constexpr bool on_elements = requires { D::on_elements; }
  , shared = requires { D::shared; };
  DeclarationCheck check(mesh, declaration.call(), on_elements, shared);
  D::tell(declaration, check);
}

// Further errors of single kinds.
class Model;
void check(const Model&, PrescribedTurn&);         // an axis without a direction
void check(const Model&, const InitialVelocity&);  // a number that is not finite
void check(const Model&, const Zone&);             // an unknown path
// A set of cards none of which has a law that softens; a number out of range.
void check(const Model&, const StrengthGiven&);
// Those of edges_of().
void check(const Model&, const CreaseGiven&);
// A time, ease, stiffness, strength or energy out of range; strength without energy, or energy without it.
void check(const Model&, const Seam&);
// A degree of freedom that this kind does not tie; no freedom given; a rigid set of one node; a periodic tie
// without a partner.
void check(const Model&, const Tie&);
// Numbers out of range; a vent to a volume of another model or with another gas.
void check(const Model&, const GasPointer&);
// A free body, a moving surface, a body that is moved already, nothing given, a zero axis.
void check(const Model&, const BodyMotion&);
// A body that is moved, or a moving surface; a number that is not finite; a spring to itself; a plane that
// may turn; two axes of turning held but not the third.
void check(const Model&, const BodyLoad&);
void check(const Model&, const BodySpring&);
void check(const Model&, const BodySupport&);
// A body that is not free, a body that has a velocity already, a number that is not finite.
void check(const Model&, const BodyVelocity&);
// A set without a whole element, fewer than two sides, only bodies whose places are given, a free body with
// another one that it does not meet or with friction between them, negative friction, a thickness or
// stiffness that is not positive.
void check(const Model&, const ContactGiven&);

}  // namespace fabricsh::model
