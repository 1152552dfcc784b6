// The answer to whether an equilibrium is stable.
#pragma once

namespace fabricsh::solver {

// unchecked: nobody has asked, or loads without a potential leave no answer by energy.
enum class Stability { unchecked, stable, unstable };

}  // namespace fabricsh::solver
