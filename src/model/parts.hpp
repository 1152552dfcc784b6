// Sheets in parts that nothing connects, which fall apart without a word.
#pragma once
#include <string>
#include <vector>

#include "model/model.hpp"

namespace fabricsh::model {

// For each body whose mesh is in parts that neither seams nor ties connect: that it falls apart. Only where
// parts share places, or where the mesh came from a file, whose parts another program may have left so.
std::vector<std::string> unconnected(const Model& model);

}  // namespace fabricsh::model
