// Runs in motion: Newmark's method [williams2010, Box 5-2, corrected], explicit or implicit, with directors
// on the sphere and a ledger of energies that are functions of the state.
#pragma once
#include <array>
#include <optional>

#include "geometry/node_view.hpp"
#include "mechanics/terms/inertia.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

enum class Scheme { explicit_steps, implicit_steps };

struct DynamicOptions {
  double duration = 0;              // s, required, positive
  std::optional<double> step = {};  // s; explicit: default 0.7 of the stable one; implicit: duration / 200
  Scheme scheme = Scheme::explicit_steps;
  double gamma = 0.5;               // the thesis' alpha
  std::optional<double> beta = {};  // default 0 explicit, 1/4 implicit; hht sets its own
  double hht = 0;                   // Hilbert, Hughes and Taylor's alpha, -1/3 to 0 (implicit)
  double mass_damping = 0;          // a of a M + b K_M, 1/s
  double stiffness_damping = 0;     // b, s
  std::optional<bool> scaled = {};  // rotary inertia scaled up; default: explicit yes, implicit no
  bool force = false;               // take the step even above the stable one
  double ledger_limit = 0.05;       // energy made, over the external work, at which the run stops
  double tolerance = 1e-8;          // implicit, from here on as in StaticOptions
  int max_iterations = 30, max_cuts = 12;
  bool line_search = true;
};

// What both schemes share: velocities for the readings, the ledger's checks.
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
  double step_size() const { return now_.step; }           // s, that the run goes by, landings apart
  virtual const mechanics::NodalRates& rates() const = 0;  // of the committed state

 protected:
  Dynamic(std::shared_ptr<model::Model> model, const DynamicOptions& options,
          std::shared_ptr<Notices> notices);
  void begin() override;
  void check() override;
  double no_size() const override { return committed_time(); }
  double scaled_kinetic() const override;
  double scheme_loss() const override { return now_.loss; }
  double driven_work() const override;
  Vec3 inertia(mesh::Index node) const override;
  Vec3 velocity(mesh::Index node) const override { return at(rates().x, node); }
  // What the trapezoid makes of gamma, hht: W_ext - W_int - W_damp - change of kinetic energy in a step.
  bool damps() const {
    const bool implicit = options_.scheme == Scheme::implicit_steps;
    return options_.gamma != 0.5 || options_.hht != 0 || (implicit && options_.beta.value_or(0.25) != 0.25);
  }
  std::vector<double> driven_rates() const;  // of the driven freedoms at the trial time, m/s or 1/s
  double driven_kinetic() const override;
  virtual const mechanics::Motion& motion() const = 0;
  // Will check() look at the ledger after so many explicit steps, at a time?
  bool looks_after(std::int64_t steps, double time) const;
  mechanics::NodalRates initial_rates() const;
  virtual void set_motion(const mechanics::NodalRates& rates) = 0;  // at time 0
  // A notice where a driven displacement goes by more than `most` m in the step to a time, s.
  void watch_jump(const std::vector<double>& from, const std::vector<double>& to, double time, double most);
  std::vector<bool> dropped_nodes(const mechanics::NodalRates& rates, std::array<bool, 3>& axes) const;
  // A notice of velocities at time 0 given to nodes that are held or driven.
  void tell_dropped(const mechanics::NodalRates& rates) const;
  void say(const std::string& text) { notices_->say(text); }
  std::string remedy(const Energy& energies) const;  // of a ledger's error

  virtual void take_options(const DynamicOptions& options) = 0;  // whose settings have changed

  DynamicOptions options_;
  const DynamicOptions given_;
  bool scaled_;
  const mechanics::Inertia* inertia_ = nullptr;  // a term of the assembly
  double stable_ = 0, smallest_ = 0;             // s; m, the smallest element
  struct Now {
    double step = 0, loss = 0;  // s; J, that the scheme has taken
    double driven_kinetic_at_0 = 0, next_check = 0;
    std::int64_t steps = 0, looked = 0;  // committed; when check() last looked at the ledger
    bool told_error = false, told_split = false, told_jump = false, told_scaled = false, was_over = false;
    double kinetic = 0, scaled = 0;  // J, the largest so far; share of that in inertia that is scaled up
    mesh::Index began = -1;          // element where energy was made when the first warning came
    void keep(Archive& archive) {
      archive(step, loss, driven_kinetic_at_0, next_check, steps, looked, told_error, told_split, told_jump,
              told_scaled, was_over, kinetic, scaled, began);
    }
  } now_;

 private:
  mesh::Index suspect() const;
  void weigh_inertia(double kinetic, double scaled);  // what scaled rotary inertia is worth, J
  double moving_kinetic() const;                      // J
  bool is_end(double time) const;
  bool is_due(double time) const;  // is it time for a look at the ledger
};

// Errors: options out of range; a step above the stable one without `force`; ties that have no lumped mass
// (explicit).
std::shared_ptr<Dynamic> make_dynamic(std::shared_ptr<model::Model> model, const DynamicOptions& options,
                                      std::shared_ptr<Notices> notices);

}  // namespace fabricsh::run
