// The events of a driven run, for all that writes or watches it: tables, series, checkpoints, run.json,
// progress. A new one is a class in a file of its own and one Job::listen.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "run/checkpoint.hpp"

namespace fabricsh::run {

class Job;

// How a call that drove a run has ended.
struct Ending {
  std::string status;   // for run.json: "done", "under way", "stopped: ..." or the words of an error
  bool ended = false;   // no step is under way: the present state is the last one for now
  bool broken = false;  // by an error or an interrupt; the run may go on from here
};

class Listener {
 public:
  // The order of calls: a checkpoint counts what outputs have written, a report states their success.
  enum class ListenerOrder { output, checkpoint, report, watch };

  Listener() = default;
  virtual ~Listener() = default;
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  virtual ListenerOrder turn() const = 0;

  // Fires when a call is about to drive the run and its files are locked. If one throws, no step is made.
  virtual void begin(Job&) {}
  // Fires when the hooks that were due before the first step of the call are done.
  virtual void ready(Job&) {}
  // Fires after each committed step, when its frames are written and its hooks and events are done: the state
  // can be saved. If one throws, the call ends at the committed state.
  virtual void step(Job&) {}
  // Fires when a call has ended, in whatever way. All are called, even if some throw.
  virtual void end(Job&, const Ending&) {}
  // Fire when the run has returned to an earlier state: first all discard what belongs to later steps, then,
  // in the opposite order, files may be cut. So a checkpoint is replaced before the rows that it counts go.
  virtual void forget(Job&) {}
  virtual void restored(Job&) {}
  // Fire when a checkpoint is written: files are forced to the disk, then all add what they need to continue.
  virtual void sync() {}
  virtual void save(std::vector<Checkpoint::CheckpointPart>&) {}
};

// The one that writes run.json in the folders of the outputs.
std::shared_ptr<Listener> make_run_json();
// "fnv1a64:...", the hash by which run.json identifies files.
std::string hash_text(const std::string& bytes);

}  // namespace fabricsh::run
