// Loops of which each thread computes a share, where they are long enough for that.
#pragma once
#include <omp.h>

#include <algorithm>

namespace fabricsh {

// A parallel region of a single thread, too, allocates a team and wakes it by a call of the system at its
// end, for which a short loop has been done several times over: without shares none is entered.
inline bool in_shares(bool worth) { return worth && omp_get_max_threads() > 1; }

// body(i) for i = 0 .. count - 1, in any order.
template <class Index, class Body>
void for_each_index(Index count, bool worth, const Body& body) {
  if (in_shares(worth)) {
#pragma omp parallel for schedule(static)
    for (Index i = 0; i < count; ++i) body(i);
  } else {
    for (Index i = 0; i < count; ++i) body(i);
  }
}

// The largest of term(i), in any order, and of zero.
template <class Index, class Term>
double largest_of(Index count, bool worth, const Term& term) {
  double most = 0;
  if (in_shares(worth)) {
#pragma omp parallel for schedule(static) reduction(max : most)
    for (Index i = 0; i < count; ++i) most = std::max(most, term(i));
  } else {
    for (Index i = 0; i < count; ++i) most = std::max(most, term(i));
  }
  return most;
}

}  // namespace fabricsh
