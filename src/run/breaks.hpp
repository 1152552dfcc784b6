// Yarns and stitches that are about to break.
#pragma once
#include "mechanics/assembly.hpp"

namespace fabricsh::run {

// The largest force over strength of yarns in tearable zones and of stitches.
struct NearestBreak {
  double trial = 0, committed = 0;
};
NearestBreak nearest_break(const mechanics::Assembly& assembly);

}  // namespace fabricsh::run
