// The settings that may change during a run and that static and dynamic runs have in common.
#pragma once
#include "base/archive.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

// now: the present value; given: that at creation. Reading keeps the present value if `given` differs.
// Not inlined, since GCC 12 then warns of an empty optional's number as uninitialised.
template <class T>
[[gnu::noinline]] void keep_setting(Archive& archive, const T& given, T& now) {
  T given_then = given, then = now;
  archive(given_then, then);
  if (archive.reading() && given_then == given) now = then;
}

template <class T>
void take_setting(const std::optional<T>& wanted, T& now) {
  if (wanted) now = *wanted;
}

// Stores the common options; their order is that of the checkpoint.
template <class Options>
void keep_settings(Archive& archive, const Options& given, Options& now) {
  keep_setting(archive, given.tolerance, now.tolerance);
  keep_setting(archive, given.max_iterations, now.max_iterations);
  keep_setting(archive, given.max_cuts, now.max_cuts);
  keep_setting(archive, given.step, now.step);
}

// Error: with this step the run would not end.
inline void check_step(const char* call, double step, double duration) {
  if (!(duration / step <= most_steps))
    throw Error(std::string(call) + ": field 'step': expected at least " + number(duration / most_steps) +
                " s (" + number(most_steps) + " steps to the duration of " + number(duration) + " s), got " +
                number(step) + " s");
}

// The options with the given changes.
template <class Options, class Settings>
Options with_settings(Options options, const Settings& wanted) {
  take_setting(wanted.tolerance, options.tolerance);
  take_setting(wanted.max_iterations, options.max_iterations);
  take_setting(wanted.max_cuts, options.max_cuts);
  if (wanted.step) options.step = wanted.step;
  return options;
}

}  // namespace fabricsh::run
