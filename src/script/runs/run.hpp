// A run as Lua sees it: the run of the core, its calls, its hooks.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "run/job.hpp"
#include "run/run.hpp"
#include "script/call/call.hpp"
#include "script/values/classes.hpp"

namespace fabricsh::script {

enum class CallKind : std::uint8_t { solve, advance, step, reach, restore };

// A call, with its target time.
struct Drive {
  CallKind made = CallKind::solve;
  double target = 0;       // s; of advance(), and for the progress of others
  std::uint64_t from = 0;  // number of steps before it
  void keep(Archive& archive) { archive(made, target, from); }
  bool same(const Drive& other) const {
    return made == other.made && (made != CallKind::advance || target == other.target);
  }
  std::string words() const;  // "advance(0.5)"
};

struct FailedCall {
  std::int64_t call = 0;
  bool numerical = false;
  std::string message;
  double time = 0;
  std::int64_t element = -1;
  std::string yarn, why;
  std::string value;  // a value raised by a hook, packed as a table with one entry; empty: there is a message
  void keep(Archive& archive) { archive(call, numerical, message, time, element, yarn, why, value); }
};

// Values by key, up to a total size.
class Notes {
 public:
  static constexpr std::size_t most_bytes = std::size_t{32} << 20;

  const std::string* find(const std::string& key) const {
    const auto found = notes_.find(key);
    return found == notes_.end() ? nullptr : &found->second;
  }
  // False: there is no room for it, and from now on for none, so that what is missing is the end.
  bool put(const std::string& key, std::string value);
  bool full() const { return full_; }
  void keep(Archive& archive);

 private:
  std::map<std::string, std::string> notes_;
  std::size_t bytes_ = 0;
  bool full_ = false;
};

struct Calls {
  std::int64_t count = 0;    // including the present one
  std::int64_t changes = 0;  // of settings or by stop() since the last call
  std::vector<Drive> made;   // all of them, in their order
  std::vector<FailedCall> failed;
  // Whether a call after this one has returned to a snapshot.
  bool restored_after(std::int64_t call) const;
  Notes read;    // results, by the moment and the expression
  Notes tables;  // kept tables at the ends of calls that changed them
  void keep(Archive& archive) {
    archive.section("calls", [&] { archive(count, made, failed, read, tables); });
  }
};

struct DeckRun;

// A Lua function (or table) kept by an analysis object instead of the registry, so that a hook can refer to
// its own analysis and both can still be collected.
class Hook {
 public:
  Hook(const Fields& fields, std::string_view name, DeckRun* run);
  // Pushes the function and the analysis object; returns the state on which to call it.
  lua_State* push() const;
  // For as long as the result exists, the function cannot (Still) or can (Free) change its analysis.
  ChangeRefused still() const;
  ChangeAllowed free() const;

 private:
  DeckRun* run_;
  int slot_;
};

// A table of the deck that checkpoints store.
struct KeptTable {
  Hook table;
  std::string restored;    // its content in the checkpoint of a restarted deck; empty: not there
  std::string at_begin{};  // its content when the present call began
  std::string at_step{};   // at the end of the last step, where events are asked for their values
};

// An analysis as seen from Lua: the run, its outputs, the functions that it calls.
struct DeckRun {
  DeckRun(Session& s, std::shared_ptr<run::Run> a);
  Session& session;
  run::Job job;
  std::shared_ptr<run::Run> analysis;                   // the one of the job
  std::int64_t number() const { return job.number(); }  // among the analyses of the session, from 1

  Calls calls;
  // For a restarted deck: the calls made before the checkpoint; those below `passing` are skipped.
  Calls before;
  bool same_deck = false;
  std::int64_t passing = 0;
  bool passes_over() const { return calls.count < passing; }
  std::vector<std::shared_ptr<const run::Run::Snapshot>> passed_snapshots;
  std::vector<KeptTable> kept_tables;
  bool has_events = false;  // whose values the deck computes, also in steps that are taken back
  std::string lost;         // why a restarted deck cannot go on with this run; empty: it can
};

template <>
struct ClassName<DeckRun> {
  static constexpr const char* name = "analysis";
};

void push_run(lua_State* L, std::shared_ptr<DeckRun> run);

// Field of the values that Lua keeps for a run: the rows of the steps that a deck has looked at. They are
// forgotten where the run goes back, or over to a checkpoint.
inline constexpr const char* step_rows = "steps";
void forget_steps(DeckRun& run);

}  // namespace fabricsh::script
