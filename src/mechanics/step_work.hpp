// The work of forces of which only the two ends of a step are known.
#pragma once

namespace fabricsh::mechanics {

// J. By the trapezoidal rule, and how far the work can lie from that if the forces change monotonically
// within the step: to either end's forces alone. change: what the work by the forces of the end is more,
// where a scheme weighs them so and the term's own account of the step does not.
struct StepWork {
  double work = 0, spread = 0, change = 0;
  StepWork& operator+=(const StepWork& other) {
    work += other.work;
    spread += other.spread;
    change += other.change;
    return *this;
  }
};

}  // namespace fabricsh::mechanics
