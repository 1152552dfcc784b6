// fabric.static: a quasi-static run.
#include "run/static.hpp"

#include "script/bind/model.hpp"
#include "script/bind/run.hpp"

namespace fabricsh::script {

using run::Static;

namespace {

const std::vector<std::string> controls{"load", "arc"}, methods{"newton", "relaxation", "either", "auto"};

void read_scheme(Call& call, run::StaticOptions& options) {
  if (call.has("min_step")) options.min_step = call.number("min_step");
  options.linear = chosen<run::Symmetry>(call.text("linear"), symmetry_words);
  options.control = chosen<run::Control>(call.text("control"), controls);
  options.method = chosen<run::Method>(call.text("method"), methods);
  if (!call.has("stabilise")) return;
  if (call.is("stabilise", LUA_TNUMBER))
    options.stabilise = call.number("stabilise");
  else if (call.flag("stabilise"))
    options.stabilise = run::usual_stabilisation;
}

int make_static(Call& call) {
  run::StaticOptions options;
  options.duration = call.number("duration");
  if (call.has("step")) options.step = call.number("step");
  options.tolerance = call.number("tolerance");
  options.max_iterations = call.count("max_iterations");
  options.max_cuts = call.count("max_cuts");
  options.line_search = call.flag("line_search");
  options.ledger_limit = call.number("ledger_limit");
  if (call.has("path")) options.path = call.number("path");
  read_scheme(call, options);
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
  if (call.text("limit") == "stop") run->stop_beyond();
  say_beginning(call, *run);
  push_run(call.L(), std::make_shared<DeckRun>(session, std::move(run)));
  keep_model(call);
  return 1;
}

std::vector<Entry> static_entries() {
  return {
      {"fabric.static", Style::fields,
       with_beginning(
           {number_("duration", "s", positive, "time to run, from 0 or from the other run's time"),
            number_("step", "s", positive, "largest step; default duration/20").optional(),
            number_("tolerance", "", Range{0, 1, true, true}, "residual over the largest nodal force")
                .or_else(1e-10),
            integer_("max_iterations", from_one, "of one step, before it is cut").or_else(200),
            integer_("max_cuts", not_negative, "halvings of one step, before the run gives up").or_else(12),
            value_("line_search", boolean, "only steps that lower the energy, but for a few on trial")
                .or_else(true),
            number_("ledger_limit", "", positive,
                    "the run stops when cloth stores more than loads and supports can have given it, by this "
                    "part of "
                    "the external work")
                .or_else(0.05),
            number_("min_step", "s", positive, "smallest step that cuts go down to").optional(),
            value_("linear", text,
                   "direct solver: auto (symmetric where law and loads are), symmetric, unsymmetric")
                .or_else("auto")
                .one_of(symmetry_words),
            value_(
                "control", text,
                "load: steps in time; arc: steps along the path, past limit points, where time may go down")
                .or_else("load")
                .one_of(controls),
            value_(
                "method", text,
                "auto: Newton's method, and where it is slow an overdamped motion and relaxation, in turn; "
                "newton: "
                "that alone; relaxation: every step by dynamic relaxation, of cloth with bending of its own "
                "by "
                "an overdamped motion; either: relaxation for steps in which Newton fails")
                .or_else("auto")
                .one_of(methods),
            limit_row(),
            number_(
                "path", "", Range{0, 1, true, true},
                "error of a run by the length of its steps, where laws remember their path, over the "
                "largest displacement or force: each step is compared with two halves and cut; without it "
                "some are, and a warning says so")
                .optional(),
            {"stabilise", boolean | number, "", Range{0, 1, false, true},
             "viscous forces on the nodes that lose this fraction of a step's work; true: 2e-4", false}}),
       "A quasi-static run: Newton's method through the histories' time.",
       sample_run() + "assert(a.duration == 1)", make_static},
  };
}

}  // namespace

void bind_static(Session& session) { install(session, static_entries()); }

}  // namespace fabricsh::script
