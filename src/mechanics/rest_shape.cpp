#include "mechanics/rest_shape.hpp"

#include <cmath>

#include "base/error.hpp"
#include "base/number.hpp"
#include "mesh/normals.hpp"

namespace fabricsh::mechanics {

namespace {

Vec3 area_vector(const std::array<Vec3, 4>& x, int corners) {
  return 0.5 * (corners == 3 ? (x[1] - x[0]).cross(x[2] - x[0]) : (x[2] - x[0]).cross(x[3] - x[1]));
}

Vec3 middle_of(const std::array<Vec3, 4>& x, int corners) {
  Vec3 sum = Vec3::Zero();
  for (int a = 0; a < corners; ++a) sum += x[static_cast<std::size_t>(a)];
  return sum / corners;
}

// Axes of an element by its first side and its normal.
Mat3 axes_of(const std::array<Vec3, 4>& x, int corners) {
  Mat3 axes;
  axes.col(2) = area_vector(x, corners).normalized();
  const Vec3 side = x[1] - x[0];
  axes.col(0) = (side - side.dot(axes.col(2)) * axes.col(2)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

// N/m of the second Piola-Kirchhoff kind at a strain of virgin cloth.
std::array<double, 2> resultants(const section::Section& section, const std::array<double, 2>& strain) {
  std::array<double, 2> sum{};
  const double E[5] = {strain[0], strain[1], 0, 0, 0};
  for (const auto& point : section.points) {
    std::vector<double> state(static_cast<std::size_t>(law::state_size(*point.law)) + 1, 0.0), next = state;
    if (law::has_initial(*point.law)) law::set_initial(*point.law, law::Site{}, state.data());
    double S[5];
    if (law::evaluate(*point.law, law::Step{}, E, state.data(), next.data(), S, nullptr) !=
        law::Evaluation::ok)
      return {std::nan(""), std::nan("")};
    for (std::size_t i = 0; i < 2; ++i) sum[i] += point.weight / 2 * section.thickness * S[i];
  }
  return sum;
}

// The tensions less those wanted, N/m over the stretched width.
Eigen::Vector2d excess(const section::Section& section, const std::array<double, 2>& tension,
                       const Eigen::Vector2d& E) {
  const auto N = resultants(section, {E[0], E[1]});
  const double a = std::sqrt(1 + 2 * E[0]), b = std::sqrt(1 + 2 * E[1]);
  return {N[0] * a / b - tension[0], N[1] * b / a - tension[1]};
}

}  // namespace

Prestrain prestrain(const section::Section& section, const std::array<double, 2>& tension) {
  constexpr double most = 1, close = 1e-12;
  const double size = std::max({std::abs(tension[0]), std::abs(tension[1]), 1e-12});
  Eigen::Vector2d E = Eigen::Vector2d::Zero(), r = excess(section, tension, E);
  for (int i = 0; i < 200 && r.norm() > close * size; ++i) {
    constexpr double h = 1e-7;
    Eigen::Matrix2d J;
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector2d step = h * Eigen::Vector2d::Unit(k);
      J.col(k) = (excess(section, tension, E + step) - excess(section, tension, E - step)) / (2 * h);
    }
    const Eigen::Vector2d full = -J.partialPivLu().solve(r);
    double share = std::min(1.0, 0.1 / std::max(full.cwiseAbs().maxCoeff(), 1e-300));
    Eigen::Vector2d next = r;
    for (; share > 1e-6; share /= 2) {
      next = excess(section, tension, E + share * full);
      if (next.allFinite() && next.norm() < r.norm()) break;
    }
    if (!(share > 1e-6)) break;
    E += share * full;
    r = next;
    if (!(E.cwiseAbs().maxCoeff() < most)) break;
  }
  if (!(r.norm() <= 1e-9 * size) || !(E.cwiseAbs().maxCoeff() < most))
    throw Error("model: field 'prestress': no strain below 100 % gives " + number(tension[0]) +
                " N/m in warp and " + number(tension[1]) + " N/m in weft to this cloth");
  return {{E[0], E[1]}, {std::sqrt(1 + 2 * E[0]), std::sqrt(1 + 2 * E[1])}};
}

RestShape::RestShape(const model::Model& model, const std::vector<Vec3>& directors)
    : model_(model), mesh_(model.mesh()), directors_(directors) {
  if (!model.has_rest()) return;
  take_shape();
  take_creases();
  take_prestress();
}

std::array<Index, 4> RestShape::own_corners(Index element) const {
  return {0, 1, 2, corners(mesh_.elements[static_cast<std::size_t>(element)]) == 3 ? -1 : 3};
}

RestShape::Outline RestShape::outline(Index element) const {
  const auto& nodes = mesh_.elements[static_cast<std::size_t>(element)];
  Outline out{{}, {}, nodes[3] < 0 ? 3 : 4, 0};
  Vec3 middle = Vec3::Zero();
  for (int a = 0; a < out.count; ++a) middle += out.at[a] = X(element, a);
  const Vec3* const x = out.at;
  const Vec3 normal = out.count == 3 ? (x[1] - x[0]).cross(x[2] - x[0]) : (x[2] - x[0]).cross(x[3] - x[1]);
  const Vec3 n = normal.normalized(), w = warp(element, middle / out.count, n);
  out.axes[0] = (w - w.dot(n) * n).normalized();
  out.axes[1] = n.cross(out.axes[0]);
  out.area = 0.5 * normal.norm();
  return out;
}

double RestShape::area(Index element) const {
  const auto e = static_cast<std::size_t>(element);
  if (shape_.empty()) return mechanics::area(mesh_.elements[e], mesh_.nodes);
  return mechanics::area(own_corners(element), shape_[e].X);
}

double RestShape::size(Index element) const {
  const auto e = static_cast<std::size_t>(element);
  if (shape_.empty()) return mechanics::size(mesh_.elements[e], mesh_.nodes);
  return mechanics::size(own_corners(element), shape_[e].X);
}

// Where supports turned a director of the mesh into a plane, that of the stress-free shape follows.
void RestShape::take_shape() {
  const mesh::Mesh& known = mesh_.hinged ? mesh_ : mesh_.uncut();  // the nodes that have normals of their own
  mesh::Mesh free;
  free.elements = known.elements;
  for (Index n = 0; n < static_cast<Index>(known.nodes.size()); ++n)
    free.nodes.push_back(model_.rest_node(mesh_.place_of(n)));
  const std::vector<Vec3> normals = mesh::node_normals(free);
  const auto normal_of_mesh = mesh::node_normals(mesh_);
  shape_.resize(mesh_.elements.size());
  unbent_.resize(mesh_.elements.size());
  for (Index e = 0; e < static_cast<Index>(shape_.size()); ++e) {
    const auto i = static_cast<std::size_t>(e);
    const auto& given = model_.reference_of(e);
    const int n = corners(mesh_.elements[i]);
    Shape& shape = shape_[i];
    Shape placed{};
    for (std::size_t a = 0; a < static_cast<std::size_t>(n); ++a) {
      const auto own = node(e, static_cast<int>(a));
      const auto place =
          mesh_.hinged ? own : static_cast<std::size_t>(mesh_.place_of(static_cast<Index>(own)));
      placed.X[a] = mesh_.nodes[own];
      placed.D[a] = directors_[own];
      shape.X[a] = free.nodes[place];
      shape.D[a] = given.mesh ? normals[place] : directors_[own];
    }
    if (given.mesh)
      for (std::size_t a = 0; a < static_cast<std::size_t>(n); ++a) {
        constexpr double turned = 1e-9;
        const auto own = node(e, static_cast<int>(a));
        if ((directors_[own] - normal_of_mesh[own]).norm() > turned && normal_of_mesh[own].norm() > 0.5)
          shape.D[a] = axes_of(shape.X, n) * axes_of(placed.X, n).transpose() * directors_[own];
        if (!(shape.D[a].norm() > 0))
          throw Error("model: field 'reference': node " +
                      std::to_string(mesh_.place_of(static_cast<Index>(own)) + 1) +
                      " has no normal: its elements are degenerate, or fold onto each other");
      }
    unbent_[i] = shape;
    if (given.rest == model::Rest::flat) lay_flat(e);
    if (given.rest == model::Rest::placed) unbent_[i] = placed;
  }
}

// A flat element has one normal; one that is warped is flat in its mean plane.
void RestShape::lay_flat(Index element) {
  const auto i = static_cast<std::size_t>(element);
  const int n = corners(mesh_.elements[i]);
  const Vec3 normal = area_vector(shape_[i].X, n).normalized(), middle = middle_of(shape_[i].X, n);
  shape_[i].D.fill(normal);
  unbent_[i] = shape_[i];
  for (Vec3& x : unbent_[i].X) x -= normal.dot(x - middle) * normal;
}

// At a crease that is no hinge the director of the sheet halves the angle of its sides: towards each it is
// turned by half.
void RestShape::take_creases() {
  std::map<Index, std::vector<std::pair<Vec3, double>>>
      at;  // per place: ways along the crease, and its angle
  auto edges = model::crease_edges(model_);
  std::erase_if(edges, [](const model::CreaseEdge& edge) { return edge.stiffness.has_value(); });
  for (const model::CreaseEdge& edge : edges) {
    const Vec3 way = (model_.rest_node(edge.to) - model_.rest_node(edge.from)).normalized();
    at[edge.from].emplace_back(way, edge.angle);
    at[edge.to].emplace_back(-way, edge.angle);
  }
  if (at.empty()) return;
  for (Index e = 0; e < static_cast<Index>(shape_.size()); ++e) {
    const auto i = static_cast<std::size_t>(e);
    const int n = corners(mesh_.elements[i]);
    const Vec3 middle = middle_of(unbent_[i].X, n);
    const auto place = [&](int a) { return mesh_.place_of(static_cast<Index>(node(e, a % n))); };
    for (int a = 0; a < n; ++a) {
      const auto found = at.find(place(a));
      if (found == at.end()) continue;
      const Vec3& x = unbent_[i].X[static_cast<std::size_t>(a)];
      Vec3& d = unbent_[i].D[static_cast<std::size_t>(a)];
      const auto& ways = found->second;
      const Vec3 way = ways.size() == 1 ? ways[0].first : Vec3((ways[0].first - ways[1].first).normalized());
      const bool has_edge = std::any_of(edges.begin(), edges.end(), [&](const model::CreaseEdge& edge) {
        const auto is = [&](int b) {
          return (edge.from == place(a) && edge.to == place(b)) ||
                 (edge.to == place(a) && edge.from == place(b));
        };
        return is(a + 1) || is(a + n - 1);
      });
      // Beyond the end of a crease the sheet is not turned.
      if (ways.size() == 1 && !has_edge && !(way.dot(middle - x) > 0)) continue;
      Vec3 inward = middle - x;
      inward -= inward.dot(way) * way;
      inward = (inward - inward.dot(d) * d).normalized();
      const double half = (ways.size() == 1 ? ways[0].second : (ways[0].second + ways[1].second) / 2) / 2;
      d = (std::cos(half) * d + std::sin(half) * inward).normalized();
    }
  }
}

void RestShape::take_prestress() {
  std::map<int, Prestrain> of_region;
  for (Index e = 0; e < static_cast<Index>(shape_.size()); ++e) {
    const auto& given = model_.reference_of(e);
    if (!given.prestress) continue;
    const int region = model_.region_of(e);
    const auto [place, is_new] = of_region.try_emplace(region);
    if (is_new) {
      const auto& section = model_.sections()[static_cast<std::size_t>(region)];
      place->second = prestrain(section, *given.prestress);
      const auto& name = model_.regions()[static_cast<std::size_t>(region)].name;
      const auto& strain = place->second.strain;
      told_.push_back("prestress" + (name.empty() ? "" : " of " + name) + ": " +
                      number((*given.prestress)[0]) + " N/m in warp and " + number((*given.prestress)[1]) +
                      " N/m in weft are strains E11 " + number(strain[0]) + " and E22 " + number(strain[1]));
    }
    contract(e, place->second);
  }
}

void RestShape::contract(Index element, const Prestrain& by) {
  const auto i = static_cast<std::size_t>(element);
  const int n = corners(mesh_.elements[i]);
  const Vec3 normal = area_vector(shape_[i].X, n).normalized(), middle = middle_of(shape_[i].X, n);
  const Vec3 w = model_.warp_at(element, middle, normal), warp = (w - w.dot(normal) * normal).normalized(),
             weft = normal.cross(warp);
  const Mat3 F = normal * normal.transpose() + warp * warp.transpose() / by.stretch[0] +
                 weft * weft.transpose() / by.stretch[1];
  for (Vec3& x : shape_[i].X) x = middle + F * (x - middle);
  contracted_[element] = {middle, F};
}

Vec3 RestShape::warp(Index element, const Vec3& X, const Vec3& n) const {
  const auto found = contracted_.find(element);
  if (found == contracted_.end()) return model_.warp_at(element, X, n);
  const auto& by = found->second;
  return model_.warp_at(element, by.middle + by.F.inverse() * (X - by.middle), n);
}

std::vector<Vec3> directors_of_folded(const mesh::Mesh& mesh) {
  if (mesh.whole && !mesh.hinged) {  // all nodes at a place have the director of the sheet there
    const std::vector<Vec3> of_places = directors_of_folded(*mesh.whole);
    std::vector<Vec3> all;
    for (const Index place : mesh.place) all.push_back(of_places[static_cast<std::size_t>(place)]);
    return all;
  }
  constexpr double cancel = 1e-9;
  std::vector<Vec3> sum(mesh.nodes.size(), Vec3::Zero()), away = sum;
  std::vector<double> whole(mesh.nodes.size(), 0);
  std::vector<Vec3> directors = mesh::node_normals(mesh);
  for (const auto& e : mesh.elements) {
    std::array<Vec3, 4> x{};
    const int n = corners(e);
    for (int a = 0; a < n; ++a)
      x[static_cast<std::size_t>(a)] = mesh.nodes[static_cast<std::size_t>(e[static_cast<std::size_t>(a)])];
    const Vec3 area = area_vector(x, n), middle = middle_of(x, n);
    for (int a = 0; a < n; ++a) {
      const auto node = static_cast<std::size_t>(e[static_cast<std::size_t>(a)]);
      sum[node] += area;
      whole[node] += area.norm();
      away[node] += mesh.nodes[node] - middle;
    }
  }
  for (std::size_t n = 0; n < directors.size(); ++n)
    if (whole[n] > 0 && sum[n].norm() <= cancel * whole[n] && away[n].norm() > 0)
      directors[n] = away[n].normalized();
  for (std::size_t n = 0; n < directors.size(); ++n)
    if (!(directors[n].norm() > 0))
      throw Error("mesh: node " + std::to_string(n + 1) + " has no normal: its elements are degenerate");
  return directors;
}

}  // namespace fabricsh::mechanics
