// The options of a quasi-static run, one row each.
#include "run/settings.hpp"
#include "run/static.hpp"

namespace fabricsh::run {

const std::vector<field::FieldOf<StaticOptions>>& static_options() {
  using namespace field;
  using O = StaticOptions;
  static const auto rows = with_defaults<O>({
      number("duration", &O::duration, "s", positive, "time to run, from 0 or from the other run's time"),
      number("step", &O::step, "s", positive, "largest step").or_by("duration/20").changes(4),
      number("tolerance", &O::tolerance, "", Range{0, 1, true, true}, "residual over the largest nodal force")
          .changes(1),
      integer("max_iterations", &O::max_iterations, from_one, "of one step, before it is cut").changes(2),
      integer("max_cuts", &O::max_cuts, not_negative, "halvings of one step, before the run gives up")
          .changes(3),
      flag("line_search", &O::line_search, "only steps that lower the energy, but for a few on trial"),
      number("ledger_limit", &O::ledger_limit, "", positive,
             "the run stops when cloth stores more than loads and supports can have given it, by this part "
             "of the external work"),
      number("min_step", &O::min_step, "s", positive, "smallest step that cuts go down to").optional(),
      linear_row<O>(""),
      word("control", &O::control, {"load", "arc"},
           "load: steps in time; arc: steps along the path, past limit points, where time may go down"),
      word(
          "method", &O::method, {"newton", "relaxation", "either", "auto"},
          "auto: Newton's method, and where it is slow an overdamped motion and relaxation, in turn; newton: "
          "that alone; relaxation: every step by dynamic relaxation, of cloth with bending of its own by an "
          "overdamped motion; either: relaxation for steps in which Newton fails")
          .or_else("auto"),
      limit_row<O>(),
      number("path", &O::path, "", Range{0, 1, true, true},
             "error of a run by the length of its steps, where laws remember their path, over the largest "
             "displacement or force: each step is compared with two halves and cut; without it some are, and "
             "a warning says so"),
      number("stabilise", &O::stabilise, "", Range{0, 1, false, true},
             "viscous forces on the nodes that lose this fraction of a step's work; true: 2e-4")
          .or_flag(usual_stabilisation)
          .optional(),
  });
  return rows;
}

}  // namespace fabricsh::run
