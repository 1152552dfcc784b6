#include "lab/least_squares.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/NonLinearOptimization>

#include "base/error.hpp"

namespace fabricsh::lab {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

// x = low + (high - low) (1 + sin q) / 2
struct BoundedResiduals {
  using Scalar = double;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };
  using InputType = Vector;
  using ValueType = Vector;
  using JacobianType = Matrix;

  const std::vector<ParameterBounds>& bounds;
  const std::function<Points(const Points&)>& evaluate;
  double difference;
  int rows = 0;

  int inputs() const { return static_cast<int>(bounds.size()); }
  int values() const { return rows; }

  std::vector<double> inside(const Vector& q) const {
    std::vector<double> x;
    for (std::size_t i = 0; i < bounds.size(); ++i)
      x.push_back(bounds[i].low +
                  (bounds[i].high - bounds[i].low) * (1 + std::sin(q(static_cast<Eigen::Index>(i)))) / 2);
    return x;
  }
  Vector outside(const std::vector<double>& x) const {
    Vector q(inputs());
    for (std::size_t i = 0; i < x.size(); ++i) {
      // At a bound the derivative of the sine is zero, and the parameter could never leave it again.
      const double part = (x[i] - bounds[i].low) / (bounds[i].high - bounds[i].low);
      q(static_cast<Eigen::Index>(i)) = std::asin(2 * std::min(1 - 1e-4, std::max(1e-4, part)) - 1);
    }
    return q;
  }
  int operator()(const Vector& q, Vector& residuals) const {
    const auto values = evaluate({inside(q)}).at(0);
    residuals = Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
    return 0;
  }
  // d residual / d x by differences away from the nearer bound; all points in one call, the first is x.
  Matrix by_x(const std::vector<double>& x) const {
    Points points{x};
    std::vector<double> steps;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double width = bounds[i].high - bounds[i].low;
      steps.push_back(width * difference * (x[i] - bounds[i].low > width / 2 ? -1 : 1));
      points.push_back(x);
      points.back()[i] += steps[i];
    }
    const Points r = evaluate(points);
    Matrix J(rows, inputs());
    for (Eigen::Index i = 0; i < J.cols(); ++i)
      for (Eigen::Index k = 0; k < J.rows(); ++k)
        J(k, i) = (r[static_cast<std::size_t>(i) + 1][static_cast<std::size_t>(k)] -
                   r[0][static_cast<std::size_t>(k)]) /
                  steps[static_cast<std::size_t>(i)];
    return J;
  }
  int df(const Vector& q, Matrix& J) const {
    J = by_x(inside(q));
    for (Eigen::Index i = 0; i < J.cols(); ++i) {
      const ParameterBounds& b = bounds[static_cast<std::size_t>(i)];
      J.col(i) *= (b.high - b.low) / 2 * std::cos(q(i));
    }
    return 0;
  }
};

std::string words(Eigen::LevenbergMarquardtSpace::Status status) {
  using namespace Eigen::LevenbergMarquardtSpace;
  switch (status) {
    case RelativeReductionTooSmall:
      return "the sum of squares no longer falls";
    case RelativeErrorTooSmall:
      return "the parameters no longer move";
    case RelativeErrorAndReductionTooSmall:
      return "neither the sum of squares nor the parameters change any more";
    case CosinusTooSmall:
      return "no change of the parameters reduces the residuals";
    case FtolTooSmall:
    case XtolTooSmall:
    case GtolTooSmall:
      return "at the limit of the arithmetic";
    default:
      return "too many iterations";
  }
}

void check(const std::vector<double>& start, const std::vector<ParameterBounds>& bounds) {
  for (std::size_t i = 0; i < start.size(); ++i)
    if (!(bounds[i].low < bounds[i].high) || start[i] < bounds[i].low || start[i] > bounds[i].high)
      throw Error("least squares: parameter " + std::to_string(i + 1) +
                  ": expected low < high and the start between them");
}

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double kShort = 0.1;      // of a standard deviation: a shorter step ends the search
constexpr double kWidest = 0.1;     // of high - low: largest difference step of a parameter
constexpr double kShortest = 1e-3;  // of a standard deviation: too near a bound for a difference
constexpr double kWild = 30;        // change of a residual per deviation above which a run has failed

Vector vector_of(const std::vector<double>& v) {
  return Eigen::Map<const Vector>(v.data(), static_cast<Eigen::Index>(v.size()));
}
std::vector<double> list_of(const Vector& v) { return {v.data(), v.data() + v.size()}; }

class Settler {
 public:
  Settler(LeastSquares found, const std::vector<ParameterBounds>& bounds,
          const std::function<Points(const Points&)>& evaluate)
      : found_(std::move(found)), evaluate_(evaluate), low_(bounds.size()), high_(bounds.size()) {
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      low_(static_cast<Eigen::Index>(i)) = bounds[i].low;
      high_(static_cast<Eigen::Index>(i)) = bounds[i].high;
    }
  }

  LeastSquares run(int rounds) {
    for (int round = 0; round < rounds; ++round) {
      const Vector step = difference();
      if (step.norm() < kShort) return finish("settled within a tenth of a standard deviation");
      if (!walk(step)) return finish("nothing better within a standard deviation");
    }
    return finish(found_.reason);
  }

 private:
  LeastSquares finish(const std::string& reason) {
    found_.reason = reason;
    return std::move(found_);
  }

  // Columns: one standard deviation along each principal combination, in parameters.
  void find_axes() {
    const Vector width = high_ - low_;
    const Matrix J = Eigen::Map<const Rows>(found_.jacobian.data(),
                                            static_cast<Eigen::Index>(found_.residuals.size()), low_.size());
    const Eigen::JacobiSVD<Matrix> svd(J * width.asDiagonal(), Eigen::ComputeThinV);
    const Vector s = svd.singularValues().cwiseMax(1e-12 * svd.singularValues()(0)).cwiseMax(1e-300);
    axes_ = width.asDiagonal() * svd.matrixV() * s.cwiseInverse().asDiagonal();
    back_ = s.asDiagonal() * svd.matrixV().transpose() * width.cwiseInverse().asDiagonal();
    columns_ = J * axes_;
  }

  // The fraction of a direction, at most 1, by which x can move within the bounds.
  double reach(const Vector& x, const Vector& direction) const {
    double most = 1;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double size = std::abs(direction(i));
      if (size == 0) continue;
      const double room = direction(i) > 0 ? high_(i) - x(i) : x(i) - low_(i);
      most = std::min({most, room / size, kWidest * (high_(i) - low_(i)) / size});
    }
    return std::max(most, 0.0);
  }

  // Recomputes the Jacobian; returns the Gauss-Newton step in standard deviations along the axes.
  Vector difference() {
    find_axes();
    const Vector x = vector_of(found_.x);
    Vector up(x.size()), down(x.size());
    Points points;
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      up(k) = reach(x, axes_.col(k));
      down(k) = reach(x, -axes_.col(k));
      points.push_back(list_of(x + up(k) * axes_.col(k)));
      points.push_back(list_of(x - down(k) * axes_.col(k)));
    }
    const Points values = evaluate_(points);
    const Vector here = vector_of(found_.residuals);
    for (Eigen::Index k = 0; k < x.size(); ++k)
      slope(k, vector_of(values[2 * static_cast<std::size_t>(k)]) - here, up(k),
            vector_of(values[2 * static_cast<std::size_t>(k) + 1]) - here, down(k));
    const Rows J = columns_ * back_;
    found_.jacobian.assign(J.data(), J.data() + J.size());
    return -columns_.colPivHouseholderQr().solve(here);
  }

  // Sets a column from the changes of the residuals over `up` forward and `down` backward: the slope of a
  // parabola, or of the only usable side; otherwise the column is kept.
  void slope(Eigen::Index k, const Vector& forward, double up, const Vector& backward, double down) {
    const bool ahead = up > kShortest && forward.allFinite() && forward.norm() < kWild;
    const bool behind = down > kShortest && backward.allFinite() && backward.norm() < kWild;
    if (ahead && behind)
      columns_.col(k) = (down * down * forward - up * up * backward) / (up * down * (up + down));
    else if (ahead)
      columns_.col(k) = forward / up;
    else if (behind)
      columns_.col(k) = -backward / down;
  }

  // Tries the step, half and a quarter of it; takes the best if it improves on the present point.
  bool walk(const Vector& step) {
    const Vector x = vector_of(found_.x);
    Points points;
    for (const double part : {1.0, 0.5, 0.25})
      points.push_back(list_of((x + part * (axes_ * step)).cwiseMax(low_).cwiseMin(high_)));
    const Points values = evaluate_(points);
    double best = vector_of(found_.residuals).squaredNorm();
    bool better = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double sum = vector_of(values[i]).squaredNorm();
      if (!(sum < best)) continue;
      best = sum;
      better = true;
      found_.x = points[i];
      found_.residuals = values[i];
    }
    return better;
  }

  LeastSquares found_;
  const std::function<Points(const Points&)>& evaluate_;
  Vector low_, high_;
  Matrix axes_, back_, columns_;
};

}  // namespace

LeastSquares least_squares(std::vector<double> start, const std::vector<ParameterBounds>& bounds,
                           const std::function<Points(const Points&)>& evaluate,
                           const LeastSquaresOptions& options) {
  check(start, bounds);
  BoundedResiduals problem{bounds, evaluate, options.difference};
  problem.rows = static_cast<int>(evaluate({start}).at(0).size());
  if (problem.rows < problem.inputs())
    throw Error("least squares: expected at least as many residuals as parameters (" +
                std::to_string(problem.inputs()) + "), got " + std::to_string(problem.rows));
  Vector q = problem.outside(start);
  Eigen::LevenbergMarquardt<BoundedResiduals> solver(problem);
  solver.parameters.ftol = solver.parameters.xtol = options.tolerance;
  solver.parameters.maxfev = 100 * options.iterations;
  auto status = solver.minimizeInit(q);
  while (status == Eigen::LevenbergMarquardtSpace::NotStarted ||
         status == Eigen::LevenbergMarquardtSpace::Running) {
    status = solver.minimizeOneStep(q);
    if (solver.iter > options.iterations) break;
  }
  LeastSquares out;
  out.x = problem.inside(q);
  out.residuals.assign(solver.fvec.data(), solver.fvec.data() + solver.fvec.size());
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> J = problem.by_x(out.x);
  out.jacobian.assign(J.data(), J.data() + J.size());
  out.iterations = static_cast<int>(solver.iter) - 1;
  out.reason = words(status);
  out.converged = status > 0 && status != Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation;
  return out;
}

Identifiability identifiability(const std::vector<double>& jacobian, const std::vector<double>& scale) {
  const auto n = static_cast<Eigen::Index>(scale.size());
  const auto m = static_cast<Eigen::Index>(jacobian.size()) / n;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Vector size = Eigen::Map<const Vector>(scale.data(), n);
  const Matrix J = Eigen::Map<const Rows>(jacobian.data(), m, n) * size.asDiagonal();
  const Eigen::JacobiSVD<Matrix> svd(J, Eigen::ComputeThinV);
  const double none =
      std::numeric_limits<double>::epsilon() * svd.singularValues()(0) * static_cast<double>(m);
  const Vector inverse =
      svd.singularValues().unaryExpr([none](double s) { return 1 / std::max(s, std::max(none, 1e-300)); });
  const Matrix half = svd.matrixV() * inverse.asDiagonal();
  const Matrix C = half * half.transpose();
  Identifiability out;
  for (Eigen::Index i = 0; i < n; ++i) {
    out.deviation.push_back(std::sqrt(C(i, i)) * size(i));
    for (Eigen::Index j = 0; j < n; ++j) out.correlation.push_back(C(i, j) / std::sqrt(C(i, i) * C(j, j)));
    out.weakest.push_back(svd.matrixV()(i, n - 1));
  }
  out.weakest_deviation = inverse(n - 1);
  return out;
}

LeastSquares settle(LeastSquares found, const std::vector<ParameterBounds>& bounds,
                    const std::function<Points(const Points&)>& evaluate, int rounds) {
  return Settler(std::move(found), bounds, evaluate).run(rounds);
}

}  // namespace fabricsh::lab
