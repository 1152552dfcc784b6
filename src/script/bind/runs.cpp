// fabric.static and fabric.dynamic: runs, which may begin from the state of another one.
#include "base/number.hpp"
#include "run/dynamic.hpp"
#include "run/static.hpp"
#include "script/bind/model.hpp"
#include "script/bind/run.hpp"
#include "script/values/field_rows.hpp"

namespace fabricsh::script {

namespace {

std::vector<Argument> with_beginning(std::vector<Argument> others) {
  std::vector<Argument> rows = {
      object_("model?", "model", "what is computed; with from= that of the other run unless given"),
      object_("from?", "analysis", "a run of the same cloth, whose state and time this one begins with"),
      number_("release?", "s", positive,
              "with from=: over which the forces of what no longer holds the cloth are taken away; default "
              "at once")};
  rows.insert(rows.begin() + 1, others.begin(), others.end());
  return rows;
}

struct Begins {
  std::shared_ptr<model::Model> model;
  run::Beginning beginning;
};
// Errors: neither a model nor such a run; a release without one; a run that has made no step.
Begins read_beginning(const Call& call) {
  Begins begins{call.object<model::Model>("model"), {}};
  const auto from = call.object<DeckRun>("from");
  if (!from) {
    if (!begins.model)
      call.refuse("model",
                  "expected a model, or from= another run, got nil (missing, or a misspelt variable)");
    if (call.has("release")) call.refuse("release", "expected from= beside it, whose supports let go");
    return begins;
  }
  if (!begins.model) begins.model = from->analysis->shared_model();
  if (call.session().options().check) return begins;
  if (from->analysis->steps().empty())
    call.refuse("from", "expected a run that has made a step, got one that has not: solve() it before");
  begins.beginning.from = from->analysis.get();
  if (call.has("release")) begins.beginning.release = call.number("release");
  return begins;
}

void say_beginning(Call& call, const run::Run& run) {
  if (run.origin() == 0) return;
  const run::EnergyAccount e = run.energy();
  call.session().notices().remark(
      std::string(run.kind()) + ": begins at time " + fabricsh::number(run.began()) +
      " s from the state of another run, with " + fabricsh::number(e.stored) + " J stored, " +
      fabricsh::number(e.dissipated) + " J dissipated and " + fabricsh::number(e.kinetic) +
      " J in motion; its work is counted from there");
}

// Stores the field "model" of the call as the property of that name of the analysis object on top of the
// stack.
void keep_model(const Call& call) {
  lua_State* L = call.L();
  lua_getiuservalue(L, -1, 1);
  if (call.push("model") == LUA_TNIL) {  // that of the run from which this one begins
    lua_pop(L, 1);
    call.push("from");
    lua_getiuservalue(L, -1, 1);
    lua_getfield(L, -1, "model");
    lua_replace(L, -3);
    lua_pop(L, 1);
  }
  lua_setfield(L, -2, "model");
  lua_pop(L, 1);
}

// Pushes the analysis object of make(model, notices, beginning).
template <class Make>
int push_begun(Call& call, Make make) {
  Session& session = call.session();
  const auto notices = std::shared_ptr<Notices>(&session.notices(), [](Notices*) {});
  const Begins begins = read_beginning(call);
  const auto& model = begins.model;
  const ChangeRefused still_model(session, model.get()), still_mesh(session, &model->mesh());
  const std::shared_ptr<run::Run> run = make(model, notices, begins.beginning);
  say_beginning(call, *run);
  push_run(call.L(), std::make_shared<DeckRun>(session, run));
  keep_model(call);
  return 1;
}

int make_static(Call& call) {
  run::StaticOptions options;
  read_rows(call, run::static_options(), options);
  if (options.method == run::Method::relaxation && call.has("max_iterations"))
    call.session().notices().say(
        "warning: static: field 'max_iterations': no effect with method \"relaxation\"; it bounds those of "
        "Newton's method, before a step is cut");
  return push_begun(call, [&](const auto& model, const auto& notices, const auto& beginning) {
    return std::make_shared<run::Static>(model, options, notices, beginning);
  });
}

int make_dynamic(Call& call) {
  run::DynamicOptions options;
  read_rows(call, run::dynamic_options(), options);
  for (const auto& row : run::dynamic_options())
    if (const std::string why = run::refused_option(options, row.name); !why.empty() && call.has(row.name))
      call.refuse(row.name, why);
  return push_begun(call, [&](const auto& model, const auto& notices, const auto& beginning) {
    return run::make_dynamic(model, options, notices, beginning);
  });
}

const run::Dynamic& dynamic(Call& call) {
  const auto* run = dynamic_cast<const run::Dynamic*>(call.self<DeckRun>()->analysis.get());
  if (run == nullptr) throw Error("a static analysis has no stable step");
  return *run;
}

int stable_step(Call& call) { return push_value(call.L(), dynamic(call).stable_step()); }

int step_size(Call& call) { return push_value(call.L(), dynamic(call).step_size()); }

std::string sample() {
  return "local mesh = fabric.mesh.rectangle{ width=0.4, height=0.1, nx=4, ny=1 }\n"
         "local m = fabric.model{ mesh=mesh, card=fabric.card 'blend' }\n"
         "m:fix('left', 'x y z rotation'):gravity{0, 0, -9.81}\n"
         "local a = fabric.dynamic{ model=m, duration=0.01 }\n";
}

}  // namespace

void bind_runs(Session& session) {
  install(
      session,
      {{"fabric.static{}", with_beginning(arguments_of(run::static_options())),
        "A quasi-static run: Newton's method through the histories' time.",
        sample_run() + "assert(a.duration == 1)", make_static},
       {"fabric.dynamic{}", with_beginning(arguments_of(run::dynamic_options())),
        "A dynamic run by Newmark's method, explicit or implicit, with a balance (ledger) of its energies.",
        sample() + "assert(a:solve().energy.error < 1e-3)", make_dynamic},
       without_arguments(
           "analysis.stable_step",
           "A step that no frequency of the reference configuration forbids central differences, s.",
           sample() + "assert(a.stable_step > 7e-5 and a.stable_step < 8e-5)", stable_step),
       without_arguments("analysis.step_size",
                         "Usual step of a dynamic run, s; steps that end at a prescribed time are shorter.",
                         sample() + "assert(a.step_size < 0.91 * a.stable_step)", step_size)});
}

}  // namespace fabricsh::script
