// Checkpoints, written during a run.
#pragma once
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "run/listener.hpp"

namespace fabricsh::run {

// Writes checkpoints of a run at the requested intervals, and where a call ends.
class Keeper final : public Listener {
 public:
  // every: s of simulated time, 0: every step; minutes: of real time; at least one is given.
  Keeper(std::string path, std::optional<double> every, std::optional<double> minutes);
  // Adds parts to the checkpoint with this path; called for each checkpoint.
  void keep_also(std::function<void(std::vector<Checkpoint::CheckpointPart>&)> parts) {
    also_ = std::move(parts);
  }
  const std::string& path() const { return path_; }
  ListenerOrder turn() const override { return ListenerOrder::checkpoint; }
  void step(Job& job) override;  // writes a checkpoint if one is due. Error: names the file and the reason
  void restored(Job& job) override;  // writes one if there is one, or if the run started from one
  void end(Job& job, const Ending& ending) override;
  void save(std::vector<Checkpoint::CheckpointPart>& parts) override {
    if (also_) also_(parts);
  }
  bool holds_end(const Run& run) const;  // the file has the present state of the run
  void force() { forced_ = true; }       // the next step writes one
  // Another run now writes this file: only the additional parts are stored, in the checkpoints of other runs.
  void write_nothing() { silent_ = true; }

 private:
  bool due(const Run& run) const;
  void write(Job& job);
  std::string path_;
  std::optional<double> every_, minutes_;
  std::function<void(std::vector<Checkpoint::CheckpointPart>&)> also_;
  double next_ = 0;  // s
  bool forced_ = false, silent_ = false;
  std::size_t written_ = static_cast<std::size_t>(-1);  // the step of the last checkpoint
  std::chrono::steady_clock::time_point last_;
};

}  // namespace fabricsh::run
