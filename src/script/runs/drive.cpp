#include "script/runs/drive.hpp"

#include <algorithm>
#include <csignal>

#include "base/number.hpp"
#include "script/call/words.hpp"
#include "script/session/at_work.hpp"
#include "script/values/lua_table.hpp"

namespace fabricsh::script {

namespace {

// While a call of a run is under way, Ctrl-C is for it.
class Driving {
 public:
  explicit Driving(Session& session) : session_(session) { session_.count_drive(1); }
  ~Driving() { session_.count_drive(-1); }
  Driving(const Driving&) = delete;
  Driving& operator=(const Driving&) = delete;

 private:
  Session& session_;
  RunAtWork at_work_;
};

// Runs several functions even if some throw, and throws the first exception at the end.
class All {
 public:
  explicit All(Session& session) : session_(session) {}
  template <class Work>
  void run(const Work& work) {
    try {
      in_protected_call(session_, work);
    } catch (const std::exception&) {
      if (!first_) first_ = std::current_exception();
    }
  }
  void finish() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  Session& session_;
  std::exception_ptr first_;
};

void leave(DeckRun& run, const run::Ending& ending) {
  All all(run.session);
  run.job.leave(ending, [&all](const std::function<void()>& work) { all.run(work); });
  if (!ending.broken) return all.finish();
  for (const auto& output : run.job.outputs())
    if (output->series->failed())
      run.analysis->warn("lost", "'" + output->file + "' lacks a row or frame: solve() tries it again; a:" +
                                     output->kind + " of the same path puts a new one in its place");
}

// The value raised by a hook, on top of the stack, packed if it is plain; else empty.
std::string plain_error(lua_State* L) {
  const int top = lua_gettop(L);
  if (top == 0 || lua_checkstack(L, 10) == 0) return {};
  std::string bytes;
  try {
    lua_newtable(L);
    lua_pushvalue(L, top);
    lua_rawseti(L, -2, 1);
    bytes = pack_table(L, -1, "error");
  } catch (...) {  // it cannot be stored: only the message is kept
  }
  lua_settop(L, top);
  return bytes;
}

[[noreturn]] void raise(lua_State* L, const std::string& value) {
  lua_newtable(L);
  fill_table(L, -1, value);
  lua_rawgeti(L, -1, 1);
  lua_error(L);
  throw Error("an error in a hook");  // not reached
}

}  // namespace

void note_failure(DeckRun& run, const std::exception& error) {
  FailedCall failed;
  failed.call = run.calls.count;
  failed.message = error.what();
  if (const auto* numerical = dynamic_cast<const NumericalFailure*>(&error)) {
    failed.numerical = true;
    failed.time = numerical->time;
    failed.element = numerical->element;
    failed.yarn = numerical->yarn;
    failed.why = numerical->why;
  }
  run.calls.failed.push_back(failed);
}

namespace {

// Whether the call was made before the checkpoint of a restarted run. If it was, its effects on the deck are
// repeated.
bool passes_over(DeckRun& run) {
  if (!run.passes_over()) return false;
  repeat_tables(run);
  for (const FailedCall& failed : run.calls.failed) {
    if (failed.call != run.calls.count) continue;
    if (!failed.value.empty()) raise(run.session.active(), failed.value);
    if (!failed.numerical) throw Error(failed.message);
    NumericalFailure again(failed.message, failed.time, failed.element, failed.yarn);
    again.why = failed.why;
    throw NumericalFailure(again);
  }
  return true;
}

// A hook of the run may read and stop it, but not drive it.
void refuse_in_hook(const DeckRun& run) {
  if (run.job.driving()) throw Error("not from a hook of the same run");
}

// Whether it is the call in which the checkpoint of a restarted run was written.
bool is_under_way(const DeckRun& run) { return run.passing > 0 && run.calls.count == run.passing; }

// Starts from the checkpoint if there is one; counts the call.
void begin_call(DeckRun& run, const Drive& call) {
  if (run.job.from() && !run.job.taken_up()) {
    take_up(run);
    run.passing = run.before.count;
  }
  if (!run.lost.empty()) throw Error(run.lost);
  ++run.calls.count;
  run.calls.changes = 0;
  check_call(run, call);
  if (run.passes_over() || (is_under_way(run) && run.same_deck)) return;
  run.calls.made.resize(static_cast<std::size_t>(run.calls.count));
  run.calls.made.back() = call;
  run.calls.made.back().from = run.analysis->steps().size();
}

// Whether the call in which the checkpoint was written is complete: a hook stopped it, or its step is done.
bool is_over(const DeckRun& run) {
  const Drive& call = run.before.made.back();
  return run.analysis->stopped() || (call.made == CallKind::step && run.analysis->steps().size() > call.from);
}

void work(DeckRun& run) {
  const Drive& call = run.calls.made.back();
  if (call.made == CallKind::step)
    run.analysis->step();
  else
    run.analysis->advance(call.target);
}

}  // namespace

void drive(DeckRun& run, const Drive& call) {
  if (run.session.options().check) return;
  refuse_in_hook(run);
  const ChangeRefused still(run.session, &run);
  begin_call(run, call);
  if (passes_over(run)) return;
  if (run.session.terminated() != 0) throw Interrupted(ended_by(run.session));
  if (run.session.is_called_off()) throw Interrupted("interrupted before this run continued");
  const bool over = is_under_way(run) && is_over(run);
  if (is_under_way(run))
    restore_tables(run);
  else
    run.job.journal().finished.erase(run.number());
  run.job.begin();
  std::erase_if(run.calls.failed, [&](const FailedCall& failed) { return failed.call == run.calls.count; });
  begin_tables(run);
  const Driving driving(run.session);
  try {
    if (!over) Collector::with_room(run.session.active(), [&run] { work(run); });
  } catch (const Interrupted&) {
    release_tables(run);
    leave(run, {"interrupted", true, true});
    throw;
  } catch (const std::exception& error) {
    note_failure(run, error);
    note_tables(run);
    leave(run, {error.what(), true, true});
    if (dynamic_cast<const NumericalFailure*>(&error) != nullptr) run.job.remember_end();
    throw;
  } catch (...) {  // a Lua error in a hook; its message remains where Lua has it
    note_failure(run, Error("an error in a hook"));
    run.calls.failed.back().value = plain_error(run.session.active());
    note_tables(run);
    leave(run, {"an error in a hook", false, true});
    throw;
  }
  note_tables(run);
  const run::Ending ending = run.job.ending();
  leave(run, ending);
  if (ending.ended) run.job.remember_end();
}

void go_back(DeckRun& run, const std::shared_ptr<const run::Run::Snapshot>& snapshot) {
  refuse_in_hook(run);
  const ChangeRefused still(run.session, &run);
  forget_steps(run);
  begin_call(run, {CallKind::restore});
  if (passes_over(run)) return;
  if (is_under_way(run)) return restore_tables(run);
  const auto& gone = run.passed_snapshots;
  if (std::find(gone.begin(), gone.end(), snapshot) != gone.end())
    throw Error("this snapshot was taken in a part of the run that the restart skips");
  run.job.journal().finished.erase(run.number());
  run.analysis->restore(*snapshot);
}

std::string ended_by(const Session& session) {
  return session.terminated() == SIGHUP ? "ended by SIGHUP" : "ended by SIGTERM";
}

namespace {

class Watch final : public run::Listener {
 public:
  explicit Watch(DeckRun& run) : run_(run) {}
  ListenerOrder turn() const override { return ListenerOrder::watch; }
  void begin(run::Job& job) override {
    from_ = job.run().time();
    next_ = 0;
    clock_ = {};
    job.run().poll([this] { stop_if_interrupted(); });
    hold_tables(run_);
  }
  void ready(run::Job&) override { hold_tables(run_); }  // as the hooks of the start have left them
  void step(run::Job& job) override {
    report(job);
    hold_tables(run_);
    stop_if_interrupted();
  }
  void end(run::Job& job, const run::Ending&) override {
    job.run().poll({});
    if (run_.session.options().clear_progress) run_.session.options().clear_progress();
  }

 private:
  void stop_if_interrupted() const {
    Session& session = run_.session;
    if (!session.take_interrupt()) return;
    session.rest_hook(session.active());
    session.call_off();
    const run::Run& a = *run_.analysis;
    throw Interrupted((session.terminated() != 0 ? ended_by(session) + " at " : "interrupted at ") +
                      fabricsh::number(a.steps().empty() ? a.time() : a.steps().back().time, 7) +
                      " s; the run is kept, solve() continues it");
  }

  void report(const run::Job& job) {
    const auto& options = run_.session.options();
    const double now = clock_.seconds();
    if (!options.progress || now < next_) return;
    next_ = now + 0.1;
    const run::Run& a = job.run();
    RunProgress p;
    p.run = job.number();
    p.time = a.time();
    p.duration = a.duration();
    p.steps = a.steps().size();
    p.iterations = a.steps().empty() ? 0 : a.steps().back().iterations;
    p.elapsed = job.seconds();
    const double done = a.time() - from_, left = run_.calls.made.back().target - a.time();
    if (done > 0) p.remaining = now * std::max(0.0, left) / done;
    p.ledger_error = [&a] { return a.energy().error; };
    options.progress(p);
  }

  DeckRun& run_;
  double from_ = 0, next_ = 0;  // s, simulated and real
  run::Clock clock_;
};

}  // namespace

std::shared_ptr<run::Listener> make_watch(DeckRun& run) { return std::make_shared<Watch>(run); }

}  // namespace fabricsh::script
