// How stiff a law is along its axes and in shear, for the choice of the strains of elements and for advice.
#pragma once
#include "law/law.hpp"

namespace fabricsh::law {

// Pa. axis: the stiffest tangent along warp and weft; shear: the first of S12 on 2 E12 of virgin cloth,
// without friction and viscosity, which do not hold it for good.
struct ByDirection {
  double axis[2] = {0, 0}, shear = 0;
};
ByDirection by_direction(const Law& law);

}  // namespace fabricsh::law
