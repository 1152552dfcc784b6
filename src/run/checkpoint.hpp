// The content of a checkpoint, the state of a run and of its outputs, and starting a run from it.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "model/fingerprint.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

struct Checkpoint {
  std::string path;  // the file it was read from; not stored

  std::string version, instructions;  // of the program; of the kernels, on which rounding depends
  std::string deck;                   // or program, that started the run
  std::uint64_t deck_hash = 0;
  std::int64_t number = 0;  // of the run among those of the deck, from 1
  int edition = model::fingerprint_edition;
  model::Fingerprint problem;
  double time = 0;              // s
  std::string state, settings;  // Run::kept(), keep_settings()
  double seconds = 0;           // computing time of the run so far
  std::string caller;           // additional data of the program that drives the run
  struct CheckpointPart {       // an output ("record", "vtk"), or named data of a caller
    std::string kind, path, bytes;
    void keep(Archive& archive) { archive(kind, path, bytes); }
  };
  std::vector<CheckpointPart> parts;
  // Checkpoints at the ends of other runs, which lie in files of their own, each written once.
  struct Finished {
    std::int64_t number = 0;  // of the run
    std::string file;         // relative to the folder of this checkpoint
    std::uint64_t hash = 0;   // of its content
    void keep(Archive& archive) { archive(number, file, hash); }
  };
  std::vector<Finished> finished;

  void keep(Archive& archive) {
    archive.section("program", [&] { archive(version, instructions); });
    archive.section("deck", [&] { archive(deck, deck_hash, number, seconds, caller); });
    archive.section("problem", [&] { archive(edition, problem); });
    archive.section("state", [&] { archive(time, state, settings); });
    archive.section("outputs", [&] { archive(parts, finished); });
  }
  const Finished* finished_run(std::int64_t number_of_run) const;  // null: not among them
};

// All that a run's state depends on: method, duration, kernels, cards and model.
model::Fingerprint problem_of(const Run& run);
// The run's present state, without its outputs.
Checkpoint checkpoint_of(Run& run);

// Replaces the file, which is complete at any instant. Error: it cannot be written.
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint);
// The file's content without its list of finished runs goes to another file. Returns its hash; none if the
// first file cannot be read. Error: the other one cannot be written.
std::optional<std::uint64_t> copy_checkpoint(const std::string& from, const std::string& to);
std::optional<std::uint64_t> hash_of_checkpoint(const std::string& path);  // none: it cannot be read
// The full path of a finished run's file.
std::string file_of(const Checkpoint& checkpoint, const Checkpoint::Finished& finished);
// Error: as read_checkpoint; its content has changed.
std::shared_ptr<const Checkpoint> read_finished(const Checkpoint& checkpoint,
                                                const Checkpoint::Finished& finished);
// Errors: those of format::read_checkpoint; a part whose members differ from this build's (named); a file
// written with other vector instructions, which round differently.
std::shared_ptr<const Checkpoint> read_checkpoint(const std::string& path);

// The differences between the run's problem and the checkpoint's; empty if there are none.
std::string difference(const Checkpoint& checkpoint, const Run& run);
// Restores settings and state. Error: names the file and the reason; the run is then unchanged.
void take_up(Run& run, const Checkpoint& checkpoint);

// Keeps track of the parts of a checkpoint that the outputs of a restarted run have continued.
class Claims {
 public:
  Claims() = default;
  explicit Claims(std::shared_ptr<const Checkpoint> from) : from_(std::move(from)) {}
  const std::shared_ptr<const Checkpoint>& from() const { return from_; }
  bool open() const { return from_ && !went_on_; }
  // Returns the part with that kind and path; without one, since the run may now write elsewhere, the next of
  // that kind. Null: the run starts from no checkpoint or has made steps. Error: no part is left.
  const std::string* take(const std::string& kind, const std::string& path);
  // Called before the first step; outputs made later are new. Error: a part that no output continues (named).
  void check();

 private:
  std::shared_ptr<const Checkpoint> from_;
  std::map<std::size_t, std::string> claimed_;  // parts, and the path of the output that continues each
  bool went_on_ = false;
};

}  // namespace fabricsh::run
