// The libraries that the linear solvers use.
#pragma once
#include <string>
#include <vector>

#include "base/version.hpp"

namespace fabricsh::linear {

// The kernels that OpenBLAS chose for this machine, as "SkylakeX"; rounding in a solution depends on them.
std::string blas_kernels();

std::vector<Library> libraries();  // Eigen, UMFPACK, CHOLMOD, OpenBLAS with its kernels

}  // namespace fabricsh::linear
