// What the bindings of models and analyses share.
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

// A call of solve() and advance(), with the time that it goes to, or of step().
struct Drive {
  bool single = false;
  double target = 0;       // s
  std::uint64_t from = 0;  // steps done before it
  void keep(Archive& archive) { archive(single, target, from); }
};
struct FailedCall {
  std::int64_t call = 0;
  bool numerical = false;
  std::string message;
  double time = 0;
  std::int64_t element = -1;
  std::string yarn, why;
  std::string value;  // that a hook raised, as a packed table of one; empty: there is a message
  void keep(Archive& archive) { archive(call, numerical, message, time, element, yarn, why, value); }
};

// What a deck's calls came to, as its checkpoints keep it.
struct Calls {
  std::int64_t count = 0;  // of solve, advance, step and restore, the one under way too
  Drive under_way;
  std::vector<FailedCall> failed;
  void keep(Archive& archive) {
    archive.section("calls", [&] { archive(count, under_way, failed); });
  }
};

// An analysis as Lua sees it: the run, its outputs, the functions that it calls.
struct Run {
  Run(Session& s, std::shared_ptr<run::Run> a);
  Session& session;
  run::Job job;
  std::shared_ptr<run::Run> analysis;                   // the job's
  std::int64_t number() const { return job.number(); }  // among the analyses of the session, from 1

  Calls calls;
  // Restarted: the calls until then, those below `passing` lie before it.
  Calls before;
  bool same_deck = false;
  std::int64_t passing = 0;
  std::vector<std::shared_ptr<const run::Run::Snapshot>> passed_snapshots;
};

template <>
struct ClassName<Run> {
  static constexpr const char* name = "analysis";
};

// A Lua function (or table) kept by an analysis object (not by the registry, so that a hook may mention its
// own analysis and both are still collected).
class Hook {
 public:
  Hook(const Fields& fields, std::string_view name, Run* run);
  // Pushes the function and the analysis object; returns the state to call on.
  lua_State* push() const;
  // While one of these lives, the function is asked for a value, or may change its analysis.
  Still still() const { return {run_->session, run_}; }
  Free free() const { return {run_->session, run_}; }

 private:
  Run* run_;
  int slot_;
};

// What a run does that strains cloth beyond what its card was tested to.
Argument limit_row();

// A pull of a strip of three elements in 4 steps, for examples: fabric, mesh, m and a.
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
