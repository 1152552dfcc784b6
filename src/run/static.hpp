// The quasi-static run: Newton's method, path following or relaxation, with steps that are cut if they fail.
#pragma once
#include <limits>
#include <optional>

#include "base/field.hpp"
#include "linear/libraries.hpp"
#include "mechanics/terms/damping.hpp"
#include "run/diagnosis.hpp"
#include "run/problem.hpp"
#include "run/run.hpp"
#include "run/solver_choice.hpp"
#include "run/step_control.hpp"
#include "solver/arc_length.hpp"
#include "solver/descent.hpp"
#include "solver/relaxation.hpp"
#include "solver/trust_region.hpp"

namespace fabricsh::run {

// load: a step has a given end time. arc: a step has a given length along the path, and time, on which loads
// and supports depend, is computed; it decreases after a limit point. The run ends when time first reaches
// the duration.
enum class Control { load, arc };
// relaxation: every step by dynamic relaxation, completed by Newton's method; where cloth has bending of its
// own, whose low rigidity makes dynamic relaxation converge too slowly, by overdamped implicit steps.
// either: Newton's method, and relaxation for a step that fails after a few cuts. automatic: Newton's method,
// which hands over to the overdamped motion where it is slow, and back, before a step is cut; then as either.
enum class Method { newton, relaxation, either, automatic };

// Described by the rows of static_options(), in static_options.cpp.
struct StaticOptions {
  double duration = 0;              // s, required, positive
  std::optional<double> step = {};  // largest step, s; default duration / 20
  double tolerance = 1e-10;         // residual over the largest nodal force so far
  double ledger_limit = 0.05;       // energy made from nothing over external work at which the run stops
  // Slack cloth at small strains switches many yarns, which takes many iterations.
  int max_iterations = 200;
  int max_cuts = 12;  // halvings of one step before the run fails
  bool line_search = true;
  double min_step = 0;  // s: smallest size of a step
  Symmetry linear = Symmetry::automatic;
  Control control = Control::load;
  Method method = Method::automatic;
  // Viscous forces c m dx/dt on the nodes; c is chosen so that a step dissipates this fraction of its work.
  // 0: none.
  double stabilise = 0;
  std::optional<SolverChoice> solver = {};  // empty: the one that `linear` names
  // Error of the way that laws remember, of the whole run, over the largest displacement or force: a step
  // that takes more than its part is cut. Empty: it is only said.
  std::optional<double> path = {};
  Limit limit = Limit::tell;
};
const std::vector<field::FieldOf<StaticOptions>>& static_options();
inline constexpr double usual_stabilisation = 2e-4;
// Of the largest displacement or force: the error of long steps that is said where the deck states no `path`.
inline constexpr double usual_path = 0.05;

class Static final : public Run {
 public:
  // Errors: options out of range; model.validate().
  Static(std::shared_ptr<model::Model> model, const StaticOptions& options, std::shared_ptr<Notices> notices,
         const Beginning& beginning = {});
  ~Static() override;

  const StaticOptions& options() const { return options_; }
  const char* kind() const override { return "static"; }
  double tolerance() const override { return options_.tolerance; }
  std::string method() const override;
  std::string kernels() const override { return linear::blas_kernels(); }
  void set(const Settings& settings) override;
  void keep_settings(Archive& archive) override;

 private:
  class Trace;
  bool takes_unsymmetric() const override;
  void begin() override;
  void begin_loaded();
  double try_step(double limit, StepReport& report) override;
  bool attempt(double size, StepReport& report) override;
  double largest_step() const override { return options_.step.value_or(options_.duration / 20); }
  double no_size() const override;
  double relaxed() const override { return now_.relaxed; }
  double imbalance(const EnergyAccount&, double) const override { return now_.made; }
  double tried_size(double size) const override;
  void commit(StepReport& report) override;
  [[noreturn]] void give_up(const StepReport& report) override;
  void memory(Archive& archive) override;
  void resize() override { problem_->resize(); }
  void take(const mechanics::Transfer& change, const std::vector<double>& rates) override;
  void check() override;

  void check_bodies() const;  // Error: a body that this kind of run cannot move
  std::unique_ptr<linear::LinearSolver> make_linear() const;
  double plan(double limit);  // size of the next step
  double damping_factor() const { return stabilisation_ == nullptr ? 0 : stabilisation_->factor(); }
  void calibrate(double size, StepReport& report);    // adapts the damping of the first step
  bool rescue(double size, StepReport& report);       // by relaxation, if it is permitted
  bool settle_jump(double size, StepReport& report);  // the first step of loads that are there at time 0
  double solve_step(double limit, StepReport& report);
  bool cut(double size);  // halves the size; false: too small
  // --- the way that laws remember (static_path.cpp)
  bool depends_on_path() const;
  bool asks_path(double part);
  bool left_shape() const;  // whether the step that has been solved may have
  bool falls() const;       // whether it ends with much less energy stored than it began with
  bool by_shares() const;   // whether contact moves bodies by shares of their way in Newton's iterations
  bool follows_path(double end, StepReport& report);
  struct Halves {  // the difference of a step to its halves: over what is largest so far, m, N and J
    double error = std::numeric_limits<double>::quiet_NaN(), moved = 0, pulled = 0, fallen = 0;
    int parts = 2;
  };
  struct StepEnd {  // what parts of a step are compared with
    std::vector<double> kinematics, pulls;
    double stored = 0;
  };
  Halves path_error(double end, StepReport& report);
  Halves compare_parts(int parts, double end, const StepEnd& to);
  double no_displacement(double force) const;
  bool solve_part(double end, std::span<const double> guess);
  std::vector<double> held_by_supports() const;  // N, 3 per node
  void put(std::span<const double> kinematics);  // as the trial configuration
  void note_path(const StepReport& report);
  void watch_path();
  void grow(const StepReport& report);  // sets the size of the next step
  void grow_arc(const StepReport& report);
  solver::NewtonResult relax(solver::NewtonOptions options);
  solver::NewtonResult arrive(
      const solver::NewtonOptions& options);  // Newton's method and the other, in turn
  solver::NewtonResult left_if_unstable(const solver::NewtonResult& found,
                                        const solver::NewtonOptions& options);
  solver::NewtonResult lifted(const solver::NewtonOptions& options);  // begins beside a flat membrane
  solver::NewtonResult complete(const solver::NewtonResult& relaxed, const solver::NewtonOptions& options);
  solver::Stability judge();  // of the trial state, where the solver that found it has not asked
  // --- rigid bodies that forces place (static_bodies.cpp)
  solver::Stability judge_bodies(const linear::Matrix& K);
  Eigen::MatrixXd stiffness_of_bodies(const linear::Matrix& K);
  std::string loose_bodies();  // in words; empty: none, or they cannot be told
  bool flies_away() const;
  bool finish(solver::NewtonResult result, double end, StepReport& report);
  void report_notices(const StepReport& report);  // gives notices
  void check_balance();                           // stops the run if energy was made from nothing
  void note_energy();                             // of the committed state
  bool turns_inside_out() const;                  // whether an element or a director does that had not before
  void note_shape();

  StaticOptions options_;
  const StaticOptions given_;
  const bool remembers_path_;  // whether a law does
  const bool places_bodies_;   // rigid ones, whose places are unknowns that only Newton's method knows of
  const bool has_energy_;      // whether the law's forces have one, which a search for equilibrium can lower
  const bool near_symmetric_;  // tangents, but for what friction adds
  std::unique_ptr<EquilibriumProblem> problem_;
  mechanics::Stabilisation* stabilisation_ = nullptr;  // a term of the assembly; null: none
  std::unique_ptr<solver::TrustRegion> stable_;        // each is created if it is used
  // For laws without an energy; for others it completes dynamic relaxation, and tries steps that have been
  // cut.
  std::unique_ptr<solver::Newton> newton_;
  std::unique_ptr<solver::ArcLength> arc_;
  std::unique_ptr<solver::Relaxation> relaxation_;
  std::unique_ptr<solver::Descent> descent_;  // in its place, where cloth has bending of its own
  std::unique_ptr<solver::LinearSolver> judging_;
  std::unique_ptr<solver::StabilityCheck> check_;  // where stable_ has not asked: along an arc, by relaxation
  std::unique_ptr<solver::Descent> helper_;        // of Newton's method
  Diagnosis step_;                                 // the present one
  bool cutting_ = false;     // whether a step that fails is halved, or is as long as asked for
  bool falls_ = false;       // whether the last step that was solved does
  bool afresh_ = false;      // whether halves of a step are solved as any step is
  bool hard_parts_ = false;  // whether one of them took many iterations
  bool relaxing_ = false;    // whether the last try at the present step was by relaxation
  Halves halves_;            // of the last step that was compared
  bool crept_ = false;       // whether it needed the overdamped motion
  bool settling_ = false;    // whether settle_jump() has tried to relax the present step
  struct StaticState {       // the variables of the run
    StepControl step;
    double arc_length = 0, tried_length = 0, longest_length = 0, landing = 0;  // along an arc
    bool reported_pivots = false, reported_damping = false, reported_error = false, reported_balance = false;
    std::int64_t left = 0;                  // unstable equilibria, of all steps
    bool jumps = false;                     // whether loads or motions begin with a jump at time 0
    bool settled = false;                   // whether that first step was relaxed
    bool inverted = false, turned = false;  // whether an element or a director of the committed state is
    double relaxed = 0;                     // J, see EnergyAccount
    double made = 0;                        // J, stored beyond what loads and supports can have given
    double unsure = 0;    // J, the part of it in steps in which bodies move or seams are drawn
    double fallen = 0;    // J, the part of `relaxed` in steps in which the cloth may have fallen
    double internal = 0;  // J, stored, dissipated and lost to damping in the committed state
    double stored = 0, most_stored = 0;  // J, in it, and in any so far
    // Of path_error(): m, N and J, the largest so far and the sums of what steps err; the step that errs
    // most; its error over what is allowed; committed steps when it was asked last, when it is next, and how
    // many between.
    double way = 0, path_force = 0, path_moved = 0, path_pulled = 0, path_fallen = 0, path_worst = 0,
           path_step = 0, path_time = 0, path_ratio = 0;
    std::int64_t path_asked = -1, path_next = 0, path_gap = 1;
    int path_parts = 2;  // in which the step that errs most was made again
    void keep(Archive& archive) {
      archive(step, arc_length, tried_length, longest_length, landing, reported_pivots, reported_damping,
              reported_error, reported_balance, left, jumps, settled, inverted, turned, relaxed, made, unsure,
              fallen, internal, stored, most_stored, way, path_force, path_moved, path_pulled, path_fallen,
              path_worst, path_step, path_time, path_ratio, path_asked, path_next, path_gap, path_parts);
    }
  } now_;
};

}  // namespace fabricsh::run
