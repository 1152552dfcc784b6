#include "model/model.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "mesh/check.hpp"
#include "mesh/corners.hpp"

namespace fabricsh::model {

namespace {

std::string quoted(const std::string& s) { return "'" + s + "'"; }

}  // namespace

Model::Model(std::shared_ptr<mesh::Mesh> mesh, card::Card card, Options options)
    : Model(std::vector<BodyGiven>{{"", std::move(mesh), std::move(card), std::move(options), {}}}) {}

Model::Model(std::vector<BodyGiven> bodies) : Sheets(std::move(bodies)) {}

std::shared_ptr<Model> Model::copy() const {
  auto made = std::make_shared<Model>(*this);
  made->sealed_ = false;
  return made;
}

void Model::seal() {
  sealed_ = true;
  seal_meshes();
}

const Components& Model::gravity() const {
  static const Components none;
  const auto& given = all<Gravity>();
  return given.empty() ? none : given.front().acceleration;
}

void Model::check_open(const char* call) const {
  if (sealed_)
    throw Error(std::string(call) + ": the model is in use by an analysis and can't be changed any more");
}

std::vector<Index> Model::elements_of_zones() const {
  std::vector<Index> found;
  for (const auto& zone : all<Zone>()) {
    const auto inside = mesh_->elements_in(mesh_->set(zone.set));
    found.insert(found.end(), inside.begin(), inside.end());
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void Model::divide_zones() {
  if (mesh_->whole) return;
  if (!all<Zone>().empty())
    mesh_ = mesh::split_corners(mesh_, elements_of_zones());
  else if (const auto hinges = hinge_edges(*this); !hinges.empty())
    mesh_ = mesh::split_sides(mesh_, hinges);
}

// The nodes of a periodic tie pair by their places, of which each has only one node.
void Model::check_zones() const {
  if (all<Zone>().empty()) return;
  std::vector<char> in_zone(mesh_->nodes.size(), 0);
  for (const Index e : elements_of_zones())
    for (const Index n : mesh_->elements[e])
      if (n >= 0) in_zone[n] = 1;
  for (const Tie& tie : all<Tie>())
    for (const std::string& set : {tie.set, tie.partner})
      if (tie.kind == TieKind::periodic)
        for (const Index n : mesh_->set(set))
          if (in_zone[n] != 0)
            throw Error("tearable: node " + std::to_string(n + 1) +
                        " of a zone is in the periodic tie of set " + quoted(set) +
                        ": expected zones without such nodes");
}

namespace {

// The times of all kinks.
struct KinksOf : DeclarationVisitor {
  std::vector<double> all;
  void history(const char*, const std::optional<History>& h, auto...) {
    if (h) all.insert(all.end(), h->kinks().begin(), h->kinks().end());
  }
  void components(const Components& value, auto...) {
    for (const auto& h : value) history("", h);
  }
  void time(const char*, const std::optional<double>& at, auto...) {
    if (at) all.push_back(*at);
  }
};

}  // namespace

std::vector<double> Model::kinks() const {
  KinksOf kinks;
  declarations_.each_kind([&kinks](const auto& all) {
    for (const auto& one : all) tell(one, kinks);
  });
  for (const auto& body : interactions().bodies())
    if (body->moving() != nullptr)
      kinks.all.insert(kinks.all.end(), body->moving()->times.begin(), body->moving()->times.end());
  std::sort(kinks.all.begin(), kinks.all.end());
  return kinks.all;
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
    const std::string direction = freedom_names.at(static_cast<std::size_t>(i));
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
      clash(node, std::string(freedom_names.at(static_cast<std::size_t>(i))) + " is " +
                      (seen.kind[i] == 1 ? "fixed" : "moved") + " (set " + quoted(seen.by[i]) +
                      ") and turned (set " + quoted(t.set) + ")");
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
  check_turned_rotations(*mesh_, all<PrescribedTurn>(), all<Support>());
  for (const auto& s : all<Support>())
    for (const auto n : mesh_->set(s.set)) take_support(seen[n], n, s);
  for (const auto& m : all<PrescribedMotion>())
    for (const auto n : mesh_->set(m.set)) take_motion(seen[n], n, m);
  for (const auto& t : all<PrescribedTurn>())
    for (const auto n : mesh_->set(t.set)) take_turn(seen[n], n, t);
  for (const auto& m : all<PrescribedMotion>())
    for (const auto& h : m.displacement)
      if (h) h->value(0);
  if (!mesh_->whole) {
    check_zones();
    check_hinges(*this);
    work_out_ties(*this);
    work_out_seams(*this);
    for (const EdgeBand& b : all<EdgeBand>()) chain_of(*mesh_, b.set);
    for (const auto& gas : all<GasPointer>()) enclosure_of(*this, *gas);
  }
  check_symmetry(*this);
  interactions().validate(*mesh_);
  std::vector<bool> used(mesh_->nodes.size(), false);
  for (const auto& e : mesh_->elements)
    for (const auto n : e)
      if (n >= 0) used[n] = true;
  for (std::size_t n = 0; n < used.size(); ++n)
    if (!used[n]) throw Error("model: node " + std::to_string(n + 1) + " belongs to no element");
}

namespace {

// "1 support", "2 supports".
std::string counted(std::size_t count, const char* noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string loads_of(const Model& m) {
  std::string words;
  const auto add = [&words](const std::string& more) { words += (words.empty() ? "" : ", ") + more; };
  m.declarations().each_kind([&]<class D>(const std::vector<D>& all) {
    if (is_load<D> && !all.empty()) add(counted(all.size(), plain(all.front()).call()));
  });
  if (const auto springs = m.all<GroundSpring>().size(); springs > 0) add(counted(springs, "spring"));
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
  for (std::size_t r = 0; r < regions().size(); ++r) {
    const auto& section = sections()[r];
    const auto& options = regions()[r].options;
    if (!regions()[r].name.empty()) text << regions()[r].name << ": ";
    text << "card " << regions()[r].card.name << ", " << section.thickness * 1e3 << " mm, "
         << section.areal_mass * 1e3 << " g/m2; warp "
         << warp_words(options, rest_shape(bodies()[regions()[r].body])) << "; "
         << (options.membrane ? "membrane" : counted(section.points.size(), "thickness point")) << "; "
         << rest_text(bodies()[regions()[r].body].reference);
  }
  text << counted(all<Support>().size(), "support") << ", "
       << counted(all<PrescribedMotion>().size(), "motion") << ", " << loads_of(*this);
  if (const auto& zones = all<Zone>(); !zones.empty())
    text << ", " << counted(zones.size(), "tearable zone") << " of "
         << counted(elements_of_zones().size(), "element");
  const auto more = [&text](std::size_t count, const char* noun) {
    if (count > 0) text << ", " << counted(count, noun);
  };
  more(all<EdgeBand>().size(), "band");
  more(all<Seam>().size(), "seam");
  more(all<GasPointer>().size(), "gas volume");
  more(all<CreaseGiven>().size(), "crease");
  more(all<ContactGiven>().size(), "contact");
  for (const auto& body : interactions().bodies())
    text << "; " << interactions().name_of(*body) << ": " << body->describe();
  return text.str();
}

}  // namespace fabricsh::model
