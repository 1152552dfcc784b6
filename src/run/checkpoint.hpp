// What a checkpoint holds of a run and of what it writes, and how a run begins from it.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "model/fingerprint.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

struct Checkpoint {
  std::string path;  // it was read from; not kept

  std::string version, instructions;  // of the program; of the kernels, on which the bits hang
  std::string deck;                   // or program, that drove the run
  std::uint64_t deck_hash = 0;
  std::int64_t number = 0;  // of the run among those of the deck, from 1
  model::Fingerprint problem;
  double time = 0;              // s
  std::string state, settings;  // Run::kept(), keep_settings()
  double seconds = 0;           // spent
  std::string caller;           // what who drives the run keeps besides, as bytes
  struct Part {                 // an output ("record", "vtk"), or what a caller keeps by name
    std::string kind, path, bytes;
    void keep(Archive& archive) { archive(kind, path, bytes); }
  };
  std::vector<Part> parts;
  std::vector<std::string> finished;                      // checkpoints of the ends of other runs, as bytes
  std::vector<std::shared_ptr<const Checkpoint>> others;  // the same, once read; not kept

  void keep(Archive& archive) {
    archive.section("program", [&] { archive(version, instructions); });
    archive.section("deck", [&] { archive(deck, deck_hash, number, seconds, caller); });
    archive.section("problem", [&] { archive(problem); });
    archive.section("state", [&] { archive(time, state, settings); });
    archive.section("outputs", [&] { archive(parts, finished); });
  }
  std::string bytes() const;  // whole, as one of `finished`
};

// All that a run's state hangs on: method, duration, kernels, cards and model.
model::Fingerprint problem_of(const Run& run);
// The run as it is, with nothing yet of what it writes.
Checkpoint checkpoint_of(Run& run);

// Replaces the file, whole at any instant. Error: it can't be written.
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint);
// Errors: see format::read_checkpoint; a part with other members than here, by its name; a file that was
// written with other vector instructions, whose bits would not be the same.
std::shared_ptr<const Checkpoint> read_checkpoint(const std::string& path);

// "" or what the run's problem differs in from the checkpoint's.
std::string difference(const Checkpoint& checkpoint, const Run& run);
// Settings and state. Error: names the file and why; the run is then as it was.
void take_up(Run& run, const Checkpoint& checkpoint);

// What a restarted run's outputs have taken of its checkpoint.
class Claims {
 public:
  Claims() = default;
  explicit Claims(std::shared_ptr<const Checkpoint> from) : from_(std::move(from)) {}
  const std::shared_ptr<const Checkpoint>& from() const { return from_; }
  bool open() const { return from_ && !went_on_; }
  // The part of that kind and path or, where the run writes elsewhere now, the next of that kind in the order
  // of the checkpoint. Null: the run begins from none or has gone on from it. Error: there is none left.
  const std::string* take(const std::string& kind, const std::string& path);
  // Before the first step; outputs made later are new. Error: names a part that nothing goes on with.
  void check();

 private:
  std::shared_ptr<const Checkpoint> from_;
  std::map<std::size_t, std::string> claimed_;  // parts, and the path that each goes on with
  bool went_on_ = false;
};

}  // namespace fabricsh::run
