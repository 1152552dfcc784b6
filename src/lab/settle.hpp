// The last steps of a search whose residuals are divided by their deviation and not quite smooth (a
// simulation may cut its steps at different places). Differences of single parameters then miss the
// combinations that the data hardly determine: one parameter has a large effect, and the small rest that
// remains when the others compensate is lost. So differences are taken along the principal axes of J^T J,
// which the data determine independently, over one standard deviation to both sides.
#pragma once
#include "lab/least_squares.hpp"

namespace fabricsh::lab {

// found: a minimum with its Jacobian. Makes Gauss-Newton steps until one is shorter than a tenth of a
// standard deviation or none is better; at most `rounds` of 2 n + 1 evaluations and three trials.
LeastSquares settle(LeastSquares found, const std::vector<ParameterBounds>& bounds,
                    const std::function<Points(const Points&)>& evaluate, int rounds);

}  // namespace fabricsh::lab
