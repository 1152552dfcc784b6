// A run as Lua sees it: the run of the core, its calls, its hooks.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "run/job.hpp"
#include "run/run.hpp"
#include "script/call/call.hpp"
#include "script/runs/calls.hpp"
#include "script/values/classes.hpp"

namespace fabricsh::script {

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

}  // namespace fabricsh::script
