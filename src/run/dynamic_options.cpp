// The options of a dynamic run, one row each.
#include "run/dynamic.hpp"
#include "run/settings.hpp"

namespace fabricsh::run {

namespace {

using O = DynamicOptions;

// The two words of rotary inertia; without one of them the scheme chooses.
field::FieldOf<O> inertia_row() {
  auto row = field::row<O>(
      "inertia", field::FieldType::text, "", {},
      "inertia of the cloth: true; or scaled for the explicit step, with more against rotations and "
      "mass that thin elements take from those about them");
  row.words = {"scaled", "true"};
  row.get = [](const O& o) {
    return o.scaled ? field::Value(std::string(*o.scaled ? "scaled" : "true")) : field::Value();
  };
  row.set = [](O& o, const field::Value& word) { o.scaled = std::get<std::string>(word) == "scaled"; };
  return row.optional();
}

field::FieldOf<O> damping_row() {
  using field::number;
  const std::vector<field::FieldOf<O>> rows{
      number("mass", &O::mass_damping, "1/s", not_negative, "a of the damping matrix a M + b K_M").optional(),
      number("stiffness", &O::stiffness_damping, "s", not_negative, "b of the damping matrix a M + b K_M")
          .optional()};
  const auto same = [](auto& options) -> auto& { return options; };
  return field::grouped<O>("damping", rows, same,
                           "Rayleigh's damping {mass=a, stiffness=b}; none unless given")
      .optional();
}

field::FieldOf<O> rest_row() {
  using field::number;
  const std::vector<field::FieldOf<UntilRest>> rows = field::with_defaults<UntilRest>(
      {number("calm", &UntilRest::calm, "", {0, 1, true, true}, "kinetic energy over the energy stored"),
       number("window", &UntilRest::window, "s", positive, "how long it has to be that calm, at least"),
       number("still", &UntilRest::still, "m", positive, "how far a node may move meanwhile")
           .or_by("1/1000 of the size of the cloth")});
  return field::group(
      "until_rest", &O::until_rest, rows,
      "end where all rests: every seam that is drawn has closed, and for window= and for a third of "
      "the time since seams, loads or motions changed, the kinetic energy has been at most "
      "calm= of that stored and no node has moved by more than still=; a.stopped is then "
      "'at rest', and solve() goes on to the duration, which it may take at most");
}

}  // namespace

const std::vector<field::FieldOf<DynamicOptions>>& dynamic_options() {
  using namespace field;
  static const auto rows = with_defaults<O>({
      number("duration", &O::duration, "s", positive, "time to run, from 0 or from the other run's time"),
      number("step", &O::step, "s", positive,
             "of time; auto: explicit 0.7 of the stable step or less, implicit duration/200")
          .or_word("auto")
          .changes(4),
      word("scheme", &O::scheme, {"explicit", "implicit"},
           "explicit (central differences) or implicit (Newmark with Newton)"),
      number("gamma", &O::gamma, "", Range{0.5, 1}, "of Newmark; above 1/2 it damps").or_by("1/2"),
      number("beta", &O::beta, "", Range{0, 1}, "of Newmark").or_by("0 explicit, (1/2 + gamma)^2/4 implicit"),
      number(
          "hht", &O::hht, "", Range{-1.0 / 3, 0},
          "alpha of Hilbert, Hughes and Taylor: damps high frequencies; beside contact as spectral_radius = "
          "(1 + hht) / (1 - hht)")
          .or_by("0, and -0.2 from the step on in which implicit steps have made energy"),
      number("spectral_radius", &O::spectral_radius, "", Range{0, 1},
             "implicit: share of an amplitude that is left after a step much longer than its period; what is "
             "lost is in energy.damping. By the generalised trapezoidal rule, which never makes energy of "
             "contact; without contact from 1/2 on by alpha, of second order")
          .or_by("1, beside contact 0.9 unless another field chooses the scheme, or error= the steps"),
      flag("slow", &O::slow,
           "implicit: motion that passes through near-equilibria, as spectral_radius=0 (Euler's backward "
           "rule): what is faster than the steps dies within them"),
      number("error", &O::error, "", Range{0, 1, true, true},
             "implicit: steps are so short that none errs by more in the place of a node or body, over the "
             "size of the model; step= is then the largest, a twentieth of the duration unless given")
          .or_by("steps as step= says")
          .decisive(),
      linear_row<O>("implicit: "),
      damping_row(),
      rest_row(),
      inertia_row(),
      flag("force", &O::force, "take the step even above the stable one"),
      number("ledger_limit", &O::ledger_limit, "", positive,
             "the run stops when the error of the energy ledger exceeds this part of the external work"),
      number("tolerance", &O::tolerance, "", Range{0, 1, true, true},
             "implicit: residual over the largest nodal force")
          .changes(1),
      integer("max_iterations", &O::max_iterations, from_one, "implicit: of one step, before it is cut")
          .changes(2),
      integer("max_cuts", &O::max_cuts, not_negative, "implicit: halvings of one step").changes(3),
      flag("line_search", &O::line_search, "implicit: iterations that overshoot are shortened"),
      limit_row<O>(),
  });
  return rows;
}

std::string refused_option(const DynamicOptions& options, const std::string& name) {
  if (options.scheme != Scheme::explicit_steps) return {};
  if (name == "error") return "unknown for scheme=\"explicit\", whose steps are as short as stability wants";
  const bool iterates =
      name == "tolerance" || name == "max_iterations" || name == "max_cuts" || name == "line_search";
  return iterates ? "unknown for scheme=\"explicit\", which does not iterate" : "";
}

}  // namespace fabricsh::run
