// a:checkpoint, a:restart, a:set, a:why, fabric.why: storing and restarting a run, changing its settings, and
// the reason for a failure.
#include "run/static.hpp"
#include "script/bind/run.hpp"
#include "script/runs/drive.hpp"
#include "script/values/field_rows.hpp"
#include "script/values/lua_table.hpp"

namespace fabricsh::script {

namespace {

// Error: a value that cannot be stored, reported at once.
void check_table(const Fields& options) {
  options.push("keep");
  pack_table(options.L(), -1, "keep");
  lua_pop(options.L(), 1);
}

// The deck's table is stored with the checkpoint, and is restored if the run starts from one.
void store_table(DeckRun& run, const std::string& path, const Fields& options, run::Keeper& keeper) {
  const std::string* kept = run.job.claims().take("keep", path);
  const Hook table(options, "keep", &run);
  keep_table(run, table, kept != nullptr ? *kept : std::string());
  keeper.keep_also([table, path](std::vector<run::Checkpoint::CheckpointPart>& parts) {
    lua_State* L = table.push();
    parts.push_back({"keep", path, pack_table(L, -2, "keep")});
    lua_pop(L, 2);
  });
}

int checkpoint(Call& call) {
  const auto run = call.self<DeckRun>();
  const std::string path = call.text("path");
  std::optional<Fields> options;
  if (call.has("options")) options.emplace(call.fields("options"));
  std::optional<double> every, minutes;
  if (options && options->has("every"))
    every = options->is("every", LUA_TSTRING) ? 0 : options->number("every");
  if (options && options->has("minutes")) minutes = options->number("minutes");
  const bool keeps = options && options->has("keep");
  if (keeps) check_table(*options);
  if (call.session().options().check) return call.itself();
  const auto keeper = run->job.checkpoint(path, every, minutes);
  if (keeps) store_table(*run, path, *options, *keeper);
  // In a restarted deck the analyses before the restored one are finished: this file does not belong to them.
  const auto& begun = call.session().restart();
  if (begun && run->number() < begun->number) keeper->write_nothing();
  return call.itself();
}

int restart_run(Call& call) {
  restart(*call.self<DeckRun>(), load_checkpoint(call.text("path")));
  return call.itself();
}

int set_kept(Call& call) {
  run::Run::Settings settings;
  for (const Argument& row : call.entry().arguments)
    if (call.has(row.name)) settings.push_back({row.name, call.number(row.name)});
  const auto run = call.self<DeckRun>();
  if (!repeats_change(*run)) run->analysis->set(settings);
  return call.itself();
}

// Those of a quasi-static run; a motion has the same.
std::vector<Argument> setting_rows() {
  std::vector<Argument> rows;
  for (field::FieldRow row : run::static_options())
    if (row.place > 0) {
      row.fallback = {};
      row.without = {};
      rows.push_back(argument_of(row).optional());
    }
  return rows;
}

int why(Call& call) {
  const std::string& text = call.self<DeckRun>()->analysis->why();
  return push_value(call.L(), text.empty() ? "this run has not failed" : text.c_str());
}

int last_why(Call& call) {
  if (lua_getfield(call.L(), LUA_REGISTRYINDEX, why_key) != LUA_TSTRING)
    lua_pushliteral(call.L(), "no run has failed");
  return 1;
}

// An example that fails: a strip compressed to zero length in one step with one attempt.
std::string failing_sample() {
  return sample_run() +
         "a = fabric.static{ model=fabric.model{ mesh=mesh, card=fabric.card 'blend', warp=90 "
         "}:fix('bottom', 'x y z rotation'):move('top', { y=-0.07 }), duration=1, step=1, max_cuts=0, "
         "max_iterations=4 }\n"
         "local ok, e = pcall(a.solve, a)\nassert(not ok and e.kind == 'numerical')\n";
}

std::vector<Entry> keep_entries() {
  const std::string sample = sample_run() + "local name = os.tmpname()\n";
  return {
      {"analysis:checkpoint()",
       {value_("path", text, "of the file, which is replaced each time; its folder is made"),
        fields_("options?",
                {Argument{"every",
                          number | text,
                          "s",
                          positive,
                          "simulated time between two of them, or 'step'; no step is made shorter for it",
                          true,
                          {},
                          {"step"}}
                     .optional(),
                 number_("minutes?", "min", positive,
                         "time on the clock between two of them; 10 where neither it nor 'every' is given"),
                 value_("keep?", table,
                        "a table of the deck (numbers, texts, booleans, tables), saved with the run and "
                        "filled again on restart")},
                "how often, and what besides the run")},
       "Writes the whole state of the run to one file as it goes, and when it ends, fails or is interrupted; "
       "--restart and analysis:restart continue from there bit for bit.",
       sample + "local seen = { n=0 }\na:every('step', function() seen.n = seen.n + 1 end)\n"
                "a:checkpoint(name, { every='step', keep=seen })\na:advance(0.5)\n"
                "local b, again = fabric.static{ model=m, duration=1, step=0.25 }, { n=0 }\n"
                "b:restart(name):checkpoint(name, { keep=again })\n"
                "assert(b.time == 0.5 and again.n == 3)\nos.remove(name)",
       checkpoint},
      {"analysis:restart()",
       {value_("path", text, "of a checkpoint of the same problem")},
       "Returns to the state of a checkpoint; 'record', 'vtk' and 'checkpoint' called after it continue "
       "their files.",
       sample + "a:checkpoint(name)\na:solve()\n"
                "local b = fabric.static{ model=m, duration=1, step=0.25 }:restart(name)\n"
                "assert(b.time == 1 and b:mean 'S11' == a:mean 'S11')\nos.remove(name)",
       restart_run},
      {"analysis:set{}", setting_rows(),
       "Changes settings of a run, also one that is under way or has failed.",
       sample_run() + "a:advance(0.5):set{ tolerance=1e-6, step=0.1 }\nassert(a:solve().time == 1)",
       set_kept},
      without_arguments(
          "analysis:why",
          "Why the run last failed: the steps tried with their residuals, the node, the element with its "
          "strain and the branches of its yarns, and what to try; as text. The error has it as e.why.",
          failing_sample() + "assert(a:why():find 'element' and e.why == a:why())", why),
      {"fabric.why()",
       {},
       "Why the last failed run failed: the text of its analysis:why().",
       failing_sample() + "assert(fabric.why() == a:why())",
       last_why},
  };
}

}  // namespace

void bind_keep(Session& session) { install(session, keep_entries()); }

}  // namespace fabricsh::script
