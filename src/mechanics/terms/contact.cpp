#include "mechanics/terms/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "base/number.hpp"
#include "geometry/box.hpp"
#include "geometry/node_view.hpp"
#include "law/compression.hpp"
#include "mechanics/terms/contact_points.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kLeast = 0.75;        // largest floor, as a share of the thickness
constexpr double kOfBodies = 0.05;     // stiffness * step^2 / reduced mass of two bodies: 14 steps in contact
constexpr double kPressed = 0.1;       // of the smaller radius: how deep bodies press each other at most
constexpr double kPressedLeast = 0.1;  // of that: the smallest distance left, below which is the floor
constexpr double kFar = 5;             // mean edges, the farthest that one of Newton's steps goes
constexpr std::size_t kShare = 4096;   // number of nodes from which loops use several threads

// The centre of the sheets; of a part between planes of symmetry that of the whole.
Vec3 centre_of(const model::Model& model) {
  Vec3 centre = box_of(model.mesh().nodes).middle();
  for (const auto& plane : model::symmetry_planes(model)) centre[plane.axis] = plane.at;
  return centre;
}

// The point of contact of a node: the leader of its joint, or the place that the sides of a hinge share.
Index point_of(Index node, const mesh::Mesh& mesh, const Joints& joints) {
  return mesh.hinged ? mesh.place_of(node) : joints.leader(node);
}

// Of surfaces whose corners are these points.
contact::Scene scene_of(const model::Model& model, const model::Surfaces& surfaces, const Joints& joints) {
  const auto& mesh = model.mesh();
  contact::Scene scene(mesh.nodes);
  const Vec3 centre = centre_of(model);
  for (const auto& elements : surfaces.elements) {
    std::vector<std::array<mesh::Index, 4>> rows;
    for (const Index e : elements) {
      rows.push_back(mesh.elements[e]);
      for (Index& n : rows.back())
        if (n >= 0) n = point_of(n, mesh, joints);
    }
    scene.add_cloth(rows, centre);
  }
  return scene;
}

// Whether two sections have the same law of compression through the thickness.
bool same_compression(const section::Section& a, const section::Section& b) {
  return a.thickness == b.thickness && a.areal_mass == b.areal_mass &&
         a.solid_thickness == b.solid_thickness && a.compression == b.compression;
}

// For each element the first element of its sheet, that is, of those connected to it by common nodes.
std::vector<std::size_t> joined(const mesh::Mesh& mesh, const std::vector<Index>& elements) {
  std::vector<std::size_t> root(elements.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  std::vector<std::ptrdiff_t> seen(mesh.nodes.size(), -1);
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (const Index n : mesh.elements[elements[i]]) {
      if (n < 0) continue;
      if (seen[n] < 0) {
        seen[n] = static_cast<std::ptrdiff_t>(i);
        continue;
      }
      const std::size_t a = find(i), b = find(static_cast<std::size_t>(seen[n]));
      root[std::max(a, b)] = std::min(a, b);
    }
  for (std::size_t i = 0; i < root.size(); ++i) root[i] = find(i);
  return root;
}

// A side of several sheets that are not alike becomes as many surfaces as there are kinds of sheets, so that
// each two have the gap of their own thicknesses. A sheet that is not alike everywhere is of one kind.
std::vector<std::vector<Index>> kinds(const model::Model& model, const std::vector<Index>& elements) {
  const std::vector<std::size_t> sheet = joined(model.mesh().uncut(), elements);
  std::vector<std::vector<int>> regions(elements.size());  // of each sheet, the first that are alike
  for (std::size_t i = 0; i < elements.size(); ++i) {
    int region = model.region_of(elements[i]);
    for (int r = 0; r < region; ++r)
      if (same_compression(model.sections()[r], model.sections()[region])) region = r;
    auto& of_sheet = regions[sheet[i]];
    const auto at = std::lower_bound(of_sheet.begin(), of_sheet.end(), region);
    if (at == of_sheet.end() || *at != region) of_sheet.insert(at, region);
  }
  std::vector<std::vector<Index>> out;
  std::vector<std::vector<int>> kind;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto& mine = regions[sheet[i]];
    const auto at = std::find(kind.begin(), kind.end(), mine);
    const auto number = static_cast<std::size_t>(at - kind.begin());
    if (at == kind.end()) {
      kind.push_back(mine);
      out.emplace_back();
    }
    out[number].push_back(elements[i]);
  }
  return out;
}

model::Surfaces split_by_kind(const model::Model& model, const model::Surfaces& given) {
  model::Surfaces out;
  std::vector<std::vector<int>> parts;  // of each surface of cloth
  for (const auto& elements : given.elements) {
    parts.emplace_back();
    for (auto& kind : kinds(model, elements)) {
      parts.back().push_back(static_cast<int>(out.elements.size()));
      out.elements.push_back(std::move(kind));
    }
  }
  const auto cloth = static_cast<int>(given.elements.size());
  const auto parts_of = [&](int side) {
    return side < cloth ? parts[side]
                        : std::vector<int>{static_cast<int>(out.elements.size()) + side - cloth};
  };
  for (const model::SurfacePair& m : given.meetings)
    for (const int a : parts_of(m.first))
      for (const int b : parts_of(m.second))
        if (m.first != m.second || a <= b)
          out.meetings.push_back({std::min(a, b), std::max(a, b), m.contact});
  return out;
}

// The bodies that a surface consists of, "front and back"; empty where it is a part of one, or many.
std::string bodies_of(const mesh::Mesh& mesh, const std::vector<Index>& elements) {
  std::string words;
  std::size_t covered = 0, count = 0;
  for (const auto& part : mesh.parts) {
    const std::size_t size = part.mesh->elements.size();
    if (std::find(elements.begin(), elements.end(), part.first_element) == elements.end()) continue;
    words += (words.empty() ? "" : " and ") + part.name;
    covered += size;
    ++count;
  }
  return covered == elements.size() && count <= 2 ? words : "";
}

// The share of the critical damping with which a mass on a spring, damped while it approaches, leaves with
// this share of its speed: exp(-zeta acos(zeta) / sqrt(1 - zeta^2)), which falls from 1 to 1/e.
double damping_of(double restitution) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double zeta = (low + high) / 2,
                 leaves = std::exp(-zeta * std::acos(zeta) / std::sqrt(1 - zeta * zeta));
    (leaves > restitution ? low : high) = zeta;
  }
  return restitution < 1 ? low : 0;
}

double mean_edge(const contact::Scene& scene) {
  double sum = 0;
  for (const auto& edge : scene.edges()) sum += edge.length;
  return scene.edges().empty() ? 0 : sum / static_cast<double>(scene.edges().size());
}

}  // namespace

Contacts::Contacts(const model::Model& model, const Configuration& configuration, const Cloth& cloth,
                   const Dofs& dofs)
    : Contacts(model, configuration, cloth, dofs,
               split_by_kind(model, model::work_out_surfaces(model.interactions(), model.mesh().uncut()))) {}

Contacts::Contacts(const model::Model& model, const Configuration& configuration, const Cloth& cloth,
                   const Dofs& dofs, model::Surfaces surfaces)
    : model_(model),
      configuration_(configuration),
      cloth_(cloth),
      dofs_(dofs),
      joints_(dofs.joints()),
      freedoms_(dofs.freedoms()),
      surfaces_(std::move(surfaces)),
      scene_(scene_of(model, surfaces_, joints_)),
      bodies_(model, scene_),
      least_areal_(std::numeric_limits<double>::infinity()),
      step_(contact_step_of_cloth * std::min(cloth.stable_step(true), cloth.step_across_heights())),
      nodes_(model.mesh().nodes.size()) {
  for (const auto& elements : surfaces_.elements) {
    sheets_.push_back(sheet(elements));
    sheets_.back().name = bodies_of(model.mesh(), elements);
    least_areal_ = std::min(least_areal_, sheets_.back().areal);
  }
  edge_ = mean_edge(scene_);
  for (const model::SurfacePair& m : surfaces_.meetings) {
    const auto& given = model.interactions().contacts()[m.contact];
    meetings_.push_back(meeting_of(m));
    const double loss = 2 * damping_of(given.restitution) * std::sqrt(moving_mass(m));
    scene_.meet(m.first, m.second, contact::ContactLaw(meetings_.back().data), given.friction, loss,
                given.sticking);
    scene_.set_film(meetings_.size() - 1, {given.film_drag(), given.film_speed, given.film_exponent});
    friction_ = friction_ || given.friction > 0 || given.sticking.value_or(0) > 0 || given.viscosity;
    rubs_ = rubs_ || friction_ || loss > 0;
  }
  find_warps();
  follow_elements();
  spread_points();
  sew_scene();
  moves_ = bodies_.any_free() || bodies_.any_driven();
  open_overlaps();
  contact_ = std::make_unique<contact::Contact>(scene_);
  x_ = start_ = scene_.reference();
  force_.assign(x_.size(), Vec3::Zero());
  torque_ = turning_ = force_;
  find_masses();
  find_driven();
  led_by_ = joints_.leaders();
  find_tied();
  find_overlaps(0);
  begin_pressed();
}

void Contacts::check_start() const {
  if (!overlaps_.empty()) throw Error(overlaps_);
}

// The first positions of the bodies stand beside the mesh, and not beside the cloth of the state.
void Contacts::begin_here() {
  bodies_.settle();
  find_overlaps(configuration_.time());
  check_start();
  begin_pressed();
}

Contacts::Sheet Contacts::sheet(const std::vector<Index>& elements) const {
  Sheet out{0, 0, std::numeric_limits<double>::infinity()};
  for (const Index e : elements) {
    const auto& section = model_.sections()[model_.region_of(e)];
    out.thickness = std::max(out.thickness, section.thickness);
    out.areal = std::min(out.areal, section.areal_mass);
    out.floor = std::max(out.floor, section.solid_thickness);
    if (e == elements.front()) out.compression = section.compression;
    if (out.compression != section.compression) out.compression.clear();  // cloths of several kinds
  }
  return out;
}

// kg/m2, of a sheet on a body, or the reduced mass of two sheets that meet; kg, that of two bodies.
double Contacts::moving_mass(const model::SurfacePair& m) const {
  double inverse = 0;
  for (const int side : {m.first, m.second})
    if (side < static_cast<int>(sheets_.size()))
      inverse += 1 / sheets_[side].areal;
    else if (m.first >= static_cast<int>(sheets_.size()))
      inverse += bodies_.inverse_mass_pressed(side - sheets_.size());
  return 1 / inverse;
}

// Two bodies press by a share of the smaller size at most, with what the explicit step of the cloth carries.
Contacts::Meeting Contacts::meeting_of_bodies(const model::SurfacePair& m) const {
  Meeting out;
  out.names = name_of(m.second) + " on " + name_of(m.first);
  out.bodies = true;
  double size = std::numeric_limits<double>::infinity();
  for (const int side : {m.first, m.second})
    if (const double s = bodies_.size(side - sheets_.size()); s > 0) size = std::min(size, s);
  out.data.gap = kPressed * size;
  out.data.floor = kPressedLeast * out.data.gap;
  out.data.stiffness = out.carried = kOfBodies * moving_mass(m) / (step_ * step_);
  return out;
}

std::string Contacts::name_of(int side) const {
  if (side < static_cast<int>(sheets_.size())) {
    if (sheets_.size() == 1) return "the cloth";
    return sheets_[side].name.empty() ? "cloth " + std::to_string(side + 1) : sheets_[side].name;
  }
  return model_.interactions().name_of(bodies_.body(side - sheets_.size()));
}

// A sheet occupies half of its thickness on either side of its midsurface.
Contacts::Meeting Contacts::meeting_of(const model::SurfacePair& m) const {
  if (m.first >= static_cast<int>(sheets_.size())) return meeting_of_bodies(m);
  const auto& given = model_.interactions().contacts()[m.contact];
  Meeting out;
  out.names =
      m.first == m.second ? name_of(m.first) + " on itself" : name_of(m.second) + " on " + name_of(m.first);
  out.given = given.stiffness.has_value();
  out.settle = given.settle;
  contact::LawData& data = out.data;
  double areal = std::numeric_limits<double>::infinity();
  std::vector<law::CompressionCurve> halves;
  for (const int side : {m.first, m.second}) {
    if (side >= static_cast<int>(sheets_.size())) continue;
    const Sheet& sheet = sheets_[side];
    const double thickness = given.thickness.value_or(sheet.thickness);
    data.gap += thickness / 2;
    data.floor += std::min(sheet.floor, given.thickness ? kLeast * thickness : thickness) / 2;
    areal = std::min(areal, sheet.areal);
    halves.push_back({sheet.compression, thickness, 0.5});
  }
  out.carried = carried_stiffness * areal / (step_ * step_);
  if (!given.stiffness && !given.thickness) data.curve = law::pressed_together(halves);
  if (!data.curve.empty())
    data.floor = std::min(data.floor, kLeast * data.curve.front().first);
  else
    data.stiffness = given.stiffness.value_or(dense_pressure / (data.gap - data.floor));
  return out;
}

std::string Contacts::stiffness_words(const Meeting& m, const contact::ContactLaw& law) const {
  const bool measured = !m.data.curve.empty();
  const std::string carried = m.softened ? ", no more than the mesh carries in motion" : "";
  if (!measured)
    return "stiffness " + number(law.stiffest()) + " Pa/m" + (m.given ? "" : " (default" + carried + ")");
  return "pressed as its card's compression has it, to a stiffness of " + number(law.stiffest()) + " Pa/m" +
         (carried.empty() ? "" : " (" + carried.substr(2) + ")");
}

std::vector<std::string> Contacts::describe() const {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < meetings_.size(); ++i) {
    const Meeting& m = meetings_[i];
    const auto& it = scene_.interactions()[i];
    if (m.bodies) {
      lines.push_back(m.names + ": from where they touch to a depth of " +
                      number(it.law.gap() - it.law.floor()) + " m, stiffness " + number(it.law.stiffest()) +
                      " N/m (default), no friction");
      continue;
    }
    lines.push_back(
        m.names + ": from a gap of " + number(it.law.gap()) + " m" +
        (m.follows ? " (default: a twentieth of the elements, or the room at the start)" : "") + ", floor " +
        number(it.law.floor()) + " m, " + stiffness_words(m, it.law) + ", friction " + number(it.friction) +
        (it.sticking > it.friction ? ", static " + number(it.sticking) : "") +
        (it.across < 0 ? "" : " along the warp, " + number(it.across) + " across") +
        (it.film.viscous > 0 ? ", film of " + number(it.film.viscous) + " Pa s/m" : "") +
        (it.film.speed > 0 ? ", thinner above " + number(it.film.speed) + " m/s" : "") +
        (m.spacing > 0 ? ", at points inside the elements, " + number(m.spacing) + " m apart" : "") +
        dependence_words(scene_, it));
    if (m.near > 0)
      lines.back() += "; " + std::to_string(m.near) + (m.near == 1 ? " point is" : " points are") +
                      " nearer than that at the start, the nearest by " + number(it.law.gap() - m.nearest) +
                      " m: opened over " + number(*m.settle) + " s";
  }
  lines.insert(lines.end(), bodies_.halves().begin(), bodies_.halves().end());
  return lines;
}

bool Contacts::assumes_stiffness() const {
  return std::any_of(meetings_.begin(), meetings_.end(),
                     [](const Meeting& m) { return !m.bodies && !m.given && m.data.curve.empty(); });
}

// Limits every stiffness that was not given to what an explicit step of the cloth carries. Contact then does
// not shorten an explicit step, and in implicit motion it does not oscillate faster than the mesh.
void Contacts::soften(bool measured) {
  for (std::size_t i = 0; i < meetings_.size(); ++i) {
    Meeting& m = meetings_[i];
    if (m.given || (!m.data.curve.empty() && !measured)) continue;
    if (scene_.interactions()[i].law.stiffest() <= m.carried) continue;
    m.softened = true;
    m.data.stiffness = m.carried;
    scene_.replace_law(i, contact::ContactLaw(m.data));
  }
}

void Contacts::set_weight(double weight) {
  weight_ = weight;
  if (implicit_) return;
  implicit_ = true;
  bodies_.go_implicit();
  soften(false);
  begin_pressed();
}

// Adds the forces of contact at the present positions, with a way also those of friction.
contact::Totals Contacts::touch(contact::Way way) {
  if (meets()) return contact_->add_forces(x_, force_, way, torque_);
  contact::Totals none;
  none.gap = std::numeric_limits<double>::infinity();
  return none;
}

// What starts within the range of contact has its energy and its forces from the start.
void Contacts::begin_pressed() {
  if (!overlaps_.empty()) return;  // from where no run begins
  positions(configuration_.x(), 0, x_);
  std::fill(force_.begin(), force_.end(), Vec3::Zero());
  committed_ = touch({});
  tied_energy_ = trial_tied_ = push_tied();
  bodies_.begin(std::span(force_).subspan(nodes_));
}

// --- overlaps at the start

// Each point begins with the share of its gap that it has at the start, so that nothing presses then.
void Contacts::open_overlaps() {
  if (!meets()) return;
  std::vector<std::vector<double>> shares(meetings_.size());
  for (std::size_t i = 0; i < meetings_.size(); ++i) {
    if (!meetings_[i].settle) continue;
    shares[i].assign(scene_.reference().size(), 1);
    scene_.open(i, shares[i]);
  }
  for (const contact::Candidate& c : contact::find_pairs(scene_, scene_.reference(), 0)) {
    auto& share = shares[static_cast<std::size_t>(c.interaction)];
    if (share.empty()) continue;
    const double whole = c.whole * scene_.interactions()[static_cast<std::size_t>(c.interaction)].law.gap(),
                 gap = contact::gap_of(c, contact::corners_of(c, scene_.reference()));
    const bool edges = c.pair.kind == contact::PairKind::edges || c.pair.kind == contact::PairKind::wrap;
    const auto points = scene_.with_nodes(c.point);
    for (std::size_t k = 0; k < (edges ? 4u : c.spot.any() ? 3u : 1u); ++k)
      if (double& s = share[static_cast<std::size_t>(points[k])]; points[k] >= 0)
        s = std::min(s, gap / whole);
  }
  for (std::size_t i = 0; i < meetings_.size(); ++i) {
    Meeting& m = meetings_[i];
    if (!m.settle) continue;
    const double least = *std::min_element(shares[i].begin(), shares[i].end());
    m.near = static_cast<std::size_t>(
        std::count_if(shares[i].begin(), shares[i].end(), [](double s) { return s < 1; }));
    m.nearest = least * scene_.interactions()[i].law.gap();
    if (m.near > 0) opened_at_ = std::max(opened_at_, *m.settle);
    for (double& s : shares[i]) s = std::max(s, 0.0);
    scene_.open(i, std::move(shares[i]));
  }
}

// Overlaps are opened smoothly from time 0 to the end of their settling.
void Contacts::open_to(double time) const {
  if (!(opened_at_ > 0)) return;
  share_of_.assign(meetings_.size(), 1);
  for (std::size_t i = 0; i < meetings_.size(); ++i)
    if (const auto& settle = meetings_[i].settle; settle && time < *settle) {
      const double s = std::max(time, 0.0) / *settle;
      share_of_[i] = s * s * (3 - 2 * s);
    }
  contact_->open_to(share_of_);
}

double Contacts::opening_energy(std::span<const Vec3> x, double time) {
  open_to(time);
  const contact::Totals totals = contact_->add_forces(x, force_);
  return totals.contact + totals.guard;
}

// The work of opening in a time dt, J, from its rate at `time`, with all positions fixed.
double Contacts::opening_pace(std::span<const Vec3> x, double time, double dt) {
  constexpr double small = 1e-3;
  const double more = opening_energy(x, time + small * dt), less = opening_energy(x, time - small * dt);
  return (more - less) / (2 * small);
}

// The work of opening in the step, by the trapezoid rule from its rates at both ends of the step. Returns
// false if there is not enough room for the opening. Afterwards contact is opened as at the end of the step.
bool Contacts::work_of_opening() {
  opening_work_ = {};
  const double from = configuration_.time(), dt = trial_time_ - from;
  if (!(from < opened_at_) || !(dt > 0)) return true;
  positions(configuration_.committed_kinematics(), 0, start_);
  const double first = opening_pace(start_, from, dt), last = opening_pace(x_, trial_time_, dt);
  opening_work_ = {(first + last) / 2, std::abs(last - first) / 2};
  open_to(trial_time_);
  return std::isfinite(opening_work_.work);
}

void Contacts::set_time(double time) {
  trial_time_ = time;
  met_.reset();
  bodies_.set_time(configuration_.time(), time);
  open_to(time);
}

bool Contacts::may_have_passed() {
  if (blocked_) return true;
  if (!meets()) return false;
  if (contact::cannot_meet(moved_, trial_.gap) && contact_->vertex_motion_bounds_surface_motion(start_, x_))
    return false;
  by_.resize(x_.size());
  for (std::size_t i = 0; i < x_.size(); ++i) by_[i] = x_[i] - start_[i];
  return contact_->may_have_passed(start_, by_, trial_.gap);
}

int Contacts::surface_of(std::int32_t point) const {
  for (std::size_t b = 0; b < bodies_.count(); ++b) {
    const auto [first, last] = bodies_.vertices(b);
    const auto p = static_cast<std::size_t>(point) - nodes_;
    if (p >= first && p < last) return static_cast<int>(b);
  }
  return -1;
}

std::string Contacts::words(const std::array<std::int32_t, 4>& points) const {
  std::string nodes, named;
  int count = 0, last = -1;
  for (const std::int32_t p : points) {
    if (p < 0) continue;
    if (static_cast<std::size_t>(p) < nodes_) {
      nodes += (count++ > 0 ? ", " : "") + std::to_string(p + 1);
      continue;
    }
    const int body = surface_of(p);
    if (body != last)
      named += (named.empty() ? "the " : " and the ") + model_.interactions().name_of(bodies_.body(body));
    last = body;
  }
  if (count == 0) return named;
  const std::string words = count > 1 ? "nodes " + nodes : "node " + nodes;
  return named.empty() ? words : words + " and " + named;
}

// --- forces

void Contacts::positions(std::span<const double> x, double share, std::vector<Vec3>& out) const {
#pragma omp parallel for schedule(static) if (nodes_ >= kShare)
  for (std::size_t n = 0; n < nodes_; ++n) out[n] = at(x, static_cast<Index>(n));
  const auto from = bodies_.committed(), to = bodies_.target();
  for (std::size_t v = 0; v < from.size(); ++v)
    out[nodes_ + v] = share >= 1 ? to[v] : share <= 0 ? from[v] : Vec3(from[v] + share * (to[v] - from[v]));
}

// The largest motion of any point in the step so far.
void Contacts::find_motion() {
  double most = 0;
#pragma omp parallel for schedule(static) reduction(max : most) if (nodes_ >= kShare)
  for (std::size_t i = 0; i < x_.size(); ++i) most = std::max(most, (x_[i] - start_[i]).squaredNorm());
  moved_ = std::sqrt(most);
}

// The way of friction from the beginning of the step to the present share of the bodies' motion; with the
// step's length if it is explicit. At the start of an explicit run there is none.
contact::Way Contacts::way(double dt) {
  if (!rubs_ || (explicit_ && !(dt > 0))) return {};
  const double share = std::clamp(share_, 0.0, 1.0);
  for (std::size_t b = 0; b < bodies_.count(); ++b) {
    const auto [first, last] = bodies_.vertices(b);
    std::fill(turning_.begin() + static_cast<std::ptrdiff_t>(nodes_ + first),
              turning_.begin() + static_cast<std::ptrdiff_t>(nodes_ + last), share * bodies_.turned(b));
  }
  if (!explicit_) return {start_, turning_, implicit_ ? dt : 0};
  return {start_, turning_, dt, inverse_mass_, planes_};
}

// J, that the trial step takes from what presses: the energy that contact gives up less the work of its
// forces at the end of the step. A convex energy falls by at least that work, so that this is not negative
// but for what the geometry bends within a step; the latter stays an error of the ledger.
double Contacts::taken() const {
  double work = trial_.work;
  for (std::size_t i = 0; i < x_.size(); ++i) work += force_[i].dot(x_[i] - start_[i]);
  for (std::size_t i = nodes_; i < x_.size(); ++i) work += torque_[i].dot(turning_[i]);
  // What friction takes has its own account; the damping of approach belongs to this one.
  const double given =
      committed_.contact + committed_.guard + tied_energy_ - trial_.contact - trial_.guard - trial_tied_;
  return std::max(0.0, opening_work_.work + given - work);
}

StepWork Contacts::step_work() const {
  StepWork sum = bodies_.step_work();
  if (evaluated_) sum += opening_work_;
  return sum;
}

double Contacts::work_on_cloth() const {
  double work = 0;
  for (std::size_t i = 0; i < nodes_; ++i)
    if (inverse_mass_[i] > 0) work += force_[i].dot(x_[i] - start_[i]);
  return work;
}

Outcome Contacts::add_forces(const law::Step& step, const Trial& trial, Forces& forces) {
  positions(trial.configuration.x(), share_, x_);
  const bool room = work_of_opening();
  positions(configuration_.committed_kinematics(), 0, start_);
  if (explicit_) find_motion();
  std::fill(force_.begin(), force_.end(), Vec3::Zero());
  std::fill(torque_.begin(), torque_.end(), Vec3::Zero());
  trial_ = touch(way(step.dt));
  trial_tied_ = push_tied();
  evaluated_ = true;
  blocked_ = !(trial_.gap > 0) || !room;
  if (!explicit_ && driven_meet())
    return {Answer::cut, -1, "parts of the cloth whose motion is given pass through what is fixed or driven"};
  if (blocked_) {
    Outcome passed{Answer::cut, -1, "surfaces that touch would pass through each other"};
    for (std::size_t n = 0; n < nodes_ && passed.element < 0; ++n)
      if (!force_[n].allFinite()) passed.element = cloth_.element_at(static_cast<Index>(n));
    return passed;
  }
  bodies_.load(std::span(force_).subspan(nodes_), std::span(torque_).subspan(nodes_));
  if (implicit_) trial_impact_ = taken();
  if (trial_.touching == 0 && tied_.empty()) return {};
#pragma omp parallel for schedule(static) if (nodes_ >= kShare)
  for (std::size_t n = 0; n < nodes_; ++n) at(forces.on_x, static_cast<Index>(n)) -= force_[n];
  return {};
}

void Contacts::add_energies(const Trial&, std::vector<Energy>& out) const {
  const contact::Totals& totals = evaluated_ ? trial_ : committed_;
  out.push_back({"contact", Account::stored, totals.contact});
  out.push_back({"guard", Account::stored, totals.guard + held_energy_ + (evaluated_ ? held_work() : 0)});
  out.push_back({"stick", Account::stored, totals.stick});
  out.push_back({"friction", Account::dissipated, lost_ + lost()});
  out.push_back({"impact", Account::dissipated,
                 impact_ + (!evaluated_ ? 0
                            : implicit_ ? trial_impact_
                                        : trial_.impact)});
  if (!tied_.empty()) out.push_back({"springs", Account::stored, evaluated_ ? trial_tied_ : tied_energy_});
  out.push_back({"rigid", Account::moving, bodies_.kinetic()});
  if (!bodies_.any_loaded()) return;
  out.push_back({"springs", Account::stored, bodies_.spring_energy()});
  out.push_back({"damping", Account::damping, bodies_.damped()});
}

// --- tangent

// Computes the stiffness of the touching pairs. If it couples nodes not coupled so far, all pairs that
// are near are added, so that the pattern grows seldom. The coupled pairs depend only on the states
// visited.
void Contacts::prepare_tangent(const Trial& trial) {
  positions(trial.configuration.x(), share_, x_);
  positions(configuration_.committed_kinematics(), 0, start_);
  blocks_.clear();
  on_bodies_.clear();
  bool known = true;
  const auto add = [&](const std::array<std::int32_t, 4>& points, auto&& visit) {
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a + 1; b < 4; ++b) {
        const std::int64_t p = points[a], q = points[b];
        if (p < 0 || q < 0) continue;
        const auto [low, high] = std::minmax(p, q);
        if (high < static_cast<std::int64_t>(nodes_)) visit(low * static_cast<std::int64_t>(nodes_) + high);
      }
  };
  if (!meets()) return add_tied_blocks();
  contact_->stiffness(
      x_,
      [&](const std::array<std::int32_t, 4>& points, const contact::Matrix12& k,
          const contact::FrictionTangent* friction) {
        blocks_.push_back({points, k});
        if (bodies_.unknowns() > 0) add_on_body(friction);
        add(points, [&](std::int64_t pair) {
          known = known && std::binary_search(pairs_.begin(), pairs_.end(), pair);
        });
      },
      way(trial_time_ - configuration_.time()));
  add_tied_blocks();
  if (known) return;
  const double skin = edge_ / 3;
  for (const auto& candidate : contact::find_pairs(scene_, x_, skin))
    add(scene_.with_nodes(candidate.point), [&](std::int64_t pair) { pairs_.push_back(pair); });
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
}

void Contacts::couple(const Trial& trial, std::vector<NodePair>& pairs) {
  prepare_tangent(trial);
  for (const std::int64_t pair : pairs_)
    pairs.emplace_back(pair / static_cast<std::int64_t>(nodes_), pair % static_cast<std::int64_t>(nodes_));
}

void Contacts::add_tangent(const Trial&, TangentSink& sink) const {
  const auto from = bodies_.committed(), to = bodies_.target();
  for (const Block& block : blocks_)
    for (int a = 0; a < 4; ++a) {
      const std::int32_t p = block.point[a];
      if (p < 0 || p >= static_cast<std::int32_t>(nodes_)) continue;
      for (int b = 0; b < 4; ++b) {
        const std::int32_t q = block.point[b];
        if (q < 0) continue;
        const Mat3 k = weight_ * block.k.block<3, 3>(3 * a, 3 * b);
        if (q < static_cast<std::int32_t>(nodes_))
          sink.on_positions(p, q, k);
        else if (moves_)
          sink.on_lead(p, k * (1 - share_) * (to[q - nodes_] - from[q - nodes_]));
      }
    }
  if (gas_.ranks.on_x.empty() || !moves_ || share_ >= 1) return;
  const auto change = gas_change({}, way_left(), true);
  for (Index n = 0; n < static_cast<Index>(nodes_); ++n)
    sink.on_lead(n, at(std::span<const double>(change), n));
}

// --- steps

void Contacts::mark(const Trial& trial) {
  marked_.resize(x_.size());
  by_.resize(x_.size());
  positions(trial.configuration.x(), share_, marked_);
}

double Contacts::near_share(const Trial& trial) {
  positions(trial.configuration.x(), share_, by_);
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < by_.size(); ++i) mean += by_[i] - marked_[i];
  mean /= static_cast<double>(by_.size());
  double most = 0;
  for (std::size_t i = 0; i < by_.size(); ++i)
    most = std::max(most, (by_[i] - marked_[i] - mean).squaredNorm());
  const double far = kFar * edge_;
  return far > 0 && most > far * far ? far / std::sqrt(most) : 1;
}

double Contacts::safe_fraction(const Trial& trial) {
  positions(trial.configuration.x(), share_, by_);
  const bool vertex_motion_bounds_surface_motion =
      contact_->vertex_motion_bounds_surface_motion(marked_, by_);
  double most = 0;
  for (std::size_t i = 0; i < by_.size(); ++i) {
    by_[i] -= marked_[i];
    most = std::max(most, by_[i].squaredNorm());
  }
  if (evaluated_ && contact::cannot_meet(std::sqrt(most), trial_.gap) && vertex_motion_bounds_surface_motion)
    return 1;
  return contact_->safe_fraction(marked_, by_);
}

void Contacts::commit() {
  if (evaluated_) {
    lost_ += lost();
    impact_ += implicit_ ? trial_impact_ : trial_.impact;
    committed_ = trial_;
    held_energy_ += held_work();
    std::swap(held_before_, held_);
    held_.clear();
    tied_energy_ = trial_tied_;
    if (meets()) contact_->commit();
  }
  evaluated_ = false;
  share_ = at_ = 0;
  if (committed_pairs_.size() != pairs_.size()) committed_pairs_ = pairs_;
  bodies_.commit();
  if (scene_.parts()) follow_faces();
}

void Contacts::rollback() {
  evaluated_ = blocked_ = false;
  held_.clear();
  if (meets()) contact_->rollback();
  share_ = at_ = 0;
  if (committed_pairs_.size() != pairs_.size()) pairs_ = committed_pairs_;
  bodies_.rollback();
}

void Contacts::keep(Archive& archive) {
  bodies_.keep(archive);
  archive(committed_.contact, committed_.guard, committed_.stick, committed_.gap, lost_, impact_, pairs_);
  archive(held_before_, held_energy_);
  if (!tied_.empty()) archive(tied_energy_);
  contact_->keep(archive);
  std::vector<double> apart = scene_.apart();
  const bool parts = joints_.any() || !dofs_.stitches().empty();
  if (parts) archive(apart);
  if (!archive.reading()) return;
  if (parts) set_apart(std::move(apart));
  committed_pairs_ = pairs_;
  reading_.version = 0;
}

// --- reading

int Contacts::find_body(const model::Rigid& body) const {
  for (std::size_t b = 0; b < bodies_.count(); ++b)
    if (&bodies_.body(b) == &body) return static_cast<int>(b);
  return -1;
}

const Contacts::Reading& Contacts::read() const {
  if (reading_.version == configuration_.version() && !reading_.x.empty()) return reading_;
  reading_.version = configuration_.version();
  reading_.x.resize(x_.size());
  positions(configuration_.x(), share_, reading_.x);
  open_to(configuration_.time());
  reading_.force.assign(x_.size(), Vec3::Zero());
  if (!meets()) {
    reading_.at_points.gap.assign(x_.size(), std::numeric_limits<double>::infinity());
    reading_.at_points.pressure.assign(x_.size(), 0);
    return reading_;
  }
  reading_.totals = contact_->add_forces(reading_.x, reading_.force);
  reading_.at_points = contact_->at_points(reading_.x);
  return reading_;
}

Contacts::NearestPair Contacts::nearest() const {
  const auto found = contact_->nearest(read().x);
  return {found.gap, found.point};
}

double Contacts::gap(Index node) const {
  return read().at_points.gap[point_of(node, model_.mesh(), joints_)];
}

double Contacts::pressure(Index node) const {
  return read().at_points.pressure[point_of(node, model_.mesh(), joints_)];
}

}  // namespace fabricsh::mechanics
