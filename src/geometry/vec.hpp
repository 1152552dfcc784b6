// Vectors and small matrices of the rooms that are not batch kernels.
#pragma once
#include <Eigen/Dense>

namespace fabricsh {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

}  // namespace fabricsh
