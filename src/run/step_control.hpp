// The size of an implicit step in time: cut after a failure, otherwise adapted to the number of iterations.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/archive.hpp"

namespace fabricsh::run {

// Iterations of a step of the right size, and the number from which the next step is made smaller.
struct StepIterations {
  int wanted, many;
};
// A static step follows a smooth path. In a step of a motion contacts and slack yarns switch, which takes
// some ten iterations however short the step is, so that shorter ones only cost more.
inline constexpr StepIterations kStaticIterations{6, 12}, kMotionIterations{12, 20};
// Cloth that slides on cloth takes as many in a sixteenth of a step: any number is right, and only failures
// shorten a step.
inline constexpr StepIterations kContactIterations{1'000'000, 1'000'000};

// The end of the next step, when the way to a landing is divided into equal steps of at most `step`.
inline double end_of_step(double now, double landing, double step) {
  const double steps = std::ceil((landing - now) / step - 1e-9);
  return steps <= 1 ? landing : now + (landing - now) / steps;
}

class StepControl {
 public:
  // s: the largest step, and the smallest size for cuts (at most max_cuts halvings of the largest).
  StepControl(double largest, double smallest, int max_cuts, StepIterations iterations)
      : largest_(largest),
        smallest_(std::max(smallest, std::ldexp(largest, -max_cuts))),
        current_(largest),
        iterations_(iterations) {}

  void keep(Archive& archive) { archive(current_, cap_, rest_, next_rest_, grown_); }
  double current() const { return current_; }
  double largest() const { return std::min(largest_, cap_); }
  // From here on steps are at most so long, s; none that a cut could not make.
  void limit(double longest) {
    cap_ = std::max(longest, smallest_);
    current_ = std::min(current_, cap_);
  }
  void set(double step) { current_ = step; }
  // For the next step, within the limits.
  void aim(double step) { current_ = std::min(largest(), std::max(step, smallest_)); }
  double smallest() const { return smallest_; }
  double end(double now, double landing) const { return end_of_step(now, landing, current_); }
  // To be called when a step of that size has failed. False: half of it would be too small.
  bool cut(double failed) {
    current_ = failed / 2;
    return current_ >= smallest_;
  }
  // Sliding friction takes many iterations whatever the step: from here on, steps that have not failed do not
  // shrink below this part of the largest.
  void expect_friction() { held_ = largest_ / 16; }
  // Where loose cloth buckles steps are cut one after another: after one that has failed before, some are
  // made until the next one is longer, and twice as many if that had come too soon.
  void rest_after_failure() {
    next_rest_ = grown_ < kSoon ? std::clamp(2 * next_rest_, kRest, kLongestRest) : kRest;
    rest_ = next_rest_;
  }
  // After a step with many iterations the next one is smaller, but none that a cut could not make; after few
  // it grows back to the largest.
  void grow(int iterations, bool was_cut) {
    const double n = std::max(1, iterations), before = current_;
    if (iterations > iterations_.many)
      current_ = std::max({0.5 * current_, std::min(current_, smallest_),
                           current_ * std::sqrt(iterations_.wanted / n), std::min(current_, held_)});
    else if (!was_cut && rest_ == 0)
      current_ = std::min(largest(), current_ * std::clamp(2 * iterations_.wanted / n, 1.0, 2.0));
    if (!was_cut && rest_ > 0) --rest_;
    grown_ = current_ > before ? 0 : std::min(grown_ + 1, kSoon);
  }

 private:
  static constexpr int kRest = 2, kLongestRest = 16, kSoon = 2;

  double largest_, smallest_, current_, held_ = 0, cap_ = std::numeric_limits<double>::infinity();
  StepIterations iterations_;
  int rest_ = 0, next_rest_ = 0;  // steps until one may be longer, now and after the last failure
  int grown_ = kSoon;             // steps since one has become longer, up to kSoon
};

}  // namespace fabricsh::run
