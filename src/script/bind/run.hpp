// Shared by the bindings of models and analyses.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "run/job.hpp"
#include "run/run.hpp"
#include "script/bind/rooms.hpp"

namespace fabricsh::script {

template <>
struct ClassName<model::Model> {
  static constexpr const char* name = "model";
};

// A call of step(), or of solve() or advance() with its target time.
struct Drive {
  bool single = false;
  double target = 0;       // s
  std::uint64_t from = 0;  // number of steps before it
  void keep(Archive& archive) { archive(single, target, from); }
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

// The results of the deck's calls, as its checkpoints store them.
struct Calls {
  std::int64_t count = 0;  // of solve, advance, step and restore, including the present one
  Drive under_way;
  std::vector<FailedCall> failed;
  void keep(Archive& archive) {
    archive.section("calls", [&] { archive(count, under_way, failed); });
  }
};

// An analysis as seen from Lua: the run, its outputs, the functions that it calls.
struct Run {
  Run(Session& s, std::shared_ptr<run::Run> a);
  Session& session;
  run::Job job;
  std::shared_ptr<run::Run> analysis;                   // the one of the job
  std::int64_t number() const { return job.number(); }  // among the analyses of the session, from 1

  Calls calls;
  // For a restarted deck: the calls made before the checkpoint; those below `passing` are skipped.
  Calls before;
  bool same_deck = false;
  std::int64_t passing = 0;
  std::vector<std::shared_ptr<const run::Run::Snapshot>> passed_snapshots;
};

template <>
struct ClassName<Run> {
  static constexpr const char* name = "analysis";
};

// A Lua function (or table) kept by an analysis object instead of the registry, so that a hook can refer to
// its own analysis and both can still be collected.
class Hook {
 public:
  Hook(const Fields& fields, std::string_view name, Run* run);
  // Pushes the function and the analysis object; returns the state on which to call it.
  lua_State* push() const;
  // For as long as the result exists, the function cannot (Still) or can (Free) change its analysis.
  Still still() const { return {run_->session, run_}; }
  Free free() const { return {run_->session, run_}; }

 private:
  Run* run_;
  int slot_;
};

// The argument that says what a run does when it strains cloth beyond the tested range of its card.
Argument limit_row();

// For examples: defines fabric, mesh, m and a, a strip of three elements pulled in 4 steps.
std::string sample_run();

void push_run(lua_State* L, std::shared_ptr<Run> run);
void bind_point(Session& session);
void bind_model(Session& session);
void bind_files(Session& session);
void bind_plot(Session& session);
void bind_render(Session& session);
void bind_analysis(Session& session);
void bind_static(Session& session);
void bind_dynamic(Session& session);
void bind_outputs(Session& session);
void bind_keep(Session& session);
void bind_check(Session& session);
void bind_table(Session& session);
void bind_lab(Session& session);
void bind_track(Session& session);
void bind_identify(Session& session);
void bind_sample(Session& session);

}  // namespace fabricsh::script
