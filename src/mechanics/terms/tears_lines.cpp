// Where yarns can break, and with what strength; and the lines along which joints can open.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "base/error.hpp"
#include "base/number.hpp"
#include "law/point.hpp"
#include "mechanics/scatter.hpp"
#include "mechanics/terms/tears.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kAlong = std::numbers::pi / 180;  // rad: how far edges may be off the yarns
constexpr double kFine = 4;  // elements per l = E' G / f^2, from which on the mesh does not matter
constexpr double kNever = std::numeric_limits<double>::infinity();
const char* const kFamily[] = {"warp", "weft"};

const std::optional<card::YarnBreak>& of_family(const card::Rupture& rupture, int family) {
  return family == 0 ? rupture.warp : rupture.weft;
}

// Strength over its mean: after Weibull, for yarns of a length (m). Those side by side within a width (m) are
// drawn one by one; together they have the mean of their strengths.
double scattered(const card::YarnBreak& yarn, double length, double width, std::uint64_t seed, Index place,
                 int family) {
  if (!yarn.scatter) return 1;
  const card::StrengthScatter& s = *yarn.scatter;
  const double size = s.length ? std::pow(*s.length / length, s.exponent.value_or(1 / s.modulus)) : 1;
  const int yarns = yarn.yarns ? static_cast<int>(std::clamp(std::round(*yarn.yarns * width), 1.0, 1e6)) : 1;
  double sum = 0;
  for (int i = 0; i < yarns; ++i) sum += weibull_strength(s.modulus, draw(seed, place, family + 2 * i), size);
  return sum / yarns;
}

// Tension stiffness per width (N/m) at the strain at which a family carries `strength`, N/m; and that of
// shear there. A card that does not come so far is taken where it ends.
struct Stiffness2 {
  double tension = 0, shear = 0;
};
Stiffness2 stiffness_at(const section::Section& section, int family, double strength) {
  constexpr double step = 2e-3, most = 1;  // strain
  const double t = section.thickness;
  law::PointDriver point(section.points.front().law);
  Stiffness2 out;
  try {
    double stretch = 1, force = 0;
    for (double E = step; E < most; E += step) {
      const auto now = point.uniaxial(family * std::numbers::pi / 2, E);
      const double to = std::sqrt(1 + 2 * E), carried = now.S * to * t;
      out.tension = (carried - force) / (to - stretch);
      stretch = to;
      force = carried;
      if (force >= strength) break;
    }
    const auto before = point.now(), after = point.strain({}, {}, before.E12 + 1e-4);
    out.shear = t * (after.S12 - before.S12) / 2e-4;
  } catch (const NumericalFailure&) {
  }
  return out;
}

}  // namespace

bool Tears::possible(const model::Model& model) {
  return !model.all<model::Zone>().empty() &&
         std::any_of(model.regions().begin(), model.regions().end(),
                     [](const model::Region& region) { return region.card.rupture.has_value(); });
}

Tears::Tears(const model::Model& model, const Configuration& configuration, const Cloth& cloth,
             const Dofs& dofs)
    : model_(model), configuration_(configuration), cloth_(cloth), dofs_(dofs) {
  find_sites();
  set_strengths();
  find_grips();
  find_lines();
}

// The edges that meet in a corner, sorted by the yarns along which they run.
Tears::Corner Tears::corner_at(Index element, int a) const {
  const auto& mesh = model_.mesh();
  const auto& nodes = mesh.elements[static_cast<std::size_t>(element)];
  const auto& X = dofs_.reference();
  const auto yarns = cloth_.readings().yarns(element);
  Corner corner{nodes[static_cast<std::size_t>(a)], element, {-1, -1}, {-1, -1}};
  for (const int step : {1, 3}) {
    const Index far = nodes[static_cast<std::size_t>((a + step) % 4)];
    const Vec3 way =
        (X[static_cast<std::size_t>(far)] - X[static_cast<std::size_t>(corner.node)]).normalized();
    const double off[] = {std::asin(std::min(1.0, way.cross(yarns.first).norm())),
                          std::asin(std::min(1.0, way.cross(yarns.second).norm()))};
    const std::size_t family = off[0] <= off[1] ? 0 : 1;
    if (off[family] > kAlong || corner.far[family] >= 0)
      throw Error("tearable: element " + model_.element_name(element) + " has an edge " +
                  number(off[family] * 180 / std::numbers::pi, 3) +
                  " degrees off the yarns: expected elements along the yarns, to a degree, where they break");
    corner.far[family] = far;
    corner.other[family] = mesh.place_of(far);
  }
  return corner;
}

void Tears::find_sites() {
  const auto& mesh = model_.mesh();
  std::map<Index, std::vector<std::pair<Index, int>>> at;
  std::map<Index, std::set<Index>> nodes;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (int a = 0; a < corners(mesh.elements[e]); ++a) {
      const Index n = mesh.elements[e][static_cast<std::size_t>(a)];
      at[mesh.place_of(n)].emplace_back(static_cast<Index>(e), a);
      nodes[mesh.place_of(n)].insert(n);
    }
  for (const auto& [place, around] : at) {
    if (nodes[place].size() < 2) continue;
    Site site{place, {}, {kNever, kNever}, {0, 0}};
    for (const auto& [e, a] : around) {
      if (corners(mesh.elements[static_cast<std::size_t>(e)]) != 4)
        throw Error("tearable: element " + model_.element_name(e) +
                    " is a triangle: expected elements with four corners where yarns break");
      site.corners.push_back(corner_at(e, a));
    }
    sites_.push_back(std::move(site));
  }
}

// m, the mean length of the edges at a place along a family.
double Tears::spacing(const Site& site, int along) const {
  const auto& X = dofs_.reference();
  double sum = 0;
  for (const Corner& c : site.corners)
    sum += (X[static_cast<std::size_t>(c.far[static_cast<std::size_t>(along)])] -
            X[static_cast<std::size_t>(c.node)])
               .norm();
  return sum / static_cast<double>(site.corners.size());
}

// 1/E' of an orthotropic sheet that tears across a family; E1 along the tear [sih1965].
double Tears::across(std::size_t region, int family, double strength) const {
  const auto& section = model_.sections()[region];
  const Stiffness2 over = stiffness_at(section, family, strength);
  const double E2 = over.tension, E1 = stiffness_at(section, 1 - family, strength).tension;
  return std::sqrt(1 / (2 * E1 * E2)) * std::sqrt(std::sqrt(E1 / E2) + E1 / (2 * over.shear));
}

// N/m: the strength with which a tear runs at the force that its energy asks for, on elements of h.
double Tears::coarse(const model::Zone& zone, std::size_t region, int family, double strength, double energy,
                     double h) {
  const double per_stiffness = across(region, family, strength);
  const double length = energy / (per_stiffness * strength * strength);
  if (zone.keep || !(kFine * h > length)) return strength;
  const double lowered = std::sqrt(energy / (per_stiffness * kFine * h));
  const std::string words = "tearable zone of set '" + zone.set + "': its elements, " + number(h, 3) +
                            " m along the tear, are coarse for tears across the " + kFamily[family] +
                            ", which want " + number(length / kFine, 3) + " m: ";
  if (!zone.lower)
    throw Error(words + "expected a finer mesh, or coarse=\"lower\" (a strength of " + number(lowered, 4) +
                " N/m in place of " + number(strength, 4) + " N/m)");
  said_.push_back(words + "the strength is lowered from " + number(strength, 4) + " N/m to " +
                  number(lowered, 4) +
                  " N/m, with which a tear runs at the right force and begins too early at an even edge");
  return lowered;
}

// A joint between regions breaks like the weaker of them; where zones overlap, the first one counts. Elements
// of one size have the same strength, so that this is worked out once.
void Tears::set_strengths() {
  const auto& mesh = model_.mesh();
  std::vector<std::size_t> zone_of(mesh.elements.size(), model_.all<model::Zone>().size());
  for (std::size_t z = model_.all<model::Zone>().size(); z-- > 0;)
    for (const Index e : mesh.elements_in(mesh.set(model_.all<model::Zone>()[z].set)))
      zone_of[static_cast<std::size_t>(e)] = z;
  const auto off_path = [&](const Site& site, const model::Zone& zone) {
    if (zone.path.empty()) return false;
    const auto& path = mesh.set(zone.path);
    return !std::binary_search(path.begin(), path.end(), site.place);
  };
  std::map<std::tuple<std::size_t, std::size_t, int, long>, double> known;
  for (Site& site : sites_)
    for (const Corner& corner : site.corners)
      for (int family = 0; family < 2; ++family) {
        const std::size_t z = zone_of[static_cast<std::size_t>(corner.element)];
        const auto& rupture = model_.card_of(corner.element).rupture;
        if (z == model_.all<model::Zone>().size() || !rupture || !of_family(*rupture, family)) continue;
        const card::YarnBreak& yarn = *of_family(*rupture, family);
        const auto& zone = model_.all<model::Zone>()[z];
        if (off_path(site, zone)) continue;
        const auto region = static_cast<std::size_t>(model_.region_of(corner.element));
        const double h = spacing(site, 1 - family);
        const auto [entry, fresh] = known.try_emplace({z, region, family, std::lround(1e3 * std::log(h))}, 0);
        if (fresh) entry->second = coarse(zone, region, family, yarn.strength, yarn.energy, h);
        const double strength = entry->second * scattered(yarn, spacing(site, family),
                                                          h * static_cast<double>(site.corners.size()) / 4,
                                                          zone.seed, site.place, family);
        const auto f = static_cast<std::size_t>(family);
        if (!(strength < site.strength[f])) continue;
        site.strength[f] = strength;
        site.energy[f] = yarn.energy;
      }
}

// --- lines

void Tears::find_lines() {
  lines_.clear();
  for (std::size_t s = 0; s < sites_.size(); ++s) {
    std::map<Index, std::vector<const Corner*>> joints;
    for (const Corner& corner : sites_[s].corners)
      joints[dofs_.joints().leader(corner.node)].push_back(&corner);
    for (const auto& [leader, joint] : joints)
      for (int family = 0; family < 2; ++family)
        if (joint.size() > 1 && sites_[s].strength[static_cast<std::size_t>(family)] < kNever)
          add_line(s, family, joint);
  }
  near_.clear();
  all_known_ = false;
  set_limits();
}

// The line of the other family through a joint, if it divides the joint in two.
void Tears::add_line(std::size_t s, int family, const std::vector<const Corner*>& joint) {
  const Index place = sites_[s].place;
  const auto& opened = dofs_.joints().opened();
  const auto along = std::size_t(1 - family), over = std::size_t(family);
  const auto meet = [&](const Corner& a, const Corner& b, std::size_t edge) {
    return a.other[edge] == b.other[edge] &&
           !std::binary_search(opened.begin(), opened.end(), Joints::Edge(place, a.other[edge]));
  };
  Line line;
  line.site = s;
  line.family = family;
  std::vector<std::size_t> part(joint.size());
  for (std::size_t i = 0; i < part.size(); ++i) part[i] = i;
  const auto& X = dofs_.reference();
  for (std::size_t i = 0; i < joint.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Corner &a = *joint[k], &b = *joint[i];
      if (const std::size_t from = part[i], to = part[k]; a.node == b.node || meet(a, b, over))
        std::replace(part.begin(), part.end(), from, to);
      if (a.node == b.node || !meet(a, b, along)) continue;
      const double length = (X[std::size_t(a.far[along])] - X[std::size_t(place)]).norm() / 2;
      line.spokes.push_back({a.other[along], a.node, b.node, length});
      line.length += length;
    }
  if (line.spokes.empty()) return;
  const std::set<std::size_t> parts(part.begin(), part.end());
  if (parts.size() != 2) return;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    const std::size_t side = part[i] == *parts.begin() ? 0 : 1;
    auto& nodes = line.nodes[side];
    line.far[side].push_back(joint[i]->far[over]);
    const std::size_t end = joint[i]->other[along] == line.spokes.front().place ? 0 : 1;
    line.ends[end].push_back(joint[i]->far[along]);
    if (std::find(nodes.begin(), nodes.end(), joint[i]->node) != nodes.end()) continue;
    nodes.push_back(joint[i]->node);
    line.mass[side] += cloth_.mass()[std::size_t(joint[i]->node)];
  }
  for (Line::Spoke& spoke : line.spokes)
    if (std::find(line.nodes[0].begin(), line.nodes[0].end(), spoke.a) == line.nodes[0].end())
      std::swap(spoke.a, spoke.b);
  if (!held(line)) lines_.push_back(std::move(line));
}

Vec3 Tears::along(Index from, Index to) const {
  const auto& X = dofs_.reference();
  return (X[std::size_t(to)] - X[std::size_t(from)]).normalized();
}

// Whether a support holds a node along a yarn.
bool Tears::holds(Index node, const Vec3& yarn) const {
  const NodeFreedoms& freedoms = dofs_.freedoms().nodes[std::size_t(node)];
  for (int c = 0; c < 3; ++c)
    if (freedoms.equation[std::size_t(c)] < 0 && std::abs(freedoms.frame.row(c).dot(yarn)) > 0.5) return true;
  return false;
}

// Whether a support takes what yarns hand over there: nothing breaks at it.
bool Tears::held(const Line& line) const {
  return holds(line.nodes[0].front(), along(line.far[0].front(), line.far[1].front()));
}

// The corners at a held place of elements that are not held as a whole, by the side on which they are.
void Tears::find_grips() {
  const auto& elements = model_.mesh().elements;
  for (std::size_t s = 0; s < sites_.size(); ++s)
    for (std::size_t f = 0; f < 2; ++f) {
      if (!(sites_[s].strength[f] < kNever)) continue;
      std::map<Index, Grip> sides;
      for (const Corner& corner : sites_[s].corners) {
        const Vec3 yarn = along(corner.node, corner.far[f]);
        const auto& nodes = elements[std::size_t(corner.element)];
        if (!holds(corner.node, yarn) ||
            std::all_of(nodes.begin(), nodes.end(), [&](Index n) { return holds(n, yarn); }))
          continue;
        Grip& grip = sides.try_emplace(corner.other[f], Grip{s, int(f), {}, {}, 0}).first->second;
        grip.nodes.push_back(corner.node);
        grip.far.push_back(corner.far[f]);
        const auto& X = dofs_.reference();
        grip.length += (X[std::size_t(corner.far[1 - f])] - X[std::size_t(corner.node)]).norm() / 2;
      }
      for (auto& [other, grip] : sides) grips_.push_back(std::move(grip));
    }
}

}  // namespace fabricsh::mechanics
