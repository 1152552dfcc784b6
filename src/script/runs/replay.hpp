// A deck's readings of a run between two of its calls. A restarted deck passes over the calls made before the
// checkpoint; the run is then in the state of the checkpoint, but the deck has to read what it read at the
// time. So readings are noted while a run has checkpoints, and repeated in the part that is passed over. A
// reading that was not noted is an error that ends the deck: it never reads something else.
#pragma once
#include <functional>

#include "script/call/call.hpp"
#include "script/runs/run.hpp"

namespace fabricsh::script {

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
