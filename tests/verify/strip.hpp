// The thesis' tensile strip (25.4 x 76.2 mm, 3 x 9 elements, y along the pull) for tests, in any orientation
// in space.
#pragma once
#include <cmath>
#include <memory>
#include <numbers>

#include "run/static.hpp"
#include "test_cards.hpp"

namespace fabricsh::test {

enum class Grips { clamped, free };

struct Strip {
  card::Card card;
  int axis = 1;  // 1: warp along the pull, 2: weft
  Grips grips = Grips::free;
  double stroke = 0;                    // m
  double duration = 1, unload_to = -1;  // s; m, -1: no unloading
  Mat3 turn = Mat3::Identity();
  double step = 0.05;
  int nx = 3, ny = 9;
  double tolerance = 1e-10;
  bool triangles = false;  // each cell cut in two
};

inline constexpr double strip_width = 25.4e-3, strip_length = 76.2e-3;

inline std::shared_ptr<model::Model> make_strip(const Strip& s) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(strip_width, strip_length, s.nx, s.ny));
  if (s.triangles) {
    const auto whole = mesh->elements;
    mesh->elements.clear();
    for (const auto& [a, b, c, d] : whole) {
      mesh->elements.push_back({a, b, c, -1});
      mesh->elements.push_back({a, c, d, -1});
    }
  }
  model::Options options;
  const Vec3 along = s.turn * (s.axis == 1 ? Vec3(0, 1, 0) : Vec3(1, 0, 0));
  if (s.turn != Mat3::Identity()) mesh->map([&](const Vec3& X) { return Vec3(s.turn * X); });
  options.warp = [along](const Vec3&) { return model::Direction(along); };
  auto m = std::make_shared<model::Model>(mesh, s.card, options);
  const Mat3 frame = s.turn.transpose();  // rows: the turned axes
  m->fix("all", model::parse_freedoms("z rotation"), frame);
  m->fix("bottom", model::parse_freedoms("y"), frame);
  if (s.grips == Grips::clamped) {
    m->fix("bottom", model::parse_freedoms("x"), frame);
    m->fix("top", model::parse_freedoms("x"), frame);
  } else {
    mesh->define("pin", mesh::NodeSet{0});
    m->fix("pin", model::parse_freedoms("x"), frame);
  }
  auto path = s.unload_to < 0
                  ? history::History::table({{0, 0}, {s.duration, s.stroke}})
                  : history::History::table({{0, 0}, {s.duration / 2, s.stroke}, {s.duration, s.unload_to}});
  model::Components c;
  c[1] = path;
  m->move("top", c, frame);
  return m;
}

// Force over the ends' area, second Piola-Kirchhoff: P / (A0 lambda) [williams2010, eq. 3.1].
inline double stress(const run::Run& a, const Strip& s, double displacement) {
  const double lambda = 1 + displacement / strip_length;
  const double force = (s.turn.transpose() * a.reaction("top")).y();
  return force / (strip_width * a.model().thickness() * lambda);
}

inline double green(double displacement) {
  const double u = displacement / strip_length;
  return u + u * u / 2;
}

}  // namespace fabricsh::test
