// Dynamic runs: Newmark's method [williams2010, Box 5-2, corrected], explicit or implicit, with directors on
// the sphere, and a ledger of energies that are functions of the state.
#pragma once
#include <array>
#include <optional>

#include "base/field.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/terms/inertia.hpp"
#include "run/run.hpp"
#include "run/solver_choice.hpp"

namespace fabricsh::run {

enum class Scheme { explicit_steps, implicit_steps };

// Leaves a mode 0.67 of its amplitude after a step that is long compared with its period, and takes 0.6 %
// of the energy of one with 20 steps to its period, in a period.
inline constexpr double kDampingAlpha = -0.2;

// How an implicit run whose deck chose no scheme has begun to damp, because it made energy: by kDampingAlpha,
// or beside contact by the rule there, with gamma = 1, or by Euler's backward rule. With a scheme of the
// deck's own `hht` is the generalised trapezoidal rule in its place.
enum class Damping { none, hht, strong, backward };

// The run ends when all seams that are drawn have closed, and for as long as the window, and as a third of
// the time since seams, loads and motions were last changing, the kinetic energy has been at most `calm` of
// the energy stored, and no node has gone farther than `still`.
struct UntilRest {
  double calm = 1e-2, window = 0.02;  // window: s
  std::optional<double> still = {};   // m
};

// Described by the rows of dynamic_options(), in dynamic_options.cpp.
struct DynamicOptions {
  double duration = 0;              // s, required, positive
  std::optional<double> step = {};  // s; explicit: default 0.7 of the stable one; implicit: duration / 200
  Scheme scheme = Scheme::explicit_steps;
  double gamma = 0.5;               // alpha in the thesis
  std::optional<double> beta = {};  // default 0 explicit, 1/4 implicit; hht sets its own
  // Hilbert, Hughes and Taylor's alpha, -1/3 to 0 (implicit). Default: 0, and from the step on in which
  // average acceleration has made energy another scheme, see Damping.
  std::optional<double> hht = {};
  // Implicit: the share of an amplitude that is left after a step much longer than its period, 0 to 1.
  // Instead of gamma, beta and hht.
  std::optional<double> spectral_radius = {};
  bool slow = false;  // implicit: as spectral_radius = 0
  // Implicit: the error of a node's place in a step, of the size of the model, that its length may cause.
  std::optional<double> error = {};
  double mass_damping = 0;          // a of a M + b K_M, 1/s
  double stiffness_damping = 0;     // b, s
  std::optional<bool> scaled = {};  // scale up rotary inertia; default: explicit yes, implicit no
  bool force = false;               // accept a step above the stable one
  double ledger_limit = 0.05;       // created energy over external work at which the run stops
  std::optional<UntilRest> until_rest = {};
  double tolerance = 1e-8;  // implicit; this and the following as in StaticOptions
  int max_iterations = 30, max_cuts = 12;
  bool line_search = true;
  Symmetry linear = Symmetry::automatic;    // implicit
  std::optional<SolverChoice> solver = {};  // implicit
  Limit limit = Limit::tell;
};
const std::vector<field::FieldOf<DynamicOptions>>& dynamic_options();
// Why a run with these options does not have the option of this name; empty: it has.
std::string refused_option(const DynamicOptions& options, const std::string& name);

// Shared by both schemes: velocities for readings, and the checks of the ledger.
class Dynamic : public Run {
 public:
  const DynamicOptions& options() const { return options_; }
  const char* kind() const override { return "dynamic"; }
  bool moves() const override { return true; }
  std::string method() const override;
  void set(const Settings& settings) override;
  void keep_settings(Archive& archive) override;
  double scaled_share() const override { return now_.scaled; }
  double stable_step() const { return stable_; }           // s, of the reference configuration (theory.md, 7)
  double step_size() const { return now_.step; }           // s, regular size of the steps
  virtual const mechanics::NodalRates& rates() const = 0;  // of the committed state

 protected:
  Dynamic(std::shared_ptr<model::Model> model, const DynamicOptions& options,
          std::shared_ptr<Notices> notices, const Beginning& beginning);
  void begin() override;
  const mechanics::NodalRates* nodal_rates() const override { return &rates(); }
  void check() override;
  double no_size() const override { return committed_time(); }
  double scaled_kinetic() const override;
  double scheme_loss() const override { return now_.loss; }
  double driven_work() const override;
  Vec3 inertia(mesh::Index node) const override;
  Vec3 velocity(mesh::Index node) const override { return at(rates().x, node); }
  // The dissipation of the scheme (gamma, hht) in a step: W_ext - W_int - W_damp - change of kinetic energy.
  bool damps() const {
    const bool implicit = options_.scheme == Scheme::implicit_steps;
    return now_.damping != Damping::none || now_.corner > 0 || radius_ < 1 || options_.gamma != 0.5 ||
           options_.hht.value_or(0) != 0 || (implicit && options_.beta.value_or(0.25) != 0.25);
  }
  std::vector<double> driven_rates() const;  // of the driven freedoms at the trial time, m/s or 1/s
  // J: the energy that the whole cloth would have with the largest jump of a support's speed at that time.
  double energy_of_corner() const;
  double driven_kinetic() const override;
  virtual const mechanics::Motion& motion() const = 0;
  // Advice if the present step is longer than some frequency allows; empty: it is not.
  virtual std::string against_long_step() const { return {}; }
  // Advice where something comes faster than contact of this mesh stops; empty, or with "; " at its end.
  virtual std::string finer_elements() const { return {}; }
  // Whether check() examines the ledger after this number of explicit steps, at this time.
  bool looks_after(std::int64_t steps, double time) const;
  mechanics::NodalRates initial_rates() const;
  virtual void set_motion(const mechanics::NodalRates& rates) = 0;  // at time 0
  // Gives a notice if a driven displacement changes by more than `most` (m) in the step up to `time` (s).
  void watch_jump(const std::vector<double>& from, const std::vector<double>& to, double time, double most);
  std::vector<bool> dropped_nodes(const mechanics::NodalRates& rates, std::array<bool, 3>& axes) const;
  // Gives a notice about initial velocities of nodes that are held or driven.
  void report_dropped_rates(const mechanics::NodalRates& rates);
  std::string share_text(double made, const EnergyAccount& energies, double scale) const;
  std::string remedy(const EnergyAccount& energies) const;  // advice for an error of the ledger
  // Lets the scheme damp from the next step on, or more than so far, as the error of the ledger over its
  // scale demands. Returns what is said of it; empty: nothing changes.
  virtual std::string begin_to_damp(double /*error*/) { return {}; }
  bool is_driven() const;  // by supports or bodies
  // Whether the work that drives the run may still be badly known, so that more is allowed to its ledger.
  bool is_young() const;
  bool has_few_steps() const;
  // J: what the error of the ledger is compared with.
  double ledger_scale(const EnergyAccount& energies) const;

  virtual void take_options(const DynamicOptions& options) = 0;  // after a change of settings

  DynamicOptions options_;
  const DynamicOptions given_;
  double radius_ = 1;         // the spectral radius of an implicit scheme, where it is chosen by that
  bool scaled_, moves_mass_;  // scaled inertia; and mass of its own that it makes of the cloth's
  const mechanics::Inertia* inertia_ = nullptr;  // a term of the assembly
  double off_ = 0;                               // J: how far the work of the last step can be off
  double stable_ = 0, smallest_ = 0;             // s; m, the smallest element
  struct DynamicState {
    double step = 0, loss = 0;  // s; J, dissipated by the scheme
    double driven_kinetic_at_0 = 0, next_check = 0;
    std::int64_t steps = 0, looked = 0;  // committed; at the last check of the ledger
    bool reported_error = false, reported_split = false, reported_jump = false, reported_scaled = false,
         was_over = false;
    Damping damping = Damping::none;
    int settling = 0;    // implicit steps left, at least, in which directors of opened joints settle
    double settles = 0;  // s, the time until which they do
    int corner = 0;      // implicit steps left behind a jump of a support's speed
    double jump = 0;     // J, of its energy, that these may still take
    double surplus = 0;  // J, of the ledger before the present one of these
    double base = 0;     // J, the surplus when the scheme began to damp; with hht the largest loss
    double kinetic = 0, scaled = 0;  // J, the largest so far; its part in scaled rotary inertia
    mesh::Index began = -1;          // element in which energy was created at the first warning
    std::int64_t touched = -1;       // committed steps when a moved body first touched; -1: not yet
    double forgiven = 0;      // the ledger's error over its scale when steps were shortened for a turning
    double early = 0;         // J, the ledger's error while ten times the limit was allowed
    double unsure = 0;        // J, of that: what the work that drives the run can be off
    bool was_sure = false;    // whether the error was more at the last check
    int short_steps = 0;      // steps that contact has made much shorter
    int flat_looks = 0;       // how often it was asked whether a flat sheet is stable
    double calm_since = -1;   // s; -1: it is not calm
    double calm_kinetic = 0;  // J, then
    std::vector<double> calm_places;  // of the nodes, then, m
    double led_until = 0;             // s, the last look at which seams, loads or motions were changing
    bool rested = false;              // it has ended at rest before
    void keep_reported(const DynamicState& then) {
      reported_error |= then.reported_error, reported_split |= then.reported_split;
      reported_jump |= then.reported_jump, reported_scaled |= then.reported_scaled;
      if (then.reported_error) began = then.began;
    }
    void keep(Archive& archive) {
      archive(step, loss, driven_kinetic_at_0, next_check, steps, looked, reported_error, reported_split,
              reported_jump, reported_scaled, was_over, damping, settling, settles, corner, jump, surplus,
              base, kinetic, scaled, began, touched, forgiven, early, unsure, was_sure, short_steps,
              flat_looks, calm_since, calm_kinetic, calm_places, led_until, rested);
    }
  } now_;

 private:
  mesh::Index suspect() const;
  void watch_flat(const EnergyAccount& energies);
  void watch_inertia();
  void watch_loss(const EnergyAccount& energies);  // reports once what the scheme took, at the end of a run
  void watch_rest();
  void report_unrest(const EnergyAccount& energies);
  bool is_calm(const EnergyAccount& energies) const;
  bool is_led() const;                                // by seams, loads or motions
  double still() const;                               // m, the way of a node within which it rests
  double rests_after() const;                         // s, that it has to be calm
  void weigh_inertia(double kinetic, double scaled);  // records the part of scaled rotary inertia, J
  bool is_end(double time) const;
  double next_look(double after) const;  // s, when the ledger is looked at next
  bool is_due(double time) const;        // whether the ledger should be checked
};

// Errors: options out of range; a step above the stable one without `force`; ties without a lumped mass
// (explicit).
std::shared_ptr<Dynamic> make_dynamic(std::shared_ptr<model::Model> model, const DynamicOptions& options,
                                      std::shared_ptr<Notices> notices, const Beginning& beginning = {});

}  // namespace fabricsh::run
