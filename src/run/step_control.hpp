// The size of an implicit step in time: cut after a failure, otherwise adapted to the number of iterations.
#pragma once
#include <algorithm>
#include <cmath>

#include "base/archive.hpp"

namespace fabricsh::run {

// Iterations of a step of the right size, and the number from which the next step is made smaller.
inline constexpr int wanted_iterations = 6, many_iterations = 12;

// The end of the next step, when the way to a landing is divided into equal steps of at most `step`.
inline double end_of_step(double now, double landing, double step) {
  const double steps = std::ceil((landing - now) / step - 1e-9);
  return steps <= 1 ? landing : now + (landing - now) / steps;
}

class StepControl {
 public:
  // s: the largest step, and the smallest size for cuts (at most max_cuts halvings of the largest).
  StepControl(double largest, double smallest, int max_cuts)
      : largest_(largest), smallest_(std::max(smallest, std::ldexp(largest, -max_cuts))), current_(largest) {}

  void keep(Archive& archive) { archive(current_); }
  double current() const { return current_; }
  double largest() const { return largest_; }
  void set(double step) { current_ = step; }
  double end(double now, double landing) const { return end_of_step(now, landing, current_); }
  // To be called when a step of that size has failed. False: half of it would be too small.
  bool cut(double failed) {
    current_ = failed / 2;
    return current_ >= smallest_;
  }
  // Sliding friction takes many iterations whatever the step: from here on, steps that have not failed do not
  // shrink below this part of the largest.
  void expect_friction() { held_ = largest_ / 16; }
  // After a step with many iterations the next one is smaller, but none that a cut could not make; after few
  // it grows back to the largest.
  void grow(int iterations, bool was_cut) {
    const double n = std::max(1, iterations);
    if (iterations > many_iterations)
      current_ = std::max({0.5 * current_, std::min(current_, smallest_),
                           current_ * std::sqrt(wanted_iterations / n), std::min(current_, held_)});
    else if (!was_cut)
      current_ = std::min(largest_, current_ * std::clamp(2 * wanted_iterations / n, 1.0, 2.0));
  }

 private:
  double largest_, smallest_, current_, held_ = 0;
};

}  // namespace fabricsh::run
