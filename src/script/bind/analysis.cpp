// The analysis object: driving it, its hooks, and reading from it.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/number.hpp"
#include "run/bodies.hpp"
#include "run/recovery.hpp"
#include "run/result_fields.hpp"
#include "script/bind/model.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"
#include "script/runs/drive.hpp"
#include "script/session/at_work.hpp"
#include "script/session/warning_log.hpp"

namespace fabricsh::script {

std::string sample_run() {
  return "local mesh = fabric.mesh.rectangle{ width=0.0254, height=0.0762, nx=1, ny=3 }\n"
         "local m = fabric.model{ mesh=mesh, card=fabric.card 'blend', warp=90 }\n"
         "m:fix('all', 'z rotation'):fix('bottom', 'x y'):fix('top', 'x'):move('top', { y=fabric.ramp(0.018, "
         "1) })\n"
         "local a = fabric.static{ model=m, duration=1, step=0.25 }\n";
}

template <>
struct ClassName<const run::Run::Snapshot> {
  static constexpr const char* name = "snapshot";
};

namespace {

// --- driving ---

int solve(Call& call) {
  const auto run = call.self<DeckRun>();
  drive(*run, {CallKind::solve, std::max(run->analysis->duration(), run->analysis->time())});
  return call.itself();
}

int advance(Call& call) {
  const double time = call.number("time");
  drive(*call.self<DeckRun>(), {CallKind::advance, time});
  return call.itself();
}

int step(Call& call) {
  const auto run = call.self<DeckRun>();
  drive(*run, {CallKind::step, run->analysis->duration()});
  return call.itself();
}

int stop(Call& call) {
  const auto run = call.self<DeckRun>();
  if (!repeats_change(*run)) run->analysis->stop(call.text("reason"));
  return 0;
}

// --- hooks ---

void run_hook(const Hook& hook) {
  const ChangeAllowed free = hook.free();
  lua_State* L = hook.push();
  call_deck(L, 1, 0);
}

int every(Call& call) {
  const auto run = call.self<DeckRun>();
  const Hook hook(call, "action", run.get());
  const auto act = [hook](run::Run&) { run_hook(hook); };
  if (call.is("interval", LUA_TSTRING))
    run->analysis->every_step(act);
  else
    run->analysis->every(call.number("interval"), act);
  return call.itself();
}

double event_value(const Hook& hook) {
  const ChangeRefused still = hook.still();
  lua_State* L = hook.push();
  call_deck(L, 1, 1);
  if (lua_type(L, -1) != LUA_TNUMBER)
    throw Error("event: field 'value': expected the function to return a number, got " + describe(L, -1));
  const double value = lua_tonumber(L, -1);
  lua_pop(L, 1);
  return value;
}

int event(Call& call) {
  const auto run = call.self<DeckRun>();
  const Hook value(call, "value", run.get());
  run::Run::Hook act;
  if (call.has("action")) act = [hook = Hook(call, "action", run.get())](run::Run&) { run_hook(hook); };
  run->has_events = true;
  run->analysis->event([value](run::Run&) { return event_value(value); }, call.number("tolerance"), act);
  return call.itself();
}

// Runs until a value reaches a target; the run ends there.
int reach(Call& call) {
  const auto run = call.self<DeckRun>();
  const double target = call.number("target");
  std::function<double(const run::Run&)> value;
  if (call.is("value", LUA_TFUNCTION)) {
    value = [hook = Hook(call, "value", run.get())](const run::Run&) { return event_value(hook); };
  } else {
    const std::string field = call.text("value"), set = call.text("set");
    run->analysis->mean(field, set);  // an error if it is unknown
    value = [field, set](const run::Run& a) { return a.mean(field, set); };
  }
  if (call.session().options().check) return call.itself();
  run->has_events = true;
  // After the target has been reached, or could not be, the event never occurs again.
  const auto sought = std::make_shared<bool>(true);
  run->analysis->event([=](run::Run& a) { return *sought ? value(a) - target : 1.0; },
                       call.number("tolerance"),
                       [sought, target](run::Run& a) {
                         *sought = false;
                         a.stop("reached " + exact_number(target));
                       });
  try {
    drive(*run, {CallKind::reach, run->analysis->duration()});
  } catch (...) {
    *sought = false;
    throw;
  }
  if (std::exchange(*sought, false) && !run->passes_over()) {
    const run::Run& a = *run->analysis;
    const Error missed("reach: the value did not reach " + exact_number(target) + "; it is " +
                       fabricsh::number(value(a), 7) + " at " + fabricsh::number(a.time(), 7) +
                       " s, where the run " + (a.stopped() ? "was stopped: " + a.stop_reason() : "ends"));
    note_failure(*run, missed);
    throw Error(missed);
  }
  return call.itself();
}

// --- reading ---

// The mean over the last seconds of the run's own steps, which are followed from the first call on.
int mean_reaction(Call& call, const model::Rigid* body) {
  auto& run = *call.self<DeckRun>()->analysis;
  const double width = call.fields("options").number("window");
  const std::int64_t number = body == nullptr ? -1 : static_cast<std::int64_t>(run.body_number(*body));
  const std::string set = body == nullptr ? call.text("set") : std::string();
  const std::string name = "reaction of " +
                           (body == nullptr ? "set " + set : "body " + std::to_string(number)) + " over " +
                           exact_number(width);
  run::Window* window = run.window(name);
  if (window == nullptr) {
    if (body == nullptr) (void)run.reaction(set);  // an error if there is no such set
    if (!run.steps().empty())
      throw Error(
          "reaction: field 'options.window': expected to be asked for once before the first step, so that "
          "the steps are followed, got the first call at time " +
          fabricsh::number(run.time()) + " s: write a:reaction(" +
          (body == nullptr ? "'" + set + "'" : std::string("body")) + ", { window=" +
          fabricsh::number(width) + " }) before a:solve() too, whose result counts for nothing");
    window = &run.window(name, run::Window(width, run::Window::Reaction{set, number}));
  }
  for (const double r : window->mean()) lua_pushnumber(call.L(), r);
  return 3;
}

int reaction(Call& call) {
  const auto& run = *call.self<DeckRun>()->analysis;
  const auto body = call.object<const model::Rigid>("set");
  if (call.has("options") && call.fields("options").flag("support")) {
    if (body == nullptr)
      call.refuse("options.support",
                  "expected a rigid body, which m:fix holds, got the set '" + call.text("set") + "'");
    if (call.fields("options").has("window"))
      call.refuse("options.support", "expected without window: means are those of forces on the cloth");
    const Vec3 r = run::body_state(run, *body).support;
    for (int i = 0; i < 3; ++i) lua_pushnumber(call.L(), r[i]);
    return 3;
  }
  if (call.has("options") && call.fields("options").has("window")) return mean_reaction(call, body.get());
  const Vec3 r = body ? run.force_of_body(run.body_number(*body)) : run.reaction(call.text("set"));
  for (int i = 0; i < 3; ++i) lua_pushnumber(call.L(), r[i]);
  return 3;
}

// Pushes a table with the values, by name, of all fields at one node or element.
int push_fields(Call& call, run::FieldPlace place) {
  const auto& run = *call.self<DeckRun>()->analysis;
  const auto item = static_cast<mesh::Index>(call.integer("number") - 1);
  place == run::FieldPlace::node ? (void)run.node(item) : (void)run.element(item);  // an error if it is wrong
  lua_createtable(call.L(), 0, 20);
  std::array<double, 5> values{};
  for (const auto& field : run::result_fields()) {
    if (field.place != place || field.components.empty() ||
        ((field.touching || field.of_yarns) && !run::has(run, field)))
      continue;
    field.values(run, item, "", values.data());
    for (std::size_t c = 0; c < field.components.size(); ++c)
      put(call.L(), field.components[c].c_str(), values[c]);
  }
  return 1;
}

int node(Call& call) { return push_fields(call, run::FieldPlace::node); }
int element(Call& call) { return push_fields(call, run::FieldPlace::element); }

int mean(Call& call) {
  return push_value(call.L(), call.self<DeckRun>()->analysis->mean(call.text("name"), call.text("set")));
}

// The options of analysis:field ask for the nodes, and perhaps for one region.
std::vector<double> nodal_values(const Call& call, const run::Run& run, const run::FieldPart& part) {
  const Fields options = call.fields("options");
  const bool nodes = options.has("at");
  const int region = options.has("region") ? options.count("region") - 1 : -1;
  lua_pop(call.L(), 1);
  if (!nodes && region >= 0) throw Error("field: field 'options.region': expected at=\"nodes\" with it");
  return nodes ? run::recovered(run, part, region) : run::values_of(run, part);
}

int field(Call& call) {
  lua_State* L = call.L();
  const auto& run = *call.self<DeckRun>()->analysis;
  const auto part = run::find_field(run, call.text("name"));
  const auto values = call.has("options") ? nodal_values(call, run, part) : run::values_of(run, part);
  const std::size_t width = part.component < 0 ? part.field->size() : 1;
  if (width == 1) return push_numbers(L, values), 1;
  lua_createtable(L, static_cast<int>(values.size() / width), 0);
  for (std::size_t i = 0; i < values.size(); i += width) {
    push_numbers(L, {values.begin() + static_cast<std::ptrdiff_t>(i),
                     values.begin() + static_cast<std::ptrdiff_t>(i + width)});
    lua_rawseti(L, -2, static_cast<lua_Integer>(i / width + 1));
  }
  return 1;
}

int energy(Call& call) {
  lua_newtable(call.L());
  for (const auto& [name, value] : run::energies(call.self<DeckRun>()->analysis->energy()))
    put(call.L(), name.c_str(), value);
  return 1;
}

int beyond(Call& call) {
  const auto& run = *call.self<DeckRun>()->analysis;
  const auto far = run.beyond();
  if (!far) return lua_pushnil(call.L()), 1;
  return push_record(call.L(), "share", far->strain_ratio, "time", far->time, "first", far->first, "strain",
                     far->strain, "tested", far->tested, "elements", run.elements_beyond(), "element",
                     far->element + 1, "yarn", far->yarn);
}

int warnings(Call& call) {
  push_warnings(call.L(), call.self<DeckRun>()->analysis->warnings());
  return 1;
}

// "ledger (energy appears ...), inverted (...)"
std::string codes_text() {
  std::string text;
  for (const run::WarningKind& kind : run::warning_kinds())
    text += (text.empty() ? "" : ", ") + std::string(kind.code) + " (" + kind.sentence + ")";
  return text;
}

int time(Call& call) { return push_value(call.L(), call.self<DeckRun>()->analysis->time()); }

int duration(Call& call) {
  const run::Run& run = *call.self<DeckRun>()->analysis;
  return push_value(call.L(), run.duration() - run.began());
}

int stopped(Call& call) {
  const run::Run& run = *call.self<DeckRun>()->analysis;
  return run.stopped() ? push_value(call.L(), run.stop_reason()) : push_value(call.L(), false);
}

// Only their number is noted for a restart: the steps themselves are in the checkpoint, unless a restore()
// has replaced them.
lua_Integer count_of_steps(lua_State* L, DeckRun& run) {
  const auto count = [&] { return push_value(L, run.analysis->steps().size()); };
  read_between(L, run, run.calls.restored_after(run.calls.count) ? "steps before a restore()" : "steps", "",
               count);
  const lua_Integer steps = lua_tointeger(L, -1);
  lua_pop(L, 1);
  return steps;
}

void push_step(lua_State* L, const run::StepReport& report) {
  push_record(L, "time", report.time, "step", report.step, "iterations", report.iterations, "cuts",
              report.cuts, "negative_pivots", report.negative_pivots);
  put(L, "stable", report.stability == solver::Stability::stable, "path", report.path, "residuals",
      report.residuals);
  if (report.stability == solver::Stability::unchecked) put(L, "stable", "unchecked");
  if (std::isnan(report.path)) put(L, "path", "unchecked");
}

// The list is a new one each time, of rows that are made once: a hook may look at it at every step.
int steps(Call& call) {
  lua_State* L = call.L();
  const auto run = call.self<DeckRun>();
  const lua_Integer count = count_of_steps(L, *run);
  lua_getiuservalue(L, 1, 1);
  if (lua_getfield(L, -1, step_rows) != LUA_TTABLE) {
    lua_newtable(L);
    lua_pushvalue(L, -1);
    lua_setfield(L, -4, step_rows);
    lua_replace(L, -2);
  }
  const int rows = lua_gettop(L);
  for (auto i = static_cast<lua_Integer>(lua_rawlen(L, rows)); i < count;) {
    push_step(L, run->analysis->steps()[static_cast<std::size_t>(i)]);
    lua_rawseti(L, rows, ++i);
  }
  lua_createtable(L, static_cast<int>(count), 0);
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(L, rows, i);
    lua_rawseti(L, -2, i);
  }
  return 1;
}

int snapshot(Call& call) {
  const auto run = call.self<DeckRun>();
  auto snapshot = run->analysis->snapshot();
  if (run->passes_over()) run->passed_snapshots.push_back(snapshot);
  push_object(call.L(), std::move(snapshot));
  read_between(call.L(), *run, "time", "", [&] { return time(call); });
  lua_setiuservalue(call.L(), -2, 1);
  return 1;
}

int snapshot_text(lua_State* L) {
  lua_getiuservalue(L, 1, 1);
  lua_pushfstring(L, "<snapshot of t = %s s>", exact_number(lua_tonumber(L, -1)).c_str());
  return 1;
}

int restore(Call& call) {
  go_back(*call.self<DeckRun>(), call.object<const run::Run::Snapshot>("snapshot"));
  return call.itself();
}

// For example "ready", "under way", "done", "stopped: the grip lets go".
std::string state_words(const run::Run& a) {
  if (a.stopped()) return "stopped: " + a.stop_reason();
  if (a.steps().empty()) return "ready";
  return a.time() >= a.duration() * (1 - 1e-12) ? "done" : "under way";
}

int push_run_text(lua_State* L, const run::Run& a) {
  const std::string words = std::string("<") + a.kind() + " run, t = " + fabricsh::number(a.time()) + " of " +
                            fabricsh::number(a.duration()) + " s, " + counted(a.steps().size(), "step") +
                            ", ";
  return push_value(L, words + state_words(a) + ">");
}

int run_text(lua_State* L) {
  const auto run = to_object<DeckRun>(L, 1);
  std::string trouble;
  try {
    return read_between(L, *run, "tostring", "", [&] { return push_run_text(L, *run->analysis); });
  } catch (const Error& error) {
    trouble = position(L) + "tostring: " + error.what();
  }
  lua_pushstring(L, trouble.c_str());
  return lua_error(L);
}

// The values available for nodes or elements: "E11 (1), stored (J/m^3), ...".
std::string numbers_of(run::FieldPlace place) {
  std::string words;
  for (const auto& field : run::result_fields()) {
    if (field.place != place || field.components.empty()) continue;
    words += words.empty() ? "" : ", ";
    for (const std::string& component : field.components)
      words += component + (&component == &field.components.back() ? "" : " ");
    words += " (" + field.sentence + (field.unit.empty() ? "" : "; " + field.unit) + ")";
  }
  return words;
}

Argument name_row(const std::vector<std::string>& names, const std::string& sentence) {
  return value_("name", text, sentence + "; of a ply ply2.E11, or by the ply's name").one_of(names).owned();
}

std::vector<Entry> driving() {
  return {
      without_arguments("analysis:solve",
                        "Runs to the duration, or to where a hook stopped it; returns the analysis.",
                        sample_run() + "assert(a:solve().time == 1)", solve),
      {"analysis:advance()",
       {number_("time", "s", not_negative, "absolute time to run to and land on")},
       "Runs to an absolute time and lands on it; returns the analysis.",
       sample_run() + "assert(a:advance(0.3).time == 0.3)",
       advance},
      without_arguments("analysis:step", "Makes one step and commits it; returns the analysis.",
                        sample_run() + "assert(a:step().time == 0.25)", step),
      {"analysis:stop()",
       {value_("reason", text, "why, for a.stopped and run.json").or_else("asked for")},
       "Ends the run after the current step; to be called from a hook.",
       sample_run() + "a:every('step', function(run) if run.time >= 0.5 then run:stop 'enough' end end)\n"
                      "assert(a:solve().stopped == 'enough' and a.time == 0.5)",
       stop},
      {"analysis:every()",
       {{"interval",
         number | text,
         "s",
         positive,
         "time between calls, which steps land on, or 'step'",
         true,
         {},
         {"step"}},
        value_("action", function, "function(a)")},
       "Calls a function at the start and then at an interval, or after each step.",
       sample_run() + "local n = 0\na:every(0.5, function(run) n = n + 1 end)\na:solve()\nassert(n == 3)",
       every},
      {"analysis:event{}",
       {value_("value", function, "function(a) whose zero is sought"),
        number_("tolerance", "", positive, "of the value, over the largest it has had").or_else(1e-6),
        value_("action?", function, "function(a), called there")},
       "Finds where a value crosses zero inside a step, lands there, commits, and calls the action.",
       sample_run() + "a:event{ value=function(run) return run:mean 'E11' - 0.1 end, action=function(run) "
                      "run:stop() end }\n"
                      "a:solve()\nassert(math.abs(a:mean 'E11' - 0.1) < 1e-6)",
       event},
      {"analysis:reach()",
       {value_("value", function | text, "function(a) that returns a number, or a field's name for its mean"),
        number_("target", "", everything, "value to reach"),
        value_("set", text, "of the field's mean").or_else("all"),
        number_("tolerance", "", positive, "of the value, over the largest distance from the target")
            .or_else(1e-6)},
       "Runs until a value reaches a target and ends a step exactly there; an error if the run ends before. "
       "Returns the analysis; solve() continues it.",
       sample_run() + "local function force(run) return select(2, run:reaction 'top') end\n"
                      "a:reach(force, 10)\nassert(math.abs(force(a) - 10) < 1e-4 and a.time < 1)\n"
                      "a:reach('E11', 0.1):solve()\nassert(a.time == 1)",
       reach},
      without_arguments("analysis:snapshot", "A copy of the whole state, to go back to with a:restore.",
                        sample_run() + "local s = a:snapshot()", snapshot),
      {"analysis:restore()",
       {object_("snapshot", "snapshot", "taken of this analysis")},
       "Goes back to a snapshot; the run goes on from there bit for bit. Returns the analysis.",
       sample_run() + "local s = a:snapshot()\na:solve():restore(s)\nassert(a.time == 0)",
       restore},
  };
}

std::vector<Entry> reading() {
  const std::string run = sample_run();
  return {
      {"analysis:reaction()",
       {set_or_body_row(),
        fields_(
            "options?",
            {number_("window?", "s", positive,
                     "the mean over the last seconds, straight between the ends of the run's steps, for a "
                     "body in implicit motion as the scheme takes its force; to be asked for once before "
                     "the first step"),
             flag_("support", "of a body: the force on it of m:fix, in the directions that are held")},
            "window = seconds for a mean, or support = true")},
       "Force that the supports, or a rigid body, exert on the cloth, summed over the set: three numbers x, "
       "y, z in N, global; zero before the first step.",
       run + "local x, y = a:solve():reaction 'top'\nassert(y > 0)",
       reaction},
      {"analysis:node()",
       {integer_("number", from_one, "of the node")},
       "Where a node is and how it moves, global: a table of " + numbers_of(run::FieldPlace::node) + ".",
       run + "assert(math.abs(a:solve():node(8).uy - 0.018) < 1e-12)",
       node},
      {"analysis:element()",
       {integer_("number", from_one, "of the element")},
       "Averages over the element's reference volume, material axes: a table of " +
           numbers_of(run::FieldPlace::element) + ".",
       run + "assert(a:solve():element(1).S11 > 0)",
       element},
      {"analysis:mean()",
       {name_row(run::scalar_names(), "of a number that elements or nodes have, see a:element and a:node"),
        value_("set", text, "elements all of whose nodes are in it; or its nodes").or_else("all")},
       "The mean of a value over elements, or over nodes, each with the same weight. Stresses in Pa, "
       "energies in J/m^3.",
       run + "assert(a:solve():mean('E11') > 0.2)",
       mean},
      {"analysis:field()",
       {name_row(run::field_names(), "of a number, or of a field: see the table of fields of a run"),
        fields_("options?",
                {value_("at?", text,
                        "fields of elements at all nodes: fitted to the elements around each node, by "
                        "superconvergent patch recovery, apart in each region")
                     .one_of({"nodes"}),
                 integer_("region?", from_one,
                          "with at: the values of this region alone, its number as in the field region; nan "
                          "at nodes outside. Default: on the border of regions their mean, by the areas of "
                          "their elements there")},
                "where")},
       "Values of all elements or nodes, in their order: a list of numbers; for a whole field a list of "
       "lists. Units are SI: stresses in Pa, energies in J/m^3.",
       run + "assert(#a:field 'S11' == 3 and #a:field 'displacement'[1] == 3)\n"
             "assert(#a:field('S11', { at='nodes' }) == #a:field 'displacement')",
       field},
      without_arguments(
          "analysis.energy",
          "Energies in J: kinetic, stored, dissipated, damping, external, internal, initial, created. Parts "
          "of stored: contact, guard (the barrier that keeps surfaces from passing), stick (elastic slip of "
          "friction that holds), directors (what keeps the directors by the normal where the elements' shear "
          "does not). Parts of dissipated: dissipated_warp, _weft, _shear, _damage (yarns that softened, see "
          "damage of a card), _bending, friction (of contact), impact (of surfaces that meet), joints "
          "(motion lost as joints closed, see analysis:join, and what directors had stored where they "
          "opened), fracture (broken yarns of tearable zones). Parts of kinetic: rigid (free rigid bodies), "
          "scaled (rotary inertia that is scaled up). error: the imbalance over the largest external work; "
          "with contact at least over the cloth's weight times its thickness.",
          run + "a:solve()\nassert(a.energy.error < 1)", energy),
      without_arguments("analysis.beyond",
                        "The largest strain beyond what the card was tested to, or nil: share (1.2 is 20 % "
                        "beyond), yarn (warp, weft or shear), element and time of this largest strain, "
                        "strain (E11, E22 or E12), tested (the strain tested), first (time at which the run "
                        "first went beyond) and elements (fraction of the elements beyond).",
                        run + "assert(a:advance(0.5).beyond == nil)", beyond),
      without_arguments("analysis.warnings",
                        "Warnings of the run about how far its results can be trusted, in order: a list of "
                        "{code, text, time (s), element (nil: no particular one), serious}. Also in "
                        "run.json. Under --strict the serious ones raise a numerical failure. The codes: " +
                            codes_text() + ".",
                        run + "assert(#a:solve().warnings == 0)", warnings),
      without_arguments("analysis.time", "Where the run is, s.", run + "assert(a.time == 0)", time),
      without_arguments("analysis.duration", "Where it ends, s.", run + "assert(a.duration == 1)", duration),
      without_arguments("analysis.stopped", "The reason it was stopped for, or false.",
                        run + "assert(a.stopped == false)", stopped),
      without_arguments(
          "analysis.steps",
          "Of each committed step: time, step, iterations, cuts, residuals, negative_pivots (none on a "
          "stable path), stable: true, false, or \"unchecked\" in motion and where loads have no potential.",
          run + "assert(#a:solve().steps == 4)", steps),
  };
}

}  // namespace

void bind_analysis(Session& session) {
  install(session, driving());
  install(session, reading());
  set_meta(session, "analysis", "__tostring", run_text);
  set_meta(session, "snapshot", "__tostring", snapshot_text);
}

}  // namespace fabricsh::script
