// A run in time over a compiled model, as driven by a deck: steps, landings, hooks, events, readings and
// snapshots. static.hpp and dynamic.hpp define how a step is made.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/notice.hpp"
#include "mechanics/assembly.hpp"
#include "model/model.hpp"
#include "run/rising.hpp"
#include "run/values.hpp"
#include "run/warnings.hpp"
#include "run/windows.hpp"
#include "run/work.hpp"

namespace fabricsh::mechanics {
class Contacts;
class Release;
class Seams;
class Tears;
}  // namespace fabricsh::mechanics

namespace fabricsh::run {

struct Diagnosis;
class Folds;
class Run;
struct ResultField;

// The state of another run of the same cloth, with which a run begins: where the cloth is, what its law
// remembers, how it moves, and the time. What held it there and does not any more lets go over `release`
// seconds, or at once. The other run is read while the new one is made.
struct Beginning {
  const Run* from = nullptr;
  double release = 0;  // s
};

// Where cloth is strained beyond what its card was tested to: tells once, or stops the run on the strain.
enum class Limit { tell, stop };

inline constexpr double same_time = 1e-12;  // relative to the duration: times closer than this are equal
inline constexpr double most_steps = 1e10;  // a run with more steps is refused, because it would not end

class Run {
 public:
  virtual ~Run();
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  // Runs to the duration, or until a hook stops it.
  void solve() { advance(std::max(duration_, time())); }
  void advance(double time);             // a step ends at this time. NumericalFailure when stuck
  void step();                           // one committed step (not beyond the duration)
  void stop(const std::string& reason);  // from a hook or event: the run ends after the current step's hooks
  bool stopped() const { return stopped_; }  // until the next solve, advance or step
  const std::string& stop_reason() const { return stop_reason_; }

  // Adds a function that is called after each committed step (along an arc time may have decreased), or at
  // intervals of `every` seconds, where steps then end; and also at the start (time 0), before the first
  // step. Hooks run in the order in which they were added. If one throws, the later ones of that step run
  // when the run continues; the one that threw is called again only with AfterError::repeat (used by outputs,
  // so that no row is lost).
  using Hook = std::function<void(Run&)>;
  enum class AfterError { skip, repeat };
  // Returns the hook's number.
  std::size_t every_step(Hook hook, AfterError after = AfterError::skip);
  std::size_t every(double interval, Hook hook, AfterError after = AfterError::skip);  // Error: not positive
  void reschedule(std::size_t hook, double interval);  // from now on; 0: every step
  // Finds the time in a step at which value(a) becomes zero after it was not. The step ends there, with
  // |value| <= tolerance * largest |value| so far, and the hook runs. The earliest event comes first.
  void event(std::function<double(Run&)> value, double tolerance, Hook hook);
  // A mean over a window of time of the run's own steps, by a name; part of the state. Of a run that has
  // begun it counts from now.
  Window& window(const std::string& name, Window made);
  Window* window(const std::string& name) { return windows_.find(name); }
  // Called by each call that drives the run, before its first step, when hooks that were due before it are
  // done.
  void when_ready(Hook hook) { ready_.push_back(std::move(hook)); }
  // Called after each step when everything else is done, so that the state can be saved. May throw.
  void when_settled(Hook hook) { settled_.push_back(std::move(hook)); }
  // Called while a step is solved. If it throws, the step ends and the run stays at the committed state.
  void poll(std::function<void()> look) { poll_ = std::move(look); }
  void on_restore(Hook hook) { restored_.push_back(std::move(hook)); }

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
  // The fields that added terms show, besides those of result_fields().
  const std::vector<std::shared_ptr<const ResultField>>& shown() const { return shown_; }

  double time() const { return trial_time_; }
  double duration() const { return duration_; }  // s, the time of its end
  double began() const { return began_; }        // s, the time of its start: that of the run it begins from
  std::uint64_t origin() const { return origin_; }  // identifies the state it begins from; 0: none
  double released_over() const { return beginning_.release; }
  // N, global: force of the supports on the cloth; zero before the run has begun.
  Vec3 reaction(const std::string& set) const;
  Vec3 reaction_at(mesh::Index node) const;
  // The contacts of the model, and the number of a body in it. Error: there is no contact, or no such body.
  const mechanics::Contacts& contact() const;
  std::size_t body_number(const model::Rigid& body) const;
  NodeValues node(mesh::Index i) const;        // from 0; Error outside
  ElementValues element(mesh::Index i) const;  // from 0; Error outside
  double mean(const std::string& name, const std::string& set = "all") const;
  std::vector<double> field(const std::string& name) const;  // see result_fields.hpp
  // Of the present state, computed once per state. ply: see Model::ply_of; an element without that ply has no
  // numbers (NaN). Without one all plies together, their components in the axes that they have in common,
  // or else in those of the section.
  const std::vector<ElementValues>& elements(const std::string& ply = {}) const;
  EnergyAccount energy() const;
  // How far the run has exceeded the tested range of its card; empty: it has not, or the card does not state
  // it.
  std::optional<Beyond> beyond() const {
    return beyond_.strain_ratio > 1 ? std::optional<Beyond>(beyond_) : std::nullopt;
  }

  // The fraction of the elements that have exceeded it, 0 to 1.
  double elements_beyond() const;
  // Stops the run at the first step that exceeds the tested range.
  void stop_beyond() { stops_beyond_ = true; }
  // What has been said about the results so far; part of the state. The list outlives the run for whoever
  // holds it.
  const std::vector<Warning>& warnings() const { return *warnings_; }
  std::shared_ptr<const std::vector<Warning>> shared_warnings() const { return warnings_; }
  // Each serious warning ends the call that runs into it with a NumericalFailure.
  void be_strict() { strict_ = true; }
  // Says the text, and keeps it as a warning of this kind. element: from 0; -1: no particular one.
  void warn(const char* code, const std::string& text, mesh::Index element = -1);
  // Keeps it without saying it.
  void note(const char* code, const std::string& text, mesh::Index element = -1);

  const model::Model& model() const { return *model_; }
  const std::shared_ptr<model::Model>& shared_model() const { return model_; }
  const mechanics::Assembly& assembly() const { return *assembly_; }
  const std::vector<StepReport>& steps() const { return reports_; }
  const std::string& why() const { return why_; }                // the last failure, in lines; empty: none
  void remember_why(std::string why) { why_ = std::move(why); }  // of a failure before a restart
  Notices& notices() { return *notices_; }
  virtual const char* kind() const = 0;    // "static", "dynamic"
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
  virtual bool moves() const { return false; }    // whether there are velocities
  virtual double tolerance() const { return 0; }  // of a step's residual; 0: not used
  // The largest fraction so far of the kinetic energy that is in scaled rotary inertia.
  virtual double scaled_share() const { return 0; }

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

  // What each contact was taken for; once the kind of run is known.
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
  // Reports once an element that is turned inside out in the committed state, and a fold that the mesh is too
  // coarse for.
  void watch_shape();
  bool warned(std::string_view code) const;  // in the present state
  // Throws the failure and stores the report for why().
  [[noreturn]] void fail(NumericalFailure failure, const std::string& why);
  // For a step that was given up after the last attempt reported. largest: the largest step, s.
  [[noreturn]] void fail(const Diagnosis& step, const StepReport& report, double largest);
  // J, the part of the kinetic energy in rotary inertia beyond that of the thickness; 0 if rotary inertia is
  // not scaled.
  virtual double scaled_kinetic() const { return 0; }
  virtual double driven_kinetic() const { return 0; }  // J, of driven displacements
  virtual double scheme_loss() const { return 0; }     // J, dissipated by the time scheme
  // J: by how much the sum of the energies is below the one that the time scheme conserves; 0: it is that.
  virtual double hidden_energy() const { return 0; }
  // J, the weight of the cloth over its thickness: an energy below which cloth that meets something is at
  // rest. 0 without contact or gravity.
  double energy_of_rest() const;
  // J, of an energy that is made or lost. Where the sum is off by more than a thousandth of `scale`, what
  // only swings between the ends of the steps is left out.
  virtual double imbalance(const EnergyAccount& sum, double scale) const;
  virtual double relaxed() const { return 0; }      // J, taken away by relaxation
  virtual double driven_work() const { return 0; }  // J, external work not contained in work_
  virtual void check() {}                           // after a step and its hooks; may throw
  virtual Vec3 inertia(mesh::Index) const {
    return Vec3::Zero();
  }  // N, to be overcome by the support of a driven node
  virtual Vec3 velocity(mesh::Index) const { return Vec3::Zero(); }  // m/s
  // Archives all state except that of Run itself; quantities derived from it are computed after reading.
  virtual void memory(Archive& archive) = 0;

  // The state between two hooks, for returning to it within the same run and discarding later steps.
  std::string save_state();
  void go_back(const std::string& save_state);

  double next_landing(double limit) const;  // the next kink, hook or limit
  // The same, or earlier: where contact follows the bodies no farther in a step of this length, s.
  double next_landing(double limit, double step);
  double committed_time() const { return std::as_const(*assembly_).state().time(); }
  bool is_kink(double time) const;
  void rollback();  // the trial state

  std::shared_ptr<model::Model> model_;
  double duration_;
  std::shared_ptr<Notices> notices_;
  std::unique_ptr<mechanics::Assembly> assembly_;
  mechanics::Tears* tears_ = nullptr;  // null: no yarns of the model can break
  mechanics::Seams* seams_ = nullptr;  // null: the model has no seams
  std::string seam_name(std::size_t stitch) const;
  std::string caught_text() const;  // of a seam that should be closer by now; empty: none
  std::function<void()> poll_;
  std::vector<double> dead_;  // N, 3 per node, dead loads at the trial time
  std::vector<StepReport> reports_;
  std::string why_;
  ExternalWork work_;
  double trial_time_ = 0, initial_energy_ = 0, began_ = 0;
  bool started() const { return started_; }
  bool hooked_ = false;  // whether a hook or event has seen a state since this was last reset

 private:
  struct Timed {
    double interval = 0;  // 0: every step
    Hook hook;
    AfterError after = AfterError::skip;
    std::int64_t count = 0;  // next landing at count * interval
    bool pending = false;
    bool repeats() const { return after == AfterError::repeat && pending; }
  };
  struct TimedState {  // state of a Timed
    std::int64_t count = 0;
    bool repeats = false;
    void keep(Archive& archive) { archive(count, repeats); }
  };
  struct Event {
    std::function<double(Run&)> value;
    double tolerance = 0;
    Hook hook;
    double last = 0, now = 0, largest = 0;  // at the committed state, the trial state; of committed states
    int side = 0;  // sign of the value when last outside its tolerance of zero; 0: not since the event
    bool pending = false;
    bool near() const { return std::abs(now) <= tolerance * largest; }
    bool crossed() const;  // across zero and outside the tolerance
    void settle();         // to be called at a commit
  };
  struct EventState {
    double last = 0, largest = 0;
    int side = 0;
    void keep(Archive& archive) { archive(last, largest, side); }
  };
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
  Windows windows_;
  void check_interval(double interval) const;
  void start();
  void prepare();  // starts the run, and runs the hooks that are due before the next step
  StepReport make_step(double limit);
  bool finds_step(double limit, StepReport& report);  // false: it is to be tried again
  void advance_to(double limit);                      // one committed step towards the limit
  void watch_folds();
  void watch_compression();  // says once that elements carry what would fold their cloth (compression.cpp)
  void refuse_serious();     // throws if strict and a serious warning has not been thrown yet
  void watch_strain();       // of the committed state: reports once a strain beyond the tested range
  void measure(Event& event);
  double land(double size, StepReport& report);  // shortens the step to the first event in it
  double search(Event& event, double size, StepReport& report);
  double land_at_limit(double size, StepReport& report);  // of the tested range, with stop_beyond
  double land_at_break(double size, StepReport& report);  // of the next yarn or stitch, in steps that iterate
  void mark_due();
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
  void keep_hooks(Archive& archive);
  void take_up(Timed& timed, std::size_t i);  // restores the stored state of the i-th, or starts it now
  void take_up(Event& event, std::size_t i);
  void run_pending();

  void check_beginning(const char* kind) const;  // Error: see the constructor
  bool same_contact() const;
  void release(const Run& from);
  Beginning beginning_;
  mechanics::Release* release_ = nullptr;  // null: nothing lets go gradually
  mechanics::NodalRates left_rates_;
  std::uint64_t origin_ = 0;
  bool let_go_ = false;

  std::vector<std::shared_ptr<const ResultField>> shown_;
  std::vector<Timed> timed_;
  std::vector<Event> events_;
  std::vector<TimedState> kept_timed_;  // as last restored, for hooks that are added later
  std::vector<EventState> kept_events_;
  std::vector<Hook> ready_, settled_;
  std::vector<Hook> restored_;
  std::vector<double> kinks_;
  RisingAccounts accounts_;
  std::unique_ptr<const Folds> folds_;  // once they have been looked for
  bool started_ = false, stopped_ = false, busy_ = false, stepping_ = false;
  std::string stop_reason_;
  Beyond beyond_;
  std::shared_ptr<std::vector<Warning>> warnings_ = std::make_shared<std::vector<Warning>>();
  std::uint64_t thrown_ = 0;  // number of warnings up to the last one that was thrown
  bool stops_beyond_ = false, strict_ = false;
  bool warned_beyond_ = false,
       warned_idle_ = false;  // said by this object, whatever state it has returned to
  struct Averages {
    std::uint64_t version = 0;
    std::vector<ElementValues> values;
  };
  ElementValues average(mesh::Index element, int ply) const;
  mutable std::map<std::string, Averages> averages_;  // by ply
};

}  // namespace fabricsh::run
