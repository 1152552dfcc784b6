#include "photograph/dots.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace fabricsh::photograph {

namespace {

Image smoothed(const Image& in, const std::vector<double>& kernel) {
  const int reach = static_cast<int>(kernel.size() / 2);
  Image half = in, out = in;
  const auto pass = [&](const Image& from, Image& to, bool across) {
    for (int row = 0; row < in.height; ++row)
      for (int column = 0; column < in.width; ++column) {
        double sum = 0;
        for (int k = -reach; k <= reach; ++k) {
          const int c = std::clamp(across ? column + k : column, 0, in.width - 1);
          const int r = std::clamp(across ? row : row + k, 0, in.height - 1);
          sum += kernel[static_cast<std::size_t>(k + reach)] * from.at(c, r);
        }
        to.at(column, row) = static_cast<float>(sum);
      }
  };
  pass(in, half, true);
  pass(half, out, false);
  return out;
}

// The brightness that separates the pixels of an image best into two classes [otsu1979].
double threshold(const Image& image) {
  std::array<double, 256> count{};
  for (const float p : image.pixels)
    count[static_cast<std::size_t>(std::clamp(p * 255.0F, 0.0F, 255.0F))] += 1;
  double total = 0, all = 0, below = 0, sum = 0, best = -1, at = 0.5;
  for (std::size_t i = 0; i < 256; ++i) total += count[i], all += count[i] * static_cast<double>(i);
  for (std::size_t i = 0; i < 255; ++i) {
    below += count[i];
    sum += count[i] * static_cast<double>(i);
    if (below == 0 || below == total) continue;
    const double gap = sum / below - (all - sum) / (total - below);
    const double between = below * (total - below) * gap * gap;
    if (between > best) best = between, at = (static_cast<double>(i) + 1) / 255;
  }
  return at;
}

struct DarkSpot {
  int left, right, top, bottom;  // columns and rows, inclusive
  std::size_t area;
};

// Connected groups of pixels (with four neighbours each) that are inside.
std::vector<DarkSpot> spots(const std::vector<char>& inside, int width, int height) {
  std::vector<char> seen(inside.size(), 0);
  std::vector<DarkSpot> out;
  std::vector<int> stack;
  for (int start = 0; start < width * height; ++start) {
    if (!inside[static_cast<std::size_t>(start)] || seen[static_cast<std::size_t>(start)]) continue;
    DarkSpot spot{width, -1, height, -1, 0};
    stack.assign(1, start);
    seen[static_cast<std::size_t>(start)] = 1;
    while (!stack.empty()) {
      const int at = stack.back(), c = at % width, r = at / width;
      stack.pop_back();
      spot = {std::min(spot.left, c), std::max(spot.right, c), std::min(spot.top, r),
              std::max(spot.bottom, r), spot.area + 1};
      for (const auto& [dc, dr] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        if (c + dc < 0 || c + dc >= width || r + dr < 0 || r + dr >= height) continue;
        const auto next = static_cast<std::size_t>((r + dr) * width + c + dc);
        if (!inside[next] || seen[next]) continue;
        seen[next] = 1;
        stack.push_back(static_cast<int>(next));
      }
    }
    out.push_back(spot);
  }
  return out;
}

double quantile(std::vector<float> values, double part) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Brightness of the background (median of the border of the window) and of the dot (median of its core).
std::pair<double, double> levels(const Image& image, const Window& w, double sign) {
  std::vector<float> rim, core;
  const double cx = (w.left + w.right) / 2.0, cy = (w.top + w.bottom) / 2.0;
  const double a = std::max(1.0, (w.right - w.left) / 4.0 - 1),
               b = std::max(1.0, (w.bottom - w.top) / 4.0 - 1);
  for (int r = w.top; r <= w.bottom; ++r)
    for (int c = w.left; c <= w.right; ++c) {
      const auto value = static_cast<float>(sign * image.at(c, r));
      if (r == w.top || r == w.bottom || c == w.left || c == w.right) rim.push_back(value);
      if (std::hypot((c - cx) / a, (r - cy) / b) < 0.7) core.push_back(value);
    }
  return {quantile(rim, 0.5), core.empty() ? quantile(rim, 0.5) : quantile(core, 0.5)};
}

// The centroid of the darkness, clipped to 15 to 85 % of the contrast so that noise inside and outside the
// dot has no weight; and the ellipse with the same second moments (those of a full ellipse are a quarter of
// its squared half axes).
std::pair<Dot, Ellipse> centroid(const Image& image, const Window& w, double sign) {
  const auto [ground, core] = levels(image, w, sign);
  Dot dot{0, 0, 0, ground - core};
  double xx = 0, xy = 0, yy = 0;
  for (int r = w.top; r <= w.bottom; ++r)
    for (int c = w.left; c <= w.right; ++c) {
      const double part = (ground - sign * image.at(c, r)) / dot.contrast;
      const double weight = std::clamp((part - 0.15) / 0.7, 0.0, 1.0);
      dot.area += weight;
      dot.x += weight * c;
      dot.y += weight * r;
      xx += weight * c * c;
      xy += weight * c * r;
      yy += weight * r * r;
    }
  dot.x /= dot.area;
  dot.y /= dot.area;
  xx = 4 * (xx / dot.area - dot.x * dot.x);
  xy = 4 * (xy / dot.area - dot.x * dot.y);
  yy = 4 * (yy / dot.area - dot.y * dot.y);
  const double det = xx * yy - xy * xy;
  return {dot, {dot.x, dot.y, yy / det, -xy / det, xx / det, sign * ground, sign * core, 1}};
}

// Largest residual of an ellipse fit relative to the contrast. Above it the spot has another shape, and its
// centroid is used.
constexpr double kLargestResidual = 0.05;

// The window is the spot with a margin, which may contain pixels of neighbouring dots.
Dot measured(const Image& image, const Window& w, double sign, double contrast) {
  auto [dot, start] = centroid(image, w, sign);
  if (dot.contrast < contrast) return dot;
  if (const auto found = fit_ellipse(image, w, start, kLargestResidual)) {
    dot.x = found->x;
    dot.y = found->y;
  }
  return dot;
}

}  // namespace

std::vector<Dot> find_dots(const Image& image, const DotOptions& options) {
  const double sign = options.dark ? 1 : -1;
  const Image smooth = smoothed(image, {0.25, 0.5, 0.25});
  const double limit = threshold(smooth);
  std::vector<char> inside(image.pixels.size());
  for (std::size_t i = 0; i < inside.size(); ++i) inside[i] = sign * smooth.pixels[i] < sign * limit;
  std::vector<Dot> out;
  for (const DarkSpot& s : spots(inside, image.width, image.height)) {
    const auto area = static_cast<double>(s.area);
    if (area < options.smallest || area > options.largest) continue;
    constexpr int margin = 4;
    const Window w{s.left - margin, s.right + margin, s.top - margin, s.bottom + margin};
    if (w.left < 0 || w.top < 0 || w.right >= image.width || w.bottom >= image.height) continue;
    const Dot dot = measured(image, w, sign, options.contrast);
    if (dot.contrast >= options.contrast) out.push_back(dot);
  }
  return out;
}

namespace {

std::array<double, 2> reference(const DotGrid& s, std::size_t dot) {
  const double c = static_cast<double>(dot % s.columns) - static_cast<double>(s.columns - 1) / 2;
  const double r = static_cast<double>(dot / s.columns) - static_cast<double>(s.rows - 1) / 2;
  return {c * s.pitch, r * s.pitch};
}

std::vector<double> gaussian(double deviation) {
  const int reach = std::max(1, static_cast<int>(std::ceil(4 * deviation)));
  std::vector<double> kernel;
  double sum = 0;
  for (int k = -reach; k <= reach; ++k) {
    kernel.push_back(deviation > 0 ? std::exp(-k * k / (2 * deviation * deviation)) : k == 0 ? 1.0 : 0.0);
    sum += kernel.back();
  }
  for (double& k : kernel) k /= sum;
  return kernel;
}

using Inverse = std::array<double, 4>;

struct Point {
  double X, Y;
};

// Where a place of the picture lies in the undeformed grid.
Point undeformed(const DotGrid& s, const Inverse& inverse, double column, double row) {
  const double x = column - (s.width - 1) / 2.0, y = row - (s.height - 1) / 2.0;
  return {inverse[0] * x + inverse[1] * y, inverse[2] * x + inverse[3] * y};
}

std::array<double, 2> nearest_middle(const DotGrid& s, const Point& at) {
  const auto nearest = [&](double along, std::size_t count) {
    const double last = static_cast<double>(count - 1);
    return static_cast<std::size_t>(std::clamp(std::floor(along / s.pitch + last / 2 + 0.5), 0.0, last));
  };
  return reference(s, nearest(at.Y, s.rows) * s.columns + nearest(at.X, s.columns));
}

// Distance of a point from the rim of a dot, positive outside, in pixels of the undeformed grid.
double outside_rim(const DotGrid& s, const Point& at, const std::array<double, 2>& middle) {
  const double dx = at.X - middle[0], dy = at.Y - middle[1];
  return std::sqrt(dx * dx + dy * dy) - s.radius;
}

// The part of a pixel covered by a dot, from side x side samples if the rim passes near.
double covered(const DotGrid& s, const Inverse& inverse, int column, int row) {
  const Point here = undeformed(s, inverse, column, row);
  const auto middle = nearest_middle(s, here);
  const double away = outside_rim(s, here, middle);
  const double reach = std::sqrt(inverse[0] * inverse[0] + inverse[1] * inverse[1] + inverse[2] * inverse[2] +
                                 inverse[3] * inverse[3]);
  if (std::abs(away) > reach) return away < 0 ? 1 : 0;
  constexpr int side = 24;
  const auto at = [](int i) { return (i + 0.5) / side - 0.5; };
  const bool alone = s.radius + 2 * reach < s.pitch / 2;  // no other dot is nearer to a sample
  int hits = 0;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const Point sample = undeformed(s, inverse, column + at(j), row + at(i));
      hits += outside_rim(s, sample, alone ? middle : nearest_middle(s, sample)) < 0 ? 1 : 0;
    }
  return hits / static_cast<double>(side * side);
}

}  // namespace

std::vector<double> true_positions(const DotGrid& s) {
  std::vector<double> out;
  for (std::size_t dot = 0; dot < s.rows * s.columns; ++dot) {
    const auto X = reference(s, dot);
    out.push_back((s.width - 1) / 2.0 + s.F[0] * X[0] + s.F[1] * X[1]);
    out.push_back((s.height - 1) / 2.0 + s.F[2] * X[0] + s.F[3] * X[1]);
  }
  return out;
}

Image draw(const DotGrid& s) {
  const double det = s.F[0] * s.F[3] - s.F[1] * s.F[2];
  const std::array<double, 4> inverse{s.F[3] / det, -s.F[1] / det, -s.F[2] / det, s.F[0] / det};
  Image image{s.width, s.height,
              std::vector<float>(static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height))};
  for (int row = 0; row < s.height; ++row)
    for (int column = 0; column < s.width; ++column)
      image.at(column, row) =
          static_cast<float>(s.ground + (s.ink - s.ground) * covered(s, inverse, column, row));
  image = smoothed(image, gaussian(s.blur));
  std::mt19937_64 random(s.seed);
  std::normal_distribution<double> normal(0, s.noise);
  for (float& p : image.pixels)
    p = static_cast<float>(std::clamp(std::round(255 * (p + normal(random))) / 255, 0.0, 1.0));
  return image;
}

}  // namespace fabricsh::photograph
