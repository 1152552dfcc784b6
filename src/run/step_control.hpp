// The size of an implicit step in time: cut where it fails, from the iterations that it took otherwise.
#pragma once
#include <algorithm>
#include <cmath>

#include "base/archive.hpp"

namespace fabricsh::run {

// Iterations that a step of the right size takes, and those from which the next one had better be smaller.
inline constexpr int wanted_iterations = 6, many_iterations = 12;

// End of the next of equal steps, none longer than `step`, from now to a landing.
inline double end_of_step(double now, double landing, double step) {
  const double steps = std::ceil((landing - now) / step - 1e-9);
  return steps <= 1 ? landing : now + (landing - now) / steps;
}

class StepControl {
 public:
  // s: the largest step, and the smallest that cuts go to (at most max_cuts halvings of the largest).
  StepControl(double largest, double smallest, int max_cuts)
      : largest_(largest),
        smallest_(std::max(smallest, std::ldexp(largest, -max_cuts))),
        least_(smallest),
        current_(largest) {}

  void keep(Archive& archive) { archive(current_); }
  double current() const { return current_; }
  double largest() const { return largest_; }
  void set(double step) { current_ = step; }
  double end(double now, double landing) const { return end_of_step(now, landing, current_); }
  // A step of that size failed. False: half of it is too small.
  bool cut(double failed) {
    current_ = failed / 2;
    return current_ >= smallest_;
  }
  // A step took many iterations: the next is smaller. It took few: it grows back to the largest.
  void grow(int iterations, bool was_cut) {
    const double n = std::max(1, iterations);
    if (iterations > many_iterations)
      current_ = std::max({0.5 * current_, least_, current_ * std::sqrt(wanted_iterations / n)});
    else if (!was_cut)
      current_ = std::min(largest_, current_ * std::clamp(2 * wanted_iterations / n, 1.0, 2.0));
  }

 private:
  double largest_, smallest_, least_, current_;
};

}  // namespace fabricsh::run
