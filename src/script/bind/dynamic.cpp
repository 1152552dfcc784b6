// fabric.dynamic: a dynamic run.
#include "run/dynamic.hpp"

#include "script/bind/model.hpp"
#include "script/bind/run.hpp"
#include "script/values/field_rows.hpp"

namespace fabricsh::script {

namespace {

int make_dynamic(Call& call) {
  run::DynamicOptions options;
  read_rows(call, run::dynamic_options(), options);
  for (const auto& row : run::dynamic_options())
    if (const std::string why = run::refused_option(options, row.name); !why.empty() && call.has(row.name))
      call.refuse(row.name, why);
  Session& session = call.session();
  const auto notices = std::shared_ptr<Notices>(&session.notices(), [](Notices*) {});
  const Begins begins = read_beginning(call);
  const auto& model = begins.model;
  const ChangeRefused still_model(session, model.get()), still_mesh(session, &model->mesh());
  auto run = run::make_dynamic(model, options, notices, begins.beginning);
  say_beginning(call, *run);
  push_run(call.L(), std::make_shared<DeckRun>(session, std::move(run)));
  keep_model(call);
  return 1;
}

const run::Dynamic& dynamic(Call& call) {
  const auto* run = dynamic_cast<const run::Dynamic*>(call.self<DeckRun>()->analysis.get());
  if (run == nullptr) throw Error("a static analysis has no stable step");
  return *run;
}

int stable_step(Call& call) { return push_value(call.L(), dynamic(call).stable_step()); }

int step_size(Call& call) { return push_value(call.L(), dynamic(call).step_size()); }

std::string sample() {
  return "local fabric = require 'fabric'\n"
         "local mesh = fabric.mesh.rectangle{ width=0.4, height=0.1, nx=4, ny=1 }\n"
         "local m = fabric.model{ mesh=mesh, card=fabric.card 'blend' }\n"
         "m:fix('left', 'x y z rotation'):gravity{0, 0, -9.81}\n"
         "local a = fabric.dynamic{ model=m, duration=0.01 }\n";
}

std::vector<Entry> dynamic_entries() {
  return {
      {"fabric.dynamic{}", with_beginning(arguments_of(run::dynamic_options())),
       "A dynamic run by Newmark's method, explicit or implicit, with a balance (ledger) of its energies.",
       sample() + "assert(a:solve().energy.error < 1e-3)", make_dynamic},
      without_arguments(
          "analysis.stable_step",
          "A step that no frequency of the reference configuration forbids central differences, s.",
          sample() + "assert(a.stable_step > 7e-5 and a.stable_step < 8e-5)", stable_step),
      without_arguments("analysis.step_size",
                        "Usual step of a dynamic run, s; steps that end at a prescribed time are shorter.",
                        sample() + "assert(a.step_size < 0.91 * a.stable_step)", step_size)};
}

}  // namespace

void bind_dynamic(Session& session) { install(session, dynamic_entries()); }

}  // namespace fabricsh::script
