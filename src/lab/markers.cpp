#include "lab/markers.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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

// The two distances whose mean is a box's length along or across the pull. For a grid: opposite sides (along:
// between rows, across: between columns); for four pins in a diamond: one diagonal, counted twice.
class Gauges {
 public:
  Gauges(const Tracks& t, const Arrangement& arrangement) : t_(t), arrangement_(arrangement) {}
  double length(std::size_t frame, std::size_t box, bool along) const {
    if (arrangement_.diamond) {
      const auto& p = arrangement_.pins;
      return along ? distance(t_, frame, p[0], p[1]) : distance(t_, frame, p[2], p[3]);
    }
    const auto k = corners(t_, box);
    return along ? (distance(t_, frame, k[0], k[2]) + distance(t_, frame, k[1], k[3])) / 2
                 : (distance(t_, frame, k[0], k[1]) + distance(t_, frame, k[2], k[3])) / 2;
  }
  // Variance of that length for coordinates with unit noise: each distance has two independent ends.
  double variance() const { return arrangement_.diamond ? 2 : 1; }

 private:
  const Tracks& t_;
  Arrangement arrangement_;
};

// The least-squares deformation gradient F that maps some markers from the first frame to another.
Eigen::Matrix2d gradient(const Tracks& t, const std::vector<std::size_t>& markers, std::size_t frame) {
  const auto n = static_cast<Eigen::Index>(markers.size());
  Eigen::Matrix2Xd X(2, n), x(2, n);
  const std::size_t at = frame * t.markers();
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t m = markers[static_cast<std::size_t>(i)];
    X.col(i) << t.x[m], t.y[m];
    x.col(i) << t.x[at + m], t.y[at + m];
  }
  X.colwise() -= Eigen::Vector2d(X.rowwise().mean());
  x.colwise() -= Eigen::Vector2d(x.rowwise().mean());
  return (x * X.transpose()) * (X * X.transpose()).inverse();
}

// The markers that are visible both in the first frame and in another.
std::vector<std::size_t> seen(const Tracks& t, std::size_t frame) {
  std::vector<std::size_t> out;
  const std::size_t at = frame * t.markers();
  for (std::size_t m = 0; m < t.markers(); ++m)
    if (std::isfinite(t.x[m] + t.y[m] + t.x[at + m] + t.y[at + m])) out.push_back(m);
  return out;
}

// The direction in the first frame along which the cloth is stretched most in any frame; zero if no frame has
// a stretch that exceeds the one across by `least`.
Eigen::Vector2d pull_direction(const Tracks& t, double least) {
  Eigen::Vector2d best = Eigen::Vector2d::Zero();
  double largest = least;
  for (std::size_t f = 1; f < t.frames; ++f) {
    const auto markers = seen(t, f);
    if (markers.size() < 4) continue;
    const Eigen::Matrix2d F = gradient(t, markers, f);
    if (!F.allFinite()) continue;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> stretch(F.transpose() * F);
    const double more =
        std::sqrt(stretch.eigenvalues()(1)) - std::sqrt(std::max(0.0, stretch.eigenvalues()(0)));
    if (more > largest) largest = more, best = stretch.eigenvectors().col(1);
  }
  return best;
}

Eigen::Vector2d between(const Tracks& t, std::size_t a, std::size_t b) {
  return {t.x[b] - t.x[a], t.y[b] - t.y[a]};
}

// The angle between two directions, 0 to 90 degrees.
double angle(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::acos(std::min(1.0, std::abs(a.normalized().dot(b.normalized())))) * 180 / M_PI;
}

constexpr double straight = 30;  // degrees by which a grid may be off the pull

// Four pins: the two that are farthest apart along the pull, and the two between them.
std::optional<Arrangement> diamond(const Tracks& t, const Eigen::Vector2d& pull) {
  std::array<std::size_t, 4> order = {0, 1, 2, 3};
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return between(t, b, a).dot(pull) < 0; });
  const Eigen::Vector2d along = between(t, order[0], order[3]), across = between(t, order[1], order[2]);
  if (!(angle(along, pull) <= straight && angle(across, pull) >= 90 - straight)) return {};
  return Arrangement{true, {order[0], order[3], order[1], order[2]}};
}

}  // namespace

Arrangement arrangement_of(const Tracks& t) {
  constexpr double least = 0.01;
  const Eigen::Vector2d pull = pull_direction(t, least);
  if (pull.isZero()) return {};
  // Sum of the vectors from the first row to the last, and from the first column to the last.
  Eigen::Vector2d rows = Eigen::Vector2d::Zero(), columns = Eigen::Vector2d::Zero();
  for (std::size_t c = 0; c < t.columns; ++c) {
    const Eigen::Vector2d line = between(t, c, (t.rows - 1) * t.columns + c);
    if (line.allFinite()) rows += line;
  }
  for (std::size_t r = 0; r < t.rows; ++r) {
    const Eigen::Vector2d line = between(t, r * t.columns, r * t.columns + t.columns - 1);
    if (line.allFinite()) columns += line;
  }
  // In a box both are long and point the right way; pins in another order have one short or rotated.
  const double size = std::max(rows.norm(), columns.norm());
  const bool box = t.markers() > 4 || std::min(rows.norm(), columns.norm()) > 1e-6 * size;
  const double off = rows.isZero() ? 90 : angle(rows, pull);
  if (box && off <= straight && (t.markers() > 4 || angle(columns, pull) >= 90 - straight)) return {};
  if (t.markers() == 4)
    if (const auto found = diamond(t, pull)) return *found;
  throw Error(
      "expected rows of markers that follow each other along the pull, but the cloth is stretched most at " +
      std::to_string(std::lround(off)) +
      " degrees to the line from the first row to the last: are rows and " +
      "columns exchanged, or were the pins named in another order?");
}

std::array<double, 4> box_gradient(const Tracks& t, std::size_t box, std::size_t frame) {
  const auto k = corners(t, box);
  const Eigen::Matrix2d F = gradient(t, {k.begin(), k.end()}, frame);
  return {F(0, 0), F(0, 1), F(1, 0), F(1, 1)};
}

namespace {

BoxStrains strains_of(const Tracks& t, const Gauges& gauges) {
  BoxStrains out;
  for (std::size_t f = 0; f < t.frames; ++f)
    for (std::size_t b = 0; b < t.boxes(); ++b)
      for (const bool along : {true, false}) {
        const double e = gauges.length(f, b, along) / gauges.length(0, b, along) - 1;
        (along ? out.along : out.across).push_back(e + e * e / 2);
      }
  return out;
}

}  // namespace

BoxStrains box_strains(const Tracks& t) { return strains_of(t, Gauges(t, {})); }

namespace {

// Variance of E from one pair of sides for coordinates with unit noise. l is the mean of two sides, each with
// two independent ends, so var l = 1; lambda = l/L, where L has the same noise; E = (lambda^2 - 1)/2.
double strain_variance(double E, double length) {
  const double square = 1 + 2 * E;
  return square * (1 + square) / (length * length);
}

struct Sums {  // over the pairs of a box that are used
  double xx = 0, xy = 0, yy = 0;
  double var_x = 0, var_y = 0;  // for unit noise
  double n = 0;
  void add(const Sums& o, double sign = 1) {
    xx += sign * o.xx, xy += sign * o.xy, yy += sign * o.yy;
    var_x += sign * o.var_x, var_y += sign * o.var_y, n += sign * o.n;
  }
  double slope(double variance) const { return xy / (xx - variance * var_x); }
};

// Mean strain along the pull over the boxes of a frame.
double mean_along(const BoxStrains& strains, std::size_t frame, std::size_t boxes) {
  double sum = 0, n = 0;
  for (std::size_t b = 0; b < boxes; ++b)
    if (const double x = strains.along[frame * boxes + b]; std::isfinite(x)) sum += x, n += 1;
  return n > 0 ? sum / n : 0;
}

// For each box. Frames are used as a whole: selecting boxes by their own noisy strain would select noise.
std::vector<Sums> sums_of(const Tracks& t, double least) {
  const Gauges gauges(t, arrangement_of(t));
  const BoxStrains strains = strains_of(t, gauges);
  std::vector<Sums> out(t.boxes());
  for (std::size_t f = 1; f < t.frames; ++f) {
    if (mean_along(strains, f, t.boxes()) < least) continue;
    for (std::size_t b = 0; b < t.boxes(); ++b) {
      const double x = strains.along[f * t.boxes() + b], y = strains.across[f * t.boxes() + b];
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      out[b].add({x * x, x * y, y * y, gauges.variance() * strain_variance(x, gauges.length(0, b, true)),
                  gauges.variance() * strain_variance(y, gauges.length(0, b, false)), 1});
    }
  }
  return out;
}

// Noise variance of a coordinate from the scatter about the line: the squared distances y - k x have the mean
// var_y + k^2 var_x. The slope uses one degree of freedom.
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

std::vector<double> shear_ratios(const std::vector<double>& E12, std::size_t boxes) {
  std::vector<double> xy(boxes, 0), xx(boxes, 0), fraction(boxes, std::numeric_limits<double>::quiet_NaN());
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
    if (xx[b] > 0) fraction[b] = xy[b] / xx[b];
  return fraction;
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
