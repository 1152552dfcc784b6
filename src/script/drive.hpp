// Driving a run from Lua: what belongs to a call of solve(), advance() or step() besides the steps.
#pragma once
#include "script/bind/run.hpp"

namespace fabricsh::script {

// Ctrl-C or SIGTERM stopped the run at its last committed step.
class Interrupted : public Error {
 public:
  using Error::Error;
};

// Does what the call asks for; keeps the time, reports progress, hears Ctrl-C. Where the run ends or fails,
// the outputs and checkpoints get its last state; run.json says how far it came. In a restarted deck the
// calls that lie before the checkpoint do nothing (one that failed fails again), and the one that was under
// way goes on.
void drive(Run& run, Drive call);

// restore(), which a restarted deck passes over likewise.
void go_back(Run& run, const std::shared_ptr<const run::Run::Snapshot>& snapshot);

}  // namespace fabricsh::script
