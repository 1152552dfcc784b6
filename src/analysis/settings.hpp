// A setting that may change while a run is under way.
#pragma once
#include "base/archive.hpp"

namespace fabricsh::analysis {

// now: as it stands; given: as the run was made.
template <class T>
void keep_setting(Archive& archive, const T& given, T& now) {
  T given_then = given, then = now;
  archive(given_then, then);
  if (archive.reading() && given_then == given) now = then;
}

template <class T>
void take_setting(const std::optional<T>& wanted, T& now) {
  if (wanted) now = *wanted;
}

}  // namespace fabricsh::analysis
