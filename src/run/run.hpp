// A run in time over a compiled model, as driven by a deck: its steps and snapshots. Its readings
// are in readings.hpp, its calls on the way in schedule.hpp; static.hpp and dynamic.hpp define how a step
// is made.
#pragma once
#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "run/readings.hpp"
#include "run/rising.hpp"
#include "run/schedule.hpp"

namespace fabricsh::mechanics {
class Release;
class Seams;
class Tears;
}  // namespace fabricsh::mechanics

namespace fabricsh::run {

struct Diagnosis;
class Folds;

// The state of another run of the same cloth, with which a run begins: where the cloth is, what its law
// remembers, how it moves, and the time. Forces that held it there and act no more fade over `release`
// seconds, or vanish at once. The other run is read while the new one is made.
struct Beginning {
  const Run* from = nullptr;
  double release = 0;  // s
};

// Where cloth is strained beyond what its card was tested to: tells once, or stops the run on the strain.
enum class Limit { tell, stop };

class Run : public Readings, public Schedule {
 public:
  ~Run() override;

  // Runs to the duration, or until a hook stops it.
  void solve() { advance(std::max(duration_, time())); }
  void advance(double time);             // a step ends at this time. NumericalFailure when stuck
  void step();                           // one committed step (not beyond the duration)
  void stop(const std::string& reason);  // from a hook or event: the run ends after the current step's hooks
  bool stopped() const { return stopped_; }  // until the next solve, advance or step
  const std::string& stop_reason() const { return stop_reason_; }

  // Where joints of tearable zones open or close: along the edges between nodes of a set, or along the edges
  // that lie on a line of points in the reference, m.
  struct Along {
    std::string set;
    std::vector<Vec3> line;  // not used if a set is given
  };
  // Opens them, between two steps: from a hook or event, or before or after a call that drives the run.
  // Returns how many joints there are more than before. Errors: within a step; the model has no zone; no edge
  // of a zone is there.
  std::size_t cut(const Along& along);
  // Closes them. The nodes of a joint must be no farther apart than `within`, m; by default a millionth of
  // the elements' mean edge. They take the mean of their places and velocities, weighted by their masses; the
  // kinetic energy that is lost is dissipated, and what moving them to their mean stores is external work.
  std::size_t join(const Along& along, std::optional<double> within = {});

  // Adds a term to the compiled model, before the run begins. Its state is stored with that of the run, so a
  // run that restores the state must have the same term. Errors: the run has begun; the tangent is not
  // symmetric, and the run's linear solver needs that; it shows a field whose name is taken.
  void add(std::unique_ptr<mechanics::Term> term);
  std::uint64_t origin() const { return origin_; }  // identifies the state it begins from; 0: none
  double released_over() const { return beginning_.release; }
  // Stops the run at the first step that exceeds the tested range.
  void stop_beyond() { stops_beyond_ = true; }
  // Each serious warning ends the call that runs into it with a NumericalFailure.
  void be_strict() { strict_ = true; }
  virtual std::string method() const = 0;  // all options on which the state depends, as text
  // Kernels of the linear algebra, on which the rounding of a solution depends; empty: nothing is solved.
  virtual std::string kernels() const { return {}; }
  // Options that may change during a run, by name: the rows of static_options() and dynamic_options() that
  // have a place. Errors: unknown, out of range, or not valid for this kind of run.
  struct Setting {
    std::string name;
    double value = 0;
  };
  using Settings = std::vector<Setting>;
  virtual void set(const Settings& settings) = 0;
  // Stores the present settings and those at the creation of the run. When reading, a setting is restored
  // only if this run was created with the same value.
  virtual void keep_settings(Archive& archive) = 0;
  // A copy of the whole state. restore() returns to it and continues bit for bit. Errors: a snapshot
  // of another run; restore called by a hook.
  struct Snapshot;
  std::shared_ptr<const Snapshot> snapshot();
  void restore(const Snapshot& snapshot);
  // The same as bytes, for a run of the same model and options in another process. resume() restores them as
  // restore() does, but does not call on_restore hooks; the state also contains that of hooks and events to
  // be added later. Error: bytes of another model, or damaged; the run is then unchanged.
  std::string kept();
  void resume(const std::string& kept);

 protected:
  // Compiles and seals the model. duration: s, of this run. Errors: duration not positive; model.validate();
  // other cloth than that of the run it begins from.
  Run(std::shared_ptr<model::Model> model, double duration, std::shared_ptr<Notices> notices,
      const char* kind, const Beginning& beginning = {});
  // Takes the state of the run it begins from, if there is one; when all terms are there.
  void take_beginning();
  void take_rest_shape();
  const mechanics::NodalRates& left_rates() const { return left_rates_; }  // empty: none
  // Of the committed state, also of directors; null: there are none.
  virtual const mechanics::NodalRates* nodal_rates() const { return nullptr; }
  // Whether something that held the cloth in that state does not any more.
  bool is_let_go() const { return let_go_; }
  // "the motion of node 3 begins 0.1 m from"; empty: motions go on from where the nodes are.
  std::string jump_of_motions() const;

  // Reports the kind that each contact was taken for, once the kind of run is known.
  void report_contacts();

  // True if no solver requires symmetric tangents: none is used, or one for unsymmetric matrices.
  virtual bool takes_unsymmetric() const = 0;

  // --- joints. The rates of the unknowns in the committed state; empty: there are none.
  virtual std::vector<double> unknown_rates() const { return {}; }
  // The numbers of unknowns have changed: makes what has one entry for each of them anew.
  virtual void resize() {}
  // Afterwards: continues from the committed state with these rates of the unknowns.
  virtual void take(const mechanics::Transfer& change, const std::vector<double>& rates) = 0;
  // s, with which cohesive springs of a tear must be stable; 0: steps are not explicit.
  virtual double tear_step() const { return 0; }

  // --- to be defined by a kind of run. A step's size is the time at its end; along an arc, its length.
  virtual void begin() = 0;  // the state at time 0, before its hooks; calls work_.start
  // Solves a step towards the limit, cutting it where necessary, and leaves it as the trial state. Returns
  // its size. NumericalFailure if no step is possible.
  virtual double try_step(double limit, StepReport& report) = 0;
  virtual bool attempt(double size, StepReport& report) = 0;     // one attempt from the committed state
  virtual double largest_step() const = 0;                       // s
  virtual double no_size() const = 0;                            // size of a step of zero length
  virtual double tried_size(double size) const { return size; }  // the size of the last attempt
  virtual void commit(StepReport& report) = 0;                   // commits the trial state; adds the work
  // Whether the step just committed is taken back to be repeated in another way; nothing else has seen it.
  virtual bool takes_back() { return false; }
  // The step has ended by an exception, in try_step() or where it was shortened to an event, and leaves no
  // trace. failed: by a NumericalFailure. Returns whether it is tried once more, in another way.
  virtual bool tries_again(bool /*failed*/) { return false; }
  [[noreturn]] virtual void give_up(const StepReport& report) = 0;
  // Ends the run if an account of energy that can only rise has fallen by more than rounding. scale: J, the
  // largest energies of the run; of_scheme: the share of it by which the loss to the time scheme may swing.
  void watch_accounts(const EnergyAccount& energies, double scale, double of_scheme = 0);
  // Reports once, at the end of a run, that the guard of the directors stores more than 1 % of the energy.
  void watch_guard(const EnergyAccount& energies);
  // Likewise that contact does, whose stiffness was assumed.
  void watch_pressed(const EnergyAccount& energies);
  void watch_crossings();
  void watch_barrier(const EnergyAccount& energies);
  // Reports once an element that is turned inside out in the committed state, and a fold that the mesh is too
  // coarse for.
  void watch_shape();
  // Throws the failure and stores the report for why().
  [[noreturn]] void fail(NumericalFailure failure, const std::string& why);
  // For a step that was given up after the last attempt reported. largest: the largest step, s.
  [[noreturn]] void fail(const Diagnosis& step, const StepReport& report, double largest);
  virtual void check() {}  // after a step and its hooks; may throw
  // Archives all state except that of Run itself; quantities derived from it are computed after reading.
  virtual void memory(Archive& archive) = 0;

  // The state between two hooks, for returning to it within the same run and discarding later steps.
  std::string save_state();
  void go_back(const std::string& save_state);

  double next_landing(double limit) const { return landing_after(committed_time(), limit); }
  // The same, or earlier: where contact follows the bodies no farther in a step of this length, s, or nodes
  // have turned by a quarter of a circle.
  double next_landing(double limit, double step);
  void rollback();  // the trial state

  mechanics::Tears* tears_ = nullptr;  // null: no yarns of the model can break
  mechanics::Seams* seams_ = nullptr;  // null: the model has no seams
  std::string seam_name(std::size_t stitch) const;
  std::string caught_text() const;  // of a seam that should be closer by now; empty: none

 private:
  // While a run is being driven, its hooks may read and stop it, but not drive it.
  class Busy {
   public:
    Busy(Run& run, const char* call);  // Error: `call` was made by a hook of this run
    ~Busy() { run_.busy_ = false; }
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;

   private:
    Run& run_;
  };
  void start();
  void prepare();  // starts the run, and runs the hooks that are due before the next step
  StepReport make_step(double limit);
  bool finds_step(double limit, StepReport& report);  // false: it is to be tried again
  void advance_to(double limit);                      // one committed step towards the limit
  void watch_folds();
  void watch_compression();  // says once that elements carry what would fold their cloth (compression.cpp)
  void refuse_serious();     // throws if strict and a serious warning has not been thrown yet
  void watch_strain();       // of the committed state: reports once a strain beyond the tested range
  double land(double size, StepReport& report);  // shortens the step to the first event in it
  double search(Event& event, double size, StepReport& report);
  double land_at_limit(double size, StepReport& report);  // of the tested range, with stop_beyond
  double land_at_break(double size, StepReport& report);  // of the next yarn or stitch, in steps that iterate
  std::vector<mechanics::Joints::Edge> edges_along(const Along& along, const char* call, bool sewn) const;
  void rejoin(std::vector<mechanics::Joints::Edge> edges, double within);
  void resew(mechanics::Sewn next, double within);
  // Changes the joints by a function that returns what becomes of the unknowns, or nothing.
  void change(const std::function<std::optional<mechanics::Transfer>()>& made);
  std::vector<std::size_t> stitches_along(const Along& along) const;
  void burst();           // opens the stitches that have reached their strength in the committed state
  void sew();             // closes the seams whose edges have been drawn together
  void tear();            // opens the joints whose yarns have reached their strength in the committed state
  void refuse_runaway();  // throws where a yarn or stitch is beyond its strength in the trial state
  void keep_assembly(Archive& archive);
  void keep(Archive& archive);
  void keep_motion(Archive& archive);

  void check_beginning(const char* kind) const;  // Error: see the constructor
  bool same_contact() const;
  void release(const Run& from);
  Beginning beginning_;
  mechanics::Release* release_ = nullptr;  // null: nothing lets go gradually
  mechanics::NodalRates left_rates_;
  std::uint64_t origin_ = 0;
  bool let_go_ = false;

  RisingAccounts accounts_;
  std::unique_ptr<const Folds> folds_;  // once they have been looked for
  bool stopped_ = false, busy_ = false, stepping_ = false;
  std::string stop_reason_;
  std::uint64_t thrown_ = 0;  // number of warnings up to the last one that was thrown
  bool strict_ = false;
  bool warned_beyond_ = false,
       warned_idle_ = false;  // said by this object, whatever state it has returned to
};

}  // namespace fabricsh::run
