// The outcome of evaluating forces: those of a law at a point, of one term, or of all terms together.
#pragma once

namespace fabricsh {

enum class Answer : unsigned char {
  ok,
  cut,    // not possible with a step of this length; a shorter step may succeed
  broken  // not possible with any step; the run ends
};

inline Answer worse(Answer a, Answer b) { return a > b ? a : b; }

}  // namespace fabricsh
