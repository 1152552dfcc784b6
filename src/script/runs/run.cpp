// The analysis object in Lua, and its hooks.
#include "script/runs/run.hpp"

#include <algorithm>

#include "base/number.hpp"
#include "script/call/boundary.hpp"
#include "script/call/chain.hpp"
#include "script/runs/drive.hpp"
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

// The innermost Lua function that has led here: of the deck, or of a virtual test, whose fields the deck can
// give.
run::StepField step_field(lua_State* L) {
  lua_Debug frame;
  bool by_library = false;
  for (int level = 1; lua_getstack(L, level, &frame) != 0; ++level) {
    lua_getinfo(L, "Sf", &frame);
    const Entry* entry = entry_of(L, -1);
    lua_pop(L, 1);
    if (*frame.what != 'C') {
      if (!own_module(frame.source)) break;
      by_library = true;
    }
    if (entry == nullptr || !entry->name.starts_with("fabric.lab.")) continue;
    for (const Argument& row : entry->arguments) {
      if (row.name == "step") return run::StepField::step;
      if (row.name == "steps")  // of a chain: a list, whose members have the options of a run
        return (row.kinds & integer) != 0 ? run::StepField::steps : run::StepField::of_run;
    }
    break;
  }
  return by_library ? run::StepField::none : run::StepField::of_run;
}

}  // namespace

DeckRun::DeckRun(Session& s, std::shared_ptr<run::Run> a)
    : session(s), job(a, s.journal(), s.count_analysis()), analysis(std::move(a)) {
  analysis->set_step_field(step_field(s.active()));
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

void forget_steps(DeckRun& run) {
  lua_State* L = run.session.active();
  push_self(L, &run);
  want_alive(L);
  lua_getiuservalue(L, -1, 1);
  lua_pushnil(L);
  lua_setfield(L, -2, step_rows);
  lua_pop(L, 2);
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

std::string Drive::words() const {
  constexpr const char* calls[] = {"solve", "advance", "step", "reach", "restore"};
  return std::string(calls[static_cast<std::size_t>(made)]) + "(" +
         (made == CallKind::advance ? exact_number(target) : "") + ")";
}

bool Calls::restored_after(std::int64_t call) const {
  return std::any_of(made.begin() + std::min(call, static_cast<std::int64_t>(made.size())), made.end(),
                     [](const Drive& drive) { return drive.made == CallKind::restore; });
}

bool Notes::put(const std::string& key, std::string value) {
  const std::string* old = find(key);
  const std::size_t rest = bytes_ - (old != nullptr ? key.size() + old->size() : 0);
  const std::size_t wanted = key.size() + value.size();
  full_ = full_ || wanted > most_bytes || rest > most_bytes - wanted;
  if (full_) return false;
  bytes_ = rest + wanted;
  notes_[key] = std::move(value);
  return true;
}

void Notes::keep(Archive& archive) {
  std::vector<std::string> keys, values;
  for (const auto& [key, value] : notes_) {
    keys.push_back(key);
    values.push_back(value);
  }
  archive(keys, values, full_);
  if (!archive.reading()) return;
  if (keys.size() != values.size()) throw Error("what the deck has read is damaged");
  notes_.clear();
  bytes_ = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    bytes_ += keys[i].size() + values[i].size();
    notes_[keys[i]] = std::move(values[i]);
  }
}

}  // namespace fabricsh::script
