// Calls of a run on its way and when: hooks, events, means over windows; and the times at which its steps
// have to end for them.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/archive.hpp"

namespace fabricsh::run {

class Run;

using Sampled = std::array<double, 3>;  // a vector, or a number and two zeros

// The values of the last `width` seconds at the ends of the run's own steps, straight between them; but what
// the force of a body has in them, which in implicit motion is that of a place within each step.
class Window {
 public:
  using Value = std::function<Sampled(const Run&)>;
  Window(double width, Value value) : width_(width), value_(std::move(value)) {}
  // N, of supports or of a body on the cloth: what a state keeps of it is enough to go on.
  struct Reaction {
    std::string set;
    std::int64_t body = -1;  // number; -1: of the set
    void keep(Archive& archive) { archive(set, body); }
  };
  Window(double width, const Reaction& of);
  // before: N, the forces of all bodies on the cloth at the sample before, 3 numbers each; empty: none.
  void sample(const Run& run, const std::vector<double>& before);
  bool begun() const { return !points_.empty(); }
  Sampled mean() const;  // over the window, or as much of it as there is

 private:
  friend class Windows;
  struct Point {
    double time = 0;
    Sampled value = {}, begin = {};  // begin: where the step began that the time ends
    void keep(Archive& archive) { archive(time, value[0], value[1], value[2], begin[0], begin[1], begin[2]); }
  };
  double width_;
  Value value_;
  std::vector<Reaction> of_ = {};  // one, or none
  std::vector<Point> points_;      // ascending in time; one at most before the window
};

class Windows {
 public:
  // Of a run that has begun, a window counts from now. One of that name goes on with what it has.
  Window& add(const std::string& name, Window window);
  Window* find(const std::string& name);
  bool empty() const { return all_.empty(); }
  void sample(const Run& run);  // after a step
  void remember_bodies(const Run& run);
  void keep(Archive& archive);

 private:
  std::map<std::string, Window> all_;
  std::map<std::string, std::vector<Window::Point>> kept_;
  std::vector<double> before_;  // N, of the bodies on the cloth at the last sample
};

inline constexpr double same_time = 1e-12;  // relative to the duration: times closer than this are equal
inline constexpr double most_steps = 1e10;  // a run with more steps is refused, because it would not end

class Schedule {
 public:
  Schedule(const Schedule&) = delete;
  Schedule& operator=(const Schedule&) = delete;

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

 protected:
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

  explicit Schedule(Run& run) : run_(run) {}
  ~Schedule() = default;
  void begin_schedule();  // when the state at the start is there, before the run counts as started
  void measure(Event& event);
  void settle();  // at a commit: what the step has crossed, windows, hooks that are due
  void run_pending();
  double landing_after(double now, double limit) const;  // the next kink, hook or limit
  bool is_kink(double time) const;
  // waits: hooks that are pending are still to run, since the call that they were due in has ended.
  void keep_schedule(Archive& archive, bool waits);

  std::function<void()> poll_;
  bool hooked_ = false;  // whether a hook or event has seen a state since this was last reset
  std::vector<double> kinks_;
  Windows windows_;
  std::vector<Event> events_;
  std::vector<Hook> ready_, settled_;
  std::vector<Hook> restored_;

 private:
  struct Timed {
    double interval = 0;  // 0: every step
    Hook hook;
    AfterError after = AfterError::skip;
    std::int64_t count = 0;  // next landing at count * interval
    bool pending = false;
    bool repeats() const { return after == AfterError::repeat && pending; }
  };
  // The state of a hook, with what it is known by in a run with others: it goes to the first hook that is
  // called as often and has no state yet.
  struct TimedState {
    double interval = 0;
    bool is_output = false, repeats = false;
    std::int64_t count = 0;
    bool taken = true;  // by a hook of this run
    void keep(Archive& archive) {
      archive(interval, is_output, repeats, count);
      if (archive.reading()) taken = false;
    }
  };
  struct EventState {
    double last = 0, largest = 0;
    int side = 0;
    void keep(Archive& archive) { archive(last, largest, side); }
  };
  void check_interval(double interval) const;
  std::size_t add(Timed timed);
  void take_up(Timed& timed);  // restores its stored state, or starts it now
  void take_up(Event& event, std::size_t i);

  Run& run_;
  std::vector<Timed> timed_;
  std::vector<TimedState> kept_timed_;  // as last restored, for hooks that are added later
  std::vector<EventState> kept_events_;
};

}  // namespace fabricsh::run
