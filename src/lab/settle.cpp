#include "lab/settle.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace fabricsh::lab {

namespace {

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

LeastSquares settle(LeastSquares found, const std::vector<ParameterBounds>& bounds,
                    const std::function<Points(const Points&)>& evaluate, int rounds) {
  return Settler(std::move(found), bounds, evaluate).run(rounds);
}

}  // namespace fabricsh::lab
