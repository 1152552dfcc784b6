// A user of the core: a strip of St. Venant-Kirchhoff cloth pulled to a stretch, its force beside the closed
// form.
#include <cmath>
#include <cstdio>
#include <memory>

#include "run/static.hpp"
#include "run/vtk_frame.hpp"

int main() {
  using namespace fabricsh;
  const double width = 0.02, length = 0.05, thickness = 4e-4, young = 2e8, stretch = 1.1;
  card::Card cloth;
  cloth.name = "linear";
  cloth.source = "example";
  cloth.density = 500;
  cloth.thickness = thickness;
  cloth.law = card::Svk{young, young, young / 2.6, 0.3, 0.3, std::nullopt, std::nullopt};

  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(width, length, 2, 5));
  mesh->define("corner", mesh::NodeSet{0});
  auto model = std::make_shared<model::Model>(mesh, cloth, model::Options{});
  model->fix("all", model::parse_freedoms("z rotation"));
  model->fix("bottom", model::parse_freedoms("y"));
  model->fix("corner", model::parse_freedoms("x"));
  model::Components up;
  up[1] = history::History::table({{0, 0}, {1, (stretch - 1) * length}});
  model->move("top", up);

  run::Static run(model, run::StaticOptions{1.0}, std::make_shared<Notices>());
  run.solve();
  const double force = run.reaction("top")[1];
  const double want = stretch * young * (stretch * stretch - 1) / 2 * width * thickness;
  std::printf("force %.9g N, closed form %.9g N\n", force, want);
  return std::abs(force / want - 1) < 1e-9 ? 0 : 1;
}
