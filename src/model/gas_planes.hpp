// The planes of symmetry that close volumes of gas.
#pragma once
#include <vector>

#include "model/model.hpp"

namespace fabricsh::model {

// The first plane of each axis. Seen from a point in all of them, what lies in them has no part in a volume.
std::vector<SymmetryPlane> planes_of_gas(const Model& model);
// A point in all of them, m; else near the place.
Vec3 apex_of_gas(const Model& model, const Vec3& place);

}  // namespace fabricsh::model
