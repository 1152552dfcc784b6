#include "lab/markers.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace fabricsh::lab {

namespace {

std::array<std::size_t, 4> corners(const Tracks& t, std::size_t box) {
  const std::size_t r = box / (t.columns - 1), c = box % (t.columns - 1), m = r * t.columns + c;
  return {m, m + 1, m + t.columns, m + t.columns + 1};
}

double distance(const Tracks& t, std::size_t frame, std::size_t a, std::size_t b) {
  const std::size_t at = frame * t.markers();
  return std::hypot(t.x[at + a] - t.x[at + b], t.y[at + a] - t.y[at + b]);
}

// Mean length of two opposite sides: along joins rows, across joins columns.
double side(const Tracks& t, std::size_t frame, std::size_t box, bool along) {
  const auto k = corners(t, box);
  return along ? (distance(t, frame, k[0], k[2]) + distance(t, frame, k[1], k[3])) / 2
               : (distance(t, frame, k[0], k[1]) + distance(t, frame, k[2], k[3])) / 2;
}

}  // namespace

std::array<double, 4> box_gradient(const Tracks& t, std::size_t box, std::size_t frame) {
  Eigen::Matrix<double, 2, 4> X, x;
  const auto k = corners(t, box);
  const std::size_t at = frame * t.markers();
  for (int i = 0; i < 4; ++i) {
    const std::size_t m = k[static_cast<std::size_t>(i)];
    X.col(i) << t.x[m], t.y[m];
    x.col(i) << t.x[at + m], t.y[at + m];
  }
  X.colwise() -= Eigen::Vector2d(X.rowwise().mean());
  x.colwise() -= Eigen::Vector2d(x.rowwise().mean());
  const Eigen::Matrix2d F = (x * X.transpose()) * (X * X.transpose()).inverse();
  return {F(0, 0), F(0, 1), F(1, 0), F(1, 1)};
}

BoxStrains box_strains(const Tracks& t) {
  BoxStrains out;
  for (std::size_t f = 0; f < t.frames; ++f)
    for (std::size_t b = 0; b < t.boxes(); ++b)
      for (const bool along : {true, false}) {
        const double e = side(t, f, b, along) / side(t, 0, b, along) - 1;
        (along ? out.along : out.across).push_back(e + e * e / 2);
      }
  return out;
}

namespace {

// Variance of E of one side pair for unit noise of a coordinate: l is the mean of two sides, each with two
// free ends, so var l = 1; lambda = l/L, L with the same noise; E = (lambda^2 - 1)/2.
double strain_variance(double E, double length) {
  const double square = 1 + 2 * E;
  return square * (1 + square) / (length * length);
}

struct Sums {  // over the pairs of a box that count
  double xx = 0, xy = 0, yy = 0;
  double var_x = 0, var_y = 0;  // for unit noise
  double n = 0;
  void add(const Sums& o, double sign = 1) {
    xx += sign * o.xx, xy += sign * o.xy, yy += sign * o.yy;
    var_x += sign * o.var_x, var_y += sign * o.var_y, n += sign * o.n;
  }
  double slope(double variance) const { return xy / (xx - variance * var_x); }
};

// Mean strain along the pull of a frame's boxes.
double mean_along(const BoxStrains& strains, std::size_t frame, std::size_t boxes) {
  double sum = 0, n = 0;
  for (std::size_t b = 0; b < boxes; ++b)
    if (const double x = strains.along[frame * boxes + b]; std::isfinite(x)) sum += x, n += 1;
  return n > 0 ? sum / n : 0;
}

// Per box. Frames are taken whole: choosing boxes by their own noisy strain would choose noise.
std::vector<Sums> sums_of(const Tracks& t, double least) {
  const BoxStrains strains = box_strains(t);
  std::vector<Sums> out(t.boxes());
  for (std::size_t f = 1; f < t.frames; ++f) {
    if (mean_along(strains, f, t.boxes()) < least) continue;
    for (std::size_t b = 0; b < t.boxes(); ++b) {
      const double x = strains.along[f * t.boxes() + b], y = strains.across[f * t.boxes() + b];
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      out[b].add({x * x, x * y, y * y, strain_variance(x, side(t, 0, b, true)),
                  strain_variance(y, side(t, 0, b, false)), 1});
    }
  }
  return out;
}

// Noise variance of a coordinate that explains the scatter about the line: the squared distances y - k x have
// the mean var_y + k^2 var_x. The slope takes one freedom.
double scatter_variance(const Sums& s) {
  double variance = 0;
  for (int i = 0; i < 50; ++i) {
    const double k = s.slope(variance);
    const double squares = s.yy - 2 * k * s.xy + k * k * s.xx;
    variance = std::max(0.0, squares / (s.var_y + k * k * s.var_x) * s.n / std::max(1.0, s.n - 1));
    variance = std::min(variance, 0.5 * s.xx / s.var_x);
  }
  return variance;
}

}  // namespace

Ratio contraction_ratio(const Tracks& tracks, double noise, double least) {
  const auto boxes = sums_of(tracks, least);
  Sums all;
  for (const Sums& s : boxes) all.add(s);
  if (all.n < 1 || all.xx <= 0)
    throw Error("poisson: expected strains along the pull of at least " + std::to_string(least));
  const double variance = noise < 0 ? scatter_variance(all) : noise * noise;
  Ratio out{-all.slope(variance), -all.slope(0), std::sqrt(variance), 0};
  double squares = 0, n = 0;
  for (const Sums& s : boxes) {
    Sums rest = all;
    rest.add(s, -1);
    if (s.n == 0 || rest.n == 0) continue;
    n += 1;
    squares += std::pow(-rest.slope(variance) - out.value, 2);
  }
  if (n > 1) out.uncertainty = std::sqrt(squares * (n - 1) / n);
  return out;
}

YarnShear yarn_shear(const std::array<double, 4>& F, double angle) {
  const Eigen::Matrix2d f = (Eigen::Matrix2d() << F[0], F[1], F[2], F[3]).finished();
  const double c = std::cos(angle), s = std::sin(angle);
  const Eigen::Vector2d warp = f * Eigen::Vector2d(c, s), weft = f * Eigen::Vector2d(-s, c);
  const double l1 = warp.norm(), l2 = weft.norm(), cosine = warp.dot(weft) / (l1 * l2);
  return {l1 * l2 * cosine / 2, l1, l2};
}

std::vector<double> shear_shares(const std::vector<double>& E12, std::size_t boxes) {
  std::vector<double> xy(boxes, 0), xx(boxes, 0), share(boxes, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t at = 0; at + boxes <= E12.size(); at += boxes) {
    double sum = 0, n = 0;
    for (std::size_t b = 0; b < boxes; ++b)
      if (std::isfinite(E12[at + b])) sum += E12[at + b], n += 1;
    for (std::size_t b = 0; b < boxes; ++b)
      if (std::isfinite(E12[at + b])) {
        xy[b] += E12[at + b] * sum / n;
        xx[b] += sum / n * sum / n;
      }
  }
  for (std::size_t b = 0; b < boxes; ++b)
    if (xx[b] > 0) share[b] = xy[b] / xx[b];
  return share;
}

std::vector<int> bias_zones(const std::vector<double>& E12) {
  double largest = 0;
  for (const double e : E12)
    if (std::isfinite(e)) largest = std::max(largest, std::abs(e));
  std::vector<int> zones;
  for (const double e : E12)
    zones.push_back(!(std::abs(e) >= 0.25 * largest) ? 1 : std::abs(e) < 0.75 * largest ? 2 : 3);
  return zones;
}

}  // namespace fabricsh::lab
