// The cost of contact: a pair of each kind that touches, a search, and a step of a sheet with nothing near.
//   bench_contact [n]   a sheet of n x n quadrilaterals (100)
#include <omp.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "contact/sheets.hpp"

using namespace fabricsh;
using namespace fabricsh::contact;
using namespace fabricsh::test;

namespace {

// Least time of several runs, ns.
template <class Work>
double least(int runs, Work work) {
  double best = 1e300;
  for (int i = 0; i < runs; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    best = std::min(
        best, std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count());
  }
  return best;
}

void pairs() {
  const ContactLaw law({0.8, 0.02, 3, {}});
  const char* names[] = {"facet", "plane", "edges", "wrap", "segment", "centre"};
  Random random(1);
  for (int k = 0; k < 6; ++k) {
    Pair pair;
    pair.kind = PairKind(k);
    pair.area = 1;
    pair.fading = {pair.kind == PairKind::edges, 0.1, 0.1};
    std::vector<Corners> touching;
    while (touching.size() < 1000) {
      const Corners x = {random.vector(1), random.vector(1), random.vector(1), random.vector(1)};
      if (pair_force(law, pair, x).active) touching.push_back(x);
    }
    double sum = 0;
    const double force = least(50, [&] {
      for (const Corners& x : touching) sum += pair_force(law, pair, x).contact;
    });
    const double stiff = least(10, [&] {
      for (const Corners& x : touching) sum += pair_derivatives(law, pair, x).contact;
    });
    std::printf("%-8s %6.0f ns force %8.0f ns with stiffness%s\n", names[k], force / 1000, stiff / 1000,
                sum < 0 ? " " : "");
  }
}

void sheet(int n, int threads) {
  omp_set_num_threads(threads);
  Sheets sheets;
  sheets.add(0.005 * n, n, Vec3::Zero());
  Scene scene = sheets.scene();
  scene.meet(0, 0, blend_law(), 0.3);
  const double elements = double(n) * n;
  const double search = least(5, [&] { find_pairs(scene, scene.reference(), 1.6e-3); });
  Contact contact(scene);
  std::vector<Vec3> x = scene.reference();
  auto f = none(x.size());
  contact.add_forces(x, f);
  const double step = least(50, [&] { contact.add_forces(x, f); });
  std::printf("%d threads, per element: search %.0f ns, step with nothing near %.1f ns\n", threads,
              search / elements, step / elements);
  // Two layers that touch all over.
  Sheets two;
  two.add(0.005 * n, n, Vec3::Zero());
  two.add(0.005 * n, n, Vec3(0.0013, 0.0017, 0.3e-3));
  Scene pile = two.scene();
  pile.meet(0, 1, blend_law(), 0.3);
  Contact pressed(pile);
  std::vector<Vec3> v = none(pile.reference().size());
  for (Vec3& u : v) u = Vec3(1, 2, 0);
  const std::vector<double> inverse_mass(v.size(), 1e5);
  std::vector<Vec3> start = pile.reference();
  for (std::size_t i = 0; i < v.size(); ++i) start[i] -= 1e-6 * v[i];
  const Way way{start, {}, 1e-6, inverse_mass};
  auto g = none(v.size());
  const Totals totals = pressed.add_forces(pile.reference(), g, way);
  const double crowd = least(20, [&] { pressed.add_forces(pile.reference(), g, way); });
  std::printf("  two layers: %zu pairs listed, %zu touch, %.0f ns a pair that touches, %.0f ns an element\n",
              pressed.listed(), totals.touching, crowd / double(totals.touching), crowd / (2 * elements));
}

}  // namespace

int main(int argc, char** argv) {
  const int n = argc > 1 ? std::atoi(argv[1]) : 100;
  pairs();
  for (const int threads : {1, 2}) sheet(n, threads);
}
