// What the linear solvers stand on.
#pragma once
#include <vector>

#include "base/version.hpp"

namespace fabricsh::solver {

std::vector<Library> libraries();  // Eigen, UMFPACK, CHOLMOD, OpenBLAS with the kernels that it chose

}  // namespace fabricsh::solver
