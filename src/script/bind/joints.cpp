// Tearable zones of a model, and opening and closing their joints during a run.
#include <algorithm>

#include "base/archive.hpp"
#include "model/declaration_rows.hpp"
#include "script/bind/model.hpp"
#include "script/bind/run.hpp"
#include "script/runs/drive.hpp"
#include "script/values/field_rows.hpp"

namespace fabricsh::script {

std::pair<std::string, std::vector<Vec3>> read_set_or_line(const Call& call) {
  call.want_one_of("set", "line", "expected the name of a set, or a line");
  if (call.has("set")) return {call.text("set"), {}};
  std::vector<Vec3> line;
  call.each("line", [&](lua_Integer i) {
    const Argument row{std::to_string(i), numbers, "m", everything, ""};
    check_value(call.L(), -1, row, "line.", false);
    line.push_back(read_vector(read_numbers(call.L(), -1), "field 'line." + row.name + "'"));
  });
  if (line.size() < 2)
    call.refuse("line", "expected two points {x, y, z} or more, got " + std::to_string(line.size()));
  return {"", line};
}

namespace {

int tearable(Call& call) {
  model::Zone zone{call.text("set")};
  if (call.has("options")) {
    const Fields options = call.fields("options");
    zone.lower = options.text("coarse") != "refuse";
    zone.keep = options.text("coarse") == "keep";
    zone.seed = static_cast<std::uint64_t>(options.integer("seed"));
    if (options.has("path")) zone.path = options.text("path");
  }
  return declare(call, std::move(zone));
}

int strength(Call& call) {
  model::StrengthGiven given{call.text("set")};
  read_rows(call, model::strength_rows(), given);
  given.seed = static_cast<std::uint64_t>(call.integer("seed"));
  return declare(call, std::move(given));
}

run::Run::Along read_along(const Call& call) {
  const auto [set, line] = read_set_or_line(call);
  return {set, line};
}

// Between two calls that drive the run, a restarted deck passes over it and returns what it returned. Before
// the first of them it is made again: the state of the checkpoint replaces what it does.
template <class Change>
int change(Call& call, const std::string& name, run::Run::Along along, Change made) {
  DeckRun& run = *call.self<DeckRun>();
  const auto make = [&] { return push_value(call.L(), made(*run.analysis)); };
  if (run.calls.count == 0) return make();
  repeats_change(run);
  Archive arguments;
  arguments(along.set);
  for (Vec3& point : along.line) arguments(point.x(), point.y(), point.z());
  return read_between(call.L(), run, name, arguments.bytes(), make);
}

int cut(Call& call) {
  const auto along = read_along(call);
  return change(call, "cut", along, [&](run::Run& run) { return run.cut(along); });
}

int join(Call& call) {
  const auto along = read_along(call);
  std::optional<double> within;
  if (call.has("within")) within = call.number("within");
  return change(call, "join", along, [&](run::Run& run) { return run.join(along, within); });
}

int joints(Call& call) {
  const auto& dofs = call.self<DeckRun>()->analysis->assembly().dofs();
  const auto& joints = dofs.joints();
  const auto& closed = dofs.sewn().closed;
  return push_record(call.L(), "stitches", closed.size(), "closed",
                     std::count(closed.begin(), closed.end(), 1), "open", joints.open(), "places",
                     joints.places());
}

std::vector<Argument> along_rows() {
  return {
      value_("set?", text, "the edges between nodes of this set"),
      value_("line?", table,
             "a list of points {x, y, z}: the edges that lie on the line through them, m in the reference")};
}

std::string sample(const std::string& end) {
  return "local mesh = fabric.mesh.rectangle{ width=0.05, height=0.1, nx=2, ny=4 }\n"
         "local m = fabric.model{ mesh=mesh, card=fabric.card 'blend', warp=90 }\n"
         "m:fix('all', 'z rotation'):fix('bottom', 'x y'):tearable 'all'\n" +
         end;
}

std::vector<Entry> joints_entries() {
  const std::string cut_sample =
      "m:move('top', { y=fabric.ramp(0.01, 1) }):fix('top', 'x')\n"
      "local a = fabric.static{ model=m, duration=1, step=0.25 }\n"
      "a:advance(0.5)\nassert(a:cut{ line={ {0, 0.05, 0}, {0.025, 0.05, 0} } } == 1)\n";
  const auto strengths = arguments_of(model::strength_rows());
  auto join_rows = along_rows();
  join_rows.push_back(
      number_("within?", "m", not_negative,
              "how far apart nodes that become one may be; default a millionth of the mean edge"));
  return {
      {"model:tearable()",
       {value_("set", text, "a set whose elements may come apart along their edges during a run"),
        fields_(
            "options?",
            {value_("coarse", text,
                    "where elements are coarse for the card's strength and energy: lower the strength "
                    "until a tear runs at the right force, and say so; refuse; or keep the strength, "
                    "which is right where no tear runs, as in a strip without a notch")
                 .one_of({"lower", "refuse", "keep"})
                 .or_else("lower"),
             integer_("seed", {0, 9007199254740992.0}, "of the scatter of strengths").or_else(1),
             value_("path?", text,
                    "a set of nodes: yarns break at these places only, where the path of a tear is given")},
            "of breaking yarns")},
       "Declares a tearable zone: each corner of its elements gets a node of its own, which moves with the "
       "others at its place until a:cut opens the joint, or in explicit motion its yarns reach the strength "
       "that the card has in rupture. The further nodes are numbered after those of the mesh.",
       sample(""),
       tearable},
      {"model:strength{}",
       {value_("set", text, "the elements meant").or_else("all"), strengths[0], strengths[1],
        integer_("seed", {0, 9007199254740992.0}, "of that").or_else(1)},
       "The strength of yarns that soften (see damage of a card) where it is not that of the card: weakened "
       "lines, scatter. Where sets overlap, the factors multiply.",
       "local mesh = fabric.mesh.rectangle{ width=0.05, height=0.1, nx=10, ny=20 }\n"
       "local card = fabric.card('blend'):with{ damage={ warp={ strength=15e3, energy=60 } } }\n"
       "local m = fabric.model{ mesh=mesh, card=card, warp=90 }\n"
       "m:strength{ factor=0.9, modulus=20, seed=3 }",
       strength},
      {"analysis:cut{}", along_rows(),
       "Opens joints of tearable zones and stitches of seams, between two steps: in a hook, an event's "
       "action, or between calls. Along the edges named the elements come apart; the tip of a cut stays "
       "whole. Returns how many joints there are more.",
       sample(cut_sample), cut},
      {"analysis:join{}", join_rows,
       "Closes joints of tearable zones and stitches of seams, between two steps, where their nodes have met "
       "again. They take the mean of their velocities weighted by their masses; the kinetic energy lost is "
       "a.energy.joints. Returns how many joints there are less.",
       sample(cut_sample + "assert(a:join{ set='all' } == 1 and a.joints.open == 0)"), join},
      without_arguments("analysis.joints",
                        "Of the tearable zones: open, the number of places whose joint is open; places, of "
                        "all places with several nodes. Of seams: stitches, and how many of them are closed.",
                        sample(cut_sample + "assert(a.joints.open == 1 and a.joints.places == 15 - 4)"),
                        joints),
  };
}

}  // namespace

void bind_joints(Session& session) { install(session, joints_entries()); }

}  // namespace fabricsh::script
