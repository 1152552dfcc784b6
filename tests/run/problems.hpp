// Small problems with an isotropic card for tests of the solver: a shallow roof, an Euler strut.
#pragma once
#include <cmath>
#include <memory>
#include <numbers>

#include "run/static.hpp"

namespace fabricsh::test {

inline card::Card isotropic(double E, double nu, double thickness) {
  card::Card c;
  c.name = "isotropic";
  c.source = "test";
  c.density = 1;
  c.thickness = thickness;
  c.law = card::Svk{E, E, E / (2 * (1 + nu)), nu, nu, std::nullopt, std::nullopt};
  return c;
}

inline std::shared_ptr<Notices> quiet() { return std::make_shared<Notices>(); }

inline mesh::NodeSet nodes_where(const mesh::Mesh& mesh, const std::function<bool(const Vec3&)>& inside) {
  mesh::NodeSet ids;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    if (inside(mesh.nodes[i])) ids.push_back(static_cast<mesh::Index>(i));
  return ids;
}

inline std::vector<double> positions(const run::Run& a) {
  const auto x = a.assembly().state().x();
  return {x.begin(), x.end()};
}

// The hinged cylindrical roof under a point load in its middle [sze2004, section 4.7]: a quarter, mm and N,
// thickness 12.7 (limit point) or 6.35 (snap-back). x runs round the roof, y along it; straight edges hinged.
// The quarter carries a quarter of `load` at node 1, downwards (-z).
struct Roof {
  double thickness = 12.7, load = 3000;
  int cells = 8;
  std::vector<std::pair<double, double>> path = {{0, 0}, {1, 1}};  // times the load
  double load_at(double time) const { return load * history::History::table(path).value(time); }
};

inline std::shared_ptr<model::Model> make_roof(const Roof& r) {
  const double R = 2540, half = 254, angle = 0.1;
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(angle, half, r.cells, r.cells));
  const double tiny = 1e-9;
  mesh->define("crown", nodes_where(*mesh, [&](const Vec3& X) { return X.x() < tiny; }));
  mesh->define("middle", nodes_where(*mesh, [&](const Vec3& X) { return X.y() < tiny; }));
  mesh->define("hinge", nodes_where(*mesh, [&](const Vec3& X) { return X.x() > angle - tiny; }));
  mesh->define("centre", mesh::NodeSet{0});
  mesh->map([&](const Vec3& X) { return Vec3(R * std::sin(X.x()), X.y(), R * std::cos(X.x())); });
  model::Options options;
  options.warp = [](const Vec3&) { return model::Direction(Vec3(0, 1, 0)); };
  auto m = std::make_shared<model::Model>(mesh, isotropic(3102.75, 0.3, r.thickness), options);
  m->fix("crown", model::parse_freedoms("x ry rz"));
  m->fix("middle", model::parse_freedoms("y rx rz"));
  m->fix("hinge", model::parse_freedoms("x y z"));
  model::Components force;
  auto quarter = r.path;
  for (auto& point : quarter) point.second *= -r.load / 4;
  force[2] = history::History::table(quarter);
  m->force("centre", force);
  return m;
}

inline double sag(const run::Run& a) { return -a.node(0).u.z(); }

}  // namespace fabricsh::test
