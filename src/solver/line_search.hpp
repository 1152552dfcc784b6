// The line search of every solver that goes along a direction delta: on the energy, whose derivative along it
// is g(a) = delta . r(a), until |g(a)| <= |g(0)| / 2 [williams2010, Box 5-1].
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

namespace fabricsh::solver {

struct LineSearch {
  bool on = true;       // off: the first share that can be evaluated is taken
  bool shorten = true;  // where the forces cannot be evaluated: a quarter of the share, and again
  double largest = 1;   // share to begin with, above 0
};

// try_share(a): moves by a * delta and gives g(a), or nothing where the forces cannot be evaluated there.
// Ends at the last share tried, which it returns; 0: none could be evaluated. While g has not changed its
// sign the whole share is taken: the next iteration goes on from there. After ten tries the last one is
// taken.
template <class TryShare>
double line_search(double g0, const LineSearch& how, TryShare try_share) {
  constexpr int tries = 10;
  double a = how.largest;
  for (int i = 0; i < tries; ++i) {
    const std::optional<double> g = try_share(a);
    if (!g) {
      if (!how.shorten) return 0;
      a /= 4;
      continue;
    }
    const bool crossed = (*g > 0) != (g0 > 0);
    if (!how.on || std::abs(*g) <= std::abs(g0) / 2 || !crossed || i == tries - 1) return a;
    a = std::max(a * g0 / (g0 - *g), 0.1 * a);  // regula falsi between 0 and a
  }
  return 0;
}

}  // namespace fabricsh::solver
