#include <algorithm>
#include <utility>

#include "base/number.hpp"
#include "script/call/push.hpp"
#include "script/call/words.hpp"
#include "script/runs/drive.hpp"
#include "script/values/lua_table.hpp"
#include "system/gate.hpp"

namespace fabricsh::script {

namespace {

constexpr const char* unpackable = "-";  // noted for results that cannot be stored

// Ends the deck, which has to repeat the calls of the one that wrote the checkpoint.
[[noreturn]] void lose(DeckRun& run, const std::string& why) {
  run.lost = "restart: " + why + "; or run the deck without --restart";
  throw Error(run.lost);
}

std::string after_call(const DeckRun& run) {
  return "after call " + std::to_string(run.calls.count) + " of analysis " + std::to_string(run.number());
}

[[noreturn]] void lose_reading(DeckRun& run, const std::string& what) {
  lose(run, what + " needs the run as it was " + after_call(run) +
                ", which the restart passes over, and checkpoint '" + run.job.from()->path +
                "' has not kept it (kept are plain results, up to " +
                std::to_string(Notes::most_bytes >> 20) +
                " MB, that were read after a:checkpoint was called). Read it in a hook (a:every, a:event), "
                "which a restart does not repeat");
}

[[noreturn]] void lose_beginning(DeckRun& run, const std::string& what) {
  lose(run, what + " begins from the state " + after_call(run) +
                ", which went on after that, and checkpoint '" + run.job.from()->path +
                "' has its later state alone. Let a run from which others begin end before, or go on with it "
                "as a run of its own, from=");
}

// The moment of a reading and the expression, which give one value: a run changes only by calls, and its
// settings by what is counted in `changes`.
std::string key_of(const DeckRun& run, std::string name, std::string arguments) {
  Archive key;
  std::int64_t count = run.calls.count, changes = run.calls.changes;
  key(count, changes, name, arguments);
  return key.bytes();
}

// Results as a packed table: a list with their number as `n`; `self` is the place of the object itself.
std::string pack_results(lua_State* L, int first, int results) {
  lua_createtable(L, results, 2);
  put(L, "n", results);
  for (int i = 1; i <= results; ++i) {
    const bool self = lua_rawequal(L, first + i - 1, 1) != 0;
    if (self)
      lua_pushinteger(L, i);
    else
      lua_pushvalue(L, first + i - 1);
    self ? lua_setfield(L, -2, "self") : lua_rawseti(L, -2, i);
  }
  std::string bytes = unpackable;
  try {
    bytes = pack_table(L, -1, "result");
  } catch (const Error&) {  // an object of the program: a restart cannot make it again
  }
  lua_pop(L, 1);
  return bytes;
}

int push_results(lua_State* L, const std::string& bytes) {
  lua_newtable(L);
  const int table = lua_gettop(L);
  fill_table(L, table, bytes);
  lua_getfield(L, table, "n");
  lua_getfield(L, table, "self");
  const lua_Integer count = lua_tointeger(L, -2), self = lua_tointeger(L, -1);
  lua_pop(L, 2);
  luaL_checkstack(L, static_cast<int>(count) + 4, "results");
  for (lua_Integer i = 1; i <= count; ++i) i == self ? lua_pushvalue(L, 1) : (void)lua_rawgeti(L, table, i);
  lua_remove(L, table);
  return static_cast<int>(count);
}

void put(DeckRun& run, Notes& notes, const std::string& key, std::string value) {
  if (notes.put(key, std::move(value))) return;
  run.session.notices().once(
      "notes",
      "warning: checkpoint: what the deck reads of a run between its calls, and its kept tables then, "
      "exceed " +
          std::to_string(Notes::most_bytes >> 20) +
          " MB and are no longer kept: a restarted deck that passes over such a reading ends there with an "
          "error; read in hooks (a:every, a:event) instead");
}

bool notes_readings(const DeckRun& run) {
  return run.calls.count > 0 && !run.job.driving() && !run.job.keepers().empty();
}

// The argument's value as bytes. Error: it cannot be named.
void add_value(lua_State* L, const DeckRun& run, const Fields& fields, const Argument& row, Archive& bytes) {
  std::string name = row.name, value;
  if (fields.push(row.name) == LUA_TUSERDATA) {
    if (const auto body = to_object<const model::Rigid>(L, -1)) {
      value = "body " + std::to_string(run.analysis->body_number(*body));
    } else {
      const auto gas = to_object<const model::GasGiven>(L, -1);
      if (!gas) throw Error("an object that cannot be named");
      const auto& gases = run.analysis->model().all<model::GasPointer>();
      value = "gas " + std::to_string(std::find(gases.begin(), gases.end(), gas) - gases.begin());
    }
  } else if (!lua_isnil(L, -1) && (row.kinds & ValueKind::fields) != 0 && lua_istable(L, -1) &&
             !row.rows.empty()) {
    const Fields inner = fields.fields(row.name);
    for (const Argument& one : row.rows) add_value(L, run, inner, one, bytes);
    lua_pop(L, 1);
  } else if (!lua_isnil(L, -1)) {
    lua_createtable(L, 1, 0);
    lua_pushvalue(L, -2);
    lua_rawseti(L, -2, 1);
    value = pack_table(L, -1, row.name);
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  bytes(name, value);
}

std::string replayed_arguments(const Call& call, const DeckRun& run) {
  Archive bytes;
  for (const Argument& row : call.entry().arguments) add_value(call.L(), run, call, row, bytes);
  return bytes.bytes();
}

// A file that was written in the part that is passed over must still be there.
void want_file(DeckRun& run, const Call& call) {
  if (const std::string file = call.text("file"); !system::Gate::of_process().exists(file))
    lose(run, "'" + file + "' was written " + after_call(run) +
                  ", which the restart passes over, and is gone: put it back");
}

// Makes an object of the core.
int make(Call& call) {
  int results = 0;
  Collector::with_room(call.L(), [&] { results = call.entry().run(call); });
  call.session().collector().look(call.L());
  return results;
}

}  // namespace

int read_between(lua_State* L, DeckRun& run, const std::string& name, const std::string& arguments,
                 const std::function<int()>& read) {
  if (run.passes_over()) {
    const std::string* noted = run.calls.read.find(key_of(run, name, arguments));
    if (noted == nullptr || *noted == unpackable) lose_reading(run, "'" + name + "'");
    return push_results(L, *noted);
  }
  const int results = read();
  if (notes_readings(run) && !run.calls.read.full())
    put(run, run.calls.read, key_of(run, name, arguments),
        pack_results(L, lua_gettop(L) - results + 1, results));
  return results;
}

namespace {

// Whether a method changes its object. A mesh's `set` with one argument only reads.
bool changes(const Entry& entry, int given) {
  constexpr const char* names[] = {
      "mesh:map",          "mesh:orient",         "analysis:solve",   "analysis:advance",
      "analysis:step",     "analysis:every",      "analysis:event",   "analysis:record",
      "analysis:vtk",      "analysis:checkpoint", "analysis:restart", "analysis:restore",
      "analysis:snapshot", "analysis:set",        "analysis:cut",     "analysis:join"};
  if (entry.name == "mesh:set") return given > 2;
  return (entry.name.starts_with("model:") && entry.name != "model:list" && entry.name != "model:declared") ||
         std::any_of(std::begin(names), std::end(names),
                     [&](const char* name) { return entry.name == name; });
}

const void* changed_object(lua_State* L) {
  if (const auto mesh = to_object<mesh::Mesh>(L, 1)) return mesh.get();
  if (const auto model = to_object<model::Model>(L, 1)) return model.get();
  return to_object<DeckRun>(L, 1).get();
}

void refuse_within(lua_State* L, const Entry& entry) {
  if (!entry.method() || !changes(entry, lua_gettop(L) - 1))
    return;  // without the table of the gathered arguments
  if (!Session::of(L).is_still(changed_object(L))) return;
  throw Error("this " + entry.owner() +
              " may not change while it asks a function for a value (a history, a direction, a column, an "
              "event's value, a function of mesh:set or mesh:map)" +
              (entry.owner() == "analysis" ? "; a hook of analysis:every may do so" : ""));
}

// A run that is passed over is in the state of the checkpoint, not in that of the call.
void refuse_passed_over(const Call& call) {
  for (const Argument& row : call.entry().arguments) {
    if (row.of != "analysis") continue;
    const auto run = call.object<DeckRun>(row.name);
    if (!run || !run->passes_over()) continue;
    row.name == "from" ? lose_beginning(*run, call.entry().name) : lose_reading(*run, call.entry().name);
  }
}

}  // namespace

int execute(Call& call) {
  const Entry& entry = call.entry();
  refuse_within(call.L(), entry);
  if (entry.touches == Touches::whole_run) refuse_passed_over(call);
  if (entry.weighs) return make(call);
  if (entry.touches == Touches::nothing || entry.touches == Touches::whole_run) return entry.run(call);
  DeckRun& run = *call.self<DeckRun>();
  if (!run.passes_over() && !notes_readings(run)) return entry.run(call);
  const std::string arguments = replayed_arguments(call, run);
  if (run.passes_over() && entry.name == "analysis:write") want_file(run, call);
  return read_between(call.L(), run, last_word(entry.name), arguments, [&] { return entry.run(call); });
}

void check_call(DeckRun& run, const Drive& call) {
  const auto& before = run.before.made;
  const auto place = static_cast<std::size_t>(run.calls.count) - 1;
  const bool asked = run.passes_over() || (run.same_deck && run.calls.count == run.passing);
  if (!asked || (place < before.size() && before[place].same(call))) return;
  lose(run, "call " + std::to_string(run.calls.count) + " of analysis " + std::to_string(run.number()) +
                " is " + call.words() + "; the deck that wrote checkpoint '" + run.job.from()->path +
                "' made " + (place < before.size() ? before[place].words() : "none") +
                " there, so that it cannot be passed over: make the deck go the same way");
}

bool repeats_change(DeckRun& run) {
  if (run.job.driving()) return false;
  ++run.calls.changes;
  return run.passes_over() && run.same_deck;
}

// --- kept tables

namespace {

std::string table_key(const DeckRun& run, std::size_t table) {
  Archive key;
  std::int64_t call = run.calls.count;
  std::uint64_t place = table;
  key(call, place);
  return key.bytes();
}

std::string content(const Hook& table) {
  lua_State* L = table.push();
  std::string bytes = unpackable;
  try {
    bytes = pack_table(L, -2, "keep");
  } catch (const Error&) {  // a checkpoint that is written now says what cannot be kept
  }
  lua_pop(L, 2);
  return bytes;
}

void fill(const Hook& table, const std::string& bytes) {
  lua_State* L = table.push();
  fill_table(L, -2, bytes);
  lua_pop(L, 2);
}

}  // namespace

void keep_table(DeckRun& run, const Hook& table, std::string restored) {
  const bool later = !run.job.taken_up() || run.passes_over();
  if (!restored.empty() && !later) fill(table, std::exchange(restored, {}));
  run.kept_tables.push_back({table, std::move(restored)});
}

void begin_tables(DeckRun& run) {
  for (KeptTable& kept : run.kept_tables)
    kept.at_begin = run.calls.tables.full() ? std::string() : content(kept.table);
}

void hold_tables(DeckRun& run) {
  if (!run.has_events) return;
  for (KeptTable& kept : run.kept_tables) kept.at_step = content(kept.table);
}

// A table that has not changed stays as it is, with whatever the deck holds of it.
namespace {

void give_back(const Hook& table, const std::string& bytes) {
  if (!bytes.empty() && bytes != unpackable && content(table) != bytes) fill(table, bytes);
}

}  // namespace

void release_tables(DeckRun& run) {
  for (KeptTable& kept : run.kept_tables) give_back(kept.table, kept.at_step);
}

std::function<void()> untraced_tables(DeckRun& run) {
  if (run.kept_tables.empty()) return {};
  std::vector<std::string> before;
  for (const KeptTable& kept : run.kept_tables) before.push_back(content(kept.table));
  return [&run, before = std::move(before)] {
    for (std::size_t i = 0; i < before.size(); ++i) give_back(run.kept_tables[i].table, before[i]);
  };
}

void note_tables(DeckRun& run) {
  for (std::size_t i = 0; i < run.kept_tables.size(); ++i) {
    if (run.calls.tables.full()) return;
    std::string now = content(run.kept_tables[i].table);
    if (now != run.kept_tables[i].at_begin) put(run, run.calls.tables, table_key(run, i), std::move(now));
    run.kept_tables[i].at_begin.clear();
  }
}

void repeat_tables(DeckRun& run) {
  for (std::size_t i = 0; i < run.kept_tables.size(); ++i) {
    const std::string* noted = run.calls.tables.find(table_key(run, i));
    if (noted == nullptr && !run.calls.tables.full()) continue;  // the call did not change it
    if (noted == nullptr || *noted == unpackable) lose_reading(run, "the kept table");
    fill(run.kept_tables[i].table, *noted);
  }
}

void restore_tables(const DeckRun& run) {
  for (const KeptTable& kept : run.kept_tables)
    if (!kept.restored.empty()) fill(kept.table, kept.restored);
}

}  // namespace fabricsh::script
