#include "run/job.hpp"

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "base/utf8.hpp"
#include "system/atomic.hpp"

namespace fabricsh::run {

namespace {

constexpr double usual_minutes = 10;

std::string absolute(const std::string& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

}  // namespace

// --- outputs

Job::Job(std::shared_ptr<Run> run, std::shared_ptr<Journal> journal, std::int64_t number)
    : run_(std::move(run)), journal_(std::move(journal)), number_(number) {
  listen(make_run_json());
  run_->when_ready([this](Run&) { notify(&Listener::ready, *this); });
  run_->when_settled([this](Run&) { notify(&Listener::step, *this); });
  run_->on_restore([this](Run&) {
    notify(&Listener::forget, *this);
    for (auto at = listeners_.rbegin(); at != listeners_.rend(); ++at) (*at)->restored(*this);
  });
}

std::string Job::free_path(const std::string& path) const {
  const std::string file = absolute(path);
  if (paths_.count(file) != 0) throw Error("argument 1: '" + path + "' is an output of this run already");
  return file;
}

// Opens an output: new, or continued if the run starts from a checkpoint that has it.
void Job::add(std::shared_ptr<Output> output, double every,
              const std::function<std::shared_ptr<Series>(Archive* from)>& make) {
  Output* old = nullptr;
  for (const auto& there : outputs_)
    if (there->kind == output->kind && there->file == absolute(output->written) && replaceable(*there))
      old = there.get();
  output->file = old != nullptr ? old->file : free_path(output->written);
  const std::string* const kept = claims_.take(output->kind, output->path);
  if (kept == nullptr) system::make_folder_for(output->written);
  auto lock = journal_->locks.take(output->written);
  Archive from(kept == nullptr ? std::string() : *kept);
  output->series = make(kept == nullptr ? nullptr : &from);
  for (const std::string& file : output->series->lost())
    run_->warn("lost", "warning: restart: '" + file + "' is gone, the series goes on without it");
  if (old != nullptr) {
    old->series = output->series;
    for (const auto& keeper : keepers_) keeper->force();
    return run_->reschedule(old->hook, every);
  }
  locks_.push_back(std::move(lock));
  paths_.insert(output->file);
  const auto frame = [output, this](Run&) { this->frame(*output->series, false); };
  constexpr auto repeat = Run::AfterError::repeat;
  output->hook = every > 0 ? run_->every(every, frame, repeat) : run_->every_step(frame, repeat);
  outputs_.push_back(output);
  listen(output);
}

void Job::frame(Series& series, bool extra) {
  const std::function<void()> take_back = untraced ? untraced() : nullptr;
  try {
    extra ? series.extra_frame(*run_) : series.frame(*run_);
  } catch (...) {
    if (take_back) take_back();
    throw;
  }
  if (extra && take_back) take_back();
}

void Job::listen(const std::shared_ptr<Listener>& listener) {
  const auto later = [](Listener::ListenerOrder turn, const auto& there) { return turn < there->turn(); };
  listeners_.insert(std::upper_bound(listeners_.begin(), listeners_.end(), listener->turn(), later),
                    listener);
}

namespace {

// Columns with a window read the mean that the run keeps.
std::vector<RecordColumn> means_of(Run& run, const std::string& path, std::vector<RecordColumn> columns) {
  for (RecordColumn& column : columns) {
    if (column.window <= 0) continue;
    const std::string name = "column " + column.name + " of " + path;
    run.window(name,
               Window(column.window, [value = column.value](const Run& now) { return Sampled{value(now)}; }));
    column.value = [&run, name](const Run&) { return run.window(name)->mean()[0]; };
  }
  return columns;
}

}  // namespace

void Job::record(const std::string& path, const std::vector<RecordColumn>& columns, double every) {
  for (const RecordColumn& column : columns) {
    want_plain(column.name + column.unit, "record: field 'columns'");
    if (!column.value) throw Error("record: column '" + column.name + "': expected a function, got none");
  }
  add(std::make_shared<Output>("record", path, path), every,
      [&](Archive* from) { return make_table(path, means_of(*run_, path, columns), from); });
}

void Job::vtk(const std::string& stem, double every, const VtkContents& contents) {
  add(std::make_shared<Output>("vtk", stem, stem + ".pvd"), every, [&](Archive* from) {
    check_fields(*run_, contents, "vtk");
    return make_vtk(stem, contents, from);
  });
}

std::shared_ptr<Keeper> Job::checkpoint(const std::string& path, std::optional<double> every,
                                        std::optional<double> minutes) {
  if (!every && !minutes) minutes = usual_minutes;
  const auto keeper = std::make_shared<Keeper>(path, every, minutes);
  const std::string file = free_path(path);
  system::make_folder_for(path);
  auto lock = journal_->locks.take(path);
  system::remove_leftovers(path);
  system::AtomicFile{path};  // what would prevent writing it in ten minutes is an error now
  locks_.push_back(std::move(lock));
  paths_.insert(file);
  keepers_.push_back(keeper);
  listen(keeper);
  return keeper;
}

// --- starting from a checkpoint

void Job::restart(const std::string& path) { begin_from(read_checkpoint(path)); }

void Job::begin_from(std::shared_ptr<const Checkpoint> from) {
  if (!outputs_.empty() || !keepers_.empty())
    throw Error(
        "expected to be called before 'record', 'vtk' and 'checkpoint', which then continue their files");
  if (const std::string differs = difference(*from, *run_); !differs.empty())
    throw Error("checkpoint '" + from->path + "' is of another problem: it differs in " + differs);
  claims_ = Claims(std::move(from));
  taken_up_ = false;
}

void Job::take_up() {
  if (!from() || taken_up_) return;
  run::take_up(*run_, *from());
  taken_up_ = true;
  seconds_ = from()->seconds;
}

// --- driving

void Job::begin() {
  claims_.check();
  std::vector<system::Locks::Lock> locks;
  for (const std::string& path : paths_) locks.push_back(journal_->locks.take(path));
  locks_ = std::move(locks);
  notify(&Listener::begin, *this);
  clock_ = {};
  driving_ = true;
}

void Job::leave(const Ending& ending, const Guarded& guarded) {
  seconds_ += clock_.seconds();
  driving_ = false;
  for (const auto& listener : listeners_) guarded([&] { listener->end(*this, ending); });
  if (ending.ended) locks_.clear();
}

Ending Job::ending() const {
  if (run_->stopped()) return {"stopped: " + run_->stop_reason(), true};
  const bool done = run_->time() >= run_->duration() * (1 - 1e-12);
  return {done ? "done" : "under way", done};
}

void Job::advance(double time) {
  take_up();
  begin();
  std::exception_ptr first;
  const auto guarded = [&first](const std::function<void()>& work) {
    try {
      work();
    } catch (...) {
      if (!first) first = std::current_exception();
    }
  };
  try {
    run_->advance(time);
  } catch (const std::exception& error) {
    leave({error.what(), true, true}, guarded);
    throw;
  } catch (...) {  // a hook may throw what is no exception of the standard library
    leave({"an error in a hook", true, true}, guarded);
    throw;
  }
  const Ending last = ending();
  leave(last, guarded);
  if (last.ended) remember_end();
  if (first) std::rethrow_exception(first);
}

// --- checkpoints

Checkpoint Job::now() {
  Checkpoint c = checkpoint_of(*run_);
  c.number = number_;
  if (journal_->sign) journal_->sign(c);
  c.seconds = seconds();
  if (caller) c.caller = caller();
  notify(&Listener::save, c.parts);
  return c;
}

namespace {

std::string own_file(const std::string& path, std::int64_t number) {
  return absolute(path) + "." + std::to_string(number);
}

}  // namespace

// If the run's file belongs to another one by now, as in a restarted deck, the end goes into a file of its
// own.
void Job::remember_end() {
  for (const auto& keeper : keepers_)
    if (keeper->holds_end(*run_)) {
      journal_->finished[number_] = {absolute(keeper->path())};
      return;
    }
  if (keepers_.empty() || journal_->finished.count(number_) != 0) return;
  const std::string file = own_file(keepers_.front()->path(), number_);
  write_checkpoint(file, now());
  journal_->finished[number_] = {file};
}

// A finished run whose file somebody has removed is forgotten: a restart runs it again.
void Journal::make_way(const std::string& file, std::int64_t number) {
  for (auto at = finished.begin(); at != finished.end();) {
    auto& [other, end] = *at;
    const bool moves = other != number && end.file == file;
    if (moves) end = {own_file(file, other), copy_checkpoint(file, own_file(file, other))};
    at = moves && !end.hash ? finished.erase(at) : std::next(at);
  }
}

std::vector<Checkpoint::Finished> Journal::list_for(const std::string& folder, std::int64_t except) {
  std::vector<Checkpoint::Finished> list;
  for (auto at = finished.begin(); at != finished.end();) {
    auto& [number, end] = *at;
    if (number != except && !end.hash) end.hash = hash_of_checkpoint(end.file);
    if (number != except && end.hash)
      list.push_back(
          {number, std::filesystem::path(end.file).lexically_relative(folder).string(), *end.hash});
    at = number != except && !end.hash ? finished.erase(at) : std::next(at);
  }
  return list;
}

}  // namespace fabricsh::run
