// What a deck drives: a run in time over a compiled model. Steps, landings, hooks, events, readings and
// snapshots are here; static.hpp and dynamic.hpp say how a step is made.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/notice.hpp"
#include "mechanics/assembly.hpp"
#include "model/model.hpp"
#include "run/values.hpp"
#include "run/work.hpp"

namespace fabricsh::run {

inline constexpr double same_time = 1e-12;  // of the duration: two times this close are one
inline constexpr double most_steps = 1e10;  // a run of more would not end: it is refused before it begins

class Run {
 public:
  virtual ~Run();
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  // Runs to the duration, or to where a hook stopped it.
  void solve() { advance(std::max(duration_, time())); }
  void advance(double time);             // to the absolute time, landing on it. NumericalFailure when stuck
  void step();                           // one committed step (clipped at the duration)
  void stop(const std::string& reason);  // from a hook or event: the run ends after the current step's hooks
  bool stopped() const { return stopped_; }  // until solve, advance or step goes on
  const std::string& stop_reason() const { return stop_reason_; }

  // Called after each committed step (along an arc, time may have gone down), or whenever `every` seconds
  // have passed (the run lands on those times); also at the start (time 0), before the first step. Hooks run
  // in the order in which they were added. Where one throws, the later ones of the step run first when the
  // run goes on; the one that threw is called again only where it asks for that (an output does, so that no
  // row is lost).
  using Hook = std::function<void(Run&)>;
  enum class AfterError { skip, repeat };
  // Returns the hook's number.
  std::size_t every_step(Hook hook, AfterError after = AfterError::skip);
  std::size_t every(double interval, Hook hook, AfterError after = AfterError::skip);  // Error: not positive
  void reschedule(std::size_t hook, double interval);  // from here on; 0: every step
  // Finds, inside the step, where value(a) comes to zero after it was not: lands there within |value| <=
  // tolerance * largest |value| so far, commits, and runs the hook. Of several, the earliest.
  void event(std::function<double(Run&)> value, double tolerance, Hook hook);
  // After each step, when all that belongs to it is done: the state is one to be kept. May throw.
  void when_settled(Hook hook) { settled_.push_back(std::move(hook)); }
  void monitor(Hook hook) { monitor_ = std::move(hook); }  // the last of these
  // Looked in at while a step is solved; what it throws ends the step, the run stays where it was.
  void poll(std::function<void()> look) { poll_ = std::move(look); }
  void on_restore(Hook hook) { restored_.push_back(std::move(hook)); }

  // A further term of the compiled model, before the run begins; it is kept with the run's state, so that a
  // run that takes the state up must be given the same. Errors: the run has begun; a tangent that is not
  // symmetric.
  void add(std::unique_ptr<mechanics::Term> term);

  double time() const { return trial_time_; }
  double duration() const { return duration_; }
  // N, global: the force the supports exert on the cloth; zero before the run has begun.
  Vec3 reaction(const std::string& set) const;
  // What touches. Error: the model has no contact; the body is none of it.
  const mechanics::Contacts& contact() const;
  std::size_t body_number(const model::Rigid& body) const;
  NodeValues node(mesh::Index i) const;        // from 0; Error outside
  ElementValues element(mesh::Index i) const;  // from 0; Error outside
  double mean(const std::string& name, const std::string& set = "all") const;
  std::vector<double> field(const std::string& name) const;  // see result_fields.hpp
  const std::vector<ElementValues>& elements() const;        // of the current state, computed once per state
  Energy energy() const;
  // How far the run has gone beyond what its card was tested to; nothing: it has not, or the card does not
  // say.
  std::optional<Beyond> beyond() const {
    return beyond_.share > 1 ? std::optional<Beyond>(beyond_) : std::nullopt;
  }

  // The part of the elements that have gone beyond it, 0 to 1.
  double elements_beyond() const;
  // Stops the run at the step that takes it beyond for the first time.
  void stop_beyond() { stops_beyond_ = true; }

  const model::Model& model() const { return *model_; }
  const mechanics::Assembly& assembly() const { return *assembly_; }
  const std::vector<StepReport>& steps() const { return reports_; }
  const std::string& why() const { return why_; }  // the last failure, in lines; empty: none
  Notices& notices() { return *notices_; }
  virtual const char* kind() const = 0;    // "static", "dynamic"
  virtual std::string method() const = 0;  // all options that a state hangs on, as text
  // The linear algebra's kernels, on which the bits of a solve hang; empty: this kind of run solves nothing.
  virtual std::string kernels() const { return {}; }
  // What may change while a run is under way. Errors: out of range, or not of this kind of run.
  struct Settings {
    std::optional<double> tolerance = {}, step = {};
    std::optional<int> max_iterations = {}, max_cuts = {};
  };
  virtual void set(const Settings& settings) = 0;
  // The settings with those that the run was made with: read by a run that was made with others, those of
  // its own stay.
  virtual void keep_settings(Archive& archive) = 0;
  virtual bool moves() const { return false; }    // are there velocities
  virtual double tolerance() const { return 0; }  // of a step's residual; 0: steps have none
  // The largest share so far of the kinetic energy in rotary inertia that is scaled up.
  virtual double scaled_share() const { return 0; }

  // A copy of the whole state; restore goes back to it and continues bit for bit. Errors: a snapshot of
  // another analysis; restore from a hook.
  struct Snapshot;
  std::shared_ptr<const Snapshot> snapshot();
  void restore(const Snapshot& snapshot);
  // The same as bytes, for a run of the same model and options in another process. resume() takes them up as
  // restore() does, but for on_restore; hooks and events added later have their state in them too. Error:
  // they are of another model or damaged; the run is then as it was.
  std::string kept();
  void resume(const std::string& kept);

 protected:
  // Compiles and seals the model. Errors: duration not positive; model.validate().
  Run(std::shared_ptr<model::Model> model, double duration, std::shared_ptr<Notices> notices,
      const char* kind);

  // --- what a kind of run does. A step's size: the time at its end; along an arc its length.
  virtual void begin() = 0;  // the state at time 0, before its hooks; calls work_.start
  // Solves a step towards the limit, cut where that is needed, and leaves it as trial state: its size.
  // NumericalFailure when stuck.
  virtual double try_step(double limit, StepReport& report) = 0;
  virtual bool attempt(double size, StepReport& report) = 0;  // one try of that size from the committed state
  virtual double largest_step() const = 0;                    // s
  virtual double no_size() const = 0;                         // of a step that goes nowhere
  virtual double tried_size(double size) const { return size; }  // what the last attempt made of it
  virtual void commit(StepReport& report) = 0;                   // the trial state; adds the external work
  [[noreturn]] virtual void give_up(const StepReport& report) = 0;
  // Throws it, with the report for why().
  [[noreturn]] void fail(NumericalFailure failure, const std::string& why);
  virtual double scaled_kinetic() const {
    return 0;
  }  // J, of the kinetic energy, in rotary inertia that is scaled up
  virtual double driven_kinetic() const { return 0; }  // J, of displacements that are driven
  virtual double scheme_loss() const { return 0; }     // J, lost to a time scheme that damps
  virtual double driven_work() const { return 0; }     // J, external work beyond work_
  virtual void check() {}                              // after a step and its hooks; may throw
  virtual Vec3 inertia(mesh::Index) const {
    return Vec3::Zero();
  }  // N, that a driven node's support overcomes
  virtual Vec3 velocity(mesh::Index) const { return Vec3::Zero(); }  // m/s
  // All that changes as the run goes, but what Run has; what hangs on it is worked out after reading.
  virtual void memory(Archive& archive) = 0;

  // The state between two hooks, to go back to within the same run: steps since are taken back.
  std::string mark();
  void go_back(const std::string& mark);

  double next_landing(double limit) const;  // the next kink, hook or limit
  double committed_time() const { return std::as_const(*assembly_).state().time(); }
  bool is_kink(double time) const;
  void rollback();  // the trial state

  std::shared_ptr<model::Model> model_;
  double duration_;
  std::shared_ptr<Notices> notices_;
  std::unique_ptr<mechanics::Assembly> assembly_;
  std::function<void()> poll_;
  std::vector<double> dead_;  // N, 3 per node, dead loads at the trial time
  std::vector<StepReport> reports_;
  std::string why_;
  ExternalWork work_;
  double trial_time_ = 0, initial_energy_ = 0;
  bool hooked_ = false;  // has a hook or event seen a state since a kind of run took that back

 private:
  struct Timed {
    double interval = 0;  // 0: every step
    Hook hook;
    AfterError after = AfterError::skip;
    std::int64_t count = 0;  // next landing at count * interval
    bool pending = false;
    bool repeats() const { return after == AfterError::repeat && pending; }
  };
  struct TimedState {  // of a Timed
    std::int64_t count = 0;
    bool repeats = false;
    void keep(Archive& archive) { archive(count, repeats); }
  };
  struct Event {
    std::function<double(Run&)> value;
    double tolerance = 0;
    Hook hook;
    double last = 0, now = 0, largest = 0;  // at the committed and at the trial state; of committed ones
    int side = 0;  // sign of the value when it was last outside its tolerance of zero; 0: not since it fired
    bool pending = false;
    bool near() const { return std::abs(now) <= tolerance * largest; }
    bool crossed() const;  // beyond zero and its tolerance
    void settle();         // the trial state is committed
  };
  struct EventState {
    double last = 0, largest = 0;
    int side = 0;
    void keep(Archive& archive) { archive(last, largest, side); }
  };
  // While a run is under way, its hooks may read it and stop it, not drive it.
  class Busy {
   public:
    Busy(Run& run, const char* call);  // Error: a hook of this run makes the call
    ~Busy() { run_.busy_ = false; }
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;

   private:
    Run& run_;
  };
  void check_interval(double interval) const;
  void start();
  void advance_to(double limit);  // one committed step towards the limit
  void watch_strain();            // of the committed state: the farthest beyond what was tested, said once
  void measure(Event& event);
  double land(double size, StepReport& report);  // shortens the attempt to the first event inside it
  double search(Event& event, double size, StepReport& report);
  void mark_due();
  void keep(Archive& archive);
  void keep_motion(Archive& archive);
  void keep_hooks(Archive& archive);
  void take_up(Timed& timed, std::size_t i);  // the state that was kept of the i-th, or as from here
  void take_up(Event& event, std::size_t i);
  void run_pending();

  std::vector<Timed> timed_;
  std::vector<Event> events_;
  std::vector<TimedState> kept_timed_;  // as last restored: hooks may be added only after that
  std::vector<EventState> kept_events_;
  std::vector<Hook> settled_;
  Hook monitor_;
  std::vector<Hook> restored_;
  std::vector<double> kinks_;
  bool started_ = false, stopped_ = false, busy_ = false;
  std::string stop_reason_;
  Beyond beyond_;
  bool told_beyond_ = false, stops_beyond_ = false;
  mutable std::vector<ElementValues> cache_;
  mutable std::uint64_t cache_version_ = 0;
};

}  // namespace fabricsh::run
