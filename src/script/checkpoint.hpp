// What a checkpoint holds, and how a run is kept in it and begins from it.
#pragma once
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "model/fingerprint.hpp"
#include "script/bind_run.hpp"

namespace fabricsh::script {

struct Checkpoint {
  std::string path;  // it was read from; not kept

  std::string version, instructions;  // of the program, of the kernels: bits hang on both
  std::string deck;
  std::uint64_t deck_hash = 0;
  std::int64_t analysis = 0;  // from 1, in the order in which the deck makes them
  model::Fingerprint problem;
  double time = 0;

  std::string state, settings;  // analysis::Run::kept(), keep_settings()
  std::int64_t calls = 0;       // of solve, advance, step and restore so far; the last one is under way
  Drive under_way;
  std::vector<FailedCall> failed;
  double seconds = 0;
  struct Part {  // an output ("record", "vtk"), or a table of the deck's ("keep")
    std::string kind, path, bytes;
    void keep(Archive& archive) { archive(kind, path, bytes); }
  };
  std::vector<Part> parts;
  std::vector<std::string> finished;  // checkpoints of the end of other analyses, as bytes
  std::vector<std::shared_ptr<const Checkpoint>> others;  // the same, once read; not kept

  void keep(Archive& archive) {
    archive(version, instructions, deck, deck_hash, analysis, problem, time, state, settings, calls,
            under_way, failed, seconds, parts, finished);
  }
};

// Error: see files::read_checkpoint; of another version or of other instructions.
std::shared_ptr<const Checkpoint> load_checkpoint(const std::string& path);

// What the checkpoint has of an analysis: its own, or one that was finished by then. Null: nothing.
std::shared_ptr<const Checkpoint> part_of(const std::shared_ptr<const Checkpoint>& checkpoint,
                                          std::int64_t analysis);

// The run, made by a restarted deck, is finished in the checkpoint of another one, and is taken as that. One
// that has become another problem since is done anew; a notice says so.
void begin_finished(Run& run, std::shared_ptr<const Checkpoint> checkpoint);
// The end of a kept run goes into all checkpoints written from here on.
void remember_end(Run& run);

// The run begins from the checkpoint, at its first solve(), advance() or step(). Error: of another problem,
// with what differs. A notice: the deck has changed.
void begin_from(Run& run, std::shared_ptr<const Checkpoint> checkpoint);
// Now, for a run at the prompt.
void restart(Run& run, std::shared_ptr<const Checkpoint> checkpoint);
// State and settings of the checkpoint that the run begins from, if it hasn't taken them yet.
void take_up(Run& run);
// What the checkpoint that the run begins from has for an output or a table: the part of that path or, where
// the deck writes elsewhere now, the next of that kind in the order of the deck. Null: the run begins from
// none or has gone on from it. Error: there is none left.
const std::string* take_part(Run& run, const std::string& kind, const std::string& path);
// Before the first step. Error: names a part that nothing of the run goes on with.
void check_parts(Run& run);

// Writes a file of the run's as often as it is asked for.
class Keeper {
 public:
  // every: s of simulated time, 0: every step; minutes of time on the clock; at least one of them.
  Keeper(Run& run, std::string path, std::optional<double> every, std::optional<double> minutes);
  void keep_table(Hook table) { table_ = std::move(table); }
  void add_table(std::vector<Checkpoint::Part>& parts) const;
  void look();                      // after a step: writes where that is due
  void write();                     // Error: names the file and why
  void force() { forced_ = true; }  // at the next look
  // The file is another analysis' by now: only the table is kept, in the checkpoints of the others.
  void write_nothing() { silent_ = true; }

 private:
  bool due() const;
  Run& run_;
  std::string path_;
  std::optional<double> every_, minutes_;
  std::optional<Hook> table_;
  double next_ = 0;  // s
  bool forced_ = false, silent_ = false;
  std::size_t written_ = static_cast<std::size_t>(-1);  // at that step
  std::chrono::steady_clock::time_point last_;
};

}  // namespace fabricsh::script
