// What came of an evaluation of forces: of a law at a point, of a term, of all terms together.
#pragma once

namespace fabricsh {

enum class Answer : unsigned char {
  ok,
  cut,    // not with a step as long as this one: a shorter one may do
  broken  // not at all: no step will do, and the run ends
};

inline Answer worse(Answer a, Answer b) { return a > b ? a : b; }

}  // namespace fabricsh
