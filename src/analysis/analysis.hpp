// What a deck drives: a run in time over a compiled model. Static is the quasi-static one.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assembly/assembly.hpp"
#include "base/notice.hpp"
#include "model/model.hpp"
#include "solver/arc_length.hpp"
#include "solver/relaxation.hpp"

namespace fabricsh::analysis {

// Read-only averages over an element's reference volume, material axes, tensor components.
struct ElementValues {
  double E11 = 0, E22 = 0, E23 = 0, E13 = 0, E12 = 0;
  double S11 = 0, S22 = 0, S23 = 0, S13 = 0, S12 = 0;
  double stored = 0, dissipated = 0;  // J/m^3
  double residual1 = 0, residual2 = 0, slack1 = 0, slack2 = 0;
};
// Names in the order of the members above, for a:mean, a:field and the outputs.
const std::vector<std::string>& element_value_names();
double element_value(const ElementValues& v, const std::string& name);  // Error: unknown name

struct NodeValues {
  Vec3 x, X, u, v, n;  // current, reference, displacement (m), velocity (m/s; zero in statics), director
};

struct Energy {  // J
  double kinetic = 0, stored = 0, dissipated = 0, damping = 0, external = 0;
  double dissipated_warp = 0, dissipated_weft = 0, dissipated_shear = 0, dissipated_bending = 0, created = 0;
  double internal() const { return stored + dissipated; }
  double error = 0;  // |kinetic + stored + dissipated + damping - external| / largest |external| so far
};

enum class Linear { automatic, symmetric, unsymmetric };  // automatic: symmetric where law and loads are
// load: each step has its end time. arc: each step has its length along the path, and time, which loads and
// supports hang on, follows; it may go down, past a limit point. The run ends where it first reaches the
// duration.
enum class Control { load, arc };
// relaxation: every step by dynamic relaxation, polished by Newton. either: Newton, and relaxation for a step
// that it can't do in a few cuts.
enum class Method { newton, relaxation, either };

struct StaticOptions {
  double duration = 0;              // s, required, positive
  std::optional<double> step = {};  // largest step, s; default duration / 20
  double tolerance = 1e-10;         // residual over the largest nodal force so far
  int max_iterations =
      50;             // slack cloth at its first strains switches many yarns: an active set takes its time
  int max_cuts = 12;  // halvings of one step before the run gives up
  bool line_search = true;
  double min_step = 0;  // s: no cut goes below
  Linear linear = Linear::automatic;
  Control control = Control::load;
  Method method = Method::newton;
  // Viscous forces c m dx/dt on the nodes, c chosen such that a step loses this fraction of its work; 0:
  // none.
  double stabilise = 0;
};
inline constexpr double usual_stabilisation = 2e-4;

// One line per committed step.
struct StepReport {
  double time = 0, step = 0;
  int iterations = 0;
  int cuts = 0;                       // halvings that this step took
  std::vector<double> residuals;      // relative residual of each iteration, the first one is the predictor's
  solver::Index negative_pivots = 0;  // of the last tangent: none on a stable path
};

class Static {
 public:
  // Compiles and seals the model. Errors: options out of range; model.validate().
  Static(std::shared_ptr<model::Model> model, const StaticOptions& options, std::shared_ptr<Notices> notices);
  ~Static();

  void solve() { advance(options_.duration); }  // runs to the duration, or to where a hook stopped it
  void advance(double time);             // to the absolute time, landing on it. NumericalFailure when stuck
  void step();                           // one committed step (clipped at the duration)
  void stop(const std::string& reason);  // from a hook or event: the run ends after the current step's hooks
  bool stopped() const { return stopped_; }
  const std::string& stop_reason() const { return stop_reason_; }

  // Called after each committed step (along an arc, time may have gone down), or whenever `every` seconds
  // have passed (the run lands on those times); also at the start (time 0), before the first step. Hooks run
  // in the order in which they were added.
  using Hook = std::function<void(Static&)>;
  void every_step(Hook hook);
  void every(double interval, Hook hook);  // Error: interval not positive
  // Locates, inside the step, where value(a) crosses zero (after having been non-zero), lands there within
  // |value| <= tolerance * largest |value| so far, commits, and runs the hook.
  void event(std::function<double(Static&)> value, double tolerance, Hook hook);

  double time() const;
  double duration() const { return options_.duration; }
  Vec3 reaction(const std::string& set) const;  // N, global: the force the supports exert on the cloth
  NodeValues node(mesh::Index i) const;         // from 0; Error outside
  ElementValues element(mesh::Index i) const;   // from 0; Error outside
  double mean(const std::string& name, const std::string& set = "all") const;
  std::vector<double> field(const std::string& name) const;  // one per element
  const std::vector<ElementValues>& elements() const;        // of the current state, computed once per state
  Energy energy() const;

  const model::Model& model() const { return *model_; }
  const assembly::Assembly& assembly() const { return *assembly_; }
  const std::vector<StepReport>& steps() const { return reports_; }
  const StaticOptions& options() const { return options_; }
  Notices& notices() { return *notices_; }

  // A snapshot is a copy of the whole state; restore goes back to it (a snapshot of another analysis is an
  // Error).
  struct Snapshot;
  std::shared_ptr<const Snapshot> snapshot() const;
  void restore(const Snapshot& snapshot);

 private:
  class Problem;  // what Newton sees
  struct Timed {
    double interval = 0;     // 0: every step
    std::int64_t count = 0;  // next landing at count * interval
    Hook hook;
  };
  struct Event {
    std::function<double(Static&)> value;
    double tolerance = 0, last = 0, largest = 0;
    Hook hook;
    bool fired = false;
  };
  void start();
  double next_landing(double limit) const;
  // A step's size: the time at its end, along an arc its length (0: that of a first step).
  double plan(double limit);                            // size of the next step
  void advance_to(double limit);                        // one committed step towards the limit
  bool attempt(double size, StepReport& report);        // solved, not committed
  void calibrate(double size, StepReport& report);      // the damping of the first step
  bool rescue(double size, StepReport& report);         // by relaxation, where that is allowed
  bool cut(double size);                                // half of it; false: too small
  void grow(const StepReport& report);                  // what the next step may be
  void land_on_event(double size, StepReport& report);  // shortens the attempt to the first event inside it
  solver::NewtonResult relax();
  bool finish(const solver::NewtonResult& result, double end, StepReport& report);
  void commit(StepReport report);
  void run_hooks();
  void add_external_work();
  void tell(const StepReport& report);  // notices
  // What carried the residual of a failed attempt; looked up before the state is rolled back.
  struct Blame {
    mesh::Index node = -1, element = -1;
    std::string yarn;  // "warp", "weft", "shear" where its branch changes within the step; or empty
  };
  Blame find_blame() const;
  std::vector<fabric::Branch> branches(mesh::Index element) const;  // 3 per point: warp, weft, shear
  [[noreturn]] void give_up(const StepReport& report) const;

  std::shared_ptr<model::Model> model_;
  StaticOptions options_;
  std::shared_ptr<Notices> notices_;
  std::unique_ptr<assembly::Assembly> assembly_;
  std::unique_ptr<Problem> problem_;
  std::unique_ptr<solver::Newton> newton_;  // each of the three where it is used
  std::unique_ptr<solver::ArcLength> arc_;
  std::unique_ptr<solver::Relaxation> relaxation_;
  std::vector<Timed> timed_;
  std::vector<Event> events_;
  std::vector<StepReport> reports_;
  std::vector<double> kinks_;
  solver::NewtonResult last_;
  Blame blame_;
  double largest_step_ = 0, current_step_ = 0, trial_time_ = 0;
  double arc_length_ = 0, tried_length_ = 0, longest_length_ = 0, landing_ = 0;  // along an arc
  double damping_work_ = 0;
  double external_work_ = 0, largest_external_work_ = 0;
  std::vector<double> previous_x_,
      previous_force_;  // 3 per node: at the last commit; dead loads plus support forces
  bool started_ = false, stopped_ = false, told_pivots_ = false, told_damping_ = false;
  std::string stop_reason_;
  mutable std::vector<ElementValues> cache_;
  mutable std::uint64_t cache_version_ = 0;
};

}  // namespace fabricsh::analysis
