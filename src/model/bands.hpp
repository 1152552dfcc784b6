// Bands along edges of cloth: elastic in hems, cords that are drawn tight.
#pragma once
#include <optional>
#include <string>

namespace fabricsh::model {

struct EdgeBand {
  std::string set;                  // nodes of an edge
  double stiffness = 0;             // N, force per strain of the band
  double ease = 0;                  // by what share of the edge the band is shorter
  std::optional<double> over = {};  // s, in which it becomes that short; empty: it is from the start
};

}  // namespace fabricsh::model
