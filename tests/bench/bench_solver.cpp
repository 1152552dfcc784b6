// The parts of a static step, on square plates of n x n elements held along one edge and bent at the
// other: bench_solver [n ...]. CPU times in ms on one thread, and the ratios that matter: assembly over
// numeric factorisation, and the whole step over the bare factorisation times the number of iterations. Both
// sides take turns, so that they see the same machine, and the median ratio is printed.
#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "run/problems.hpp"
#include "test_cards.hpp"

using namespace fabricsh;

namespace {

// CPU time of the process, on one thread: the machine may be shared.
class Stopwatch {
 public:
  double ms() const { return now() - start_; }

 private:
  static double now() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
  double start_ = now();
};

template <class Act>
double best(int repeats, Act act) {
  double least = 1e30;
  for (int i = 0; i < repeats; ++i) {
    const Stopwatch watch;
    act();
    least = std::min(least, watch.ms());
  }
  return least;
}

template <class Act>
double once(Act act) {
  return best(1, act);
}

double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + static_cast<long>(v.size() / 2), v.end());
  return v[v.size() / 2];
}

std::shared_ptr<model::Model> make_plate(const card::Card& card, int n) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(1, 1, n, n));
  auto m = std::make_shared<model::Model>(mesh, card, model::Options{});
  m->fix("left", model::parse_freedoms("x y z rotation"));
  model::Components lift;
  lift[2] = history::History::ramp(0.2, 1);
  m->move("right", lift);
  return m;
}

struct Factor {
  double analyse = 0, numeric = 0, solve = 0;
  double fill = 0;  // million entries
};

Factor measure(linear::LinearSolver& solver, const linear::Matrix& K, int repeats) {
  Factor f;
  std::vector<double> b(K.size(), 1.0), x(K.size());
  f.analyse = best(1, [&] { solver.prepare(K); });
  f.numeric = best(repeats, [&] {
    if (!solver.factorise(K)) std::printf("  not factorised\n");
  });
  f.solve = best(repeats, [&] { solver.solve(K, b, x); });
  f.fill = static_cast<double>(solver.report().fill) / 1e6;
  return f;
}

void print(const char* name, const Factor& f) {
  std::printf("  %-18s analyse %8.1f  factorise %8.1f  solve %7.1f  fill %6.1f M\n", name, f.analyse,
              f.numeric, f.solve, f.fill);
}

void report(const char* name, const card::Card& card, int n, bool orderings) {
  const int repeats = n <= 64 ? 5 : 2;
  auto plate = make_plate(card, n);
  mechanics::Assembly assembly(*plate);
  const bool symmetric = plate->section().symmetric;
  if (symmetric) assembly.keep_upper();  // as a run does
  linear::Matrix K(assembly.pattern());
  std::printf("%s, %d x %d elements, %lld unknowns\n", name, n, n, static_cast<long long>(K.size()));
  const double tangent = best(repeats, [&] { assembly.tangent({}, K, {}, {}); });
  const double force = best(repeats, [&] { assembly.forces({}); });
  using linear::Ordering;
  const auto chosen =
      measure(*(symmetric ? linear::make_symmetric_solver() : linear::make_unsymmetric_solver()), K, repeats);
  if (orderings) {
    print("L S L^T AMD", measure(*linear::make_symmetric_solver(Ordering::amd), K, repeats));
    print("L S L^T METIS", measure(*linear::make_symmetric_solver(Ordering::metis), K, repeats));
    print("UMFPACK AMD", measure(*linear::make_unsymmetric_solver(Ordering::amd), K, repeats));
    print("UMFPACK METIS", measure(*linear::make_unsymmetric_solver(Ordering::metis), K, repeats));
  }
  print("automatic", chosen);
  std::printf("  tangent %.1f  force %.1f\n", tangent, force);
  const auto solver = symmetric ? linear::make_symmetric_solver() : linear::make_unsymmetric_solver();
  const auto factorise = [&] { solver->factorise(K); };
  factorise();
  std::vector<double> assembling, stepping;
  for (int i = 0; i < 2 * repeats + 1; ++i) {
    assembly.forces({});  // Newton's tangents follow forces at the same place, whose states stay
    const double filled = once([&] { assembly.tangent({}, K, {}, {}); });
    assembling.push_back(filled / once(factorise));
  }
  run::Static a(make_plate(card, n), {.duration = 1, .step = 0.05}, test::quiet());
  a.step();
  int iterations = 0;
  for (int i = 0; i < repeats; ++i) {
    const double before = once(factorise), step = once([&] { a.step(); }), after = once(factorise);
    const int count = a.steps().back().iterations;
    iterations += count;
    stepping.push_back(step / (count * (before + after) / 2));
  }
  std::printf(
      "  ratios: tangent / factorisation %.3f   whole / bare factorisation %.3f (%d steps of %d "
      "iterations)\n",
      median(assembling), median(stepping), repeats, iterations);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  omp_set_num_threads(1);
  std::vector<int> sizes;
  for (int i = 1; i < argc; ++i) sizes.push_back(std::atoi(argv[i]));
  if (sizes.empty()) sizes = {32, 64, 128};
  for (const int n : sizes) {
    report("isotropic", test::isotropic(1e7, 0.3, 1e-3), n, true);
    report("woven (blend)", test::blend(), n, false);
  }
}
