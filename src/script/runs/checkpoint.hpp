// Runs of a restarted deck: which of the deck's calls were made before the checkpoint.
#pragma once
#include <memory>
#include <string>

#include "script/runs/run.hpp"

namespace fabricsh::script {

// Error: as run::read_checkpoint; not permitted under --safe.
std::shared_ptr<const run::Checkpoint> load_checkpoint(const std::string& path);

// The checkpoint of one analysis within `checkpoint`: its own, or one finished earlier. Null: none.
// Error: the file of the finished one is gone, damaged or another one.
std::shared_ptr<const run::Checkpoint> part_of(const std::shared_ptr<const run::Checkpoint>& checkpoint,
                                               std::int64_t analysis);

// For a run of a restarted deck that had finished before the checkpoint was written: takes its final state.
// If its problem has changed, it is computed again, with a notice.
void begin_finished(DeckRun& run, std::shared_ptr<const run::Checkpoint> checkpoint);

// The run starts from the checkpoint at its first solve(), advance() or step(). Error: another problem, with
// the differences. Notice: the deck has changed.
void begin_from(DeckRun& run, std::shared_ptr<const run::Checkpoint> checkpoint);
// Restores it at once, for a run at the prompt.
void restart(DeckRun& run, std::shared_ptr<const run::Checkpoint> checkpoint);
// Restores state and settings of the checkpoint from which the run starts, if that has not been done.
void take_up(DeckRun& run);

// The information on the deck and its arguments for run.json and checkpoints.
run::Journal journal_of(const SessionOptions& options);

}  // namespace fabricsh::script
