// What the linear solvers stand on.
#pragma once
#include <string>
#include <vector>

#include "base/version.hpp"

namespace fabricsh::linear {

// The name of the kernels that OpenBLAS chose for this machine, "SkylakeX": the bits of a solve hang on them.
std::string blas_kernels();

std::vector<Library> libraries();  // Eigen, UMFPACK, CHOLMOD, OpenBLAS with the kernels that it chose

}  // namespace fabricsh::linear
