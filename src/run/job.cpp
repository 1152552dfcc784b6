#include "run/job.hpp"

#include <omp.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/number.hpp"
#include "base/utf8.hpp"
#include "base/version.hpp"
#include "card/fields.hpp"
#include "run/vtk_series.hpp"
#include "simd/isa.hpp"
#include "system/atomic.hpp"

namespace fabricsh::run {

namespace {

constexpr double usual_minutes = 10;

std::string absolute(const std::string& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

format::Json steps_json(const Run& run) {
  std::int64_t iterations = 0, cuts = 0;
  double worst = 0;
  for (const auto& step : run.steps()) {
    iterations += step.iterations;
    cuts += step.cuts;
    if (!step.residuals.empty()) worst = std::max(worst, step.residuals.back());
  }
  format::Json json = format::Json::object();
  json.set("count", run.steps().size()).set("iterations", iterations).set("cuts", cuts);
  json.set("largest_final_residual", worst).set("tolerance", run.tolerance());
  return json;
}

format::Json beyond_json(const Run& run) {
  const auto far = run.beyond();
  if (!far) return {};
  format::Json json = format::Json::object();
  json.set("share", far->share).set("yarn", far->yarn).set("element", far->element + 1);
  json.set("time", far->time).set("first", far->first).set("elements", run.elements_beyond());
  return json.set("strain", far->strain).set("tested", far->tested);
}

format::Json warnings_json(const Run& run) {
  format::Json list = format::Json::array();
  for (const Warning& w : run.warnings()) {
    format::Json json = format::Json::object();
    json.set("code", w.code).set("text", w.text).set("time", w.time);
    if (w.element >= 0) json.set("element", w.element + 1);
    list.push(json.set("serious", w.serious));
  }
  return list;
}

}  // namespace

std::string hash_text(const std::string& bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "fnv1a64:%016llx", static_cast<unsigned long long>(hash(bytes)));
  return text;
}

// --- outputs

Job::Job(std::shared_ptr<Run> run, std::shared_ptr<Journal> journal, std::int64_t number)
    : run_(std::move(run)), journal_(std::move(journal)), number_(number) {
  run_->on_restore([this](Run&) { come_back(); });
}

std::string Job::free_path(const std::string& path) const {
  const std::string file = absolute(path);
  if (paths_.count(file) != 0) throw Error("argument 1: '" + path + "' is an output of this run already");
  return file;
}

// Opens an output: new, or continued if the run starts from a checkpoint that has it. Its frames are written
// every `every` seconds, and once more when the run ends.
template <class Make, class Continue>
void Job::add(Output output, double every, const std::string& written, const Make& make,
              const Continue& continued) {
  Output* old = nullptr;
  for (const auto& there : outputs_)
    if (there->kind == output.kind && there->file == absolute(written) && replaceable(*there))
      old = there.get();
  output.file = old != nullptr ? old->file : free_path(written);
  const std::string* const kept = claims_.take(output.kind, output.path);
  if (kept == nullptr) system::make_folder_for(written);
  auto lock = journal_->locks.take(written);
  if (kept != nullptr) {
    Archive from(*kept);
    output.series = continued(from);
    for (const std::string& file : output.series->lost())
      run_->warn("lost", "warning: restart: '" + file + "' is gone, the series goes on without it");
  } else {
    output.series = make();
  }
  if (old != nullptr) {
    old->series = output.series;
    for (const auto& keeper : keepers_) keeper->force();
    return run_->reschedule(old->hook, every);
  }
  locks_.push_back(std::move(lock));
  paths_.insert(output.file);
  written_.push_back(written);
  const auto added = std::make_shared<Output>(std::move(output));
  const auto frame = [added](Run& a) { added->series->frame(a); };
  constexpr auto repeat = Run::AfterError::repeat;
  added->hook = every > 0 ? run_->every(every, frame, repeat) : run_->every_step(frame, repeat);
  outputs_.push_back(added);
}

// The run has returned to an earlier state. The last checkpoint counts the rows and frames written since
// then, so they are removed only after it has been replaced.
void Job::come_back() {
  for (const auto& output : outputs_) output->series->forget(run_->steps().size());
  for (const auto& keeper : keepers_) keeper->replace();
  for (const auto& output : outputs_) output->series->remove_forgotten();
}

void Job::record(const std::string& path, const std::vector<Column>& columns, double every) {
  for (const Column& column : columns) {
    want_plain(column.name + column.unit, "record: field 'columns'");
    if (!column.value) throw Error("record: column '" + column.name + "': expected a function, got none");
  }
  add(
      {"record", path, "", {}}, every, path, [&] { return std::make_shared<TableSeries>(path, columns); },
      [&](Archive& from) { return std::make_shared<TableSeries>(path, columns, from); });
}

void Job::vtk(const std::string& stem, double every, const VtkContents& contents) {
  const auto checked = [&]() -> const VtkContents& { return check_fields(*run_, contents, "vtk"), contents; };
  add(
      {"vtk", stem, "", {}}, every, stem + ".pvd",
      [&] { return std::make_shared<VtkSeries>(stem, checked()); },
      [&](Archive& from) { return std::make_shared<VtkSeries>(stem, checked(), from); });
}

std::shared_ptr<Keeper> Job::checkpoint(const std::string& path, std::optional<double> every,
                                        std::optional<double> minutes) {
  if (!every && !minutes) minutes = usual_minutes;
  const auto keeper = std::make_shared<Keeper>(*this, path, every, minutes);
  const std::string file = free_path(path);
  system::make_folder_for(path);
  auto lock = journal_->locks.take(path);
  system::remove_leftovers(path);
  system::AtomicFile{path};  // what would prevent writing it in ten minutes is told now
  locks_.push_back(std::move(lock));
  paths_.insert(file);
  keepers_.push_back(keeper);
  run_->when_settled([keeper](Run&) { keeper->look(); });
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
  for (const auto& output : outputs_) output->series->go_on();
  if (seconds_ == 0) write_report("running", 0);
  clock_ = {};
  driving_ = true;
}

void Job::leave(const std::string& status, bool ended, bool broken, const Guarded& guarded) {
  seconds_ += clock_.seconds();
  driving_ = false;
  Run& a = *run_;
  if (ended) {
    for (const auto& output : outputs_)
      guarded([&a, broken, s = output->series.get()] { broken ? s->extra_frame(a) : s->frame(a); });
    for (const auto& keeper : keepers_) guarded([&keeper] { keeper->write(); });
  }
  guarded([&] { write_report(status, seconds_); });
  if (ended) locks_.clear();
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
  } catch (const std::exception& trouble) {
    leave(trouble.what(), true, true, guarded);
    throw;
  } catch (...) {  // a hook may throw what is no exception of the standard library
    leave("an error in a hook", true, true, guarded);
    throw;
  }
  const bool ended = run_->stopped() || run_->time() >= run_->duration() * (1 - 1e-12);
  leave(run_->stopped() ? "stopped: " + run_->stop_reason()
        : ended         ? "done"
                        : "under way",
        ended, false, guarded);
  if (ended) remember_end();
  if (first) std::rethrow_exception(first);
}

// --- run.json

format::Json Job::report(const std::string& status, double seconds) const {
  const Run& run = *run_;
  const model::Model& model = run.model();
  format::Json mine = format::Json::object();
  mine.set("number", number_).set("kind", run.kind()).set("card", model.card().name);
  mine.set("card_hash", hash_text(card::lua_text(model.card()))).set("model", model.describe());
  mine.set("status", status).set("time", run.time()).set("duration", run.duration()).set("seconds", seconds);
  mine.set("steps", steps_json(run)).set("energy_error", run.energy().error);
  mine.set("beyond", beyond_json(run)).set("warnings", warnings_json(run));
  if (run.moves()) mine.set("scaled_inertia", run.scaled_share());
  mine.set("outputs", written_);
  return mine;
}

void Job::write_report(const std::string& status, double seconds) {
  if (written_.empty()) return;
  const format::Json mine = report(status, seconds);
  std::set<std::string> folders;
  for (const std::string& output : written_)
    folders.insert(std::filesystem::path(output).parent_path().string());
  for (const std::string& folder : folders) {
    auto& runs = journal_->folders[folder];
    runs[number_] = mine;
    format::Json json = format::Json::object();
    json.set("program", "fabricsh").set("version", version()).set("build", build_kind());
    json.set("compiler", compiler()).set("instructions", name(best_isa()));
    if (journal_->about) journal_->about(json);
    json.set("threads", omp_get_max_threads());
    format::Json list = format::Json::array();
    for (const auto& [number, record] : runs) list.push(record);
    json.set("runs", list);
    system::write_file((folder.empty() ? "" : folder + "/") + "run.json", json.text(), system::Sync::no,
                       system::Folder::expect);
  }
}

// --- checkpoints

Checkpoint Job::now() {
  Checkpoint c = checkpoint_of(*run_);
  c.number = number_;
  if (journal_->sign) journal_->sign(c);
  c.seconds = seconds();
  if (caller) c.caller = caller();
  for (const auto& output : outputs_) {
    Archive place;
    output->series->keep(place);
    c.parts.push_back({output->kind, output->path, place.bytes()});
  }
  for (const auto& keeper : keepers_) keeper->add_parts(c.parts);
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
    if (keeper->holds_end()) {
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

Keeper::Keeper(Job& job, std::string path, std::optional<double> every, std::optional<double> minutes)
    : job_(job),
      path_(std::move(path)),
      every_(every),
      minutes_(minutes),
      last_(std::chrono::steady_clock::now()) {}

bool Keeper::due() const {
  if (forced_) return true;
  const Run& run = job_.run();
  if (every_ && run.time() >= next_ - same_time * run.duration()) return true;
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - last_;
  return minutes_ && since.count() >= 60 * *minutes_;
}

// The times of `every` are counted from 0 and not from a restart, so that the output does not depend on
// restarts.
void Keeper::look() {
  if (silent_) return;
  const Run& run = job_.run();
  if (every_ && *every_ > 0 && next_ == 0 && written_ == static_cast<std::size_t>(-1)) {
    const auto passed = run.steps().empty() ? 0.0 : run.time() - run.steps().back().step;
    next_ = *every_ * (std::floor(passed / *every_ + 1e-9) + 1);
  }
  if (due()) write();
}

void Keeper::write() {
  if (silent_) return;
  const Run& run = job_.run();
  const std::size_t step = run.steps().size();
  if (step == written_ && !forced_) return;
  try {
    for (const auto& output : job_.outputs()) output->series->sync();
    Checkpoint c = job_.now();
    const std::string file = absolute(path_);
    job_.journal().make_way(file, job_.number());
    c.finished = job_.journal().list_for(std::filesystem::path(file).parent_path().string(), job_.number());
    write_checkpoint(path_, c);
  } catch (const Error& error) {
    throw Error("checkpoint: " + std::string(error.what()) + " (the run is kept at " +
                exact_number(run.time()) + " s; solve() continues it)");
  }
  written_ = step;
  forced_ = false;
  last_ = std::chrono::steady_clock::now();
  if (every_ && *every_ > 0) next_ = *every_ * (std::floor(run.time() / *every_ + 1e-9) + 1);
}

bool Keeper::holds_end() const { return !silent_ && written_ == job_.run().steps().size(); }

void Keeper::replace() {
  forced_ = true;
  if (job_.from() || written_ != static_cast<std::size_t>(-1)) write();
}

}  // namespace fabricsh::run
