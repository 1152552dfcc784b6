// The state of a run: the model, its compiled form, the time, the steps so far, and what has been said about
// them.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/notice.hpp"
#include "mechanics/assembly.hpp"
#include "model/model.hpp"
#include "run/values.hpp"
#include "run/warnings.hpp"

namespace fabricsh::run {

// Of a node whose director is driven about an axis. The force is that of the support on a node that goes
// about a centre; of others it is zero here and among the forces on positions.
struct TurningSupport {
  mechanics::Index node = -1;
  Vec3 force = Vec3::Zero();  // N
  double moment = 0;          // N m, about the axis
  void keep(Archive& archive) { archive(node, force[0], force[1], force[2], moment); }
};

// The external forces that do work on the cloth; 3 per node, global.
struct WorkingForces {
  std::vector<double> on_x;  // N
  std::vector<double> on_d;  // N m, on directors; empty if no load acts on them
  std::vector<TurningSupport> turning;
};
// Dead loads, follower loads and the forces of moving supports at the trial configuration, whose forces must
// have been computed after set_time() at its time. dead: as for ExternalWork.
void find_working_forces(const mechanics::Assembly& assembly, std::span<const double> dead,
                         WorkingForces& out);

class ExternalWork {
 public:
  // Called with the trial configuration, its forces computed for its time, before the commit. dead: dead
  // loads at that time, N, 3 per node. The first state of a run does no work.
  void start(mechanics::Assembly& assembly, std::span<const double> dead);
  void add(mechanics::Assembly& assembly, std::span<const double> dead);
  // The same where the path between the states is unknown (relaxation). With forces that change monotonically
  // along it the work lies between that of the first and of the last state's forces. To be added by add().
  // theta: the part of the forces that counts at the end of the step.
  mechanics::StepWork bounded(mechanics::Assembly& assembly, std::span<const double> dead,
                              double theta = 0.5);
  // J, adds work known from elsewhere.
  void add(double work);
  void keep(Archive& archive) { archive(total_, largest_, before_.on_x, before_.on_d, before_.turning); }
  double total() const { return total_; }      // J
  double largest() const { return largest_; }  // J, the largest |total| so far

 private:
  mechanics::StepWork of_step(mechanics::Assembly& assembly, std::span<const double> dead, bool bounded);
  double total_ = 0, largest_ = 0;
  WorkingForces before_, now_;
  std::optional<bool> loaded_;  // whether constant dead loads are other than zero, once known
};

// The field by which whoever asked for a run can make its steps smaller: that of the run itself; `step` (s)
// or `steps` (a number of them) of a virtual test, which has no other option of a run; or none.
enum class StepField { of_run, step, steps, none };

class RunState {
 public:
  virtual ~RunState();
  RunState(const RunState&) = delete;
  RunState& operator=(const RunState&) = delete;

  double time() const { return trial_time_; }
  double duration() const { return duration_; }  // s, the time of its end
  double began() const { return began_; }        // s, the time of its start: that of the run it begins from
  bool started() const { return started_; }      // whether the state at its start has been computed
  const model::Model& model() const { return *model_; }
  const std::shared_ptr<model::Model>& shared_model() const { return model_; }
  const mechanics::Assembly& assembly() const { return *assembly_; }
  const std::vector<StepReport>& steps() const { return reports_; }
  virtual const char* kind() const = 0;         // "static", "dynamic"
  virtual bool moves() const { return false; }  // whether there are velocities
  // Where in a step its force of contact is that of a load that changes: 1, at its end; 1/2, in its middle.
  virtual double place_of_contact() const { return 1; }
  virtual double tolerance() const { return 0; }  // of a step's residual; 0: not used

  // How far the run has exceeded the tested range of its card; empty: it has not, or the card does not state
  // it.
  std::optional<Beyond> beyond() const {
    return beyond_.strain_ratio > 1 ? std::optional<Beyond>(beyond_) : std::nullopt;
  }
  // Warnings about the results so far; part of the state. The list outlives the run for whoever
  // holds it.
  const std::vector<Warning>& warnings() const { return *warnings_; }
  std::shared_ptr<const std::vector<Warning>> shared_warnings() const { return warnings_; }
  // Says the text, and keeps it as a warning of this kind. element: from 0; -1: no particular one.
  void warn(const char* code, const std::string& text, mesh::Index element = -1);
  // Warnings advise in terms of that field.
  void set_step_field(StepField field) { step_field_ = field; }
  // Keeps it without saying it.
  void note(const char* code, const std::string& text, mesh::Index element = -1);
  Notices& notices() { return *notices_; }
  const std::string& why() const { return why_; }                // the last failure, in lines; empty: none
  void remember_why(std::string why) { why_ = std::move(why); }  // of a failure before a restart

 protected:
  RunState(std::shared_ptr<model::Model> model, double duration, std::shared_ptr<Notices> notices);
  double committed_time() const { return std::as_const(*assembly_).state().time(); }
  bool warned(std::string_view code) const;  // in the present state
  // Advice at the end of a warning: `own` in options of the run; a step (s) that would do, 0: none, where
  // these cannot be given.
  std::string advice(const std::string& own, double step = 0) const;

  std::shared_ptr<model::Model> model_;
  double duration_;
  std::shared_ptr<Notices> notices_;
  std::unique_ptr<mechanics::Assembly> assembly_;
  std::vector<double> dead_;  // N, 3 per node, dead loads at the trial time
  std::vector<StepReport> reports_;
  std::string why_;
  ExternalWork work_;
  double trial_time_ = 0, initial_energy_ = 0, began_ = 0;
  bool started_ = false;
  StepField step_field_ = StepField::of_run;
  bool stops_beyond_ = false;  // at the first step that exceeds the tested range
  Beyond beyond_;
  std::shared_ptr<std::vector<Warning>> warnings_ = std::make_shared<std::vector<Warning>>();
};

}  // namespace fabricsh::run
