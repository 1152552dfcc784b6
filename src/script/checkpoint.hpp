// A run of a deck and the checkpoint that it begins from: what of the deck's calls lies before it.
#pragma once
#include <memory>
#include <string>

#include "script/bind/run.hpp"

namespace fabricsh::script {

// Error: see run::read_checkpoint; under --safe none is read.
std::shared_ptr<const run::Checkpoint> load_checkpoint(const std::string& path);

// What the checkpoint has of an analysis: its own, or one that was finished by then. Null: nothing.
std::shared_ptr<const run::Checkpoint> part_of(const std::shared_ptr<const run::Checkpoint>& checkpoint,
                                               std::int64_t analysis);

// The run, made by a restarted deck, is finished in the checkpoint of another one, and is taken as that. One
// that has become another problem since is done anew; a notice says so.
void begin_finished(Run& run, std::shared_ptr<const run::Checkpoint> checkpoint);

// The run begins from the checkpoint, at its first solve(), advance() or step(). Error: of another problem,
// with what differs. A notice: the deck has changed.
void begin_from(Run& run, std::shared_ptr<const run::Checkpoint> checkpoint);
// Now, for a run at the prompt.
void restart(Run& run, std::shared_ptr<const run::Checkpoint> checkpoint);
// State and settings of the checkpoint that the run begins from, if it hasn't taken them yet.
void take_up(Run& run);

// What run.json and checkpoints say of the deck and its arguments.
run::Journal journal_of(const Options& options);

}  // namespace fabricsh::script
