// What is said of the state of a run; the content of its snapshots and checkpoints, and returning to them.
#include "run/run_state.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

RunState::RunState(std::shared_ptr<model::Model> model, double duration, std::shared_ptr<Notices> notices)
    : model_(std::move(model)), duration_(duration), notices_(std::move(notices)) {}

RunState::~RunState() = default;

void RunState::note(const char* code, const std::string& text, mesh::Index element) {
  constexpr std::string_view prefix = "warning: ";
  const bool serious = warning_kind(code).serious || (stops_beyond_ && code == std::string_view("beyond"));
  warnings_->push_back(
      {code, text.starts_with(prefix) ? text.substr(prefix.size()) : text, time(), element, serious});
}

void RunState::warn(const char* code, const std::string& text, mesh::Index element) {
  note(code, text, element);
  notices_->say(text);
}

bool RunState::warned(std::string_view code) const {
  return std::any_of(warnings_->begin(), warnings_->end(), [&](const Warning& w) { return w.code == code; });
}

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
  archive.section("hooks", [&] { keep_schedule(archive, !busy_); });
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
