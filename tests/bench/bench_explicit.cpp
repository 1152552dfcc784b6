// The central-difference loop of a free woven sheet in violent motion: forces, commit, nodal update.
//   bench_explicit                       every instruction set of this machine, one and two threads
//   bench_explicit one <n> <points> <threads> [warped]   one case; points 0: separate bending
//   bench_explicit run <n> <points> <threads>            the product's own loop, with the ledger and no
//   outputs
// Nanoseconds per element and step, least of several windows (process CPU time for one thread, else wall
// time), and the shares of the law's branches, which must all occur.
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <random>
#include <string>
#include <vector>

#include "law/data.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/terms/cloth.hpp"
#include "run/dynamic.hpp"
#include "test_cards.hpp"

using namespace fabricsh;

namespace {

constexpr double side = 1.0;                            // m
constexpr int warm_up = 150, window = 6, windows = 30;  // steps; short windows find the quiet moments

struct Case {
  int n = 100, points = 3, threads = 1;
  bool warped = false;  // a wavy sheet of irregular elements instead of a flat grid
};

std::shared_ptr<model::Model> make_sheet(const Case& c) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(side, side, c.n, c.n));
  if (c.warped)
    mesh->map([](const Vec3& X) {
      return Vec3(X.x() + 0.01 * std::sin(20 * X.y()), X.y() + 0.01 * std::sin(17 * X.x()),
                  0.02 * std::sin(9 * X.x()) * std::cos(8 * X.y()));
    });
  auto card = test::blend();
  if (c.points == 0) card.bending = card::Bending{15e-6, 12e-6, 5e-6, {}, {}};
  model::Options options;
  options.warp = [](const Vec3&) { return model::Direction(0.0); };
  if (c.points > 0) options.points = c.points;
  return std::make_shared<model::Model>(mesh, card, options);
}

// m/s, the same for a row of nodes: a run takes initial velocities by sets of nodes.
Vec3 row_velocity(double y) { return {5 * std::sin(9 * y), 4 * std::sin(21 * y), 0}; }

// Branches of all law points, sampled between steps.
struct Branches {
  double points = 0, virgin = 0, unloading = 0, slack = 0, shear_virgin = 0, shear_unloading = 0;
  double flips = 0, pairs = 0;  // of the shear branch's sign between two samples one step apart
  std::vector<signed char> sign;
};

double now(int threads) {
  if (threads == 1) return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class Sheet {
 public:
  // in_rows: it moves as the sheet of a run does, at the step of that run.
  explicit Sheet(const Case& c, bool in_rows = false)
      : model_(make_sheet(c)), assembly_(*model_), threads_(c.threads) {
    assembly_.terms().find<mechanics::Cloth>()->update_in_place();
    const auto n = static_cast<std::size_t>(assembly_.dofs().unknowns());
    mass_.assign(n, 0);
    rate_.assign(n, 0);
    residual_.assign(n, 0);
    const double h = side / c.n, t = model_->section().thickness;
    const auto& law = *model_->section().points[0].law;
    step_ = 0.6 * h / std::sqrt(law::stiffest(law) / model_->section().points[0].density);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 1);
    for (std::size_t i = 0; i < assembly_.dofs().reference().size(); ++i) {
      const Vec3& X = assembly_.dofs().reference()[i];
      const double m = assembly_.cloth().mass()[i];
      const Vec3 v(16 * std::sin(25 * X.x()) * std::cos(9 * X.y()) + 12 * std::sin(21 * X.y()),
                   9 * std::sin(23 * X.y()) + 14 * std::sin(19 * X.x() + 5 * X.y()),
                   3 * std::sin(11 * X.x()) * std::cos(14 * X.y()));
      for (int k = 0; k < 5; ++k) {
        const auto equation = assembly_.dofs().freedoms().nodes[i].equation[k];
        mass_[equation] = k < 3 ? m : m * std::max(t * t / 12, h * h / 8);
        rate_[equation] = k < 3 ? v[k] + noise(random) : 5 * noise(random);
        if (in_rows) rate_[equation] = k < 3 ? row_velocity(X.y())[k] : 0;
      }
    }
    assembly_.terms().external(0, external_);
  }
  void step() {
    assembly_.begin_iterate();
    assembly_.apply_increment(rate_, step_, {});
    forces();
    assembly_.residual(external_, residual_);
    for (std::size_t i = 0; i < rate_.size(); ++i) rate_[i] += step_ * residual_[i] / mass_[i];
    time_ += step_;
    assembly_.commit(time_);
  }
  double seconds_of_forces() const { return of_forces_; }  // of all steps so far
  void count(Branches& b) const {
    const bool first = b.sign.empty();
    std::size_t at = 0;
    for (mechanics::Index e = 0; e < assembly_.cloth().elements(); e += 7)
      assembly_.cloth().readings().visit(
          e, [&](double, const law::Law& law, const double* E, const double* state) {
            const auto i = law::internal(law, E, state);
            for (const auto branch : {i.warp, i.weft}) {
              b.virgin += branch == law::LoadBranch::virgin;
              b.unloading += branch == law::LoadBranch::unloading;
              b.slack += branch == law::LoadBranch::slack;
            }
            b.shear_virgin += i.shear == law::LoadBranch::virgin;
            b.shear_unloading += i.shear != law::LoadBranch::virgin;
            b.points += 1;
            const signed char sign = state[law::potential_state::sg] < 0 ? -1 : 1;
            if (first) {
              b.sign.push_back(sign);
              return;
            }
            b.flips += sign != b.sign[at];
            b.sign[at++] = sign;
            b.pairs += 1;
          });
  }

 private:
  void forces() {
    const double start = now(threads_);
    const bool done = assembly_.forces({});
    of_forces_ += now(threads_) - start;
    if (done) return;
    std::printf("the law failed at %g s\n", time_);
    std::exit(1);
  }
  std::shared_ptr<model::Model> model_;
  mechanics::Assembly assembly_;
  int threads_;
  double of_forces_ = 0;
  std::vector<double> mass_, rate_, residual_, external_;
  double step_ = 0, time_ = 0;
};

template <class Act>
double per_element(const Case& c, int times, Act act) {
  const double start = now(c.threads);
  for (int i = 0; i < times; ++i) act();
  return (now(c.threads) - start) / times / (static_cast<double>(c.n) * c.n) * 1e9;
}

bool all_occur(const Branches& b) {
  const double axes = 2 * b.points;
  std::printf(
      "   yarns %% virgin %.0f unloading %.0f slack %.0f, shear %% virgin %.0f unloading %.0f, %.2f %% "
      "flip\n",
      100 * b.virgin / axes, 100 * b.unloading / axes, 100 * b.slack / axes, 100 * b.shear_virgin / b.points,
      100 * b.shear_unloading / b.points, 100 * b.flips / b.pairs);
  for (const double share : {b.virgin / axes, b.unloading / axes, b.slack / axes, b.shear_virgin / b.points,
                             b.shear_unloading / b.points})
    if (share < 0.05) return false;
  return b.flips / b.pairs > 1e-3;
}

int run_case(const Case& c) {
  omp_set_num_threads(c.threads);
  Sheet sheet(c);
  for (int i = 0; i < warm_up; ++i) sheet.step();
  double whole = 1e30, forces = 1e30;
  Branches branches;
  for (int w = 0; w < windows; ++w) {
    const double before = sheet.seconds_of_forces();
    whole = std::min(whole, per_element(c, window, [&] { sheet.step(); }));
    forces = std::min(forces, (sheet.seconds_of_forces() - before) / window / c.n / c.n * 1e9);
    if (w % 5 == 0) {
      branches.sign.clear();
      sheet.count(branches);
      sheet.step();
      sheet.count(branches);
    }
  }
  std::printf("%-8s %d thread%s %3d x %-3d %s %s  step %6.1f  forces %6.1f ns", fabricsh::name(best_isa()),
              c.threads, c.threads == 1 ? " " : "s", c.n, c.n, c.warped ? "warped" : "flat  ",
              c.points == 0 ? "bending " : (std::to_string(c.points) + " points").c_str(), whole, forces);
  return all_occur(branches) ? 0 : (std::printf("a branch of the law did not occur\n"), 1);
}

// --- the product's loop

constexpr double most_over_kernel = 1.15;  // of what a run takes, over the kernel's own step

// The sheet as a run of so many steps, its rows moving against each other.
std::shared_ptr<run::Run> make_run(const Case& c, int steps) {
  auto model = make_sheet(c);
  auto mesh = std::make_shared<mesh::Mesh>(model->mesh());
  for (int row = 0; row <= c.n; ++row) {
    mesh::NodeSet nodes;
    for (int i = 0; i <= c.n; ++i) nodes.push_back(row * (c.n + 1) + i);
    mesh->define("row" + std::to_string(row), nodes);
  }
  auto moving = std::make_shared<model::Model>(mesh, model->card(), model->options());
  for (int row = 0; row <= c.n; ++row) {
    const double y = static_cast<double>(row) / c.n;
    moving->add<model::InitialVelocity>({"row" + std::to_string(row), row_velocity(y)});
  }
  run::DynamicOptions options;
  options.duration = 1;
  const double step = 0.5 * std::dynamic_pointer_cast<run::Dynamic>(
                                run::make_dynamic(moving, options, std::make_shared<Notices>()))
                                ->step_size();
  options.duration = step * steps;
  options.step = step;
  return run::make_dynamic(moving, options, std::make_shared<Notices>());
}

double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + static_cast<long>(v.size() / 2), v.end());
  return v[v.size() / 2];
}

// A run of `steps` steps against the kernel's step, in turns of as many steps as hold a look at the ledger,
// so that both see the same machine. Of long runs, the first steps.
bool run_against_kernel(const Case& c, int steps) {
  const int turn = steps >= 4000 ? steps / 200 : 20, turns = std::min(steps / turn, 24) - 1;
  Sheet sheet(c, true);
  const auto run = make_run(c, steps);
  for (int i = 0; i < turn; ++i) {
    sheet.step();
    run->step();
  }
  std::vector<double> kernel, product, share;
  for (int i = 0; i < turns; ++i) {
    kernel.push_back(per_element(c, turn, [&] { sheet.step(); }));
    product.push_back(per_element(c, turn, [&] { run->step(); }));
    share.push_back(product.back() / kernel.back());
  }
  const double over = median(share);
  std::printf(
      "%-8s %d thread%s %3d x %-3d %d points  a run of %5d steps: %6.1f ns, the kernel's step %6.1f ns: "
      "%.3f\n",
      fabricsh::name(best_isa()), c.threads, c.threads == 1 ? " " : "s", c.n, c.n, c.points, steps,
      median(product), median(kernel), over);
  return over <= most_over_kernel;
}

int run_runs(const Case& c) {
  omp_set_num_threads(c.threads);
  const bool few = run_against_kernel(c, 400), many = run_against_kernel(c, 40000);
  if (!few || !many) std::printf("more than %.2f times the kernel's step\n", most_over_kernel);
  return few && many ? 0 : 1;
}

int run_all(const char* self) {
  int status = 0;
  for (const int n : {100, 400})
    for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512})
      for (const int threads : {1, 2})
        for (const char* what : {"2", "3", "5", "0", "3 warped"}) {
          if (isa > best_isa() || threads > omp_get_num_procs()) continue;
          const std::string points = std::string(what).substr(0, 1);
          const std::string command = std::string("FABRICSH_ISA=") + fabricsh::name(isa) + " " + self +
                                      " one " + std::to_string(n) + " " + points + " " +
                                      std::to_string(threads) + (std::strlen(what) > 1 ? " warped" : "");
          status |= std::system(command.c_str());
        }
  return status != 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) return run_all(argv[0]);
  if (std::strcmp(argv[1], "run") == 0)
    return run_runs({std::atoi(argv[2]), std::atoi(argv[3]), std::atoi(argv[4]), false});
  return run_case({std::atoi(argv[2]), std::atoi(argv[3]), std::atoi(argv[4]), argc > 5});
}
