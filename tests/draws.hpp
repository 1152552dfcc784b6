// How often a test repeats what it draws at random.
#pragma once
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace fabricsh::test {

// A tenth of the repetitions, unless FABRICSH_TEST_DRAWS states another share of them: all in the long form
// of a room's tests. At least one.
inline int draws(int all) {
  const char* given = std::getenv("FABRICSH_TEST_DRAWS");
  if (given == nullptr) given = "0.1";
  char* end = nullptr;
  const double share = std::strtod(given, &end);
  if (end == given || *end != 0 || !(share > 0 && share <= 1))
    throw std::runtime_error("FABRICSH_TEST_DRAWS: expected a share above 0, at most 1, got " +
                             std::string(given));
  return static_cast<int>(std::ceil(share * all));
}

}  // namespace fabricsh::test
