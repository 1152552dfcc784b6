// What the bindings of models and analyses share.
#pragma once
#include <set>

#include "analysis/run.hpp"
#include "script/bind.hpp"

namespace fabricsh::script {

template <>
struct ClassName<model::Model> {
  static constexpr const char* name = "model";
};

// A run.json beside the outputs of a run: what made them.
class RunRecord {
 public:
  explicit RunRecord(const Session& session) : session_(session) {}
  void add_output(const std::string& path) { outputs_.push_back(path); }
  // Writes one run.json into each folder that holds an output; nothing without outputs.
  void write(const analysis::Run& run, const std::string& status, double seconds) const;

 private:
  const Session& session_;
  std::vector<std::string> outputs_;
};

// An analysis as Lua sees it: the run, its outputs, the functions that it calls.
struct Run {
  Run(Session& s, std::shared_ptr<analysis::Run> a) : session(s), analysis(std::move(a)), record(s) {}
  Session& session;
  std::shared_ptr<analysis::Run> analysis;
  RunRecord record;
  std::vector<std::function<void()>> finish;  // writes the last frame of each output
  std::set<std::string> paths;                // of the outputs
  double seconds = 0;                         // spent so far
};

template <>
struct ClassName<Run> {
  static constexpr const char* name = "analysis";
};

// A Lua function kept by an analysis object (not by the registry, so that a hook may mention its own analysis
// and both are still collected).
class Hook {
 public:
  Hook(const Fields& fields, std::string_view name, Run* run);
  // Pushes the function and the analysis object; returns the state to call on.
  lua_State* push() const;

 private:
  Run* run_;
  int slot_;
};

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
void bind_check(Session& session);
void bind_table(Session& session);
void bind_lab(Session& session);
void bind_track(Session& session);
void bind_identify(Session& session);
void bind_sample(Session& session);

}  // namespace fabricsh::script
