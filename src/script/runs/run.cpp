// The analysis object in Lua, and its hooks.
#include "script/runs/run.hpp"

#include "script/runs/checkpoint.hpp"
#include "script/runs/replay.hpp"
#include "script/runs/watch.hpp"
#include "script/session/warning_log.hpp"

namespace fabricsh::script {

namespace {

// Registry table from the address of a Run to its userdata; weak, so that it keeps no run alive.
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

void push_self(lua_State* L, const DeckRun* run) {
  push_runs(L);
  lua_rawgetp(L, -1, run);
  lua_remove(L, -2);
}

// In a finaliser of the deck the weak table of runs no longer has a run that is being collected.
void want_alive(lua_State* L) {
  if (lua_type(L, -1) != LUA_TUSERDATA)
    throw Error("this analysis is being deleted, no variable holds it any more");
}

}  // namespace

DeckRun::DeckRun(Session& s, std::shared_ptr<run::Run> a)
    : session(s), job(a, s.journal(), s.count_analysis()), analysis(std::move(a)) {
  job.listen(make_watch(*this));
  job.caller = [this] {
    Archive archive;
    archive(calls);
    return archive.bytes();
  };
  job.untraced = [this] { return untraced_tables(*this); };
  // or if it belongs to the part of the run that a restarted deck skips
  job.replaceable = [this](const run::Output& output) { return output.series->failed() || passes_over(); };
}

namespace {

// The run's part of the checkpoint of a restarted deck; null: there is none, or it cannot be used any more.
std::shared_ptr<const run::Checkpoint> own_part(const DeckRun& run) {
  try {
    return run.session.restart() ? part_of(run.session.restart(), run.number()) : nullptr;
  } catch (const Error& error) {
    run.session.notices().say("restart: analysis " + std::to_string(run.number()) +
                              " is run again: " + error.what());
  }
  return nullptr;
}

}  // namespace

void push_run(lua_State* L, std::shared_ptr<DeckRun> run) {
  const DeckRun* address = run.get();
  run->session.log().add(run->analysis->shared_warnings());
  if (run->session.options().strict) run->analysis->be_strict();
  if (const auto mine = own_part(*run)) {
    if (mine == run->session.restart())
      begin_from(*run, mine);
    else
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

Hook::Hook(const Fields& fields, std::string_view name, DeckRun* run) : run_(run) {
  lua_State* L = fields.L();
  push_self(L, run);
  want_alive(L);
  lua_getiuservalue(L, -1, 1);
  slot_ = static_cast<int>(lua_rawlen(L, -1)) + 1;
  fields.push(name);
  lua_rawseti(L, -2, slot_);
  lua_pop(L, 2);
}

ChangeRefused Hook::still() const { return {run_->session, run_}; }

ChangeAllowed Hook::free() const { return {run_->session, run_}; }

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

}  // namespace fabricsh::script
