#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "base/number.hpp"
#include "geometry/box.hpp"
#include "law/bending_spring.hpp"
#include "law/check_parts.hpp"
#include "law/law.hpp"
#include "law/transverse.hpp"
#include "mechanics/terms/cloth.hpp"
#include "run/diagnosis.hpp"
#include "run/place_text.hpp"

namespace fabricsh::run {

std::string beyond_text(const Beyond& b) {
  const char* component = b.yarn == "warp" ? "E11" : b.yarn == "weft" ? "E22" : "E12";
  const std::string element = "element " + std::to_string(b.element + 1);
  const std::string who = b.yarn == "shear" ? element + " is sheared to "
                                            : "the " + b.yarn + " of " + element + " is strained to ";
  return who + component + " = " + number(b.strain) + ", the card was tested to " + number(b.tested);
}

// --- loads that begin with a jump

namespace {

// Times as fractions of the duration. There are several later ones, since a history may be zero again at one.
constexpr double kEarly = 1e-9, kLater[] = {0.37e-3, 0.61e-3, 1e-3};

// The value immediately after time 0; 0 if it begins at zero and grows.
double jump_of(const model::History& h, double duration) {
  if (const double at_once = h.value(0); at_once != 0) return at_once;
  const double early = h.value(kEarly * duration);
  double later = 0;
  for (const double fraction : kLater) later = std::max(later, std::abs(h.value(fraction * duration)));
  return std::abs(early) > 0.5 * later ? early : 0;
}

// Collects the jumps among the histories of a model's loads or motions.
class JumpFinder {
 public:
  JumpFinder(double duration, std::vector<Jump>& found) : duration_(duration), found_(found) {}
  void at(const std::string& what, const model::Components& components, const char* unit) {
    for (std::size_t i = 0; i < 3; ++i)
      if (components[i]) at(what, std::string(1, "xyz"[i]) + " = ", *components[i], unit);
  }
  void at(const std::string& what, const std::string& component, const model::History& h, const char* unit) {
    if (const double jump = jump_of(h, duration_); jump != 0)
      found_.push_back({what + " (" + component + number(jump) + " " + unit + ")", jump});
  }

 private:
  double duration_;
  std::vector<Jump>& found_;
};

// Tells it the histories of each load.
class LoadJumps : public model::DeclarationVisitor {
 public:
  explicit LoadJumps(JumpFinder& found) : found_(found) {}
  template <class Load>
  void about(const Load& load) {
    what_ = std::string("the ") + load.call() + " on '" + load.set + "'";
  }
  void components(const model::Components& value, const char* unit, auto...) {
    found_.at(what_, value, unit);
  }
  void history(const char*, const std::optional<model::History>& h, const char* unit, auto...) {
    if (h) found_.at(what_, "", *h, unit);
  }

 private:
  JumpFinder& found_;
  std::string what_;
};

std::string list(const std::vector<Jump>& all) {
  constexpr std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, all.size()); ++i)
    text += (i == 0 ? "" : i + 1 == all.size() ? " and " : ", ") + all[i].words;
  if (all.size() > most) text += " and " + std::to_string(all.size() - most) + " more";
  return text;
}

}  // namespace

Jumps find_jumps(const model::Model& model, double duration) {
  Jumps jumps;
  JumpFinder loads(duration, jumps.loads), motions(duration, jumps.motions);
  const auto of = [](const char* what, const std::string& set) { return what + (" '" + set + "'"); };
  loads.at("gravity", model.gravity(), "m/s^2");
  LoadJumps of_loads(loads);
  model::tell_loads(model.declarations(), of_loads);
  for (const auto& m : model.all<model::PrescribedMotion>())
    motions.at(of("the motion of", m.set), m.displacement, "m");
  for (const auto& t : model.all<model::PrescribedTurn>())
    motions.at(of("the turn of", t.set), "", t.angle, "degrees");
  return jumps;
}

std::string moved_bodies_text(const model::Model& model) {
  std::vector<Jump> moved;
  for (const model::BodyMotion& motion : model.interactions().all<model::BodyMotion>()) {
    const std::string what = "the motion of the " + model.interactions().name_of(*motion.body);
    const auto look = [&](const std::string& component, const model::History& h, const char* unit) {
      if (const double at = h.value(0); at != 0)
        moved.push_back({what + " (" + component + " = " + number(at) + " " + unit + ")", at});
    };
    for (std::size_t i = 0; i < 3; ++i)
      if (const auto& h = motion.displacement[i]) look(std::string(1, "xyz"[i]), *h, "m");
    if (motion.turn) look("turn", motion.turn->angle, "degrees");
  }
  if (moved.empty()) return {};
  return list(moved) + (moved.size() > 1 ? " are" : " is") + " not zero at time 0; the run starts with the " +
         (moved.size() > 1 ? "bodies" : "body") + " there";
}

std::string nip_text(const std::string& run, const mechanics::Nip& nip) {
  const std::string plies = nip.plies == 1 ? "the cloth" : std::to_string(nip.plies) + " plies";
  const bool fits = std::isfinite(nip.pressure), barrier = nip.pressure > nip.carried;
  return "warning: " + run + ": at node " + std::to_string(nip.node + 1) + " the " + nip.first + " and the " +
         nip.second + ", whose places are given, are " + number(nip.gap, 3) + " m apart, and " + plies +
         " between them " + (nip.plies == 1 ? "needs " : "need ") + number(nip.thickness, 3) +
         " m in contact: " +
         (!fits ? "less than the " + number(nip.floor, 3) +
                      " m that contact allows at least, so that no pressure "
                      "holds it there"
                : "by the law of contact the pressure is " + number(nip.pressure, 2) + " Pa from the start" +
                      (barrier ? ", of which " + number(nip.carried, 2) + " Pa are carried before its barrier"
                               : std::string())) +
         "; a gap of at least " + number(nip.thickness, 3) +
         " m, or m:force on one of them in place of a gap, does not do that";
}

std::vector<std::string> crowding_texts(const mechanics::Contacts& contact) {
  constexpr double much = 0.01;  // of the area of the body
  const auto& surfaces = contact.surfaces();
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < surfaces.meetings().size(); ++i) {
    const auto& law = surfaces.law(i);
    const int body = surfaces.body_of(surfaces.scene().interactions()[i].second);
    const model::Facets* const facets =
        body < 0 ? nullptr : surfaces.bodies().body(static_cast<std::size_t>(body)).facets();
    if (facets == nullptr || surfaces.meetings()[i].bodies) continue;
    const double reach = law.gap() - law.floor();
    const model::Crowding all = model::crowding(*facets, reach);
    std::string words;
    if (all.share > much)
      words = number(100 * all.share, 3) + " % of its area has another sheet of facets within " +
              number(all.nearest, 3) + " m, as about " + place_text(all.sheets);
    if (all.beside > much)
      words += (words.empty() ? "" : ", and ") + number(all.length, 3) +
               " m of its free edges have facets in front of them that are not joined, the nearest " +
               number(all.gap, 3) + " m away, as about " + place_text(all.edges);
    if (!words.empty())
      lines.push_back(
          surfaces.meetings()[i].names + ": " + words + ": within the range of contact, " + number(reach, 3) +
          " m, each of them presses, so that a place counts up to twice; expected sheets that are "
          "farther apart and facets that share their corners, or a smaller thickness=");
  }
  return lines;
}

std::string warning_text(const Jumps& jumps, double duration) {
  if (jumps.loads.empty()) return {};
  const std::string value = number(jumps.loads.front().value);
  return list(jumps.loads) + (jumps.loads.size() > 1 ? " are" : " is") +
         " at full value at time 0 and applied in the first step; fabric.ramp(" + value + ", " +
         number(duration) + ") in place of " + value + " brings it up step by step";
}

std::string full_text(const Jumps& jumps) {
  std::vector<Jump> all = jumps.loads;
  all.insert(all.end(), jumps.motions.begin(), jumps.motions.end());
  if (all.empty()) return "a load is";
  return list(all) + (all.size() > 1 ? " are" : " is");
}

// --- loads on supports

namespace {

constexpr double kAlong = 1e-9;  // cosine of the angle between a load and a free direction

// Whether the supports leave the node no motion along e.
bool is_held(const mechanics::NodeFreedoms& node, const Vec3& e) {
  for (int c = 0; c < 3; ++c) {
    const auto equation = node.equation[static_cast<std::size_t>(c)];
    const bool moves = equation >= 0 || equation == mechanics::tied;
    if (moves && std::abs(node.frame.row(c).dot(e)) > kAlong) return false;
  }
  return true;
}

// As far as samples show.
bool is_zero(const model::History& h, double duration) {
  constexpr int samples = 37;
  for (int i = 0; i <= samples; ++i)
    if (h.value(duration * i / samples) != 0) return false;
  return true;
}

void find_supported_loads(const std::string& what, const mesh::NodeSet& set,
                          const model::Components& components, const Mat3& frame, bool area,
                          const mechanics::Assembly& assembly, double duration,
                          std::vector<std::string>& lines) {
  for (int c = 0; c < 3; ++c) {
    const auto& history = components[static_cast<std::size_t>(c)];
    if (!history || is_zero(*history, duration)) continue;
    const Vec3 e = frame.row(c).transpose();
    const auto held = static_cast<std::size_t>(std::count_if(set.begin(), set.end(), [&](mesh::Index n) {
      return is_held(assembly.dofs().freedoms().nodes[static_cast<std::size_t>(n)], e);
    }));
    const bool all = held == set.size(), one = set.size() == 1;
    if (area ? !all : 2 * held <= set.size()) continue;
    const std::string of =
        one   ? "its node, which is"
        : all ? "any of its " + std::to_string(held) + " nodes, which are"
              : std::to_string(held) + " of its " + std::to_string(set.size()) + " nodes, which are";
    const std::string line = what + " along " + "xyz"[c] + (frame.isIdentity() ? "" : " of its frame") +
                             " moves nothing at " + of + " fixed or moved there: supports take it up";
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
  }
}

}  // namespace

std::vector<std::string> idle_loads(const model::Model& model, const mechanics::Assembly& assembly,
                                    double duration) {
  std::vector<std::string> lines;
  const auto look = [&](const char* what, const auto& load, const model::Components& components) {
    const auto& set = model.mesh().set(load.set);
    find_supported_loads(what + (" '" + load.set + "'"), set, components, load.frame,
                         !model.mesh().elements_in(set).empty(), assembly, duration, lines);
  };
  for (const auto& f : model.all<model::ForceLoad>()) look("the force on", f, f.total);
  for (const auto& t : model.all<model::TractionLoad>()) look("the traction on", t, t.intensity);
  return lines;
}

// --- loads on a part of something symmetric

namespace {

constexpr double kOffMiddle = 1e-6;  // of a radius

bool cuts(const model::SymmetryPlane& plane, const model::Rigid& body, double extent) {
  const auto facets = model::shown(body, extent);
  double low = plane.at, high = plane.at;
  for (const Vec3& x : facets.vertices) {
    low = std::min(low, x[plane.axis]);
    high = std::max(high, x[plane.axis]);
  }
  const double near = 1e-6 * extent;
  return low < plane.at - near && high > plane.at + near;
}

// Whether the plane cuts a ball, or a rod along it, off the middle, so that the whole would have two of them
// that overlap. Other shapes may end beyond the plane, where no cloth is.
bool cuts_off_middle(const model::SymmetryPlane& plane, const model::RigidShape& shape) {
  const auto cut = [&](double middle, double radius) {
    const double distance = std::abs(middle - plane.at);
    return distance > kOffMiddle * radius && distance < (1 - kOffMiddle) * radius;
  };
  if (const auto* ball = std::get_if<model::Sphere>(&shape))
    return cut(ball->centre[plane.axis], ball->radius);
  const auto* rod = std::get_if<model::Cylinder>(&shape);
  return rod != nullptr &&
         std::abs(rod->to[plane.axis] - rod->from[plane.axis]) <= kOffMiddle * rod->radius &&
         cut(rod->from[plane.axis], rod->radius);
}

bool moves_across(const model::BodyMotion& motion, int axis, double duration) {
  const auto& along = motion.displacement[static_cast<std::size_t>(axis)];
  if (along && !is_zero(*along, duration)) return true;
  if (!motion.turn || is_zero(motion.turn->angle, duration)) return false;
  return Vec3::Unit(axis).cross(motion.turn->axis.normalized()).norm() > kAlong;
}

}  // namespace

void check_symmetric_loads(const model::Model& model, double duration) {
  const double extent = box_of(model.mesh().nodes).size().norm();
  for (const auto& plane : model::symmetry_planes(model)) {
    if (model.mesh().set(plane.set).size() == model.mesh().nodes.size()) continue;
    const auto& across = model.gravity()[static_cast<std::size_t>(plane.axis)];
    if (across && !is_zero(*across, duration))
      throw Error(
          "gravity: its " + std::string(1, "xyz"[plane.axis]) + " points across " + plane.words() +
          ", and would pull the part that is left out the other way: expected gravity in the plane, or "
          "the whole model");
    for (const model::BodyMotion& motion : model.interactions().all<model::BodyMotion>())
      if (moves_across(motion, plane.axis, duration) && cuts(plane, *motion.body, extent))
        throw Error("move: the " + model.interactions().name_of(*motion.body) + " is cut by " +
                    plane.words() +
                    ": expected a motion in the plane and a turn about its normal alone, or the whole model");
    for (const model::RigidPointer& body : model.interactions().bodies())
      if (!body->free() && cuts_off_middle(plane, body->shape()))
        throw Error("model: the " + model.interactions().name_of(*body) + " is cut by " + plane.words() +
                    " off its middle, so that the whole has two that overlap: expected its middle in the "
                    "plane, or the whole model");
  }
}

// --- bending

namespace {

constexpr double kInPlane = 1e-6;  // sine of the angle between a free direction and the surface

bool may_leave_surface(const mechanics::Assembly& assembly) {
  const auto d = assembly.state().d();
  for (std::size_t n = 0; n < assembly.dofs().reference().size(); ++n) {
    const auto& node = assembly.dofs().freedoms().nodes[n];
    const Eigen::Map<const Vec3> director(d.data() + 3 * n);
    for (int c = 0; c < 3; ++c) {
      const auto equation = node.equation[static_cast<std::size_t>(c)];
      const bool moves = equation >= 0 || equation == mechanics::tied;
      if (moves && std::abs(node.frame.row(c).dot(director)) > kInPlane) return true;
    }
  }
  return false;
}

std::string odd_bending(card::Card card, double thickness, const law::Law& law) {
  card.thickness = thickness;
  law::CheckReport report;
  law::check_bending(card, law, report);
  std::string words;
  for (const auto& item : report.items)
    if (item.severity == Severity::warning)
      words += (words.empty() ? "card '" + card.name + "': " : "; ") + item.key + ": " + item.text;
  return words;
}

}  // namespace

std::string bending_warning(const model::Model& model, const mechanics::Assembly& assembly) {
  std::string words;
  if (model.membrane()) return words;
  for (std::size_t r = 0; r < model.regions().size() && words.empty(); ++r) {
    const auto& section = model.sections()[r];
    const auto& plies = model.regions()[r].options.plies;
    if (plies.empty())
      words = odd_bending(model.regions()[r].card, section.thickness, *section.points.front().law);
    for (std::size_t i = 0; i < plies.size() && words.empty(); ++i)
      words = odd_bending(plies[i].card, plies[i].thickness,
                          *std::find_if(section.points.begin(), section.points.end(), [i](const auto& p) {
                             return p.ply == static_cast<int>(i);
                           })->law);
  }
  return words.empty() || !may_leave_surface(assembly) ? std::string() : words;
}

std::string shear_warning(const model::Model& model, const mechanics::Assembly& assembly) {
  constexpr double shows = 0.01;
  if (model.membrane() || !may_leave_surface(assembly)) return {};
  const double length = box_of(assembly.dofs().reference()).size().norm() / 2;
  for (std::size_t r = 0; r < model.regions().size(); ++r) {
    const auto& region = model.regions()[r];
    if (model.sections()[r].bends_apart || !region.options.plies.empty()) continue;
    const double t = model.sections()[r].thickness;
    const auto derived = law::derived_shear(region.card);
    for (std::size_t yarn = 0; yarn < 2; ++yarn) {
      const auto& d = derived[yarn];
      const double share = d.shear > 0 ? d.axis * t * t / (3 * d.shear * length * length) : 0;
      if (share <= shows) continue;
      return "card '" + region.card.name +
             "' bends through its thickness, with a modulus of transverse shear of " +
             number(1e-6 * d.shear, 3) + " MPa that is derived from its shear: bent along the " +
             (yarn == 0 ? "warp" : "weft") + " it adds " + number(100 * share, 2) +
             " % to the deflection of a strip of " + number(1e3 * length, 3) +
             " mm, half of this sheet, and more in shorter ones; " +
             (std::holds_alternative<card::Svk>(region.card.law)
                  ? "transverse={warp, weft} of the card states it, "
                  : "") +
             "bending={warp=, weft=, twist=} takes its place";
    }
  }
  return {};
}

namespace {

// m, of an element along its sides from corner 0 to 1 and from 1 to 2.
struct Sides {
  double first, second;
  Vec3 along;  // the first
};
Sides sides_of(const std::array<mesh::Index, 4>& e, const std::vector<Vec3>& X) {
  const auto at = [&](int i) -> const Vec3& {
    return X[static_cast<std::size_t>(e[static_cast<std::size_t>(i)])];
  };
  const Vec3 first = (at(1) - at(0) + at(2) - at(3)) / 2, second = (at(3) - at(0) + at(2) - at(1)) / 2;
  return {first.norm(), second.norm(), first.normalized()};
}

}  // namespace

// The moment M along the fibres couples the turn of an element's sides in its plane, u_y,x, with the splay of
// the directors, phi_y,x. Across elements of length h along and b across the fibres the first is held by the
// stretch of the softer yarns, A h^2 / b^2, and the second by the twist: M = c h / b sqrt(A B_twist). The
// factor c was measured on cantilevers of elements of 1.5 x 10 to 2.4 x 10 mm: 1.3 to 1.5. Where elements
// hold that bending by shear (element/shell4_geometry.cpp), A has 4 to 5 G b^2 / h^2 beside it, measured on 1
// x 10 and 1.5 x 10 mm.
std::string splay_warning(const model::Model& model, const mechanics::Assembly& assembly) {
  constexpr double elongated = 4, anisotropic = 1e3, measured = 1.3;
  if (model.membrane() || !may_leave_surface(assembly)) return {};
  const auto& X = assembly.dofs().reference();
  const auto& elements = model.mesh().elements;
  const double size = box_of(X).size().norm();
  double widest = size;  // m, radius
  std::string words;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    if (elements[e][3] < 0) continue;
    const auto element = static_cast<mesh::Index>(e);
    const auto& section = model.sections()[static_cast<std::size_t>(model.region_of(element))];
    if (!section.bends_apart) continue;
    const Sides sides = sides_of(elements[e], X);
    const double aspect = std::max(sides.first, sides.second) / std::min(sides.first, sides.second);
    if (aspect < elongated) continue;
    const auto modulus = law::by_direction(*section.points.front().law);
    const std::size_t stiff = modulus.axis[0] > modulus.axis[1] ? 0 : 1;
    if (modulus.axis[stiff] < anisotropic * std::max(modulus.axis[1 - stiff], modulus.shear)) continue;
    const auto [warp, weft] = assembly.cloth().readings().yarns(element);
    const bool short_along = (std::abs((stiff == 0 ? warp : weft).dot(sides.along)) > std::sqrt(0.5)) ==
                             (sides.first < sides.second);
    if (!short_along) continue;
    const double held = section.yarns_over_shear[stiff] > 0 ? 4 * aspect * aspect * modulus.shear : 0;
    const double moment =
        measured / aspect *
        std::sqrt((modulus.axis[1 - stiff] + held) * section.thickness * section.bending[2].rigidity);
    const double radius = law::stiffest(section.bending[stiff]) / moment;
    if (radius <= widest) continue;
    widest = radius;
    words = "quadrilaterals are " + number(aspect, 2) + " times as long across the " +
            (stiff == 0 ? "warp" : "weft") + " as along it, as element " + model.element_name(element) +
            ", and that direction is " + number(modulus.axis[stiff] / modulus.axis[1 - stiff], 2) +
            " times as stiff as the other: bent along it to less than about " +
            number(std::round(1e3 * radius), 4) + " mm of radius (" + number(moment, 2) +
            " N) their directors splay, and the sheet loses its stability where cloth does not; sides of one "
            "length, "
            "or triangles, do not";
  }
  return words;
}

// --- mechanisms

namespace {

constexpr double kNoStiffness = 1e-10;  // fraction of the largest eigenvalue below which a motion is free
constexpr double kDriven = 1e-6;        // work of the loads on a mechanism, relative to its upper bound

using Mode = Eigen::Matrix<double, 6, 1>;  // displacement of the centre, m; rotation times the length, m

// The resistance of supports and springs to the six rigid motions of the sheet in its present configuration.
class RigidMotions {
 public:
  explicit RigidMotions(const mechanics::Assembly& assembly) : assembly_(assembly) {
    const auto x = assembly.state().x();
    const auto count = static_cast<std::size_t>(assembly.dofs().reference().size());
    centre_.setZero();
    for (std::size_t n = 0; n < count; ++n) centre_ += at(x, n) / static_cast<double>(count);
    for (std::size_t n = 0; n < count; ++n) length_ = std::max(length_, (at(x, n) - centre_).norm());
    for (std::size_t n = 0; n < count; ++n) add_node(n);
  }
  void add_spring(const model::GroundSpring& spring, const mesh::NodeSet& nodes) {
    for (const auto n : nodes)
      for (int i = 0; i < 3; ++i)
        if (spring.stiffness[static_cast<std::size_t>(i)] > 0)
          add_direction(static_cast<std::size_t>(n), spring.frame.row(i).transpose());
  }
  // The motions without resistance.
  std::vector<Mode> free() const {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> modes(resistance_);
    std::vector<Mode> all;
    for (int i = 0; i < 6; ++i)
      if (modes.eigenvalues()[i] <= kNoStiffness * std::max(modes.eigenvalues()[5], 1e-30))
        all.push_back(modes.eigenvectors().col(i));
    return all;
  }
  Vec3 velocity(const Mode& mode, std::size_t n) const {
    return mode.head<3>() + turning(mode).cross(at(assembly_.state().x(), n) - centre_);
  }
  double length() const { return length_; }
  std::string words(const Mode& mode) const {
    const Vec3 turn = turning(mode), move = mode.head<3>();
    const double rate = turn.norm();
    if (rate * length_ < 1e-6 * move.norm()) return "move along " + place_text(move.normalized(), "");
    const Vec3 point = centre_ + turn.cross(move) / (rate * rate);
    return "turn about the line through " + place_text(point, " m") + " along " + place_text(turn / rate, "");
  }

 private:
  static Eigen::Map<const Vec3> at(std::span<const double> v, std::size_t n) {
    return Eigen::Map<const Vec3>(v.data() + 3 * n);
  }
  Vec3 turning(const Mode& mode) const { return mode.tail<3>() / length_; }
  void add_row(const Mode& row) { resistance_ += row * row.transpose(); }
  void add_direction(std::size_t n, const Vec3& e) {
    Mode row;
    row << e, (at(assembly_.state().x(), n) - centre_).cross(e) / length_;
    add_row(row);
  }
  // The director cannot rotate towards b.
  void add_rotation(const Vec3& d, const Vec3& b) {
    Mode row;
    row << Vec3::Zero(), d.cross(b);
    add_row(row);
  }
  void add_node(std::size_t n) {
    const auto& node = assembly_.dofs().freedoms().nodes[n];
    const auto stays = [&](std::size_t i) {
      return node.equation[i] < 0 && node.equation[i] != mechanics::tied;
    };
    for (int c = 0; c < 3; ++c)
      if (stays(static_cast<std::size_t>(c))) add_direction(n, node.frame.row(c).transpose());
    const Vec3 d = at(assembly_.state().d(), n), b1 = at(assembly_.state().b1(), n);
    if (stays(3)) add_rotation(d, b1);
    if (stays(4)) add_rotation(d, d.cross(b1));
  }

  const mechanics::Assembly& assembly_;
  Vec3 centre_;
  double length_ = 0;
  Eigen::Matrix<double, 6, 6> resistance_ = Eigen::Matrix<double, 6, 6>::Zero();
};

// Whether, and how much, the loads at a time drive the mode; sets what a small support must hold.
void look_at_loads(const RigidMotions& motions, const mechanics::Assembly& assembly, const Mode& mode,
                   double time, Mechanism& found) {
  std::vector<double> dead;
  assembly.terms().external(time, dead);
  std::vector<double> follower(dead.size()), on_directors(dead.size());
  for (const auto* const load : assembly.terms().all<mechanics::FollowerLoad>())
    load->add_follower(time, assembly.trial(), follower, on_directors);
  double most = 0, load = 0;
  Vec3 work = Vec3::Zero(), along = Vec3::Zero();
  for (std::size_t n = 0; n < assembly.dofs().reference().size(); ++n) {
    const Vec3 v = motions.velocity(mode, n);
    const Vec3 f =
        Eigen::Map<const Vec3>(dead.data() + 3 * n) + Eigen::Map<const Vec3>(follower.data() + 3 * n);
    work += f.cwiseProduct(v);
    along += f.cwiseProduct(v).cwiseAbs();
    most += f.norm() * v.norm();
    load += f.norm();
  }
  if (std::abs(work.sum()) <= kDriven * most) return;
  found.driven = true;
  const double stiffness = 2 * load / motions.length();
  if (stiffness <= found.stiffness) return;
  found.stiffness = stiffness;
  along.maxCoeff(&found.axis);
}

}  // namespace

namespace {

// Of several free motions those along and about the axes, if not all are free: " (along z, about x)".
std::string axes_of(const std::vector<Mode>& free) {
  constexpr double kIn = 1e-6;  // what is left of a motion that lies among them
  std::string along, about;
  for (int i = 0; i < 6 && free.size() < 6; ++i) {
    double inside = 0;
    for (const Mode& mode : free) inside += mode[i] * mode[i];
    if (inside < 1 - kIn) continue;
    std::string& list = i < 3 ? along : about;
    list += (list.empty() ? (i < 3 ? "along " : "about ") : " and ") + std::string(1, "xyz"[i % 3]);
  }
  if (along.empty() && about.empty()) return {};
  return " (" + along + (along.empty() || about.empty() ? "" : ", ") + about + ")";
}

}  // namespace

Mechanism find_mechanism(const model::Model& model, const mechanics::Assembly& assembly,
                         const std::vector<double>& times) {
  RigidMotions motions(assembly);
  for (const auto& spring : model.all<model::GroundSpring>())
    motions.add_spring(spring, model.mesh().set(spring.set));
  const auto free = motions.free();
  Mechanism found;
  for (const Mode& mode : free)
    for (const double time : times) look_at_loads(motions, assembly, mode, time, found);
  if (free.size() == 1) found.words = motions.words(free.front());
  found.ways = static_cast<int>(free.size());
  if (free.size() > 1)
    found.words = "move as a whole in " + std::to_string(free.size()) + " ways" + axes_of(free);
  return found;
}

}  // namespace fabricsh::run
