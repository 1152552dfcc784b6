// Bounded nonlinear least squares: Levenberg-Marquardt (MINPACK as ported by Eigen), with MINUIT's sine
// transformation for the bounds [more1978, james1975]. One call evaluates a whole list of points, so that the
// caller can distribute them over processes.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace fabricsh::lab {

using Points = std::vector<std::vector<double>>;

struct ParameterBounds {
  double low, high;  // low < high
};

struct LeastSquaresOptions {
  int iterations = 50;
  double tolerance = 1e-8;   // relative, for the sum of squares and the parameters
  double difference = 1e-4;  // step of forward differences, relative to high - low
};

struct LeastSquares {
  std::vector<double> x;          // within the bounds
  std::vector<double> residuals;  // at x
  std::vector<double> jacobian;   // d residual / d x, residuals x parameters, row by row
  int iterations = 0;
  bool converged = false;
  std::string reason;
};

// evaluate: one list of residuals per point, all of the same length, at least the number of parameters.
LeastSquares least_squares(std::vector<double> start, const std::vector<ParameterBounds>& bounds,
                           const std::function<Points(const Points&)>& evaluate,
                           const LeastSquaresOptions& options = {});

// How well the data determine each parameter, from the Jacobian of residuals divided by their deviation.
struct Identifiability {
  std::vector<double> deviation;    // standard deviation of each parameter
  std::vector<double> correlation;  // parameters x parameters
  std::vector<double> weakest;      // the least determined combination, of length one in units of `scale`
  double weakest_deviation = 0;     // of that combination, in the same units
};
// scale: a typical size of each parameter (high - low); jacobian: as above.
Identifiability identifiability(const std::vector<double>& jacobian, const std::vector<double>& scale);

// --- The last steps of a search whose residuals are divided by their deviation and not quite smooth (a
// simulation may cut its steps at different places). Differences of single parameters then miss the
// combinations that the data hardly determine: one parameter has a large effect, and the small rest that
// remains when the others compensate is lost. So differences are taken along the principal axes of J^T J,
// which the data determine independently, over one standard deviation to both sides.

// found: a minimum with its Jacobian. Makes Gauss-Newton steps until one is shorter than a tenth of a
// standard deviation or none is better; at most `rounds` of 2 n + 1 evaluations and three trials.
LeastSquares settle(LeastSquares found, const std::vector<ParameterBounds>& bounds,
                    const std::function<Points(const Points&)>& evaluate, int rounds);

}  // namespace fabricsh::lab
