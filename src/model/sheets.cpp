#include "model/sheets.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "base/error.hpp"
#include "mesh/check.hpp"
#include "section/section.hpp"

namespace fabricsh::model {

namespace {

std::string quoted_set(const std::string& s) { return "'" + s + "'"; }

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

}  // namespace

Sheets::Sheets(std::vector<BodyGiven> bodies) : bodies_(std::move(bodies)) {
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

void Sheets::add_body(Index which) {
  const BodyGiven& body = bodies_[which];
  const std::string of = body.name.empty() ? "" : "body '" + body.name + "': ";
  if (body.mesh->elements.empty()) throw Error("model: " + of + "the mesh has no elements");
  if (const auto twice = mesh::repeated_elements(*body.mesh); !twice.empty())
    throw Error("model: " + of + "element " + std::to_string(twice.front() + 1) +
                " of the mesh is on the same nodes as an element before" +
                (twice.size() > 1 ? ", as are " + std::to_string(twice.size() - 1) + " more" : "") +
                ": expected each piece of cloth once (plies are a field of the model)");
  take_reference(body, of);
  const mesh::Mesh& shape = rest_shape(body);
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
void Sheets::assign(Index region, Index which, const std::string& set) {
  const BodyGiven& body = bodies_[which];
  const Index first = mesh_->parts.empty() ? 0 : mesh_->parts[which].first_element;
  region_of_.resize(mesh_->elements.size(), 0);
  if (set.empty()) {
    std::fill_n(region_of_.begin() + first, body.mesh->elements.size(), static_cast<int>(region));
    return;
  }
  const auto inside = body.mesh->elements_in(body.mesh->set(set));
  if (inside.empty()) throw Error("model: region " + quoted_set(set) + " holds no whole element");
  for (const Index e : inside) {
    int& now = region_of_[first + e];
    if (!body.regions.empty() && regions_[now].name != body.name)
      throw Error("model: element " + std::to_string(e + 1) + " is in two regions, " +
                  quoted_set(regions_[now].name) + " and " + quoted_set(regions_[region].name));
    now = static_cast<int>(region);
  }
}

void Sheets::seal_meshes() {
  mesh_->in_use = true;
  for (auto& body : bodies_) {
    body.mesh->in_use = true;
    if (body.reference.mesh) body.reference.mesh->in_use = true;
  }
}

namespace {

// The name of a ply by its number, from 0.
std::string ply_word(std::size_t number) { return "ply" + std::to_string(number + 1); }

}  // namespace

int Sheets::ply_of(Index element, const std::string& ply) const {
  const auto& plies = regions_[region_of(element)].options.plies;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, plies.size()); ++i)
    if (ply == ply_word(i) || (i < plies.size() && !ply.empty() && ply == plies[i].name))
      return static_cast<int>(i);
  return -1;
}

std::vector<std::string> Sheets::plies() const {
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

std::string Sheets::element_name(Index element) const {
  if (mesh_->parts.empty()) return std::to_string(element + 1);
  std::size_t part = mesh_->parts.size() - 1;
  while (mesh_->parts[part].first_element > element) --part;
  return std::to_string(element - mesh_->parts[part].first_element + 1) + " of body " +
         mesh_->parts[part].name;
}

// The parts of a joined mesh follow each other, and so do their stress-free shapes.
void Sheets::take_reference(const BodyGiven& body, const std::string& of) {
  const auto& given = body.reference;
  if (given.prestress && !body.options.plies.empty())
    throw Error("model: " + of + "field 'prestress': expected a card without layers, which share a tension");
  if (given.mesh) check_reference(of, *body.mesh, *given.mesh);
  if (!given.mesh) return;
  const auto part = std::find_if(mesh_->parts.begin(), mesh_->parts.end(),
                                 [&](const auto& one) { return one.name == body.name; });
  const Index node = part == mesh_->parts.end() ? 0 : part->first_node,
              element = part == mesh_->parts.end() ? 0 : part->first_element;
  if (rest_nodes_.empty()) {
    rest_nodes_ = mesh_->nodes;
    rest_warp_ = mesh_->warp;
    rest_warp_.resize(mesh_->elements.size(), Vec3::Zero());
  }
  std::copy(given.mesh->nodes.begin(), given.mesh->nodes.end(), rest_nodes_.begin() + node);
  const auto warp = rest_warp_.begin() + element;
  std::fill_n(warp, given.mesh->elements.size(), Vec3(Vec3::Zero()));
  std::copy(given.mesh->warp.begin(), given.mesh->warp.end(), warp);
}

Vec3 Sheets::warp_at(Index element, const Vec3& X, const Vec3& n) const {
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

Vec3 Sheets::warp_as_placed(Index element, const Vec3& x, const Vec3& n) const {
  if (rest_nodes_.empty()) return warp_at(element, x, n);
  const auto& e = mesh_->elements[static_cast<std::size_t>(element)];
  const int last = e[3] < 0 ? 2 : 3;
  Vec3 middle = Vec3::Zero();
  for (int a = 0; a <= last; ++a) middle += rest_corner(element, a) / (last + 1);
  const auto sides = [&](const auto& at) {
    Eigen::Matrix<double, 3, 2> both;
    both.col(0) = at(last - 1) - at(0);
    both.col(1) = at(last) - at(last == 2 ? 0 : 1);
    return both;
  };
  const auto there = sides([&](int a) -> const Vec3& { return rest_corner(element, a); });
  const auto here = sides([&](int a) -> const Vec3& {
    return mesh_->nodes[static_cast<std::size_t>(e[static_cast<std::size_t>(a)])];
  });
  const Vec3 normal = there.col(0).cross(there.col(1)).normalized();
  const Vec3 warp = warp_at(element, middle, normal);
  return here * there.colPivHouseholderQr().solve(warp - warp.dot(normal) * normal);
}

}  // namespace fabricsh::model
