#include "photograph/correlation.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "base/error.hpp"

namespace fabricsh::photograph {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr int kIterations = 60;
constexpr double kConverged = 1e-4;  // pixels, of the subset's corners
constexpr double kFarthest = 4;      // pixels from the start of an iteration: it has found something else
// A texture determines a displacement when noise of one grey level of 256 moves it by less than this, pixels.
constexpr double kBlurred = 0.02;
constexpr double kLevel = 1.0 / 255;

// Pixels at the rim that no subset has on the first photograph, so that one that moves by less is not lost.
constexpr int kRim = 4;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Eigen::Map<const Matrix6> matrix(const std::array<double, 36>& values) {
  return Eigen::Map<const Matrix6>(values.data());
}

// The map of a subset about its middle as a matrix, and back.
Eigen::Matrix3d map_of(const Subset& s) {
  Eigen::Matrix3d m;
  m << 1 + s.G[0], s.G[1], s.u, s.G[2], 1 + s.G[3], s.v, 0, 0, 1;
  return m;
}
void set_map(Subset& s, const Eigen::Matrix3d& m) {
  s.u = m(0, 2);
  s.v = m(1, 2);
  s.G = {m(0, 0) - 1, m(0, 1), m(1, 0), m(1, 1) - 1};
}

}  // namespace

Image cropped(const Image& image, const PixelRegion& r) {
  Image out{r.right - r.left, r.bottom - r.top, {}};
  for (int row = r.top; row < r.bottom; ++row)
    for (int column = r.left; column < r.right; ++column) out.pixels.push_back(image.at(column, row));
  return out;
}

Correlator::Correlator(const Image& first, const CorrelationOptions& options)
    : width_(first.width), height_(first.height), options_(options) {
  const Spline spline(first);
  const int half = options.half, side = 2 * half + 1;
  const int left = std::max(kRim, options.region.left),
            right = std::min(first.width - kRim, options.region.right);
  const int top = std::max(kRim, options.region.top),
            bottom = std::min(first.height - kRim, options.region.bottom);
  if (right - left < side || bottom - top < side)
    throw Error("correlate: expected a region of at least " + std::to_string(side) + " x " +
                std::to_string(side) + " pixels, one subset, got " + std::to_string(right - left) + " x " +
                std::to_string(bottom - top));
  columns_ = static_cast<std::size_t>((right - left - side) / options.step + 1);
  rows_ = static_cast<std::size_t>((bottom - top - side) / options.step + 1);
  std::vector<double> blurred;
  for (std::size_t r = 0; r < rows_; ++r)
    for (std::size_t c = 0; c < columns_; ++c) {
      const int x = left + half + static_cast<int>(c) * options.step,
                y = top + half + static_cast<int>(r) * options.step;
      Subset subset;
      subset.x = x;
      subset.y = y;
      SubsetPattern p;
      Matrix6 sum = Matrix6::Zero();
      double mean = 0;
      for (int j = -half; j <= half; ++j)
        for (int i = -half; i <= half; ++i) {
          const auto [dx, dy] = spline.slope(x + i, y + j);
          p.values.push_back(first.at(x + i, y + j));
          p.descent.push_back({dx, dx * i, dx * j, dy, dy * i, dy * j});
          const Eigen::Map<const Vector6> d(p.descent.back().data());
          sum += d * d.transpose();
          mean += p.values.back() / (side * side);
        }
      double square = 0;
      for (double& v : p.values) v -= mean, square += v * v;
      p.norm = std::sqrt(square);
      const double xx = sum(0, 0), xy = sum(0, 3), yy = sum(3, 3);
      const double weakest = (xx + yy) / 2 - std::hypot((xx - yy) / 2, xy);
      blurred.push_back(weakest > 0 ? std::sqrt(2.0) * kLevel / std::sqrt(weakest) : nan);
      if (blurred.back() < kBlurred) {
        for (double& v : p.values) v /= p.norm;
        const Matrix6 inverse = sum.inverse();
        std::copy(inverse.data(), inverse.data() + 36, p.inverse.begin());
        std::copy(sum.data(), sum.data() + 36, p.products.begin());
        order_.push_back(subsets_.size());
      } else {
        subset.state = Subset::SubsetState::textureless;
        p = {};
      }
      patterns_.push_back(std::move(p));
      subsets_.push_back(subset);
    }
  if (order_.empty())
    throw Error(
        "correlate: none of the " + std::to_string(subsets_.size()) +
        " subsets on the first photograph has a texture that determines a displacement: larger subsets, "
        "another region, or speckles");
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t a, std::size_t b) { return blurred[a] < blurred[b]; });
}

// Whole pixels around where the subset is expected, its pattern turned and stretched as last seen: the place
// where the correlation is largest. False: not in the picture.
bool Correlator::searched(const Image& pixels, Subset& s, std::size_t subset) const {
  const int half = options_.half;
  const SubsetPattern& p = patterns_[subset];
  std::vector<std::pair<int, int>> places;
  for (int j = -half; j <= half; ++j)
    for (int i = -half; i <= half; ++i)
      places.emplace_back(std::lround(s.x + s.u + i + s.G[0] * i + s.G[1] * j),
                          std::lround(s.y + s.v + j + s.G[2] * i + s.G[3] * j));
  double best = -2;
  std::pair<int, int> by;
  for (int dy = -options_.search; dy <= options_.search; ++dy)
    for (int dx = -options_.search; dx <= options_.search; ++dx) {
      double sum = 0, square = 0, product = 0;
      bool inside = true;
      for (std::size_t k = 0; k < places.size() && inside; ++k) {
        const int column = places[k].first + dx, row = places[k].second + dy;
        inside = column >= 0 && row >= 0 && column < width_ && row < height_;
        if (!inside) break;
        const double g = pixels.at(column, row);
        sum += g;
        square += g * g;
        product += g * p.values[k];
      }
      const auto n = static_cast<double>(places.size());
      const double spread = square - sum * sum / n;
      if (!inside || spread <= 0) continue;
      const double correlation = product / std::sqrt(spread);
      if (correlation > best) best = correlation, by = {dx, dy};
    }
  if (best < -1) return false;
  s.u += by.first;
  s.v += by.second;
  return true;
}

// Deviation of a displacement from what is left of the difference (the sum of its squares), which is the
// noise of both images. Interpolation reduces that of the second between pixels, but not at the wavelengths
// of the speckles, which decide; noise of the first image also enters the gradient, and is ignored there.
double Correlator::deviation(const SubsetPattern& p, const Subset& s, double rest) const {
  const int half = options_.half;
  const auto n = static_cast<double>(p.values.size());
  double kept = 0, square = 0;
  for (int j = -half; j <= half; ++j)
    for (int i = -half; i <= half; ++i) {
      kept +=
          Spline::kept(s.x + s.u + i + s.G[0] * i + s.G[1] * j, s.y + s.v + j + s.G[2] * i + s.G[3] * j) / n;
      square += i * i;
    }
  const double noise = rest / (n - 8) / (1 + kept);  // six parameters, brightness and contrast
  Matrix6 clean = matrix(p.products);
  const double noise_term = noise * Spline::slope_noise();
  for (int k = 0; k < 6; ++k) clean(k, k) -= noise_term * (k % 3 == 0 ? n : square);
  const Matrix6 inverse = clean.inverse();
  return std::sqrt(noise * (inverse(0, 0) + inverse(3, 3)));
}

// Gauss and Newton on the zero-mean normalised difference, the step taken by the first photograph's subset
// and undone on the map [pan2013]. False: lost.
bool Correlator::refine(const Spline& image, Subset& s, std::size_t subset) const {
  const int half = options_.half;
  const SubsetPattern& p = patterns_[subset];
  const Subset start = s;
  std::vector<double> g(p.values.size());
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    double mean = 0, square = 0;
    std::size_t k = 0;
    for (int j = -half; j <= half; ++j)
      for (int i = -half; i <= half; ++i, ++k) {
        const double x = s.x + s.u + i + s.G[0] * i + s.G[1] * j, y = s.y + s.v + j + s.G[2] * i + s.G[3] * j;
        if (!image.holds(x, y)) return false;
        g[k] = image.at(x, y);
        mean += g[k];
      }
    mean /= static_cast<double>(g.size());
    for (double& v : g) v -= mean, square += v * v;
    if (square <= 0) return false;
    const double norm = std::sqrt(square);
    Vector6 right = Vector6::Zero();
    double rest = 0, correlation = 0;
    for (k = 0; k < g.size(); ++k) {
      const double e = p.norm * (p.values[k] - g[k] / norm);
      right += e * Eigen::Map<const Vector6>(p.descent[k].data());
      rest += e * e;
      correlation += p.values[k] * g[k] / norm;
    }
    const Vector6 step = -matrix(p.inverse) * right;
    Subset moved;
    moved.u = step(0), moved.v = step(3);
    moved.G = {step(1), step(2), step(4), step(5)};
    set_map(s, map_of(s) * map_of(moved).inverse());
    if (!(std::hypot(s.u - start.u, s.v - start.v) < kFarthest)) return false;
    const double largest = std::hypot(step(0), step(3)) +
                           half * std::hypot(std::hypot(step(1), step(2)), std::hypot(step(4), step(5)));
    if (largest < kConverged) {
      s.correlation = correlation;
      s.deviation = deviation(p, s, rest);
      return correlation >= options_.least;
    }
  }
  return false;
}

// From every subset that was found to its four neighbours, the best first: each starts where the map of the
// one that leads to it would put it [pan2013].
void Correlator::spread(const Spline& image, std::vector<std::size_t> found) {
  const auto worse = [&](std::size_t a, std::size_t b) {
    const double x = subsets_[a].correlation, y = subsets_[b].correlation;
    return x != y ? x < y : a > b;
  };
  std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(worse)> open(worse);
  for (const std::size_t i : found) open.push(i);
  while (!open.empty()) {
    const std::size_t from = open.top();
    open.pop();
    const auto row = static_cast<std::ptrdiff_t>(from / columns_),
               column = static_cast<std::ptrdiff_t>(from % columns_);
    for (const auto& [dr, dc] : {std::pair{0, 1}, {0, -1}, {1, 0}, {-1, 0}}) {
      if (row + dr < 0 || column + dc < 0 || row + dr >= static_cast<std::ptrdiff_t>(rows_) ||
          column + dc >= static_cast<std::ptrdiff_t>(columns_))
        continue;
      const auto to =
          static_cast<std::size_t>((row + dr) * static_cast<std::ptrdiff_t>(columns_) + column + dc);
      if (subsets_[to].state != Subset::SubsetState::lost) continue;
      const Subset& lead = subsets_[from];
      Subset s = subsets_[to];
      const double dx = s.x - lead.x, dy = s.y - lead.y;
      s.G = lead.G;
      s.u = lead.u + s.G[0] * dx + s.G[1] * dy;
      s.v = lead.v + s.G[2] * dx + s.G[3] * dy;
      if (!refine(image, s, to)) continue;
      s.state = Subset::SubsetState::found;
      subsets_[to] = s;
      open.push(to);
    }
  }
}

void Correlator::seed(const Spline& image, const Image& pixels, std::size_t subset) {
  if (subsets_[subset].state != Subset::SubsetState::lost) return;
  Subset s = subsets_[subset];
  if (!searched(pixels, s, subset) || !refine(image, s, subset)) return;
  s.state = Subset::SubsetState::found;
  subsets_[subset] = s;
  spread(image, {subset});
}

// A subset that resembles the wrong place (a pattern that repeats itself, little texture) is not where the
// maps of its neighbours put it: it is lost. The median of their places decides [westerweel2005].
void Correlator::part_strays() {
  constexpr double kNear = 0.5, kSpread = 5;  // pixels; times the median distance of the neighbours' places
  std::vector<std::size_t> strays;
  std::vector<double> u, v, away;
  const auto median = [](std::vector<double>& list) {
    std::nth_element(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2), list.end());
    return list[list.size() / 2];
  };
  const auto rows = static_cast<std::ptrdiff_t>(rows_), columns = static_cast<std::ptrdiff_t>(columns_);
  for (std::size_t i = 0; i < subsets_.size(); ++i) {
    const Subset& here = subsets_[i];
    if (here.state != Subset::SubsetState::found) continue;
    u.clear(), v.clear(), away.clear();
    const auto row = static_cast<std::ptrdiff_t>(i) / columns,
               column = static_cast<std::ptrdiff_t>(i) % columns;
    for (std::ptrdiff_t r = std::max<std::ptrdiff_t>(0, row - 1); r <= std::min(rows - 1, row + 1); ++r)
      for (std::ptrdiff_t c = std::max<std::ptrdiff_t>(0, column - 1); c <= std::min(columns - 1, column + 1);
           ++c) {
        const Subset& s = subsets_[static_cast<std::size_t>(r * columns + c)];
        if (&s == &here || s.state != Subset::SubsetState::found) continue;
        const double dx = here.x - s.x, dy = here.y - s.y;
        u.push_back(s.u + s.G[0] * dx + s.G[1] * dy);
        v.push_back(s.v + s.G[2] * dx + s.G[3] * dy);
      }
    if (u.size() < 4) continue;  // too few to find the outlier
    const double mu = median(u), mv = median(v);
    for (std::size_t k = 0; k < u.size(); ++k) away.push_back(std::hypot(u[k] - mu, v[k] - mv));
    if (std::hypot(here.u - mu, here.v - mv) > kNear + kSpread * median(away)) strays.push_back(i);
  }
  for (const std::size_t i : strays) subsets_[i].state = Subset::SubsetState::lost;
}

// The plane of displacements through the subsets around each, and its Green-Lagrange strain.
void Correlator::strains() {
  const int reach = options_.gauge / 2;
  const auto at = [&](std::ptrdiff_t r, std::ptrdiff_t c) -> const Subset* {
    if (r < 0 || c < 0 || r >= static_cast<std::ptrdiff_t>(rows_) ||
        c >= static_cast<std::ptrdiff_t>(columns_))
      return nullptr;
    const Subset& s = subsets_[static_cast<std::size_t>(r) * columns_ + static_cast<std::size_t>(c)];
    return s.state == Subset::SubsetState::found ? &s : nullptr;
  };
  for (std::size_t i = 0; i < subsets_.size(); ++i) {
    Subset& here = subsets_[i];
    here.strain = {nan, nan, nan};
    if (here.state != Subset::SubsetState::found) continue;
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, 2> b = Eigen::Matrix<double, 3, 2>::Zero();
    for (int dr = -reach; dr <= reach; ++dr)
      for (int dc = -reach; dc <= reach; ++dc) {
        const Subset* s = at(static_cast<std::ptrdiff_t>(i / columns_) + dr,
                             static_cast<std::ptrdiff_t>(i % columns_) + dc);
        if (!s) continue;
        const Eigen::Vector3d place((s->x - here.x) / options_.step, (s->y - here.y) / options_.step, 1);
        A += place * place.transpose();
        b += place * Eigen::RowVector2d(s->u, s->v);
      }
    const Eigen::FullPivLU<Eigen::Matrix3d> lu(A);
    if (A(2, 2) < 5 || !lu.isInvertible()) continue;  // three would be met by any noise
    const Eigen::Matrix<double, 3, 2> plane = lu.solve(b) / options_.step;
    const double xx = plane(0, 0), xy = plane(1, 0), yx = plane(0, 1), yy = plane(1, 1);
    here.strain = {xx + (xx * xx + yx * yx) / 2, yy + (xy * xy + yy * yy) / 2,
                   (xy + yx + xx * xy + yx * yy) / 2};
  }
}

const std::vector<Subset>& Correlator::add(const Image& image) {
  if (image.width != width_ || image.height != height_)
    throw Error("correlate: expected photographs of " + std::to_string(width_) + " x " +
                std::to_string(height_) + " pixels as the first, got one of " + std::to_string(image.width) +
                " x " + std::to_string(image.height));
  const Spline spline(image);
  // Each starts at its last known position.
  for (const std::size_t i : order_) subsets_[i].state = Subset::SubsetState::lost;
  for (const std::size_t i : order_) seed(spline, image, i);
  part_strays();
  strains();
  return subsets_;
}

}  // namespace fabricsh::photograph
