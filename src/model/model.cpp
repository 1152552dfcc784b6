#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

#include "base/error.hpp"
#include "base/number.hpp"
#include "mesh/check.hpp"
#include "mesh/corners.hpp"
#include "section/transverse.hpp"

namespace fabricsh::model {

namespace {

const char* const kFreedomNames[] = {"x", "y", "z", "rx", "ry", "rz"};

std::string quoted(const std::string& s) { return "'" + s + "'"; }

void take_word(FixedFreedoms& f, const std::string& word, const std::string& call) {
  if (word == "rotation") {
    f.rotation = true;
    return;
  }
  for (int i = 0; i < 6; ++i)
    if (word == kFreedomNames[i]) {
      (i < 3 ? f.translation[i] : f.axis[i - 3]) = true;
      return;
    }
  throw Error(call + ": unknown freedom " + quoted(word) + ", expected some of x y z rx ry rz rotation");
}

bool none_given(const Components& c) { return !c[0] && !c[1] && !c[2]; }

// m, the mean length of the sides of elements.
double mean_side(const mesh::Mesh& mesh) {
  double sum = 0, count = 0;
  for (const auto& e : mesh.elements) {
    const int n = (e[3] < 0 ? 3 : 4);
    for (int a = 0; a < n; ++a, ++count) sum += (mesh.nodes[e[(a + 1) % n]] - mesh.nodes[e[a]]).norm();
  }
  return count > 0 ? sum / count : 0;
}

// The card with the folds that the model asks for.
card::Card folding(card::Card card, const Options& options) {
  card.folds = options.folds.value_or(card.folds);
  return card;
}

section::Section section_of(const card::Card& card, const Options& options, const mesh::Mesh& mesh) {
  if (!options.plies.empty()) {
    auto plies = options.plies;
    for (auto& ply : plies) ply.card = folding(ply.card, options);
    return section::stacked(plies, options.points, options.offset);
  }
  const double thickness = options.thickness.value_or(card.thickness);
  const card::Card own = folding(card, options);
  if (options.membrane) return section::membrane(own, thickness);
  section::Section out = section::integrated(own, thickness, options.points, options.offset);
  section::hide_transverse_shear(out, own, mean_side(mesh));
  return out;
}

section::Section make_section(const card::Card& card, const Options& options, const mesh::Mesh& mesh) {
  section::Section section = section_of(card, options, mesh);
  if (options.full_yarns) section.yarns_over_shear = {};
  return section;
}

// The shape in which the cloth of a body is free of stress.
const mesh::Mesh& shape_of(const BodyGiven& body) {
  return body.reference.mesh ? *body.reference.mesh : *body.mesh;
}

}  // namespace

FixedFreedoms parse_freedoms(const std::string& words, const std::string& call) {
  FixedFreedoms f;
  std::string word;
  bool any = false;
  for (const char c : words + " ") {
    if (c != ' ' && c != ',' && c != '\t' && c != '\n') {
      word += c;
      continue;
    }
    if (word.empty()) continue;
    take_word(f, word, call);
    any = true;
    word.clear();
  }
  if (!any) throw Error(call + ": no freedom named, expected some of x y z rx ry rz rotation");
  return f;
}

Model::Model(std::shared_ptr<mesh::Mesh> mesh, card::Card card, Options options)
    : Model(std::vector<BodyGiven>{{"", std::move(mesh), std::move(card), std::move(options), {}}}) {}

Model::Model(std::vector<BodyGiven> bodies) : bodies_(std::move(bodies)) {
  if (bodies_.empty()) throw Error("model: field 'bodies': expected at least one body, got none");
  if (bodies_.size() == 1 && bodies_.front().name.empty()) {
    mesh_ = bodies_.front().mesh;
  } else {
    std::vector<std::pair<std::string, std::shared_ptr<const mesh::Mesh>>> parts;
    for (const auto& body : bodies_) parts.emplace_back(body.name, body.mesh);
    mesh_ = std::make_shared<mesh::Mesh>(mesh::join(parts));
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b) add_body(static_cast<Index>(b));
}

void Model::add_body(Index which) {
  const BodyGiven& body = bodies_[which];
  const std::string of = body.name.empty() ? "" : "body '" + body.name + "': ";
  if (body.mesh->elements.empty()) throw Error("model: " + of + "the mesh has no elements");
  if (const auto twice = mesh::repeated_elements(*body.mesh); !twice.empty())
    throw Error("model: " + of + "element " + std::to_string(twice.front() + 1) +
                " of the mesh is on the same nodes as an element before" +
                (twice.size() > 1 ? ", as are " + std::to_string(twice.size() - 1) + " more" : "") +
                ": expected each piece of cloth once (plies are a field of the model)");
  take_reference(body, of);
  const mesh::Mesh& shape = shape_of(body);
  if (!body.options.warp && !shape.flat && !shape.has_warp())
    throw Error(
        "model: " + of +
        "field 'warp': expected a direction {x,y,z}, an angle in degrees or a function, got nil: this "
        "mesh is "
        "not a flat generated one, so the warp has no default");
  const auto add = [&](const std::string& name, const card::Card& card, const Options& options) {
    regions_.push_back({name, card, options, which});
    sections_.push_back(make_section(card, options, shape));
    return static_cast<Index>(regions_.size()) - 1;
  };
  const Index own = add(body.name, body.card, body.options);
  if (own > 0 || !body.regions.empty()) assign(own, which, "");
  for (const RegionGiven& region : body.regions)
    assign(add((body.name.empty() ? "" : body.name + ".") + region.set, region.card, region.options), which,
           region.set);
}

// Assigns the elements of a set of a body (empty: the whole body) to a region.
void Model::assign(Index region, Index which, const std::string& set) {
  const BodyGiven& body = bodies_[which];
  const Index first = mesh_->parts.empty() ? 0 : mesh_->parts[which].first_element;
  region_of_.resize(mesh_->elements.size(), 0);
  if (set.empty()) {
    std::fill_n(region_of_.begin() + first, body.mesh->elements.size(), static_cast<int>(region));
    return;
  }
  const auto inside = body.mesh->elements_in(body.mesh->set(set));
  if (inside.empty()) throw Error("model: region " + quoted(set) + " holds no whole element");
  for (const Index e : inside) {
    int& now = region_of_[first + e];
    if (!body.regions.empty() && regions_[now].name != body.name)
      throw Error("model: element " + std::to_string(e + 1) + " is in two regions, " +
                  quoted(regions_[now].name) + " and " + quoted(regions_[region].name));
    now = static_cast<int>(region);
  }
}

std::shared_ptr<Model> Model::copy() const {
  auto made = std::make_shared<Model>(*this);
  made->sealed_ = false;
  return made;
}

void Model::seal() {
  sealed_ = mesh_->in_use = true;
  for (auto& body : bodies_) {
    body.mesh->in_use = true;
    if (body.reference.mesh) body.reference.mesh->in_use = true;
  }
}

namespace {

// What a ply is called by its number, from 0.
std::string ply_word(std::size_t number) { return "ply" + std::to_string(number + 1); }

}  // namespace

int Model::ply_of(Index element, const std::string& ply) const {
  const auto& plies = regions_[region_of(element)].options.plies;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, plies.size()); ++i)
    if (ply == ply_word(i) || (i < plies.size() && !ply.empty() && ply == plies[i].name))
      return static_cast<int>(i);
  return -1;
}

std::vector<std::string> Model::plies() const {
  std::vector<std::string> all;
  const auto add = [&all](const std::string& word) {
    if (!word.empty() && std::find(all.begin(), all.end(), word) == all.end()) all.push_back(word);
  };
  for (const Region& region : regions_) {
    const auto& plies = region.options.plies;
    for (std::size_t i = 0; i < std::max<std::size_t>(1, plies.size()); ++i) add(ply_word(i));
    for (const auto& ply : plies) add(ply.name);
  }
  return all;
}

std::string Model::element_name(Index element) const {
  if (mesh_->parts.empty()) return std::to_string(element + 1);
  std::size_t part = mesh_->parts.size() - 1;
  while (mesh_->parts[part].first_element > element) --part;
  return std::to_string(element - mesh_->parts[part].first_element + 1) + " of body " +
         mesh_->parts[part].name;
}

void Model::check_open(const char* call) const {
  if (sealed_)
    throw Error(std::string(call) + ": the model is in use by an analysis and can't be changed any more");
}

void Model::fix(const std::string& set, const FixedFreedoms& fixed, const Mat3& frame) {
  check_open("fix");
  mesh_->set(set);
  supports_.push_back({set, fixed, frame});
}

void Model::move(const std::string& set, Components displacement, const Mat3& frame) {
  check_open("move");
  mesh_->set(set);
  if (none_given(displacement)) throw Error("move: expected at least one of x, y, z, got none");
  motions_.push_back({set, std::move(displacement), frame});
}

void Model::crease(CreaseGiven crease) {
  check_open("crease");
  edges_of(*this, crease);
  creases_.push_back(std::move(crease));
}

void Model::gravity(Components acceleration) {
  check_open("gravity");
  gravity_ = std::move(acceleration);
}

void Model::velocity(InitialVelocity velocity) {
  check_open("velocity");
  mesh_->set(velocity.set);
  if (!velocity.linear.allFinite() || !velocity.spin.allFinite() || !velocity.centre.allFinite())
    throw Error("velocity: expected finite numbers in m/s, degrees/s and m");
  velocities_.push_back(std::move(velocity));
}

void Model::turn(const std::string& set, const Vec3& axis, History angle, std::optional<Vec3> centre) {
  check_open("turn");
  mesh_->set(set);
  if (!(axis.norm() > 0) || !axis.allFinite())
    throw Error("turn: field 'axis': expected a direction {x, y, z}");
  turns_.push_back({set, axis.normalized(), std::move(angle), centre});
}

void Model::symmetry(const std::string& set, int axis) {
  check_open("symmetry");
  FixedFreedoms f;
  f.translation[axis] = true;
  f.axis = {true, true, true};
  f.axis[axis] = false;
  fix(set, f);
  supports_.back().symmetry = axis;
}

void Model::tie(Tie tie) {
  check_open("tie");
  const auto& set = mesh_->set(tie.set);
  const FixedFreedoms& f = tie.freedoms;
  if (tie.kind == TieKind::rigid) {
    if (set.size() < 2) throw Error("tie: rigid set " + quoted(tie.set) + " needs two nodes or more");
  } else if (!f.translation[0] && !f.translation[1] && !f.translation[2] && !f.rotation) {
    throw Error("tie: no freedom named, expected some of x y z");
  }
  if (tie.kind == TieKind::periodic) mesh_->set(tie.partner);
  if (f.axis[0] || f.axis[1] || f.axis[2] || (f.rotation && tie.kind != TieKind::periodic))
    throw Error(tie.kind == TieKind::periodic ? "tie: expected some of x y z rotation"
                                              : "tie: expected some of x y z");
  ties_.push_back(std::move(tie));
}

void Model::tearable(Zone zone) {
  check_open("tearable");
  if (!zone.path.empty()) mesh_->set(zone.path);
  if (mesh_->elements_in(mesh_->set(zone.set)).empty())
    throw Error("tearable: set " + quoted(zone.set) + " holds no whole element");
  zones_.push_back(std::move(zone));
}

void Model::strength(StrengthGiven strength) {
  check_open("strength");
  const auto elements = mesh_->elements_in(mesh_->set(strength.set));
  if (elements.empty()) throw Error("strength: set " + quoted(strength.set) + " holds no whole element");
  const auto softens = [this](Index e) {
    const auto& points = sections_[static_cast<std::size_t>(region_of(e))].points;
    return std::any_of(points.begin(), points.end(), [](const auto& p) { return law::softens(*p.law); });
  };
  if (std::none_of(elements.begin(), elements.end(), softens))
    throw Error("strength: set " + quoted(strength.set) +
                ": expected elements of a card whose yarns soften (its field 'damage'), got none");
  if (!(strength.factor > 0) || !std::isfinite(strength.factor))
    throw Error("strength: field 'factor': expected a number above 0, got " + number(strength.factor));
  if (!(strength.modulus >= 0) || !std::isfinite(strength.modulus))
    throw Error("strength: field 'modulus': expected a number above 0, got " + number(strength.modulus));
  strengths_.push_back(std::move(strength));
}

void Model::seam(Seam seam) {
  check_open("seam");
  mesh_->set(seam.first);
  mesh_->set(seam.second);
  const auto positive = [](const char* field, const std::optional<double>& value, const char* unit) {
    if (value && !(*value > 0 && std::isfinite(*value)))
      throw Error("seam: field '" + std::string(field) + "': expected a positive number, " + unit + ", got " +
                  number(*value));
  };
  positive("over", seam.over, "s");
  positive("stiffness", seam.stiffness, "N/m^2");
  positive("strength", seam.strength, "N/m");
  positive("energy", seam.energy, "J/m");
  if (!(seam.ease >= 0 && seam.ease < 1))
    throw Error("seam: field 'ease': expected a share of the length from 0 to below 1, got " +
                number(seam.ease));
  if (seam.strength.has_value() != seam.energy.has_value())
    throw Error("seam: field '" + std::string(seam.strength ? "energy" : "strength") +
                "': expected strength (N/m) and energy (J/m) together, got one alone");
  if (seam.stiffness && seam.strength) {
    const double least = *seam.strength * *seam.strength / (2 * *seam.stiffness);
    if (!(*seam.energy > least))
      throw Error("seam: field 'energy': expected more than " + number(least) +
                  " J/m, which a seam of this stiffness stores at its strength, got " + number(*seam.energy));
  }
  seams_.push_back(std::move(seam));
}

void Model::band(EdgeBand band) {
  check_open("band");
  mesh_->set(band.set);
  if (!(band.stiffness > 0) || !std::isfinite(band.stiffness))
    throw Error("band: field 'stiffness': expected a positive number, N, got " + number(band.stiffness));
  if (!(band.ease >= 0 && band.ease < 1))
    throw Error("band: field 'ease': expected a share of the length from 0 to below 1, got " +
                number(band.ease));
  if (band.over && !(*band.over > 0 && std::isfinite(*band.over)))
    throw Error("band: field 'over': expected a positive number, s, got " + number(*band.over));
  bands_of_edges_.push_back(std::move(band));
}

std::vector<Index> Model::elements_of_zones() const {
  std::vector<Index> all;
  for (const auto& zone : zones_) {
    const auto inside = mesh_->elements_in(mesh_->set(zone.set));
    all.insert(all.end(), inside.begin(), inside.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

void Model::divide_zones() {
  if (mesh_->whole) return;
  if (!zones_.empty())
    mesh_ = mesh::split_corners(mesh_, elements_of_zones());
  else if (const auto hinges = hinge_edges(*this); !hinges.empty())
    mesh_ = mesh::split_sides(mesh_, hinges);
}

// The nodes of a periodic tie pair by their places, of which each has only one node.
void Model::check_zones() const {
  if (zones_.empty()) return;
  std::vector<char> in_zone(mesh_->nodes.size(), 0);
  for (const Index e : elements_of_zones())
    for (const Index n : mesh_->elements[e])
      if (n >= 0) in_zone[n] = 1;
  for (const auto& tie : ties_)
    for (const std::string& set : {tie.set, tie.partner})
      if (tie.kind == TieKind::periodic)
        for (const Index n : mesh_->set(set))
          if (in_zone[n] != 0)
            throw Error("tearable: node " + std::to_string(n + 1) +
                        " of a zone is in the periodic tie of set " + quoted(set) +
                        ": expected zones without such nodes");
}

void Model::remove(DeclarationKind kind, std::size_t i) {
  check_open("remove");
  const auto take = [i](auto& all) { remove_at(all, i); };
  switch (kind) {
    case DeclarationKind::fix:
      return take(supports_);
    case DeclarationKind::move:
      return take(motions_);
    case DeclarationKind::turn:
      return take(turns_);
    case DeclarationKind::tie:
      return take(ties_);
    case DeclarationKind::tearable:
      return take(zones_);
    case DeclarationKind::seam:
      return take(seams_);
    case DeclarationKind::strength:
      return take(strengths_);
    case DeclarationKind::band:
      return take(bands_of_edges_);
    case DeclarationKind::gas:
      take(gases_);
      return close_with_bodies();
    case DeclarationKind::crease:
      return take(creases_);
    case DeclarationKind::velocity:
      return take(velocities_);
    case DeclarationKind::contact:
      return interactions_.remove(Interactions::InteractionKind::contact, i);
    case DeclarationKind::body_move:
      return interactions_.remove(Interactions::InteractionKind::motion, i);
    case DeclarationKind::body_velocity:
      return interactions_.remove(Interactions::InteractionKind::velocity, i);
    case DeclarationKind::body_load:
      return interactions_.remove(Interactions::InteractionKind::load, i);
    case DeclarationKind::body_spring:
      return interactions_.remove(Interactions::InteractionKind::spring, i);
    case DeclarationKind::body_fix:
      return interactions_.remove(Interactions::InteractionKind::support, i);
    case DeclarationKind::gravity:
      gravity_ = {};
  }
}

void Model::contact(ContactGiven contact) {
  check_open("contact");
  interactions_.add(std::move(contact), *mesh_);
}

void Model::move(BodyMotion motion) {
  check_open("move");
  interactions_.move(std::move(motion));
}

void Model::velocity(BodyVelocity velocity) {
  check_open("velocity");
  interactions_.velocity(std::move(velocity));
}

void Model::load(BodyLoad load) {
  check_open(load.moment ? "moment" : "force");
  interactions_.load(std::move(load));
}

void Model::spring(BodySpring spring) {
  check_open(spring.damper ? "damper" : "spring");
  interactions_.spring(std::move(spring));
}

void Model::support(BodySupport support) {
  check_open("fix");
  interactions_.support(std::move(support));
}

namespace {

// The times of all kinks of loads.
struct KinksOf {
  std::vector<double>& all;
  template <class Load>
  void about(const Load&) {}
  void history(const char*, const History& h, const char*) {
    all.insert(all.end(), h.kinks().begin(), h.kinks().end());
  }
  void components(const Components& value, const char* unit) {
    for (const auto& h : value)
      if (h) history("", *h, unit);
  }
  void stiffness(const std::array<double, 3>&, const char*) {}
  void frame(const Mat3&) {}
};

}  // namespace

std::vector<double> Model::kinks() const {
  std::vector<double> all = interactions_.kinks();
  const auto add = [&](const History& h) { all.insert(all.end(), h.kinks().begin(), h.kinks().end()); };
  const auto add_each = [&](const Components& c) {
    for (const auto& h : c)
      if (h) add(*h);
  };
  for (const auto& m : motions_) add_each(m.displacement);
  KinksOf kinks_of{all};
  tell_each(loads_, kinks_of);
  add_each(gravity_);
  for (const auto& t : turns_) add(t.angle);
  for (const auto& g : gases_)
    if (g->inflow) add(*g->inflow);
  for (const auto& s : seams_)
    if (s.over) all.push_back(*s.over);
  for (const auto& b : bands_of_edges_)
    if (b.over) all.push_back(*b.over);
  std::sort(all.begin(), all.end());
  return all;
}

namespace {

// State of a node during validation: for each direction 0 free, 1 fixed, 2 moved; and the set responsible.
struct NodeHold {
  std::array<int, 3> kind{};
  std::array<std::string, 3> by;
  Mat3 frame = global_frame();
  bool framed = false;  // held along one or two directions only, so that the frame matters
  std::string framed_by;
};

[[noreturn]] void clash(mesh::Index node, const std::string& what) {
  throw Error("model: node " + std::to_string(node + 1) + ": " + what);
}

void take_frame(NodeHold& seen, mesh::Index node, const Mat3& frame, const std::string& set) {
  if (seen.framed && (seen.frame - frame).norm() > 1e-12)
    clash(node, "sets " + quoted(seen.framed_by) + " and " + quoted(set) +
                    " hold or move it in two different frames");
  seen.frame = frame;
  seen.framed = true;
  seen.framed_by = set;
}

void take_support(NodeHold& seen, mesh::Index node, const Support& s) {
  const auto& t = s.fixed.translation;
  if (!(t[0] || t[1] || t[2])) return;
  if (!(t[0] && t[1] && t[2])) take_frame(seen, node, s.frame, s.set);
  for (int i = 0; i < 3; ++i)
    if (t[i] && seen.kind[i] == 0) {
      seen.kind[i] = 1;
      seen.by[i] = s.set;
    }
}

void take_motion(NodeHold& seen, mesh::Index node, const PrescribedMotion& m) {
  take_frame(seen, node, m.frame, m.set);
  for (int i = 0; i < 3; ++i) {
    if (!m.displacement[i]) continue;
    const std::string direction = kFreedomNames[i];
    if (seen.kind[i] == 1)
      clash(node,
            direction + " is fixed (set " + quoted(seen.by[i]) + ") and moved (set " + quoted(m.set) + ")");
    if (seen.kind[i] == 2 && seen.by[i] != m.set)
      clash(node, direction + " is moved twice (sets " + quoted(seen.by[i]) + " and " + quoted(m.set) + ")");
    if (seen.kind[i] == 2) clash(node, direction + " is moved twice (set " + quoted(m.set) + ")");
    seen.kind[i] = 2;
    seen.by[i] = m.set;
  }
}

}  // namespace

namespace {

void take_turn(NodeHold& seen, mesh::Index node, const PrescribedTurn& t) {
  for (int i = 0; i < 3 && t.centre; ++i) {
    if (seen.kind[i] != 0)
      clash(node, std::string(kFreedomNames[i]) + " is " + (seen.kind[i] == 1 ? "fixed" : "moved") +
                      " (set " + quoted(seen.by[i]) + ") and turned (set " + quoted(t.set) + ")");
    seen.kind[i] = 2;
    seen.by[i] = t.set;
  }
}

void check_turned_rotations(const mesh::Mesh& mesh, const std::vector<PrescribedTurn>& turns,
                            const std::vector<Support>& supports) {
  std::map<mesh::Index, std::string> turned;
  for (const auto& t : turns)
    for (const auto n : mesh.set(t.set))
      if (const auto [at, fresh] = turned.emplace(n, t.set); !fresh)
        clash(n, "is turned twice (sets " + quoted(at->second) + " and " + quoted(t.set) + ")");
  for (const auto& s : supports) {
    if (!s.fixed.rotation && !s.fixed.axis[0] && !s.fixed.axis[1] && !s.fixed.axis[2]) continue;
    for (const auto n : mesh.set(s.set))
      if (turned.contains(n))
        clash(n, "rotation is fixed (set " + quoted(s.set) + ") and turned (set " + quoted(turned[n]) + ")");
  }
}

}  // namespace

void Model::validate() const {
  std::map<mesh::Index, NodeHold> seen;
  check_turned_rotations(*mesh_, turns_, supports_);
  for (const auto& s : supports_)
    for (const auto n : mesh_->set(s.set)) take_support(seen[n], n, s);
  for (const auto& m : motions_)
    for (const auto n : mesh_->set(m.set)) take_motion(seen[n], n, m);
  for (const auto& t : turns_)
    for (const auto n : mesh_->set(t.set)) take_turn(seen[n], n, t);
  for (const auto& m : motions_)
    for (const auto& h : m.displacement)
      if (h) h->value(0);
  if (!mesh_->whole) {
    check_zones();
    check_hinges(*this);
    work_out_ties(*this);
    work_out_seams(*this);
    for (const EdgeBand& b : bands_of_edges_) chain_of(*mesh_, b.set);
    for (const auto& gas : gases_) enclosure_of(*this, *gas);
  }
  check_symmetry(*this);
  interactions_.validate(*mesh_);
  std::vector<bool> used(mesh_->nodes.size(), false);
  for (const auto& e : mesh_->elements)
    for (const auto n : e)
      if (n >= 0) used[n] = true;
  for (std::size_t n = 0; n < used.size(); ++n)
    if (!used[n]) throw Error("model: node " + std::to_string(n + 1) + " belongs to no element");
}

Vec3 Model::warp_at(Index element, const Vec3& X, const Vec3& n) const {
  const auto& warp = regions_[region_of(element)].options.warp;
  const auto& given = rest_nodes_.empty() ? mesh_->warp : rest_warp_;
  const Direction own = given.empty() || given[element].isZero() ? Direction(0.0) : Direction(given[element]);
  const Direction direction = warp ? (*warp)(X) : own;
  Vec3 wanted;
  if (const double* angle = std::get_if<double>(&direction)) {
    const Vec3 e1 = (Vec3::UnitX() - n.x() * n).normalized();
    const double a = *angle * std::numbers::pi / 180;
    wanted = std::cos(a) * e1 + std::sin(a) * n.cross(e1);
    if (std::abs(n.x()) > 1 - 1e-12) wanted.setZero();
  } else {
    wanted = std::get<Vec3>(direction);
  }
  if (!wanted.allFinite() || (wanted - wanted.dot(n) * n).norm() <= 1e-9 * wanted.norm()) {
    std::ostringstream text;
    text << "model: field 'warp': no direction in the surface at (" << X.transpose() << "), whose normal is ("
         << n.transpose() << ")";
    throw Error(text.str());
  }
  return wanted;
}

namespace {

// "1 support", "2 supports".
std::string counted(std::size_t count, const char* noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string loads_of(const Model& m) {
  std::string words;
  const auto add = [&words](const std::string& more) { words += (words.empty() ? "" : ", ") + more; };
  each_kind(m.loads(), [&](const auto& all) {
    if (!all.empty()) add(counted(all.size(), all.front().call));
  });
  if (std::any_of(m.gravity().begin(), m.gravity().end(), [](const auto& part) { return part.has_value(); }))
    add("gravity");
  return words.empty() ? "no loads" : words;
}

std::string warp_words(const Options& options, const mesh::Mesh& mesh) {
  if (options.warp) return options.warp_text;
  return mesh.warp.empty() ? "0 degrees from +x (default)" : "along the grain of the mesh";
}

}  // namespace

std::string Model::describe() const {
  std::ostringstream text;
  text << "model: " << mesh_->origin << ", " << mesh_->uncut().nodes.size() << " nodes, "
       << mesh_->elements.size() << " elements; ";
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const auto& section = sections_[r];
    const auto& options = regions_[r].options;
    if (!regions_[r].name.empty()) text << regions_[r].name << ": ";
    text << "card " << regions_[r].card.name << ", " << section.thickness * 1e3 << " mm, "
         << section.areal_mass * 1e3 << " g/m2; warp "
         << warp_words(options, shape_of(bodies_[regions_[r].body])) << "; "
         << (options.membrane ? "membrane" : counted(section.points.size(), "thickness point")) << "; "
         << rest_text(bodies_[regions_[r].body].reference);
  }
  text << counted(supports_.size(), "support") << ", " << counted(motions_.size(), "motion") << ", "
       << loads_of(*this);
  if (!zones_.empty())
    text << ", " << counted(zones_.size(), "tearable zone") << " of "
         << counted(elements_of_zones().size(), "element");
  if (!bands_of_edges_.empty()) text << ", " << counted(bands_of_edges_.size(), "band");
  if (!seams_.empty()) text << ", " << counted(seams_.size(), "seam");
  if (!gases_.empty()) text << ", " << counted(gases_.size(), "gas volume");
  if (!creases_.empty()) text << ", " << counted(creases_.size(), "crease");
  if (interactions_.any()) {
    if (!interactions_.contacts().empty())
      text << ", " << counted(interactions_.contacts().size(), "contact");
    for (const auto& body : interactions_.bodies())
      text << "; " << interactions_.name_of(*body) << ": " << body->describe();
  }
  return text.str();
}

}  // namespace fabricsh::model
