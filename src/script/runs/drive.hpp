// Driving a run from Lua: what a call of solve(), advance() or step() does besides the steps.
#pragma once
#include "script/runs/run.hpp"

namespace fabricsh::script {

// Executes the call, measures its time, reports progress and reacts to Ctrl-C. When the run ends or fails,
// outputs and checkpoints get its last state, and run.json records how far it came. In a restarted deck the
// calls made before the checkpoint do nothing (one that failed fails again), and the interrupted call
// continues.
void drive(DeckRun& run, const Drive& call);

// The present call has ended with this error, which a restarted deck raises again when it passes over the
// call.
void note_failure(DeckRun& run, const std::exception& error);

// The call restore(), which a restarted deck also skips if it was made before the checkpoint.
void go_back(DeckRun& run, const std::shared_ptr<const run::Run::Snapshot>& snapshot);

// --- Progress of a run, and Ctrl-C, while it is driven.

// Ctrl-C or SIGTERM stopped the run at its last committed step.
class Interrupted : public Error {
 public:
  using Error::Error;
};

// "ended by SIGTERM": the signal that ends the program.
std::string ended_by(const Session& session);

// A listener that reports the progress of a run several times a second, and ends the call after Ctrl-C.
std::shared_ptr<run::Listener> make_watch(DeckRun& run);

}  // namespace fabricsh::script
