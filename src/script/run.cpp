// The analysis object in Lua, its hooks, and run.json.
#include <omp.h>

#include <filesystem>
#include <set>

#include "base/hash.hpp"
#include "base/isa.hpp"
#include "base/version.hpp"
#include "files/atomic.hpp"
#include "files/json.hpp"
#include "files/source.hpp"
#include "script/bind_run.hpp"
#include "script/checkpoint.hpp"

namespace fabricsh::script {

namespace {

// Registry table from the address of a Run to its userdata; weak, so that it keeps none alive.
constexpr const char* runs_key = "fabricsh.runs";

void push_runs(lua_State* L) {
  if (lua_getfield(L, LUA_REGISTRYINDEX, runs_key) == LUA_TTABLE) return;
  lua_pop(L, 1);
  lua_newtable(L);
  lua_newtable(L);
  lua_pushliteral(L, "v");
  lua_setfield(L, -2, "__mode");
  lua_setmetatable(L, -2);
  lua_pushvalue(L, -1);
  lua_setfield(L, LUA_REGISTRYINDEX, runs_key);
}

void push_self(lua_State* L, const Run* run) {
  push_runs(L);
  lua_rawgetp(L, -1, run);
  lua_remove(L, -2);
}

// In a finaliser of the deck's the weak table of runs has forgotten one that goes away with it.
void want_alive(lua_State* L) {
  if (lua_type(L, -1) != LUA_TUSERDATA) throw Error("this analysis is being collected");
}

std::string hash_text(const std::string& bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "fnv1a64:%016llx", static_cast<unsigned long long>(hash(bytes)));
  return text;
}

}  // namespace

std::string file_bytes(const std::string& path) {
  try {
    return path.empty() ? "" : files::read_file(path);
  } catch (const Error&) {  // a deck that is gone by now has no hash
    return {};
  }
}

namespace {

files::Json steps_json(const analysis::Run& run) {
  std::int64_t iterations = 0, cuts = 0;
  double worst = 0;
  for (const auto& step : run.steps()) {
    iterations += step.iterations;
    cuts += step.cuts;
    if (!step.residuals.empty()) worst = std::max(worst, step.residuals.back());
  }
  files::Json json = files::Json::object();
  json.set("count", run.steps().size()).set("iterations", iterations).set("cuts", cuts);
  json.set("largest_final_residual", worst).set("tolerance", run.tolerance());
  return json;
}

files::Json beyond_json(const analysis::Run& run) {
  const auto far = run.beyond();
  if (!far) return {};
  files::Json json = files::Json::object();
  json.set("share", far->share).set("yarn", far->yarn).set("element", far->element + 1);
  json.set("time", far->time).set("first", far->first);
  return json.set("strain", far->strain).set("tested", far->tested);
}

files::Json program_json(const Options& options) {
  files::Json json = files::Json::object();
  json.set("program", "fabricsh").set("version", version()).set("build", build_kind());
  json.set("compiler", compiler()).set("lua", LUA_RELEASE).set("instructions", name(best_isa()));
  json.set("deck", options.deck).set("deck_hash", hash_text(file_bytes(options.deck)));
  return json.set("arguments", options.command_line).set("threads", omp_get_max_threads());
}

}  // namespace

std::string sample_run() {
  return "local fabric = require 'fabric'\n"
         "local mesh = fabric.mesh.rectangle{ width=0.0254, height=0.0762, nx=1, ny=3 }\n"
         "local m = fabric.model{ mesh=mesh, card=fabric.card 'blend', warp=90 }\n"
         "m:fix('all', 'z rotation'):fix('bottom', 'x y'):fix('top', 'x'):move('top', { y=fabric.ramp(0.018, "
         "1) })\n"
         "local a = fabric.static{ model=m, duration=1, step=0.25 }\n";
}

void push_run(lua_State* L, std::shared_ptr<Run> run) {
  const Run* address = run.get();
  if (const auto& checkpoint = run->session.restart()) {
    const auto mine = part_of(checkpoint, run->number);
    if (mine == checkpoint)
      begin_from(*run, mine);
    else if (mine)
      begin_finished(*run, mine);
  }
  push_object(L, std::move(run));
  lua_newtable(L);
  lua_setiuservalue(L, -2, 1);
  push_runs(L);
  lua_pushvalue(L, -2);
  lua_rawsetp(L, -2, address);
  lua_pop(L, 1);
}

Hook::Hook(const Fields& fields, std::string_view name, Run* run) : run_(run) {
  lua_State* L = fields.L();
  push_self(L, run);
  want_alive(L);
  lua_getiuservalue(L, -1, 1);
  slot_ = static_cast<int>(lua_rawlen(L, -1)) + 1;
  fields.push(name);
  lua_rawseti(L, -2, slot_);
  lua_pop(L, 2);
}

lua_State* Hook::push() const {
  if (run_->session.options().clear_progress) run_->session.options().clear_progress();
  lua_State* L = run_->session.active();
  luaL_checkstack(L, 8, "too many nested callbacks");
  push_self(L, run_);
  want_alive(L);
  lua_getiuservalue(L, -1, 1);
  lua_rawgeti(L, -1, slot_);
  lua_replace(L, -2);
  lua_insert(L, -2);
  return L;
}

void RunRecord::write(const analysis::Run& run, const std::string& status, double seconds) const {
  if (outputs_.empty()) return;
  const model::Model& model = run.model();
  files::Json mine = files::Json::object();
  mine.set("number", number_).set("kind", run.kind()).set("card", model.card().name);
  mine.set("card_hash", hash_text(card_text(model.card()))).set("model", model.describe());
  mine.set("status", status).set("time", run.time()).set("duration", run.duration()).set("seconds", seconds);
  mine.set("steps", steps_json(run)).set("energy_error", run.energy().error);
  mine.set("beyond", beyond_json(run));
  if (run.moves()) mine.set("scaled_inertia", run.scaled_share());
  mine.set("outputs", outputs_);
  std::set<std::string> folders;
  for (const std::string& output : outputs_)
    folders.insert(std::filesystem::path(output).parent_path().string());
  for (const std::string& folder : folders) {
    auto& runs = session_.run_records().folders[folder];
    runs[number_] = mine;
    files::Json json = program_json(session_.options());
    files::Json list = files::Json::array();
    for (const auto& [number, record] : runs) list.push(record);
    json.set("runs", list);
    files::write_file((folder.empty() ? "" : folder + "/") + "run.json", json.text(), files::Sync::no,
                      files::Folder::expect);
  }
}

}  // namespace fabricsh::script
