// fabric.dynamic: a dynamic run.
#include "run/dynamic.hpp"

#include <algorithm>

#include "script/bind/model.hpp"
#include "script/bind/run.hpp"

namespace fabricsh::script {

namespace {

void read_damping(const Call& call, run::DynamicOptions& options) {
  if (!call.has("damping")) return;
  const Fields damping = call.fields("damping");
  if (damping.has("mass")) options.mass_damping = damping.number("mass");
  if (damping.has("stiffness")) options.stiffness_damping = damping.number("stiffness");
}

void read_slow(const Call& call, run::DynamicOptions& options) {
  if (options.scheme != run::Scheme::implicit_steps)
    call.refuse("slow", "expected with scheme=\"implicit\": explicit steps follow every wave");
  if (options.spectral_radius) call.refuse("slow", "expected without 'spectral_radius', which it sets to 0");
  options.spectral_radius = 0;
}

void read_method(const Call& call, run::DynamicOptions& options) {
  if (call.text("scheme") == "implicit") options.scheme = run::Scheme::implicit_steps;
  if (call.is("step", LUA_TNUMBER)) options.step = call.number("step");
  if (call.has("gamma")) options.gamma = call.number("gamma");
  if (call.has("beta")) options.beta = call.number("beta");
  if (call.has("hht")) options.hht = call.number("hht");
  if (call.has("spectral_radius")) options.spectral_radius = call.number("spectral_radius");
  if (call.flag("slow")) read_slow(call, options);
  options.linear = chosen<run::Symmetry>(call.text("linear"), symmetry_words);
  if (call.has("inertia")) options.scaled = call.text("inertia") == "scaled";
  options.force = call.flag("force");
  options.ledger_limit = call.number("ledger_limit");
}

int make_dynamic(Call& call) {
  run::DynamicOptions options;
  options.duration = call.number("duration");
  read_method(call, options);
  read_damping(call, options);
  if (options.scheme == run::Scheme::explicit_steps)
    for (const char* field : {"tolerance", "max_iterations", "max_cuts"})
      if (call.has(field)) call.refuse(field, "unknown for scheme=\"explicit\", which does not iterate");
  options.tolerance = call.number("tolerance");
  options.max_iterations = call.count("max_iterations");
  options.max_cuts = call.count("max_cuts");
  Session& session = call.session();
  const auto notices = std::shared_ptr<Notices>(&session.notices(), [](Notices*) {});
  const Begins begins = read_beginning(call);
  const auto& model = begins.model;
  const ChangeRefused still_model(session, model.get()), still_mesh(session, &model->mesh());
  auto run = run::make_dynamic(model, options, notices, begins.beginning);
  if (call.text("limit") == "stop") run->stop_beyond();
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

int stable_step(Call& call) {
  lua_pushnumber(call.L(), dynamic(call).stable_step());
  return 1;
}

int step_size(Call& call) {
  lua_pushnumber(call.L(), dynamic(call).step_size());
  return 1;
}

std::string sample() {
  return "local fabric = require 'fabric'\n"
         "local mesh = fabric.mesh.rectangle{ width=0.4, height=0.1, nx=4, ny=1 }\n"
         "local m = fabric.model{ mesh=mesh, card=fabric.card 'blend' }\n"
         "m:fix('left', 'x y z rotation'):gravity{0, 0, -9.81}\n"
         "local a = fabric.dynamic{ model=m, duration=0.01 }\n";
}

std::vector<Argument> arguments() {
  return with_beginning(
      {number_("duration", "s", positive, "time to run, from 0 or from the other run's time"),
       Argument{"step",
                number | text,
                "s",
                positive,
                "of time; auto: explicit 0.7 of the stable step or less, implicit duration/200",
                true,
                {},
                {"auto"}}
           .optional(),
       value_("scheme", text, "explicit (central differences) or implicit (Newmark with Newton)")
           .or_else("explicit")
           .one_of({"explicit", "implicit"}),
       number_("gamma", "", Range{0.5, 1}, "of Newmark; above 1/2 it damps; default 1/2").optional(),
       number_("beta", "", Range{0, 1}, "of Newmark; default 0 explicit, (1/2 + gamma)^2/4 implicit")
           .optional(),
       number_("hht", "", Range{-1.0 / 3, 0},
               "alpha of Hilbert, Hughes and Taylor: damps high frequencies; default 0, and -0.2 from the "
               "step on "
               "in which implicit steps have made energy")
           .optional(),
       number_(
           "spectral_radius", "", Range{0, 1},
           "implicit: share of an amplitude that is left after a step much longer than its period; what is "
           "lost is in energy.damping. From 1/2 on by alpha, of second order; below by the generalised "
           "trapezoidal rule, which beside contact never makes energy")
           .optional(),
       value_("slow", boolean,
              "implicit: motion that passes through near-equilibria, as spectral_radius=0 (Euler's backward "
              "rule): what is faster than the steps dies within them")
           .or_else(false),
       value_("linear", text,
              "implicit: direct solver: auto (symmetric where law and loads are), symmetric, unsymmetric")
           .or_else("auto")
           .one_of(symmetry_words),
       fields_("damping",
               {number_("mass", "1/s", not_negative, "a of the damping matrix a M + b K_M").optional(),
                number_("stiffness", "s", not_negative, "b of the damping matrix a M + b K_M").optional()},
               "Rayleigh's damping {mass=a, stiffness=b}; none unless given")
           .optional(),
       value_("inertia", text,
              "rotary inertia of the cloth: true, or scaled up where it would limit the explicit step")
           .optional()
           .one_of({"scaled", "true"}),
       value_("force", boolean, "take the step even above the stable one").or_else(false),
       number_("ledger_limit", "", positive,
               "the run stops when the error of the energy ledger exceeds this part of the external work")
           .or_else(0.05),
       number_("tolerance", "", Range{0, 1, true, true}, "implicit: residual over the largest nodal force")
           .or_else(1e-8),
       integer_("max_iterations", from_one, "implicit: of one step, before it is cut").or_else(30),
       integer_("max_cuts", not_negative, "implicit: halvings of one step").or_else(12), limit_row()});
}

std::vector<Entry> dynamic_entries() {
  return {
      {"fabric.dynamic", Style::fields, arguments(),
       "A dynamic run by Newmark's method, explicit or implicit, with a balance (ledger) of its energies.",
       sample() + "assert(a:solve().energy.error < 1e-3)", make_dynamic},
      {"analysis.stable_step",
       Style::property,
       {},
       "A step that no frequency of the reference configuration forbids central differences, s.",
       sample() + "assert(a.stable_step > 7e-5 and a.stable_step < 8e-5)",
       stable_step},
      {"analysis.step_size",
       Style::property,
       {},
       "Usual step of a dynamic run, s; steps that end at a prescribed time are shorter.",
       sample() + "assert(a.step_size < 0.91 * a.stable_step)",
       step_size}};
}

}  // namespace

void bind_dynamic(Session& session) { install(session, dynamic_entries()); }

}  // namespace fabricsh::script
