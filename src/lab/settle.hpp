// The last steps of a search whose residuals are in units of their deviation and not quite smooth (a
// simulation cuts its steps here and not there). Differences of single parameters then miss the combinations
// that the data hardly fix: a step of one of them changes much, and what is looked for is the little that
// remains when the others make up for it. So differences are taken along the combinations that the data fix
// independently of each other (the principal axes of J^T J), over a standard deviation of each to both sides.
#pragma once
#include "lab/least_squares.hpp"

namespace fabricsh::lab {

// found: a minimum with its Jacobian. Goes on by Gauss and Newton until a step is shorter than a tenth of a
// standard deviation or nothing better is found, for at most `rounds` of 2 n + 1 evaluations and three tries.
LeastSquares settle(LeastSquares found, const std::vector<Bounds>& bounds,
                    const std::function<Points(const Points&)>& evaluate, int rounds);

}  // namespace fabricsh::lab
