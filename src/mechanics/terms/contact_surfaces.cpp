// Data of the surfaces that may touch, and their consequences before anything moves.
#include "mechanics/terms/contact_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "base/number.hpp"
#include "contact/search.hpp"
#include "geometry/box.hpp"
#include "geometry/node_view.hpp"
#include "law/compression.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kLeast = 0.75;        // largest floor, as a share of the thickness
constexpr double kOfBodies = 0.05;     // stiffness * step^2 / reduced mass of two bodies: 14 steps in contact
constexpr double kPressed = 0.1;       // of the smaller radius: how deep bodies press each other at most
constexpr double kPressedLeast = 0.1;  // of that: the smallest distance left, below which is the floor
constexpr double kOfElements = 0.1;    // thickness in contact with a solid of facets, over an element's side

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

ContactSurfaces::ContactSurfaces(const model::Model& model, const Configuration& configuration,
                                 const Cloth& cloth, const Dofs& dofs)
    : model_(model),
      joints_(dofs.joints()),
      surfaces_(split_by_kind(model, model::work_out_surfaces(model.interactions(), model.mesh().uncut()))),
      scene_(scene_of(model, surfaces_, joints_)),
      bodies_(model, scene_),
      step_(contact_step_of_cloth * std::min(cloth.stable_step(true), cloth.rates().step_across_heights())) {
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
    scene_.interaction(meetings_.size() - 1).film = {given.film_drag(), given.film_speed,
                                                     given.film_exponent};
    friction_ = friction_ || given.friction > 0 || given.sticking.value_or(0) > 0 || given.viscosity;
    rubs_ = rubs_ || friction_ || loss > 0;
  }
  find_warps(configuration, cloth);
  follow_elements();
  spread_points();
  sew_scene(dofs);
  open_overlaps();
}

Index ContactSurfaces::point_of(Index node) const {
  return mechanics::point_of(node, model_.mesh(), joints_);
}
ContactSurfaces::Sheet ContactSurfaces::sheet(const std::vector<Index>& elements) const {
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
double ContactSurfaces::moving_mass(const model::SurfacePair& m) const {
  double inverse = 0;
  for (const int side : {m.first, m.second})
    if (side < static_cast<int>(sheets_.size()))
      inverse += 1 / sheets_[side].areal;
    else if (m.first >= static_cast<int>(sheets_.size()))
      inverse += bodies_.readings().inverse_mass_pressed(side - sheets_.size());
  return 1 / inverse;
}

// Two bodies press by a share of the smaller size at most, with what the explicit step of the cloth carries.
ContactSurfaces::Meeting ContactSurfaces::meeting_of_bodies(const model::SurfacePair& m) const {
  Meeting out;
  out.names = name_of(m.second) + " on " + name_of(m.first);
  out.bodies = true;
  double size = std::numeric_limits<double>::infinity();
  for (const int side : {m.first, m.second})
    if (const double s = bodies_.readings().size(side - sheets_.size()); s > 0) size = std::min(size, s);
  out.data.gap = kPressed * size;
  out.data.floor = kPressedLeast * out.data.gap;
  out.data.stiffness = out.carried = kOfBodies * moving_mass(m) / (step_ * step_);
  return out;
}

std::string ContactSurfaces::name_of(int side) const {
  if (side < static_cast<int>(sheets_.size())) {
    if (sheets_.size() == 1) return "the cloth";
    return sheets_[side].name.empty() ? "cloth " + std::to_string(side + 1) : sheets_[side].name;
  }
  return model_.interactions().name_of(bodies_.body(side - sheets_.size()));
}

// A sheet occupies half of its thickness on either side of its midsurface.
ContactSurfaces::Meeting ContactSurfaces::meeting_of(const model::SurfacePair& m) const {
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
    data.stiffness = given.stiffness.value_or(contact::dense_stiffness(data.gap, data.floor));
  return out;
}

std::string ContactSurfaces::stiffness_words(const Meeting& m, const contact::ContactLaw& law) const {
  const bool measured = !m.data.curve.empty();
  const std::string carried = m.taken      ? ", of the run from which this one begins"
                              : m.softened ? ", no more than the mesh carries in motion"
                                           : "";
  if (!measured)
    return "stiffness " + number(law.stiffest()) + " Pa/m" + (m.given ? "" : " (default" + carried + ")");
  return "pressed as its card's compression has it, to a stiffness of " + number(law.stiffest()) + " Pa/m" +
         (carried.empty() ? "" : " (" + carried.substr(2) + ")");
}

std::vector<std::string> ContactSurfaces::describe() const {
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

bool ContactSurfaces::assumes_stiffness() const {
  return std::any_of(meetings_.begin(), meetings_.end(),
                     [](const Meeting& m) { return !m.bodies && !m.given && m.data.curve.empty(); });
}

void ContactSurfaces::soften(bool measured) {
  for (std::size_t i = 0; i < meetings_.size(); ++i) {
    Meeting& m = meetings_[i];
    if (m.given || (!m.data.curve.empty() && !measured)) continue;
    if (scene_.interactions()[i].law.stiffest() <= m.carried) continue;
    m.softened = true;
    m.data.stiffness = m.carried;
    scene_.interaction(i).law = contact::ContactLaw(m.data);
  }
}

// The same contact goes on as it was: its force would jump with its stiffness.
void ContactSurfaces::take_stiffness(const ContactSurfaces& other) {
  for (std::size_t i = 0; i < meetings_.size(); ++i) {
    Meeting& m = meetings_[i];
    const auto twin = std::find_if(other.meetings_.begin(), other.meetings_.end(), [&m](const Meeting& o) {
      return o.names == m.names && o.data.gap == m.data.gap && o.data.floor == m.data.floor &&
             o.data.curve == m.data.curve && !o.given;
    });
    if (m.given || twin == other.meetings_.end() || twin->data.stiffness == m.data.stiffness) continue;
    m.taken = true;
    m.data.stiffness = twin->data.stiffness;
    scene_.interaction(i).law = contact::ContactLaw(m.data);
  }
}

// Each point begins with the share of its gap that it has at the start, so that nothing presses then.
void ContactSurfaces::open_overlaps() {
  if (!any()) return;
  std::vector<std::vector<double>> shares(meetings_.size());
  for (std::size_t i = 0; i < meetings_.size(); ++i) {
    if (!meetings_[i].settle) continue;
    shares[i].assign(scene_.reference().size(), 1);
    scene_.interaction(i).opening = shares[i];
  }
  for (const contact::Candidate& c : contact::find_pairs(scene_, scene_.reference(), 0)) {
    auto& share = shares[static_cast<std::size_t>(c.interaction)];
    if (share.empty()) continue;
    const double whole = c.whole * scene_.interactions()[static_cast<std::size_t>(c.interaction)].law.gap(),
                 gap = contact::gap_of(c, contact::corners_of(c, scene_.reference()));
    const bool edges = c.pair.kind == contact::PairKind::edges || c.pair.kind == contact::PairKind::wrap;
    const auto points = scene_.spots().with_nodes(c.point);
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
    for (double& s : shares[i]) s = std::max(s, 0.0);
    scene_.interaction(i).opening = std::move(shares[i]);
  }
}

double ContactSurfaces::opened_at() const {
  double last = 0;
  for (const Meeting& m : meetings_)
    if (m.near > 0) last = std::max(last, *m.settle);
  return last;
}

int ContactSurfaces::body_at(std::int32_t point) const {
  for (std::size_t b = 0; b < bodies_.count(); ++b) {
    const auto [first, last] = bodies_.vertices(b);
    const auto p = static_cast<std::size_t>(point) - nodes();
    if (p >= first && p < last) return static_cast<int>(b);
  }
  return -1;
}

std::string ContactSurfaces::words(const std::array<std::int32_t, 4>& points) const {
  std::string nodes, named;
  int count = 0, last = -1;
  for (const std::int32_t p : points) {
    if (p < 0) continue;
    if (static_cast<std::size_t>(p) < this->nodes()) {
      nodes += (count++ > 0 ? ", " : "") + std::to_string(p + 1);
      continue;
    }
    const int body = body_at(p);
    if (body != last)
      named += (named.empty() ? "the " : " and the ") + model_.interactions().name_of(bodies_.body(body));
    last = body;
  }
  if (count == 0) return named;
  const std::string words = count > 1 ? "nodes " + nodes : "node " + nodes;
  return named.empty() ? words : words + " and " + named;
}

int ContactSurfaces::find_body(const model::Rigid& body) const {
  for (std::size_t b = 0; b < bodies_.count(); ++b)
    if (&bodies_.body(b) == &body) return static_cast<int>(b);
  return -1;
}

// m, in the mean.
double ContactSurfaces::side_of_elements(int sheet) const {
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
void ContactSurfaces::follow_elements() {
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
              contact::dense_stiffness(gap, m.data.floor)};  // the floor is below the gap that it had
    scene_.interaction(i).law = contact::ContactLaw(m.data);
  }
}

// Friction by direction needs the warp of each triangle as a sum of its sides, which it follows.
void ContactSurfaces::find_warps(const Configuration& configuration, const Cloth& cloth) {
  const auto& all = model_.interactions().contacts();
  if (std::none_of(all.begin(), all.end(), [](const auto& given) { return given.across.has_value(); }))
    return;
  std::vector<std::array<double, 2>> warp(scene_.triangles().size(), {0, 0});
  for (std::size_t t = 0; t < warp.size(); ++t) {
    const contact::TriangleRow& row = scene_.triangles()[t];
    if (row.surface >= static_cast<int>(sheets_.size())) continue;
    const auto corner = [&](std::size_t k) { return at(configuration.x(), row.nodes[k]); };
    Eigen::Matrix<double, 3, 2> sides;
    sides << corner(1) - corner(0), corner(2) - corner(0);
    const Eigen::Vector2d by = (sides.transpose() * sides).inverse() * sides.transpose() *
                               cloth.readings().yarns(element_of(row)).first;
    warp[t] = {by[0], by[1]};
  }
  for (std::size_t i = 0; i < meetings_.size(); ++i)
    if (const auto& across = all[surfaces_.meetings[i].contact].across) {
      scene_.interaction(i).across = *across;
      scene_.interaction(i).warp = warp;
    }
}

// The points that seams hold together. Where seams meet, as those of four panels under an arm, all nodes that
// become one joint are held together, also those that no stitch of their own connects.
void ContactSurfaces::sew_scene(const Dofs& dofs) {
  if (dofs.stitches().empty()) return;
  std::vector<Index> first(nodes());
  std::iota(first.begin(), first.end(), Index{0});
  const auto root = [&](Index n) {
    while (first[n] != n) n = first[n];
    return n;
  };
  for (const auto& stitch : dofs.stitches())
    if (stitch.leads.size() == 1) {
      const Index a = root(stitch.node), b = root(stitch.leads[0].node);
      first[std::max(a, b)] = std::min(a, b);
    }
  std::map<Index, std::vector<Index>> joints;
  for (const auto& stitch : dofs.stitches()) {
    joints[root(stitch.node)].push_back(stitch.node);
    for (const auto& lead : stitch.leads) joints[root(lead.node)].push_back(lead.node);
  }
  std::vector<std::set<std::int32_t>> partners(nodes());
  for (const auto& stitch : dofs.stitches())
    for (const auto& lead : stitch.leads)
      for (const Index a : joints[root(stitch.node)])
        for (const Index b : joints[root(lead.node)]) {
          if (a == b) continue;
          partners[a].insert(static_cast<std::int32_t>(b));
          partners[b].insert(static_cast<std::int32_t>(a));
        }
  std::vector<std::vector<std::int32_t>> sorted;
  for (const auto& of_node : partners) sorted.emplace_back(of_node.begin(), of_node.end());
  scene_.neighbours().sew(std::move(sorted));
}

}  // namespace fabricsh::mechanics
