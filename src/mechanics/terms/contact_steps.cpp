// The explicit steps that contact allows, and the speeds that it stops.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/intersect.hpp"
#include "mechanics/terms/contact_schemes.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kInGuard = 1;  // stiffness * step^2 / areal mass while the guard acts
constexpr double kBesideTie =
    0.5;                       // of the step without ties to bodies, which take 10/4 of the cloth's stiffness
constexpr double kPairs = 10;  // that press one node at once
constexpr double kBesideSoft = 0.7;  // of the step of the cloth beside contact that takes hardly any of it
// Where the smallest elements share the masses beside them: the step over that in which waves cross their
// height, with which the default stiffness carries. Ten pairs that press one node at once are still stable.
constexpr double kSpare = 1.2;
constexpr double kMargin = 2;     // of a stiffness that is proposed, for what a pair is pressed with later
constexpr double kAboutNode = 2;  // areas of a node that press a ball on it: half its own and its facets'

}  // namespace

// Pa/m: of the stiffest contact, as of nodes that press.
double ExplicitContact::stiffest() const {
  const contact::Scene& scene = state_.surfaces.scene();
  double most = 0;
  for (std::size_t i = 0; i < state_.surfaces.meetings().size(); ++i)
    if (const auto& it = scene.interactions()[i]; !it.rigid)
      most = std::max(most, it.law.stiffest() / (state_.surfaces.meetings()[i].given ? 1 : eased(scene, it)));
  return most;
}

// With r the share, and k dt^2 / sigma the stiffness of contact over what carries it, a node that ten pairs
// press has r^2 + 10/4 k dt^2 / sigma of what is stable: as much as of a contact of the default stiffness.
double ExplicitContact::share_of_cloth(double stable) const {
  if (state_.ties.any()) return kBesideTie * contact_step_of_cloth;
  const double by_contact = kPairs / 4 * stiffest() * stable * stable / state_.surfaces.least_areal(),
               carried = contact_step_of_cloth * contact_step_of_cloth + kPairs / 4 * carried_stiffness;
  const double share = std::sqrt(carried / (1 + by_contact));
  constexpr double rounding = 1e-6;
  return share > contact_step_of_cloth * (1 + rounding) ? std::min(share, kBesideSoft)
                                                        : contact_step_of_cloth;
}

// s: what a light free body carries, whose mass is not that of the cloth that it presses: `share` of its
// mass over the stiffness of all places that press it at once, squared with the step. These are the nodes and
// facets about one node of the largest area, or the patch that a depth of the range of contact makes.
double ExplicitContact::carried_by_bodies(double share, bool guarded) const {
  const ContactSurfaces& surfaces = state_.surfaces;
  const contact::Scene& scene = surfaces.scene();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < surfaces.meetings().size(); ++i) {
    const auto& it = scene.interactions()[i];
    double inverse = 0;
    for (const int side : {it.first, it.second})
      if (const int body = surfaces.body_of(side); body >= 0)
        inverse += surfaces.bodies().readings().inverse_mass_pressed(static_cast<std::size_t>(body));
    if (!(inverse > 0)) continue;
    const double range = it.law.gap() - it.law.floor(), radius = scene.surfaces()[it.second].radius;
    const double ease = surfaces.meetings()[i].given ? 1 : eased(scene, it);
    double area = it.rigid ? 1 : 2 * std::numbers::pi * radius * range;
    for (const std::int32_t p : scene.surfaces()[it.first].points)
      if (!it.rigid) area = std::max(area, kAboutNode * scene.area(p) / ease);
    const double stiffness = guarded
                                 ? it.law(it.law.floor() + std::min(state_.trial.hard_gap, range)).stiffness
                                 : it.law.stiffest();
    least = std::min(least, share / (area * stiffness * inverse));
  }
  return std::sqrt(least);
}

double ExplicitContact::largest_step(bool scaled) const {
  const ContactSurfaces& surfaces = state_.surfaces;
  const double of_contact = std::sqrt(carried_stiffness * surfaces.least_areal() / stiffest()),
               of_bodies = carried_by_bodies(carried_stiffness, false);
  const double stable = cloth_.stable_step(scaled);
  if (state_.ties.any())
    return std::min({kBesideTie * std::min(contact_step_of_cloth * stable, surfaces.step()), of_contact,
                     surfaces.bodies().loads().stable_step(), of_bodies});
  const double of_cloth = share_of_cloth(stable) * stable;
  const double spare = std::clamp(of_cloth / surfaces.step(), 1.0, kSpare);
  return std::min({of_cloth, spare * of_contact, surfaces.bodies().loads().stable_step(), of_bodies});
}

// Of the square of the speed that is stopped flat: the area with which one pair presses over the area whose
// mass it stops. One corner of a solid's facets may meet an element in its middle, whose three nodes count;
// an edge that crosses one of the cloth in the middle stops two.
double ExplicitContact::weakest_share(const contact::Interaction& it) const {
  const contact::Scene& scene = state_.surfaces.scene();
  const auto& sheet = scene.surfaces()[it.first];
  const auto& other = scene.surfaces()[it.second];
  double most = 0;
  for (const std::int32_t p : sheet.points) most = std::max(most, scene.area(p));
  if (other.shape == contact::Shape::wall) return 0.5;
  if (other.shape == contact::Shape::cloth) return 1.0 / 3;
  if (other.shape != contact::Shape::solid)
    return it.parts.empty() ? 1.0 / 12 : std::min(1.0 / 12, area_as_flat(scene, it) / (3 * most));
  double least = sheet.mean_area;
  for (const std::int32_t p : other.points) least = std::min(least, scene.area(p));
  return least / 2 / (3 * most);
}

// Two sheets that meet share the speed: half of the mass has all of it.
ExplicitContact::Stopped ExplicitContact::stopped_by(std::size_t meeting) const {
  const ContactSurfaces& surfaces = state_.surfaces;
  const contact::Scene& scene = surfaces.scene();
  const auto& it = scene.interactions()[meeting];
  const bool sheets = surfaces.body_of(it.second) < 0;
  const double range = it.law.gap() - it.law.guard_gap(),
               mass = sheets ? surfaces.least_areal() / 2 : surfaces.least_areal();
  const double flat = range * std::sqrt(it.law.stiffest() / mass);
  return {flat, flat * std::sqrt(weakest_share(it)), surfaces.meetings()[meeting].given};
}

ExplicitContact::Stopped ExplicitContact::speed_stopped() const {
  const ContactSurfaces& surfaces = state_.surfaces;
  const contact::Scene& scene = surfaces.scene();
  Stopped least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), false};
  for (std::size_t i = 0; i < surfaces.meetings().size(); ++i) {
    if (scene.interactions()[i].rigid) continue;
    const Stopped here = stopped_by(i);
    if (here.flat < least.flat) least.given = here.given;
    least.flat = std::min(least.flat, here.flat);
    least.anywhere = std::min(least.anywhere, here.anywhere);
  }
  return least;
}

// Of several contacts between the cloth and a body that of the pair's nodes counts. A body has no law of its
// own, and two sheets that meet give way to each other.
std::optional<ExplicitContact::Pressed> ExplicitContact::pressed(const std::array<std::int32_t, 4>& points,
                                                                 double gap) const {
  const ContactSurfaces& surfaces = state_.surfaces;
  int body = -1;
  for (const std::int32_t p : points)
    if (p >= 0 && static_cast<std::size_t>(p) >= surfaces.nodes()) body = surfaces.body_at(p);
  if (body < 0) return {};
  const auto of_cloth = [&](const std::vector<std::int32_t>& corners) {
    return std::any_of(corners.begin(), corners.end(), [&](std::int32_t p) {
      return std::find(points.begin(), points.end(), p) != points.end();
    });
  };
  for (const auto& it : surfaces.scene().interactions()) {
    if (it.rigid || surfaces.body_of(it.second) != body) continue;
    if (!of_cloth(surfaces.scene().surfaces()[it.first].points)) continue;
    const double pressure = it.law(it.law.floor() + gap).pressure;
    const double carried = it.law(it.law.guard_gap()).pressure;
    if (!(std::isfinite(pressure) && pressure > carried)) return {};
    const double stiffness = kMargin * pressure / carried * it.law.stiffest();
    return Pressed{pressure, carried, stiffness,
                   std::sqrt(carried_stiffness * surfaces.least_areal() / stiffness)};
  }
  return {};
}

std::vector<ExplicitContact::DrawnThrough> ExplicitContact::drawn_through() const {
  const auto& stitches = dofs_.stitches();
  std::vector<std::size_t> drawn;
  std::vector<contact::Edge> ways;
  for (std::size_t i = 0; i < stitches.size(); ++i) {
    if (dofs_.sewn().closed[i] != 0 || !dofs_.seams()[stitches[i].seam].over) continue;
    drawn.push_back(i);
    ways.push_back({static_cast<std::int32_t>(stitches[i].node),
                    static_cast<std::int32_t>(stitches[i].leads.front().node)});
  }
  if (drawn.empty()) return {};
  const ContactSurfaces& surfaces = state_.surfaces;
  const contact::Scene& scene = surfaces.scene();
  std::vector<Vec3> x(state_.x.size());
  state_.positions(state_.configuration.x(), 0, x);
  std::vector<contact::Triangle> facets;
  std::vector<std::size_t> meeting;  // of each facet
  for (std::size_t i = 0; i < surfaces.meetings().size(); ++i) {
    const auto& it = scene.interactions()[i];
    if (it.rigid || scene.surfaces()[it.second].shape != contact::Shape::solid) continue;
    for (const contact::TriangleRow& t : scene.triangles())
      if (t.surface == it.second) facets.push_back(t.nodes);
    meeting.resize(facets.size(), i);
  }
  const auto length = [&](std::size_t stitch) {
    return Dofs::gap(stitches[stitch], state_.configuration.x()).norm();
  };
  std::vector<DrawnThrough> found;
  for (const auto& [way, facet] : contact::intersections(x, ways, facets)) {
    const std::size_t stitch = drawn[way];
    const auto same = [&](const DrawnThrough& d) { return stitches[d.stitch].seam == stitches[stitch].seam; };
    const auto at = std::find_if(found.begin(), found.end(), same);
    if (at != found.end() && length(at->stitch) >= length(stitch)) continue;
    const auto& it = scene.interactions()[meeting[facet]];
    DrawnThrough through{stitch, surfaces.name_of(it.second), stopped_by(meeting[facet]).anywhere};
    if (at == found.end())
      found.push_back(std::move(through));
    else
      *at = std::move(through);
  }
  return found;
}

double ExplicitContact::largest_contact_step() const {
  const ContactSurfaces& surfaces = state_.surfaces;
  const contact::Scene& scene = surfaces.scene();
  double stiffest = 0;
  for (std::size_t i = 0; i < surfaces.meetings().size(); ++i)
    if (const auto& it = scene.interactions()[i]; !it.rigid && (it.cloths || !state_.pairs.eases(it)))
      stiffest = std::max(stiffest, it.law(it.law.floor() + state_.trial.hard_gap).stiffness /
                                        (surfaces.meetings()[i].given ? 1 : eased(scene, it)));
  return std::min({std::sqrt(kInGuard * surfaces.least_areal() / stiffest), carried_by_bodies(kInGuard, true),
                   surfaces.bodies().loads().stable_step()});
}

}  // namespace fabricsh::mechanics
