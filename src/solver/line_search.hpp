// The line search of all solvers that move along a direction delta. It works on the energy, whose derivative
// along delta is g(a) = delta . r(a), and ends when |g(a)| <= |g(0)| / 2 [williams2010, Box 5-1].
#pragma once
#include <algorithm>
#include <cmath>

#include "base/answer.hpp"

namespace fabricsh::solver {

struct LineSearch {
  bool on = true;       // off: the first fraction at which the forces can be evaluated is taken
  bool shorten = true;  // where the forces cannot be evaluated, try a quarter of the fraction, repeatedly
  double largest = 1;   // fraction to begin with; 0: none is possible
};

// The result at one fraction of the step: g, if the forces could be evaluated.
struct TriedFraction {
  Answer answer = Answer::ok;
  double g = 0;
};

// The last fraction tried, and its result.
struct Searched {
  double fraction = 0;
  Answer answer = Answer::ok;
};

// try_fraction(a) moves by a * delta and returns g(a). While g has the sign of g(0), the whole
// fraction is taken, since the next iteration continues from there. Where g has changed its sign, the root is
// kept between two fractions: by secants, but by halving the interval once two of them have ended before the
// root, as they do where something stiff begins to resist, like a contact. After ten attempts the last one is
// taken. If the search ends with an answer other than ok, no fraction can be used.
template <class TryFraction>
Searched line_search(double g0, const LineSearch& how, TryFraction try_fraction) {
  constexpr int tries = 10;
  double a = how.largest;
  if (!(a > 0)) return {0, Answer::cut};
  double low = 0, g_low = g0, high = 0, g_high = 0;  // high: 0 if none is known
  int before = 0;                                    // attempts that ended before the root
  for (int i = 0; i < tries; ++i) {
    const TriedFraction tried = try_fraction(a);
    if (tried.answer == Answer::broken) return {a, Answer::broken};
    if (tried.answer == Answer::cut) {
      if (!how.shorten) break;
      a = low + (a - low) / 4;
      continue;
    }
    const bool crossed = (tried.g > 0) != (g0 > 0);
    if (!how.on || std::abs(tried.g) <= std::abs(g0) / 2 || (!crossed && high == 0) || i == tries - 1)
      return {a, Answer::ok};
    (crossed ? high : low) = a;
    (crossed ? g_high : g_low) = tried.g;
    if (!crossed) ++before;
    const double margin = before < 2 ? 0.1 : 0.5;
    a = low + (high - low) * std::clamp(g_low / (g_low - g_high), margin, 1 - margin);
  }
  return {a, Answer::cut};
}

}  // namespace fabricsh::solver
