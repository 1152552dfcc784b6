// An upper bound of the frequencies of a model, from those of its elements and what springs and loads add.
#pragma once
#include <span>
#include <vector>

#include "mechanics/assembly.hpp"

namespace fabricsh::mechanics {

// 1/s^2, per node: a bound of what the tangents of all terms but cloth and contact add to the squares of the
// frequencies, at the trial configuration. Empty: nothing. For true or scaled rotary inertia.
std::vector<double> added_rates(const Assembly& assembly, bool scaled);

// 1/s^2: no frequency's square is above this one at the trial configuration, whatever the laws' tangents are.
double rate_bound(const Assembly& assembly, bool scaled, std::span<const double> added);

// The element from which the bound comes, which takes longer to find.
struct FastestElement {
  double rate = 0, added = 0;  // 1/s^2, the bound and what the other terms have of it
  Index element = -1;
};
enum class At { reference, trial };
FastestElement fastest_element(const Assembly& assembly, bool scaled, std::span<const double> added, At at);

}  // namespace fabricsh::mechanics
