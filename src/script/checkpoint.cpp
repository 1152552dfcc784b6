#include "script/checkpoint.hpp"

#include <algorithm>
#include <cmath>

#include "base/hash.hpp"
#include "base/isa.hpp"
#include "base/version.hpp"
#include "files/checkpoint.hpp"
#include "files/gate.hpp"
#include "script/lua_table.hpp"
#include "script/words.hpp"

namespace fabricsh::script {

namespace {

void add_part(model::Fingerprint& parts, const std::string& name, const std::string& text,
              const std::string& bytes) {
  parts.push_back({name, text, hash(bytes)});
}

// All that a run's state hangs on.
model::Fingerprint problem_of(const analysis::Run& a) {
  model::Fingerprint parts;
  add_part(parts, "method", a.method(), a.method());
  const std::string duration = number_text(a.duration()) + " s";
  add_part(parts, "duration", duration, duration);
  if (const std::string kernels = a.kernels(); !kernels.empty())
    add_part(parts, "BLAS kernels (the bits of a solve hang on them; OPENBLAS_CORETYPE chooses)", kernels,
             kernels);
  const model::Model& m = a.model();
  std::string cards;
  for (const auto& region : m.regions()) {
    cards += card_text(region.card);
    for (const auto& ply : region.options.plies) cards += card_text(ply.card);
  }
  add_part(parts, "card", m.card().name, cards);
  for (auto& part : model::fingerprint(m, a.duration())) parts.push_back(std::move(part));
  return parts;
}

// Of the deck's text and arguments.
std::uint64_t deck_hash(const Options& options) {
  std::string all = file_bytes(options.deck);
  for (const std::string& argument : options.arguments) all += '\0' + argument;
  return hash(all);
}

Checkpoint checkpoint_of(Run& run) {
  analysis::Run& a = *run.analysis;
  const Options& options = run.session.options();
  Checkpoint c;
  c.version = version();
  c.instructions = name(best_isa());
  c.deck = options.deck;
  c.deck_hash = deck_hash(options);
  c.analysis = run.number;
  c.problem = problem_of(a);
  c.time = a.time();
  c.state = a.kept();
  Archive settings;
  a.keep_settings(settings);
  c.settings = settings.bytes();
  c.calls = run.calls;
  c.under_way = run.under_way;
  c.failed = run.failed;
  c.seconds = run.seconds_now();
  for (const auto& output : run.outputs) {
    Archive place;
    output->series->keep(place);
    c.parts.push_back({output->kind, output->path, place.bytes()});
  }
  for (const auto& keeper : run.checkpoints) keeper->add_table(c.parts);
  return c;
}

std::string part_text(const std::string& kind, const std::string& path) {
  if (kind == "keep") return "kept table of checkpoint '" + path + "'";
  return (kind == "record" ? "table '" : "series '") + path + "'";
}

}  // namespace

namespace {

std::shared_ptr<Checkpoint> read_checkpoint(const std::string& path, std::string bytes) {
  auto c = std::make_shared<Checkpoint>();
  Archive archive(std::move(bytes));
  const auto refuse = [&](const std::string& why) { throw Error("checkpoint '" + path + "': " + why); };
  try {
    archive(c->version);
    if (c->version != version()) refuse("it was written by version " + c->version + ", this is " + version());
    archive(c->instructions, c->deck, c->deck_hash, c->analysis, c->problem, c->time, c->state, c->settings);
    archive(c->calls, c->under_way, c->failed, c->seconds, c->parts, c->finished);
  } catch (const Error& error) {
    if (std::string(error.what()).starts_with("checkpoint ")) throw;
    refuse(std::string("it is damaged: ") + error.what());
  }
  if (!archive.at_end()) refuse("it is damaged: there is more in it than belongs there");
  if (c->instructions != name(best_isa()))
    refuse("it was written with the instructions " + c->instructions + ", this machine has " +
           name(best_isa()) + ": its bits would not be the same");
  c->path = path;
  return c;
}

}  // namespace

std::shared_ptr<const Checkpoint> load_checkpoint(const std::string& path) {
  if (files::Gate::of_process().closed())
    throw Error("checkpoint '" + path +
                "': not read under --safe: a file made up for it could make the run write where it must not");
  auto c = read_checkpoint(path, files::read_checkpoint(path));
  for (const std::string& bytes : c->finished) c->others.push_back(read_checkpoint(path, bytes));
  return c;
}

std::shared_ptr<const Checkpoint> part_of(const std::shared_ptr<const Checkpoint>& checkpoint,
                                          std::int64_t analysis) {
  if (checkpoint->analysis == analysis) return checkpoint;
  for (const auto& other : checkpoint->others)
    if (other->analysis == analysis) return other;
  return nullptr;
}

namespace {

std::string bytes_of(Checkpoint checkpoint) {
  Archive archive;
  checkpoint.keep(archive);
  return archive.bytes();
}

void begin(Run& run, std::shared_ptr<const Checkpoint> checkpoint) {
  const Options& options = run.session.options();
  run.same_deck = checkpoint->deck_hash == deck_hash(options);
  if (!options.deck.empty() && !run.same_deck)
    run.session.notices().once("restart", "restart: the deck or its arguments are not those that wrote '" +
                                              checkpoint->path +
                                              "'; the problem is the same, so the run goes on");
  run.from = std::move(checkpoint);
  run.claimed.clear();
  run.went_on = false;
}

}  // namespace

void begin_from(Run& run, std::shared_ptr<const Checkpoint> checkpoint) {
  const std::string differs = difference(checkpoint->problem, problem_of(*run.analysis));
  if (!differs.empty())
    throw Error("checkpoint '" + checkpoint->path + "' is of another problem: it differs in " + differs);
  begin(run, std::move(checkpoint));
}

void begin_finished(Run& run, std::shared_ptr<const Checkpoint> checkpoint) {
  const std::string differs = difference(checkpoint->problem, problem_of(*run.analysis));
  if (!differs.empty())
    return run.session.notices().say("restart: analysis " + std::to_string(run.number) +
                                     " is done anew: it differs from the finished one in '" +
                                     checkpoint->path + "' in " + differs);
  run.session.run_records().finished[run.number] = bytes_of(*checkpoint);
  begin(run, std::move(checkpoint));
}

void remember_end(Run& run) {
  if (run.checkpoints.empty()) return;
  run.session.run_records().finished[run.number] = bytes_of(checkpoint_of(run));
}

void take_up(Run& run) {
  if (!run.from || run.taken_up) return;
  const Checkpoint& c = *run.from;
  try {
    Archive settings(c.settings);
    run.analysis->keep_settings(settings);
    run.analysis->resume(c.state);
  } catch (const Error& error) {
    throw Error("checkpoint '" + c.path + "': it is damaged: " + error.what());
  }
  run.taken_up = true;
  run.failed = c.failed;
  run.seconds = c.seconds;
  const bool finished = run.session.restart() != nullptr && run.session.restart()->analysis != c.analysis;
  run.session.notices().say(
      "restart: " + (finished ? "analysis " + std::to_string(c.analysis) + " is finished, " : "") + "from '" +
      c.path + "' at time " + number_text(c.time) + " s");
}

void restart(Run& run, std::shared_ptr<const Checkpoint> checkpoint) {
  if (run.clock_runs) throw Error("not from a hook of the same run");
  const Still still(run.session, &run);
  if (!run.outputs.empty() || !run.checkpoints.empty())
    throw Error(
        "expected to be called before 'record', 'vtk' and 'checkpoint', which then go on with their files");
  begin_from(run, std::move(checkpoint));
  run.taken_up = false;
  take_up(run);
  run.passing = 0;
}

const std::string* take_part(Run& run, const std::string& kind, const std::string& path) {
  if (!run.from || run.went_on) return nullptr;
  const auto& parts = run.from->parts;
  const auto find = [&](const auto& fits) -> const std::string* {
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i].kind == kind && fits(i)) {
        run.claimed[i] = path;
        return &parts[i].bytes;
      }
    return nullptr;
  };
  const auto is_free = [&](std::size_t i) { return run.claimed.count(i) == 0; };
  const std::string* part = find([&](std::size_t i) { return !is_free(i) && run.claimed[i] == path; });
  if (part == nullptr) part = find([&](std::size_t i) { return is_free(i) && parts[i].path == path; });
  if (part == nullptr) part = find(is_free);
  if (part == nullptr)
    throw Error("checkpoint '" + run.from->path + "': the run that wrote it had no " + part_text(kind, path) +
                " there; new ones can be added after the first solve(), advance() or step()");
  return part;
}

void check_parts(Run& run) {
  if (!run.from || run.went_on) return;
  for (std::size_t i = 0; i < run.from->parts.size(); ++i) {
    const auto& part = run.from->parts[i];
    if (run.claimed.count(i) == 0)
      throw Error("checkpoint '" + run.from->path + "': it has the " + part_text(part.kind, part.path) +
                  ", which nothing of this run goes on with");
  }
  run.went_on = true;
}

Keeper::Keeper(Run& run, std::string path, std::optional<double> every, std::optional<double> minutes)
    : run_(run),
      path_(std::move(path)),
      every_(every),
      minutes_(minutes),
      last_(std::chrono::steady_clock::now()) {}

bool Keeper::due() const {
  if (forced_) return true;
  if (every_ && run_.analysis->time() >= next_ - analysis::same_time * run_.analysis->duration()) return true;
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - last_;
  return minutes_ && since.count() >= 60 * *minutes_;
}

// The times of `every` are counted from 0, whenever the run was taken up: what is written does not hang on
// it.
void Keeper::look() {
  if (silent_) return;
  const double time = run_.analysis->time();
  if (every_ && *every_ > 0 && next_ == 0 && written_ == static_cast<std::size_t>(-1)) {
    const auto passed = run_.analysis->steps().empty() ? 0.0 : time - run_.analysis->steps().back().step;
    next_ = *every_ * (std::floor(passed / *every_ + 1e-9) + 1);
  }
  if (due()) write();
}

void Keeper::add_table(std::vector<Checkpoint::Part>& parts) const {
  if (!table_) return;
  lua_State* L = table_->push();
  parts.push_back({"keep", path_, pack_table(L, -2, "keep")});
  lua_pop(L, 2);
}

void Keeper::write() {
  if (silent_) return;
  const std::size_t step = run_.analysis->steps().size();
  if (step == written_ && !forced_) return;
  try {
    for (const auto& output : run_.outputs) output->series->sync();
    Checkpoint c = checkpoint_of(run_);
    for (const auto& [number, bytes] : run_.session.run_records().finished)
      if (number != run_.number) c.finished.push_back(bytes);
    files::write_checkpoint(path_, bytes_of(std::move(c)));
  } catch (const Error& error) {
    throw Error("checkpoint: " + std::string(error.what()) + " (the run is alive at " +
                number_text(run_.analysis->time()) + " s, solve() goes on)");
  }
  written_ = step;
  forced_ = false;
  last_ = std::chrono::steady_clock::now();
  const double time = run_.analysis->time();
  if (every_ && *every_ > 0) next_ = *every_ * (std::floor(time / *every_ + 1e-9) + 1);
}

}  // namespace fabricsh::script
