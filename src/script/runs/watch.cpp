#include "script/runs/watch.hpp"

#include <csignal>

#include "base/number.hpp"
#include "script/runs/replay.hpp"

namespace fabricsh::script {

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
