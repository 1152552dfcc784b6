#include <Eigen/Dense>
#include <cmath>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include "photograph/dots.hpp"

namespace fabricsh::photograph {

namespace {

using Vector = Eigen::VectorXd;

constexpr int kParameters = 8;
constexpr double kLargestShift = 0.5;  // pixels from the start; beyond it the fit has found another object
constexpr double kSharpest =
    0.3;  // pixels; below it the rim lies between two pixels: the blur is not observable

Vector vector_of(const Ellipse& e) {
  Vector p(kParameters);
  p << e.x, e.y, e.xx, e.xy, e.yy, e.ground, e.ink, e.blur;
  return p;
}
Ellipse ellipse_of(const Vector& p) { return {p(0), p(1), p(2), p(3), p(4), p(5), p(6), p(7)}; }

double brightness(const Ellipse& e, double column, double row) {
  const double dx = column - e.x, dy = row - e.y;
  const double gx = e.xx * dx + e.xy * dy, gy = e.xy * dx + e.yy * dy;
  const double q = std::sqrt(std::max(0.0, dx * gx + dy * gy)), slope = std::hypot(gx, gy);
  // Distance from the rim to first order: (q - 1) over the gradient of q; exact for a circle.
  const double away = slope > 0 ? (q - 1) * q / slope : -1e3;
  const double blur = std::max(kSharpest, std::abs(e.blur));
  return e.ground + (e.ink - e.ground) * std::erfc(away / (blur * std::sqrt(2.0))) / 2;
}

struct EllipseResiduals {
  using Scalar = double;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };
  using InputType = Vector;
  using ValueType = Vector;
  using JacobianType = Eigen::MatrixXd;

  const Image& image;
  Window w;

  int inputs() const { return kParameters; }
  int values() const { return (w.right - w.left + 1) * (w.bottom - w.top + 1); }
  int operator()(const Vector& p, Vector& rest) const {
    const Ellipse e = ellipse_of(p);
    Eigen::Index at = 0;
    for (int row = w.top; row <= w.bottom; ++row)
      for (int column = w.left; column <= w.right; ++column)
        rest(at++) = brightness(e, column, row) - image.at(column, row);
    return 0;
  }
};

}  // namespace

std::optional<Ellipse> fit_ellipse(const Image& image, const Window& window, const Ellipse& start,
                                   double largest_residual) {
  Eigen::NumericalDiff<EllipseResiduals> picture(EllipseResiduals{image, window});
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<EllipseResiduals>> search(picture);
  search.parameters.maxfev = 200;
  search.parameters.ftol = search.parameters.xtol = 1e-7;
  Vector p = vector_of(start);
  search.minimize(p);
  const Ellipse found = ellipse_of(p);
  const double rest = search.fnorm / std::sqrt(static_cast<double>(picture.values()));
  const bool near = std::hypot(found.x - start.x, found.y - start.y) < kLargestShift;
  if (!near || !(rest < largest_residual * std::abs(found.ground - found.ink))) return std::nullopt;
  return found;
}

}  // namespace fabricsh::photograph
