// fabric.static: a quasi-static run.
#include "run/static.hpp"

#include "script/bind/model.hpp"
#include "script/bind/run.hpp"
#include "script/values/field_rows.hpp"

namespace fabricsh::script {

using run::Static;

namespace {

int make_static(Call& call) {
  run::StaticOptions options;
  read_rows(call, run::static_options(), options);
  Session& session = call.session();
  if (options.method == run::Method::relaxation && call.has("max_iterations"))
    session.notices().say(
        "warning: static: field 'max_iterations': no effect with method \"relaxation\"; it bounds those of "
        "Newton's method, before a step is cut");
  const auto notices = std::shared_ptr<Notices>(&session.notices(), [](Notices*) {});
  const Begins begins = read_beginning(call);
  const auto& model = begins.model;
  const ChangeRefused still_model(session, model.get()), still_mesh(session, &model->mesh());
  auto run = std::make_shared<Static>(model, options, notices, begins.beginning);
  say_beginning(call, *run);
  push_run(call.L(), std::make_shared<DeckRun>(session, std::move(run)));
  keep_model(call);
  return 1;
}

std::vector<Entry> static_entries() {
  return {
      {"fabric.static{}", with_beginning(arguments_of(run::static_options())),
       "A quasi-static run: Newton's method through the histories' time.",
       sample_run() + "assert(a.duration == 1)", make_static},
  };
}

}  // namespace

void bind_static(Session& session) { install(session, static_entries()); }

}  // namespace fabricsh::script
