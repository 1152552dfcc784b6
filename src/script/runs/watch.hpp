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

// What reports the progress of a run several times a second, and ends the call after Ctrl-C.
std::shared_ptr<run::Listener> make_watch(DeckRun& run);

}  // namespace fabricsh::script
