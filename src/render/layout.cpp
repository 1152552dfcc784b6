#include "render/layout.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

namespace fabricsh::render {

namespace {

Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1]}; }
Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1]}; }
Point operator*(double s, const Point& a) { return {s * a[0], s * a[1]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1]; }
double length(const Point& a) { return std::hypot(a[0], a[1]); }

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Half of the extent of a text along a direction.
double reach(const Point& size, const Point& along) {
  return (std::abs(along[0]) * size[0] + std::abs(along[1]) * size[1]) / 2;
}

bool overlap(const Word& a, const Word& b, double gap) {
  return std::abs(a.centre[0] - b.centre[0]) < (a.size[0] + b.size[0]) / 2 + gap &&
         std::abs(a.centre[1] - b.centre[1]) < (a.size[1] + b.size[1]) / 2 + gap;
}

std::string text_of(double value, double step) {
  char text[32];
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  std::snprintf(text, sizeof text, "%.*f", decimals, value == 0 ? 0.0 : value);
  return text;
}

// Rounded tick values within a range.
struct Ticks {
  double first, step;
  int count;
  double value(int i) const { return step * std::round(first / step + i); }
};

Ticks ticks(double low, double high, double step) {
  const double slack = 1e-9 * (high - low), first = step * std::ceil((low - slack) / step);
  const double count = std::floor((high + slack - first) / step) + 1;
  return {first, step, std::max(0, static_cast<int>(count))};
}

class ViewDraft {
 public:
  ViewDraft(const Bounds& bounds, const View& view, const std::string& unit, const Space& space, double scale)
      : bounds_(bounds), view_(view), unit_(unit), space_(space), scale_(scale) {}

  // The layout with the centre of the bounds at {0, 0}.
  ViewLayout made() {
    if (!unit_.empty()) {
      for (int k = 0; k < 3; ++k) axis(k);
      for (const auto& [k, start, end, out] : axes_) labels(k, start, end, out);
    }
    return {scale_, {}, words_, lines_};
  }

 private:
  struct BoxAxis {
    int k;
    Point start, end, out;
  };

  Point at(const Vector& p) const {
    Vector from_centre{};
    for (std::size_t k = 0; k < 3; ++k) from_centre[k] = p[k] - (bounds_[2 * k] + bounds_[2 * k + 1]) / 2;
    return {scale_ * dot(from_centre, view_.right), scale_ * dot(from_centre, view_.up)};
  }

  // x and y are labelled along the lowest of their four edges, z along the
  // leftmost one; ties are resolved by the leftmost, then the lowest edge.
  void axis(int k) {
    const auto n = static_cast<std::size_t>(k), i = (n + 1) % 3, j = (n + 2) % 3;
    BoxAxis best{k, {}, {}, {}};
    double least = std::numeric_limits<double>::infinity();
    for (int edge = 0; edge < 4; ++edge) {
      Vector p{};
      p[i] = bounds_[2 * i + static_cast<std::size_t>(edge & 1)];
      p[j] = bounds_[2 * j + static_cast<std::size_t>(edge >> 1)];
      p[n] = bounds_[2 * n];
      const Point start = at(p);
      p[n] = bounds_[2 * n + 1];
      const Point end = at(p), middle = 0.5 * (start + end);
      const double rank = k == 2 ? middle[0] + 1e-3 * middle[1] : middle[1] + 1e-3 * middle[0];
      if (rank < least) least = rank, best.start = start, best.end = end;
    }
    const Point along = best.end - best.start;
    if (length(along) < space_.letter) return;
    best.out = (1 / length(along)) * Point{along[1], -along[0]};
    const double side = dot(best.out, 0.5 * (best.start + best.end));
    if (side < -1e-6 || (side < 1e-6 && best.out[1] > 0)) best.out = -1.0 * best.out;
    axes_.push_back(best);
    lines_.push_back({best.start, best.end});
  }

  double widest(const Ticks& t, const Point& along) const {
    double all = 0;
    for (int i = 0; i < t.count; ++i)
      all = std::max(all, 2 * reach(space_.measure(text_of(t.value(i), t.step)), along));
    return all;
  }

  // The smallest round interval whose tick labels keep a distance.
  Ticks chosen(int k, const Point& along, double pixels) const {
    const double low = bounds_[static_cast<std::size_t>(2 * k)],
                 high = bounds_[static_cast<std::size_t>(2 * k + 1)];
    const double decade = std::pow(10, std::floor(std::log10(high - low)) - 1);
    for (const auto& [apart, gap] :
         {std::pair{3.2, 1.0},
          {2.0, 1.0},
          {1.2, 0.5}})  // smaller distances only if there were fewer than two ticks
      for (const double part : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
        const Ticks t = ticks(low, high, part * decade);
        const double distance = pixels * t.step / (high - low);
        if (distance < apart * space_.letter || distance < widest(t, along) + gap * space_.letter) continue;
        if (t.count >= 2) return t;
        break;
      }
    return ticks(low, high, 1000 * decade);
  }

  bool free(const Word& word) const {
    return std::none_of(words_.begin(), words_.end(),
                        [&](const Word& other) { return overlap(word, other, 0.4 * space_.letter); });
  }

  void labels(int k, const Point& start, const Point& end, const Point& out) {
    const double pixels = length(end - start), tick = 0.4 * space_.letter;
    const Point along = (1 / pixels) * (end - start);
    const double low = bounds_[static_cast<std::size_t>(2 * k)],
                 high = bounds_[static_cast<std::size_t>(2 * k + 1)];
    const Ticks t = chosen(k, along, pixels);
    double farthest = tick;
    for (int i = 0; i < t.count; ++i) {
      const Point foot = start + (pixels * (t.value(i) - low) / (high - low)) * along;
      lines_.push_back({foot, foot + tick * out});
      Word word{text_of(t.value(i), t.step), {}, {}};
      word.size = space_.measure(word.text);
      word.centre = foot + (1.6 * tick + reach(word.size, out)) * out;
      farthest = std::max(farthest, 1.6 * tick + 2 * reach(word.size, out));
      if (free(word)) words_.push_back(word);
    }
    title(k, start, end, out, farthest);
  }

  // Beside the middle of the axis, moved outwards until it overlaps no other label; above a vertical axis.
  void title(int k, const Point& start, const Point& end, const Point& out, double farthest) {
    Word word{std::string(1, "xyz"[k]) + ", " + unit_, {}, {}};
    word.size = space_.measure(word.text);
    const Point top = start[1] > end[1] ? start : end;
    const bool upright = std::abs(out[1]) < 0.2;
    const Point from = upright ? top : 0.5 * (start + end), way = upright ? Point{0, 1} : out;
    double distance = (upright ? space_.letter : farthest + 0.4 * space_.letter) + reach(word.size, way);
    do {
      word.centre = from + distance * way;
      distance += 0.5 * space_.letter;
    } while (!free(word));
    words_.push_back(word);
  }

  const Bounds& bounds_;
  const View& view_;
  const std::string& unit_;
  const Space& space_;
  double scale_;
  std::vector<BoxAxis> axes_;
  std::vector<Word> words_;
  std::vector<Segment> lines_;
};

struct ProjectedBounds {
  Point low{0, 0}, high{0, 0};
  void add(const Point& p) {
    for (std::size_t k = 0; k < 2; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
  }
};

// The space occupied by the sheet, its axes and their labels.
ProjectedBounds taken(const ViewLayout& l, const Bounds& b, const View& view) {
  ProjectedBounds frame;
  for (int corner = 0; corner < 8; ++corner) {
    Point p{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double half = (corner >> k & 1 ? 0.5 : -0.5) * (b[2 * k + 1] - b[2 * k]) * l.scale;
      p = p + half * Point{view.right[k], view.up[k]};
    }
    frame.add(p);
  }
  for (const Word& word : l.words)
    frame.add(word.centre - 0.5 * word.size), frame.add(word.centre + 0.5 * word.size);
  for (const Segment& line : l.lines) frame.add(line.from), frame.add(line.to);
  return frame;
}

}  // namespace

View view_from(double azimuth, double elevation) {
  const double a = azimuth * std::numbers::pi / 180, e = elevation * std::numbers::pi / 180;
  return {{std::cos(a), std::sin(a), 0},
          {-std::sin(a) * std::sin(e), std::cos(a) * std::sin(e), std::cos(e)}};
}

ViewLayout layout(const Bounds& bounds, const View& view, const std::string& unit, const Space& space) {
  const double margin = 0.5 * space.letter, width = space.width - 2 * margin,
               height = space.height - 2 * margin;
  const auto fits = [&](const ViewLayout& l) {
    const ProjectedBounds f = taken(l, bounds, view);
    return f.high[0] - f.low[0] <= width && f.high[1] - f.low[1] <= height;
  };
  // Without labels the bounds alone would fill the space at this larger scale.
  const ProjectedBounds bare = taken(ViewDraft(bounds, view, "", space, 1).made(), bounds, view);
  double low = 0, high = std::min({width / std::max(bare.high[0] - bare.low[0], 1e-300),
                                   height / std::max(bare.high[1] - bare.low[1], 1e-300), space.most});
  ViewLayout best = ViewDraft(bounds, view, "", space, unit.empty() ? high : 1e-3 * high).made();
  for (int i = 0; i < 24; ++i) {
    const double middle = (low + high) / 2;
    const ViewLayout l = ViewDraft(bounds, view, unit, space, middle).made();
    if (fits(l))
      low = middle, best = l;
    else
      high = middle;
  }
  const ProjectedBounds f = taken(best, bounds, view);
  best.centre = Point{space.width / 2, space.height / 2} - 0.5 * (f.low + f.high);
  for (Word& word : best.words) word.centre = word.centre + best.centre;
  for (Segment& line : best.lines) line.from = line.from + best.centre, line.to = line.to + best.centre;
  return best;
}

namespace {

// Values below 0.001 or from a million on are written with a power of ten, as 2e-5.
std::string bar_text(double value, double step, double largest) {
  if (std::abs(value) < 1e-9 * step) return "0";
  if (largest >= 1e-3 && largest < 1e6) return text_of(value, step);
  const int power = static_cast<int>(std::floor(std::log10(largest) + 1e-9));
  const double unit = std::pow(10, power);
  return text_of(value / unit, step / unit) + "e" + std::to_string(power);
}

}  // namespace

Bar round_bar(double low, double high, bool fixed, int count) {
  const double decade = std::pow(10, std::floor(std::log10((high - low) / count)));
  double step = 10 * decade;
  for (const double part : {5.0, 2.0, 1.0})
    if (part * decade * (1 + 1e-9) >= (high - low) / count) step = part * decade;
  Bar bar{low, high};
  if (!fixed) {
    bar.low = std::min(low, step * std::floor(low / step + 1e-6));
    bar.high = std::max(high, step * std::ceil(high / step - 1e-6));
  }
  const double largest = std::max(std::abs(bar.low), std::abs(bar.high));
  const Ticks t = ticks(bar.low, bar.high, step);
  for (int i = 0; i < t.count; ++i) bar.numbers.emplace_back(t.value(i), bar_text(t.value(i), step, largest));
  return bar;
}

}  // namespace fabricsh::render
