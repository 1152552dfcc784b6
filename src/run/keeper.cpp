#include "run/keeper.hpp"

#include <cmath>
#include <filesystem>

#include "base/error.hpp"
#include "base/number.hpp"
#include "run/job.hpp"
#include "system/atomic.hpp"

namespace fabricsh::run {

Keeper::Keeper(std::string path, std::optional<double> every, std::optional<double> minutes)
    : path_(std::move(path)), every_(every), minutes_(minutes), last_(std::chrono::steady_clock::now()) {}

bool Keeper::due(const Run& run) const {
  if (forced_) return true;
  if (every_ && run.time() >= next_ - same_time * run.duration()) return true;
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - last_;
  return minutes_ && since.count() >= 60 * *minutes_;
}

// The times of `every` are counted from 0 and not from a restart, so that the output does not depend on
// restarts.
void Keeper::step(Job& job) {
  if (silent_) return;
  const Run& run = job.run();
  if (every_ && *every_ > 0 && next_ == 0 && written_ == static_cast<std::size_t>(-1)) {
    const auto passed = run.steps().empty() ? 0.0 : run.time() - run.steps().back().step;
    next_ = *every_ * (std::floor(passed / *every_ + 1e-9) + 1);
  }
  if (due(run)) write(job);
}

void Keeper::write(Job& job) {
  if (silent_) return;
  const Run& run = job.run();
  const std::size_t step = run.steps().size();
  if (step == written_ && !forced_) return;
  try {
    job.notify(&Listener::sync);
    Checkpoint c = job.now();
    const std::string file = std::filesystem::absolute(path_).lexically_normal().string();
    job.journal().make_way(file, job.number());
    c.finished = job.journal().list_for(std::filesystem::path(file).parent_path().string(), job.number());
    write_checkpoint(path_, c);
  } catch (const Error& error) {
    const std::string words = "checkpoint: " + std::string(error.what()) + " (the run is kept at " +
                              exact_number(run.time()) + " s; solve() continues it)";
    if (dynamic_cast<const system::CannotWrite*>(&error) != nullptr) throw system::CannotWrite(words);
    throw Error(words);
  }
  written_ = step;
  forced_ = false;
  last_ = std::chrono::steady_clock::now();
  if (every_ && *every_ > 0) next_ = *every_ * (std::floor(run.time() / *every_ + 1e-9) + 1);
}

bool Keeper::holds_end(const Run& run) const { return !silent_ && written_ == run.steps().size(); }

void Keeper::restored(Job& job) {
  forced_ = true;
  if (job.from() || written_ != static_cast<std::size_t>(-1)) write(job);
}

void Keeper::end(Job& job, const Ending& ending) {
  if (ending.ended) write(job);
}

}  // namespace fabricsh::run
