// What is given of a contact: cloth that starts inside a solid, motions that pass through each other, and
// bodies that turn farther in a step than contact follows.
#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "base/number.hpp"
#include "contact/intersect.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/terms/contact.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kNearest = 1e-3;    // smallest gap at the start that is opened, as a share of the whole
constexpr std::size_t kTold = 5;     // number of overlaps named in a message
constexpr double kOfElements = 0.1;  // thickness in contact with a solid of facets, over an element's side

}  // namespace

// m, in the mean.
double Contacts::side_of_elements(int sheet) const {
  const auto& mesh = model_.mesh();
  double sum = 0, count = 0;
  for (const Index e : surfaces_.elements[sheet]) {
    const auto& element = mesh.elements[e];
    const int n = element[3] < 0 ? 3 : 4;
    for (int i = 0; i < n; ++i) sum += (mesh.nodes[element[i]] - mesh.nodes[element[(i + 1) % n]]).norm();
    count += n;
  }
  return count > 0 ? sum / count : 0;
}

// Coarse cloth that comes against the corners of a body is stopped by its own thickness at a walk only: the
// speed that contact stops grows with its gap. So cloth whose elements are long against its thickness is as
// thick against solids of facets as a share of them, but never so that it is pressed from the start.
void Contacts::follow_elements() {
  const double none = std::numeric_limits<double>::infinity();
  std::vector<double> wanted(meetings_.size(), 0), room(meetings_.size(), none);
  double skin = 0;
  for (std::size_t i = 0; i < meetings_.size(); ++i) {
    const model::SurfacePair& m = surfaces_.meetings[i];
    const auto& given = model_.interactions().contacts()[m.contact];
    if (meetings_[i].bodies || given.thickness || given.stiffness || given.settle) continue;
    const auto bodies = static_cast<int>(sheets_.size());
    if (m.first >= bodies || m.second < bodies) continue;
    const model::Rigid& body = bodies_.body(static_cast<std::size_t>(m.second - bodies));
    if (body.facets() == nullptr || !body.facets()->closed || body.free()) continue;
    wanted[i] = kOfElements / 2 * side_of_elements(m.first);
    skin = std::max(skin, wanted[i] - scene_.interactions()[i].law.gap());
  }
  if (!(skin > 0)) return;
  for (const contact::Candidate& c : contact::find_pairs(scene_, scene_.reference(), skin)) {
    double& least = room[static_cast<std::size_t>(c.interaction)];
    least = std::min(least, contact::gap_of(c, contact::corners_of(c, scene_.reference())));
  }
  for (std::size_t i = 0; i < meetings_.size(); ++i) {
    Meeting& m = meetings_[i];
    const double gap = std::min(wanted[i], room[i]);
    if (gap <= scene_.interactions()[i].law.gap()) continue;
    m.follows = true;
    m.data = {gap, m.data.floor,
              dense_pressure / (gap - m.data.floor)};  // the floor is below the gap that it had
    scene_.replace_law(i, contact::ContactLaw(m.data));
  }
}

void Contacts::find_overlaps(double time) {
  overlaps_ = overlaps_at(time);
  if (overlaps_.empty()) overlaps_ = inside();
}

std::string Contacts::overlaps_at(double time) {
  if (!meets()) return {};
  positions(configuration_.x(), 0, x_);
  open_to(time);
  auto overlaps = contact_->overlaps(x_);
  for (std::size_t i = 0; i < meetings_.size(); ++i)
    if (meetings_[i].near > 0 && meetings_[i].nearest < kNearest * scene_.interactions()[i].law.gap() &&
        overlaps.empty())
      return "contact: field 'settle': " + meetings_[i].names + ": expected at least " +
             number(kNearest * scene_.interactions()[i].law.gap()) + " m between what is opened, got " +
             number(meetings_[i].nearest) + " m";
  if (overlaps.empty()) return {};
  std::string text = "contact: " + std::to_string(overlaps.size()) +
                     (overlaps.size() == 1 ? " pair overlaps" : " pairs overlap") + " at the start:";
  for (std::size_t i = 0; i < std::min(kTold, overlaps.size()); ++i)
    text += (i > 0 ? "; " : " ") + words(overlaps[i].point) +
            (overlaps[i].gap > 0 ? ", " + number(overlaps[i].gap) + " m apart" : ", one through the other");
  if (overlaps.size() > kTold) text += "; ...";
  const auto tight = [](const auto& overlap) { return overlap.gap > 0; };
  return text + "; expected all of it apart" +
         (std::any_of(overlaps.begin(), overlaps.end(), tight)
              ? " (settle= of m:contact would open what is not one through the other)"
              : "");
}

// No edge of a sheet inside a solid need be near its surface, so that no pair tells. Empty: nothing is
// inside.
std::string Contacts::inside() const {
  for (const model::RigidPointer& given : model_.interactions().bodies()) {
    const model::Facets* facets = given->facets();
    const auto number = static_cast<std::size_t>(find_body(*given));
    if (facets == nullptr || !(facets->closed || given->free())) continue;
    const auto vertices =
        bodies_.committed().subspan(bodies_.vertices(number).first, facets->vertices.size());
    for (const auto& it : scene_.interactions()) {
      if (it.second != bodies_.surface(number)) continue;
      for (const std::int32_t p : scene_.surfaces()[static_cast<std::size_t>(it.first)].points)
        if ((it.rigid || scene_.sheet(p) == p) &&
            contact::encloses(vertices, facets->triangles, x_[static_cast<std::size_t>(p)]))
          return "contact: " + words({p, -1, -1, -1}) + " starts inside the " +
                 model_.interactions().name_of(*given) + ", which bounds a solid: expected " +
                 (it.rigid ? "it" : "the cloth") +
                 " outside of it (a hollow body has neither closed=true nor a mass)";
    }
  }
  return {};
}

// Friction by direction needs the warp of each triangle as a sum of its sides, which it follows.
void Contacts::find_warps() {
  const auto& all = model_.interactions().contacts();
  if (std::none_of(all.begin(), all.end(), [](const auto& given) { return given.across.has_value(); }))
    return;
  std::vector<std::array<double, 2>> warp(scene_.triangles().size(), {0, 0});
  for (std::size_t t = 0; t < warp.size(); ++t) {
    const contact::TriangleRow& row = scene_.triangles()[t];
    if (row.surface >= static_cast<int>(sheets_.size())) continue;
    const auto corner = [&](std::size_t k) { return at(configuration_.x(), row.nodes[k]); };
    const auto e = static_cast<std::size_t>(row.element);
    const Index element = surfaces_.elements[static_cast<std::size_t>(row.surface)][e];
    Eigen::Matrix<double, 3, 2> sides;
    sides << corner(1) - corner(0), corner(2) - corner(0);
    const Eigen::Vector2d by =
        (sides.transpose() * sides).inverse() * sides.transpose() * cloth_.yarns(element).first;
    warp[t] = {by[0], by[1]};
  }
  for (std::size_t i = 0; i < meetings_.size(); ++i)
    if (const auto& across = all[surfaces_.meetings[i].contact].across) scene_.set_across(i, *across, warp);
}

// A film that an explicit step does not carry would have to be thinned, and would then not be what was given.
void Contacts::refuse_films() const {
  constexpr double carried = 0.1;  // of areal mass over step: facets and both faces of a ply add up to more
  const double most = carried * least_areal_ / step_;
  for (std::size_t i = 0; i < meetings_.size(); ++i) {
    const double drag = scene_.interactions()[i].film.viscous;
    if (drag > most)
      throw Error(
          "contact: field 'film': " + meetings_[i].names + ": explicit steps of " + number(step_) +
          " s carry a viscosity over thickness of at most " + number(most) + " Pa s/m, got " + number(drag) +
          ": a run that is faster than the process by a factor needs a viscosity that is smaller by it "
          "(or scheme=\"implicit\")");
  }
}

void Contacts::find_driven() {
  driven_.assign(x_.size(), 0);
  bool moves = bodies_.any_driven(), any = false;
  for (std::size_t n = 0; n < nodes_; ++n) {
    const auto& eq = freedoms_.nodes[n].equation;
    driven_[n] = std::all_of(eq.begin(), eq.begin() + 3, is_prescribed) ? 1 : 0;
    any = any || driven_[n] != 0;
    moves = moves ||
            (driven_[n] != 0 && std::any_of(eq.begin(), eq.begin() + 3, [](Index e) { return e < held; }));
  }
  for (std::size_t v = 0; nodes_ + v < x_.size(); ++v) driven_[nodes_ + v] = bodies_.free_of(v) < 0 ? 1 : 0;
  if (!any || !moves) driven_.clear();
}

// Newton's iterations take driven nodes and driven bodies to their ends one after the other, along ways on
// which they may miss each other. So the way of the whole step is looked at, once, when both have arrived.
bool Contacts::driven_meet() {
  if (driven_.empty() || !(share_ >= 1 || !moves_) || !(trial_time_ > configuration_.time())) return false;
  if (met_) return *met_;
  positions(configuration_.committed_kinematics(), 0, start_);
  by_.assign(x_.size(), Vec3::Zero());
  bool moved = false;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    if (driven_[i] != 0) by_[i] = x_[i] - start_[i];
    moved = moved || !by_[i].isZero(0);
  }
  if (!moved) return false;
  met_ = contact_->safe_fraction(start_, by_, driven_) < 1;
  return *met_;
}

double Contacts::latest_end(double to) const {
  const double from = configuration_.time();
  if (!moves_ || !(to > from)) return to;
  BoundingBox cloth{at(configuration_.x(), 0), at(configuration_.x(), 0)};
  for (std::size_t n = 1; n < nodes_; ++n) {
    const Vec3 x = at(configuration_.x(), static_cast<Index>(n));
    cloth.low = cloth.low.cwiseMin(x);
    cloth.high = cloth.high.cwiseMax(x);
  }
  for (std::size_t b = 0; b < bodies_.count(); ++b) {
    double near = std::numeric_limits<double>::infinity();
    for (const auto& it : scene_.interactions())
      if (it.first == bodies_.surface(b) || it.second == bodies_.surface(b))
        near = std::min(near, it.law.floor());
    to = bodies_.follows(b, from, to, near, cloth);
  }
  return to;
}

bool Contacts::turns_too_far() const { return bodies_.turned_most() > (1 + 1e-6) * Bodies::largest_turn; }

}  // namespace fabricsh::mechanics
