// Vectors and small matrices for all code outside the batch kernels.
#pragma once
#include <Eigen/Dense>

namespace fabricsh {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

}  // namespace fabricsh
