// Driving a run from Lua: what a call of solve(), advance() or step() does besides the steps.
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "script/call/call.hpp"
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

// --- Runs of a restarted deck: which of the deck's calls were made before the checkpoint.

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

// --- A deck's readings of a run between two of its calls. A restarted deck passes over the calls made before
// the checkpoint; the run is then in the state of the checkpoint, but the deck has to read what it read at
// the time. So readings are noted while a run has checkpoints, and repeated in the part that is passed over.
// A reading that was not noted is an error that ends the deck: it never reads something else.

// Executes `read`, which pushes results of the run and returns their number, and notes them if a restart may
// need them; or, in a part of the deck that is passed over, pushes the results noted under this name and
// these arguments. Result values may be plain, or the object on which the method was called.
int read_between(lua_State* L, DeckRun& run, const std::string& name, const std::string& arguments,
                 const std::function<int()>& read);

// Executes a call of the deck; as above if it reads a run. Error: it needs the whole state of a run in a part
// that is passed over.
int execute(Call& call);

// Error: the deck makes another call here than the one that wrote the checkpoint, in the part that is passed
// over.
void check_call(DeckRun& run, const Drive& call);

// Whether the present change of a run by a method such as set() is repeated by a restarted deck, whose run
// has the effect of it already; counts the change.
bool repeats_change(DeckRun& run);

// Kept tables: the deck's table is to be stored in the checkpoints of this run; `restored` is its content in
// the checkpoint from which the run starts. It is filled in the same way as readings are repeated: after each
// call that is passed over with what it was then, and in the call in which the checkpoint was written with
// what the checkpoint has.
void keep_table(DeckRun& run, const Hook& table, std::string restored);
void begin_tables(DeckRun& run);    // before a call that is executed
void hold_tables(DeckRun& run);     // at the end of a step
void release_tables(DeckRun& run);  // where a step was taken back: as they were then
// A function that gives them the present content again.
std::function<void()> untraced_tables(DeckRun& run);
void note_tables(DeckRun& run);           // after it
void repeat_tables(DeckRun& run);         // instead of a call that is passed over
void restore_tables(const DeckRun& run);  // in the call in which the checkpoint was written

}  // namespace fabricsh::script
