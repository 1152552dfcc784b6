#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/number.hpp"
#include "format/source.hpp"
#include "script/runs/drive.hpp"
#include "system/gate.hpp"

namespace fabricsh::script {

namespace {

std::string file_bytes(const std::string& path) {
  try {
    return path.empty() ? "" : format::read_file(path);
  } catch (const Error&) {  // a deck that no longer exists has no hash
    return {};
  }
}

// The hash of the deck's text and arguments.
std::uint64_t deck_hash(const SessionOptions& options) {
  std::string all = file_bytes(options.deck);
  for (const std::string& argument : options.arguments) all += '\0' + argument;
  return hash(all);
}

// The calls that were made before the checkpoint was written. Error: damaged.
Calls calls_of(const run::Checkpoint& checkpoint) {
  Calls calls;
  try {
    Archive archive(checkpoint.caller);
    archive(calls);
  } catch (const Error& error) {
    throw Error("checkpoint '" + checkpoint.path + "': " + error.what());
  }
  return calls;
}

}  // namespace

run::Journal journal_of(const SessionOptions& options) {
  run::Journal journal;
  journal.about = [&options](format::Json& json) {
    json.set("lua", LUA_RELEASE).set("deck", options.deck);
    json.set("deck_hash", run::hash_text(file_bytes(options.deck))).set("arguments", options.command_line);
  };
  journal.sign = [&options](run::Checkpoint& checkpoint) {
    checkpoint.deck = options.deck;
    checkpoint.deck_hash = deck_hash(options);
  };
  return journal;
}

std::shared_ptr<const run::Checkpoint> load_checkpoint(const std::string& path) {
  if (system::Gate::of_process().closed())
    throw Error("checkpoint '" + path +
                "': not read under --safe: a manipulated file could make the run write where it must not");
  return run::read_checkpoint(path);
}

std::shared_ptr<const run::Checkpoint> part_of(const std::shared_ptr<const run::Checkpoint>& checkpoint,
                                               std::int64_t analysis) {
  if (checkpoint->number == analysis) return checkpoint;
  const auto* finished = checkpoint->finished_run(analysis);
  return finished == nullptr ? nullptr : run::read_finished(*checkpoint, *finished);
}

void begin_from(DeckRun& run, std::shared_ptr<const run::Checkpoint> checkpoint) {
  const SessionOptions& options = run.session.options();
  run.same_deck = checkpoint->deck_hash == deck_hash(options);
  run.before = calls_of(*checkpoint);
  run.job.begin_from(checkpoint);
  if (options.deck.empty() || run.same_deck) return;
  const std::string words = "restart: the deck or its arguments are not those that wrote '" +
                            checkpoint->path + "'; the problem is the same, so the run goes on";
  run.session.notices().once("restart", words);
  run.analysis->note("restart", words);
}

void begin_finished(DeckRun& run, std::shared_ptr<const run::Checkpoint> checkpoint) {
  const std::string differs = run::difference(*checkpoint, *run.analysis);
  if (!differs.empty())
    return run.session.notices().say("restart: analysis " + std::to_string(run.number()) +
                                     " is run again: it differs from the finished one in '" +
                                     checkpoint->path + "' in " + differs);
  const auto& begun = *run.session.restart();
  const auto& finished = *begun.finished_run(run.number());
  run.job.journal().finished[run.number()] = {run::file_of(begun, finished), finished.hash};
  begin_from(run, std::move(checkpoint));
}

namespace {

// A run that was stopped, or is at its end, has nothing to go on with by itself.
std::string where_it_stands(const run::Run& run) {
  if (run.stopped())
    return ", where the run was stopped (" + run.stop_reason() +
           "): that call is over, and only a further solve() of the deck makes steps";
  return run.time() >= run.duration() * (1 - 1e-12) ? ", its end: no step is left" : "";
}

}  // namespace

void take_up(DeckRun& run) {
  if (!run.job.from() || run.job.taken_up()) return;
  const run::Checkpoint& c = *run.job.from();
  run.job.take_up();
  run.calls.made = run.before.made;
  run.calls.failed = run.before.failed;
  run.calls.read = run.before.read;
  run.calls.tables = run.before.tables;
  for (const FailedCall& failed : run.before.failed)
    if (failed.numerical) run.analysis->remember_why(failed.why);
  const auto& begun = run.session.restart();
  const bool finished = begun != nullptr && begun->number != c.number;
  run.session.notices().say(
      "restart: " + (finished ? "analysis " + std::to_string(c.number) + " is finished, " : "") + "from '" +
      c.path + "' at time " + exact_number(c.time) + " s" + where_it_stands(*run.analysis));
}

void restart(DeckRun& run, std::shared_ptr<const run::Checkpoint> checkpoint) {
  if (run.job.driving()) throw Error("not from a hook of the same run");
  const ChangeRefused still(run.session, &run);
  forget_steps(run);
  begin_from(run, std::move(checkpoint));
  take_up(run);
  run.passing = 0;
}

}  // namespace fabricsh::script
