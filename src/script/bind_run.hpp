// What the bindings of models and analyses share.
#pragma once
#include <chrono>
#include <map>
#include <set>

#include "analysis/run.hpp"
#include "files/json.hpp"
#include "output/series.hpp"
#include "script/bind.hpp"

namespace fabricsh::script {

template <>
struct ClassName<model::Model> {
  static constexpr const char* name = "model";
};

// What a session knows of its analyses, by their numbers.
struct RunRecords {
  // What the run.json of each folder says of those that write there.
  std::map<std::string, std::map<std::int64_t, files::Json>> folders;
  // Of those that are finished and were kept (a:checkpoint): the bytes of a checkpoint of their end, which
  // the checkpoints of the others hold too.
  std::map<std::int64_t, std::string> finished;
};

// A run.json beside the outputs of a run: what made them.
class RunRecord {
 public:
  RunRecord(Session& session, std::int64_t number) : session_(session), number_(number) {}
  void add_output(const std::string& path) { outputs_.push_back(path); }
  // Writes one run.json into each folder that holds an output, with the session's other runs there; nothing
  // without outputs.
  void write(const analysis::Run& run, const std::string& status, double seconds) const;

 private:
  Session& session_;
  std::int64_t number_;
  std::vector<std::string> outputs_;
};

class Keeper;

// A table or series of the run's.
struct Output {
  std::string kind, path;  // "record" or "vtk", as given
  std::string file;        // its full path
  std::shared_ptr<output::Series> series;
  std::size_t hook = 0;  // that writes it
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

class Clock {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// An analysis as Lua sees it: the run, its outputs, the functions that it calls.
struct Run {
  Run(Session& s, std::shared_ptr<analysis::Run> a)
      : session(s), number(s.count_analysis()), analysis(std::move(a)), record(s, number) {}
  Session& session;
  std::int64_t number;  // among the analyses of the session, from 1
  std::shared_ptr<analysis::Run> analysis;
  RunRecord record;
  std::vector<std::shared_ptr<Output>> outputs;
  std::vector<std::shared_ptr<Keeper>> checkpoints;
  std::set<std::string> paths;  // of the outputs and checkpoints
  double seconds = 0;           // spent before the call under way
  Clock clock;                  // of that call
  bool clock_runs = false;
  double seconds_now() const { return seconds + (clock_runs ? clock.seconds() : 0); }

  std::int64_t calls = 0;  // of solve, advance, step and restore, the one under way too
  Drive under_way;
  std::vector<FailedCall> failed;
  // Restarted: what it begins from, whether it has; calls below `passing` lie before it.
  std::shared_ptr<const Checkpoint> from;
  bool taken_up = false, same_deck = false;
  std::int64_t passing = 0;
  std::map<std::size_t, std::string> claimed;  // parts of that checkpoint, and the path each goes on with
  bool went_on = false;                        // from there: outputs made later are new
  std::vector<std::shared_ptr<const analysis::Run::Snapshot>> passed_snapshots;
};

template <>
struct ClassName<Run> {
  static constexpr const char* name = "analysis";
};

// Absolute. Error: the run writes there already.
std::string free_path(const Run& run, const std::string& path);

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

// A pull of a strip of three elements in 4 steps, for examples: fabric, mesh, m and a.
std::string sample_run();

std::string file_bytes(const std::string& path);  // empty: it can't be read

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
