// The time in which waves in the plane of the cloth cross the smallest height of an element, s. The default
// stiffness of contact follows it also where the cloth's own step is longer, so that a rim of small elements
// is pressed no deeper.
#pragma once
#include "model/model.hpp"

namespace fabricsh::mechanics {

double step_across_heights(const model::Model& model);

}  // namespace fabricsh::mechanics
