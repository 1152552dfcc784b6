// The whole hemisphere with a hole, P = 400 at each of four points [sze2004, section 3.4], on n x n elements
// a quarter: bench_hemisphere [n ...]. Processor time on one thread, iterations and displacements, and their
// ratios to CalculiX 2.20 with 1024 S8R elements (199 s, 242 iterations) and to the published 4.067
// and 8.178.
#include <omp.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "mesh/generators.hpp"
#include "run/problems.hpp"
#include "test_cards.hpp"

using namespace fabricsh;

namespace {

constexpr double kSeconds = 199, kIterations = 242, kOut = 4.067, kIn = 8.178;

mesh::Index nearest(const mesh::Mesh& mesh, const Vec3& to) {
  mesh::Index best = 0;
  for (std::size_t n = 1; n < mesh.nodes.size(); ++n)
    if ((mesh.nodes[n] - to).norm() < (mesh.nodes[best] - to).norm()) best = static_cast<mesh::Index>(n);
  return best;
}

// Held only against moving as a rigid body.
std::shared_ptr<model::Model> make(int n) {
  mesh::Hemisphere shape;
  shape.radius = 10;
  shape.around = 4 * n;
  shape.along = n;
  shape.angle = 360;
  auto mesh = std::make_shared<mesh::Mesh>(mesh::hemisphere(shape));
  const double hole = 18 * std::numbers::pi / 180;
  const std::pair<const char*, Vec3> places[] = {{"a", {10, 0, 0}},
                                                 {"b", {0, 10, 0}},
                                                 {"c", {-10, 0, 0}},
                                                 {"d", {0, -10, 0}},
                                                 {"e", {10 * std::sin(hole), 0, 10 * std::cos(hole)}}};
  for (const auto& [name, place] : places) mesh->define(name, mesh::NodeSet{nearest(*mesh, place)});
  model::Options options;
  options.warp = [](const Vec3&) { return model::Direction(Vec3(Vec3::UnitZ())); };
  auto m = std::make_shared<model::Model>(mesh, test::isotropic(6.825e7, 0.3, 0.04), options);
  const auto push = [&](const char* set, int axis, double force) {
    model::Components c;
    c[axis] = history::History::ramp(force, 1);
    m->force(set, c);
  };
  push("a", 0, 400);
  push("c", 0, -400);
  push("b", 1, -400);
  push("d", 1, 400);
  m->fix("a", model::parse_freedoms("y z"));
  m->fix("c", model::parse_freedoms("y z"));
  m->fix("b", model::parse_freedoms("x"));
  m->fix("e", model::parse_freedoms("y"));
  return m;
}

void report(int n) {
  const double start = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  const auto m = make(n);
  run::Static a(m, {.duration = 1, .step = 0.25}, test::quiet());
  a.solve();
  const double seconds = static_cast<double>(std::clock()) / CLOCKS_PER_SEC - start;
  int iterations = 0;
  for (const auto& step : a.steps()) iterations += step.iterations;
  const double out = a.node(m->mesh().set("a")[0]).u.x(), in = -a.node(m->mesh().set("b")[0]).u.y();
  std::printf(
      "%3d x %-3d  %8.2f s (/ 199 s: %.4f)  %4d iterations (/ 242: %.2f)  %.4f (/ 4.067: %.4f)  "
      "%.4f (/ 8.178: %.4f)\n",
      n, n, seconds, seconds / kSeconds, iterations, iterations / kIterations, out, out / kOut, in, in / kIn);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  omp_set_num_threads(1);
  std::vector<int> sizes;
  for (int i = 1; i < argc; ++i) sizes.push_back(std::atoi(argv[i]));
  if (sizes.empty()) sizes = {16, 32, 64};
  for (const int n : sizes) report(n);
}
