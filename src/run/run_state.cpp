// The content of snapshots and checkpoints of a run, and returning to them.
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

namespace {

constexpr int kDue = 10;  // added to the side of an event, which is -1, 0 or 1, whose hook is still to run

}  // namespace

struct Run::Snapshot {
  const Run* owner;
  std::string bytes;
};

Run::Busy::Busy(Run& run, const char* call) : run_(run) {
  if (run.busy_) throw Error(std::string(call) + ": not from a hook of the same run");
  run.busy_ = true;
}

void Run::keep_assembly(Archive& archive) {
  if (assembly_->keep(archive)) resize();
}

void Run::keep(Archive& archive) {
  keep_assembly(archive);
  if (archive.reading()) {
    trial_time_ = committed_time();
    assembly_->set_time(trial_time_);
  }
  archive.section("ledger", [&] { archive(dead_, initial_energy_, work_, reports_, accounts_); });
  archive.section("progress",
                  [&] { archive(started_, stopped_, stop_reason_, beyond_, *warnings_, thrown_); });
  archive.section(kind(), [&] { memory(archive); });
  archive.section("hooks", [&] {
    keep_hooks(archive);
    windows_.keep(archive);
  });
}

void Run::keep_motion(Archive& archive) {
  keep_assembly(archive);
  std::uint64_t steps = reports_.size();
  archive(dead_, work_, beyond_, accounts_, steps);
  memory(archive);
  if (!archive.reading()) return;
  trial_time_ = committed_time();
  assembly_->set_time(trial_time_);
  reports_.resize(steps);
}

std::string Run::save_state() {
  Archive archive;
  keep_motion(archive);
  return archive.bytes();
}

void Run::go_back(const std::string& save_state) {
  Archive archive(save_state);
  keep_motion(archive);
}

void Run::keep_hooks(Archive& archive) {
  if (!archive.reading()) {
    kept_timed_.clear();
    kept_events_.clear();
    // Hooks that an error has kept from running, in a call that has ended, are still to run.
    for (const auto& timed : timed_)
      kept_timed_.push_back({timed.count, timed.repeats() || (timed.pending && !busy_)});
    for (const auto& event : events_)
      kept_events_.push_back({event.last, event.largest, event.side + (event.pending && !busy_ ? kDue : 0)});
  }
  archive(kept_timed_, kept_events_);
  if (!archive.reading()) return;
  for (std::size_t i = 0; i < timed_.size(); ++i) take_up(timed_[i], i);
  for (std::size_t i = 0; i < events_.size(); ++i) take_up(events_[i], i);
}

// A hook added after the state was stored counts from now.
void Run::take_up(Timed& timed, std::size_t i) {
  timed.pending = false;
  timed.count = 1;
  if (i < kept_timed_.size()) {
    timed.count = kept_timed_[i].count;
    timed.pending = kept_timed_[i].repeats;
  } else if (timed.interval > 0) {
    timed.count += static_cast<std::int64_t>(std::floor(time() / timed.interval + 1e-9));
  }
}

void Run::take_up(Event& event, std::size_t i) {
  event.pending = false;
  if (i < kept_events_.size()) {
    event.last = kept_events_[i].last;
    event.largest = kept_events_[i].largest;
    event.pending = kept_events_[i].side > kDue - 2;
    event.side = kept_events_[i].side - (event.pending ? kDue : 0);
  } else if (started_) {
    event.side = 0;
    measure(event);
    event.settle();
  }
}

std::shared_ptr<const Run::Snapshot> Run::snapshot() {
  return std::make_shared<Snapshot>(Snapshot{this, kept()});
}

void Run::restore(const Snapshot& snapshot) {
  if (snapshot.owner != this) throw Error("restore: this snapshot was taken of another analysis");
  const Busy busy(*this, "restore");
  Archive archive(snapshot.bytes);
  keep(archive);
  for (const auto& hook : restored_) hook(*this);
}

std::string Run::kept() {
  Archive archive;
  keep(archive);
  return archive.bytes();
}

void Run::resume(const std::string& bytes) {
  const Busy busy(*this, "restart");
  const std::string before = kept();
  const std::vector<Warning> said = *warnings_;
  Archive archive(bytes);
  try {
    keep(archive);
    if (!archive.at_end()) throw Error("there are more bytes than the run has");
  } catch (...) {
    Archive back(before);
    keep(back);
    throw;
  }
  for (const Warning& w : said)  // of the restart itself
    if (!std::any_of(warnings_->begin(), warnings_->end(),
                     [&](const Warning& kept) { return kept.text == w.text; }))
      warnings_->push_back(w);
}

}  // namespace fabricsh::run
