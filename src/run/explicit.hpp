// The run by central differences, with one evaluation of forces per step.
#pragma once
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "run/central_differences.hpp"
#include "run/dynamic.hpp"
#include "run/problem.hpp"

namespace fabricsh::mechanics {
class ExplicitContact;
}

namespace fabricsh::run {

class Explicit final : public Dynamic {
 public:
  Explicit(std::shared_ptr<model::Model> model, const DynamicOptions& options,
           std::shared_ptr<Notices> notices, const Beginning& beginning = {});
  const mechanics::NodalRates& rates() const override;

 private:
  bool takes_unsymmetric() const override { return true; }
  void begin() override;
  void take_options(const DynamicOptions& options) override;
  void set_motion(const mechanics::NodalRates& rates) override;
  double try_step(double limit, StepReport& report) override;
  bool attempt(double size, StepReport& report) override;
  double largest_step() const override { return now_.step; }
  void commit(StepReport& report) override;
  [[noreturn]] void give_up(const StepReport& report) override;
  double scaled_kinetic() const override;
  std::vector<CentralDifferences::Weight> added_inertia() const;
  const mechanics::Motion& motion() const override { return motion_; }
  double hidden_energy() const override;
  std::string against_pressing() const;  // where cloth is pressed for long, or as against_passing()
  std::string against_passing() const;   // advice where surfaces are pressed to the smallest distance
  std::string against_long_step() const override;
  std::string finer_elements() const override;
  void memory(Archive& archive) override;
  std::vector<double> unknown_rates() const override { return motion_.velocities(); }
  void resize() override;
  void take(const mechanics::Transfer& change, const std::vector<double>& rates) override;
  double tear_step() const override { return options_.step.value_or(usual_step()); }
  void list_unknowns();

  void check_stable_step(double undamped) const;  // s, without stiffness damping
  // s: 0.7 of the nominal step and at most 0.9 of the bound, or less with contact.
  double usual_step() const;
  void choose_step();
  void bound_step();  // sets the bound and the stable step for the reference configuration
  // s, with damping by stiffness, which makes a step shorter.
  double damped(double step) const;
  double of_gamma() const;                                                    // factor of the stable step
  double bound_of(double rate) const { return damped(2 / std::sqrt(rate)); }  // s, of a rate_bound()
  void report_step_bound();
  bool lead_drawn_seams();   // around what their straight way passes through; whether there is any more
  bool is_of_waves() const;  // whether the usual step is that of waves in the cloth, not that of the bound
  void split();              // reduces the step where stretch or loads have made the stable step smaller
  // With contact, steps are made in blocks of equal size. If contact needs a smaller step, the run returns to
  // the start of the block and repeats it with half the step: the step does not follow the gap continuously.
  void open_block();
  bool step_acceptable(double dt);
  void redo(const StepReport& report);
  void report_guard();
  void report_cost();  // of a step that contact has long kept short
  std::optional<double> try_shorter(double size, StepReport& report);
  double block_step() const { return std::ldexp(now_.step, -block_.halved); }  // s
  mesh::Index fastest_node() const;                                            // -1: no node moves
  mesh::Index fastest_element() const;  // whose nodes part fastest for its size; -1: none
  // The cause of a failing step: the element, and advice.
  struct Culprit {
    mesh::Index element = -1;
    std::string advice;
  };
  Culprit culprit(double step) const;
  std::optional<Culprit> frequency_above(double step) const;  // empty: no frequency forbids the step
  std::string shape_text(mesh::Index element) const;
  bool stuck() const;          // contact cannot hold what is pressed together
  std::string reason() const;  // the meaning of end_ in words

  struct RepeatableBlock {
    std::string start;  // see Run::save_state()
    // From its start; and since guards were last looked at, which hooks, whose states are not taken back, do
    // not put off.
    std::int64_t steps = 0, watched = 0;
    int halved = 0,
        barrier_free_blocks = 0;  // number of halvings; of times so watched since the guard was last needed
    bool guarded = false, reported = false;
    // Whether guards are met by shorter steps alone, and whether something has struck them since its start.
    bool uneased = false, struck = false;
    void keep(Archive& archive) {
      archive(start, steps, watched, halved, barrier_free_blocks, guarded, reported, uneased, struck);
    }
  } block_;
  double nominal_ = 0, bound_ = 0;  // s: the step of the waves in the cloth; one that no frequency forbids
  std::vector<double> added_;       // see mechanics::added_rates()
  // Central differences conserve the sum of the energies less dt^2/8 times this weight, sum of m a^2; what
  // changes of dt have moved of that, J; the dt, s.
  struct Conserved {
    double moved = 0, dt = 0;
    void keep(Archive& archive) { archive(moved, dt); }
  } conserved_;
  double weight_of_acceleration_ = 0;  // J/s^2, see CentralDifferences: before the joints changed
  // Per unknown whether it is a rotation; and the limits, m and rad, beyond which an increment means that the
  // run diverges.
  std::vector<unsigned char> turns_;
  std::array<double, 2> farthest_{};
  CentralDifferences motion_;
  std::vector<CentralDifferences::Weight> added_inertia_;
  const std::function<void()> unpolled_;  // no poll, since a step is short
  EquilibriumProblem problem_;
  mechanics::ExplicitContact* contact_ = nullptr;  // null: the model has none
  std::vector<double> left_velocities_ = {};  // of the unknowns of the run that it begins from; empty: none
  bool dirty_ = false;                        // whether the trial state differs from the committed one
  // The reason for which the last attempt ended early.
  enum class End { none, ran_away, limited, forces } end_ = End::none;
  mutable mechanics::NodalRates rates_;
  mutable std::uint64_t rates_version_ = 0;
};

}  // namespace fabricsh::run
