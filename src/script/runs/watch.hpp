// Progress of a run, and Ctrl-C, while it is driven.
#pragma once
#include "script/runs/run.hpp"

namespace fabricsh::script {

// Ctrl-C or SIGTERM stopped the run at its last committed step.
class Interrupted : public Error {
 public:
  using Error::Error;
};

// "ended by SIGTERM": the signal that ends the program.
std::string ended_by(const Session& session);

// Reports progress after steps, several times a second, and ends the call after Ctrl-C.
class Watch final : public run::Listener {
 public:
  explicit Watch(Run& run) : run_(run) {}
  Turn turn() const override { return Turn::watch; }
  void begin(run::Job& job) override;
  void step(run::Job& job) override;
  void end(run::Job& job, const run::Ending& ending) override;

 private:
  void stop_if_interrupted() const;
  void report(const run::Job& job);
  Run& run_;
  double from_ = 0, next_ = 0;  // s, simulated and real
  run::Clock clock_;
};

}  // namespace fabricsh::script
