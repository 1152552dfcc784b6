#include "plot/key.hpp"

#include <algorithm>
#include <cmath>

#include "plot/text.hpp"

namespace fabricsh::plot {

namespace {

constexpr double kSample = 2.8, kGap = 0.5, kRow = 1.3;  // in font sizes

struct PagePoint {
  double x = 0, y = 0;
};

// Whether a line segment crosses the box (clipping by J. Liang and B. Barsky).
bool crosses(const PageBox& b, const PagePoint& p, const PagePoint& q) {
  double from = 0, to = 1;
  const double dx = q.x - p.x, dy = q.y - p.y;
  for (const auto& [along, room] : {std::pair{-dx, p.x - b.left}, std::pair{dx, b.right - p.x},
                                    std::pair{-dy, p.y - b.bottom}, std::pair{dy, b.top - p.y}}) {
    if (along == 0 && room < 0) return false;
    if (along < 0) from = std::max(from, room / along);
    if (along > 0) to = std::min(to, room / along);
  }
  return from <= to;
}

class Cover {
 public:
  Cover(const PlacedPanel& panel, const PageBox& box) : panel_(panel), box_(box) {}

  bool by(const PlottedCurve& c) const {
    const bool marks = c.style == CurveStyle::points;
    if (!c.y.empty() && by_line(c.x, c.y, !marks)) return true;
    for (const Ends* ends : {&c.band, &c.error}) {
      if (ends->empty()) continue;
      std::vector<double> low = ends->low;
      for (double& value : low) value = panel_.y.held(value);
      if (by_line(c.x, low, ends == &c.band) || by_line(c.x, ends->high, ends == &c.band)) return true;
      for (std::size_t i = 0; i < c.x.size(); ++i)
        if (hits(spot(c.x[i], low[i]), spot(c.x[i], ends->high[i]))) return true;
    }
    for (std::size_t i = 0; i < c.x_error.low.size() && i < c.y.size(); ++i)
      if (hits(spot(panel_.x.held(c.x_error.low[i]), c.y[i]), spot(c.x_error.high[i], c.y[i]))) return true;
    return false;
  }

 private:
  PagePoint spot(double x, double y) const {
    const PageBox& f = panel_.frame;
    return {f.left + panel_.x.part(x) * f.width(), f.bottom + panel_.y.part(y) * f.height()};
  }

  bool hits(const PagePoint& p, const PagePoint& q) const {
    const bool finite = std::isfinite(p.x + p.y) && std::isfinite(q.x + q.y);
    return finite && crosses(box_, p, q);
  }

  bool by_line(const std::vector<double>& x, const std::vector<double>& y, bool joined) const {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const PagePoint here = spot(x[i], y[i]);
      if (hits(here, here)) return true;
      if (joined && i > 0 && hits(spot(x[i - 1], y[i - 1]), here)) return true;
    }
    return false;
  }

  const PlacedPanel& panel_;
  PageBox box_;
};

PageBox in_corner(const PageBox& f, const KeySize& size, double letter, Key corner) {
  const double off = 0.7 * letter;
  const bool left = corner == Key::top_left || corner == Key::bottom_left,
             top = corner == Key::top_left || corner == Key::top_right;
  const double x = left ? f.left + off : f.right - off - size.width,
               y = top ? f.top - off - size.height : f.bottom + off;
  return {x, y, x + size.width, y + size.height};
}

bool is_free(const Figure& figure, const PlacedPanel& panel, const PageBox& box, double letter) {
  const PageBox& f = panel.frame;
  if (box.left < f.left || box.right > f.right || box.bottom < f.bottom || box.top > f.top) return false;
  const double around = 0.3 * letter;
  const Cover cover(panel, {box.left - around, box.bottom - around, box.right + around, box.top + around});
  return std::none_of(figure.curves.begin(), figure.curves.end(),
                      [&](const PlottedCurve& curve) { return cover.by(curve); });
}

}  // namespace

KeySize key_size(const Figure& figure, double letter, double width, Key place) {
  KeySize size;
  int entries = 0;
  for (const PlottedCurve& curve : figure.curves) {
    if (curve.label.empty()) continue;
    ++entries;
    size.column = std::max(size.column, (kSample + kGap) * letter + text_width(curve.label, letter));
  }
  if (entries == 0) return size;
  const double gap = 1.2 * letter;
  if (place == Key::below)
    size.columns = std::clamp(static_cast<int>((width + gap) / (size.column + gap)), 1, entries);
  size.rows = (entries + size.columns - 1) / size.columns;
  size.width = size.columns * size.column + (size.columns - 1) * gap;
  size.height = size.rows * kRow * letter;
  return size;
}

bool key_box(const Figure& figure, const PlacedPanel& panel, const KeySize& size, double letter, Key place,
             PageBox& box) {
  const PageBox& f = panel.frame;
  if (place == Key::below) {
    const double top = f.bottom - (figure.x.label.empty() ? 1.7 : 3.1) * letter,
                 left = std::max(letter * 0.3, (f.left + f.right - size.width) / 2);
    box = {left, top - size.height, left + size.width, top};
    return true;
  }
  if (place == Key::right) {
    const double left = f.right + 0.8 * letter;
    box = {left, f.top - size.height, left + size.width, f.top};
    return true;
  }
  if (place != Key::best) return box = in_corner(f, size, letter, place), true;
  for (const Key corner : {Key::top_left, Key::top_right, Key::bottom_right, Key::bottom_left}) {
    box = in_corner(f, size, letter, corner);
    if (is_free(figure, panel, box, letter)) return true;
  }
  return false;
}

void fill_key(const Figure& figure, PlacedPanel& panel, const KeySize& size, double letter) {
  int entry = 0;
  for (std::size_t i = 0; i < figure.curves.size(); ++i) {
    if (figure.curves[i].label.empty()) continue;
    const int row = entry % size.rows, column = entry / size.rows;
    ++entry;
    const double left = panel.key.left + column * (size.column + 1.2 * letter),
                 y = panel.key.top - (row + 0.5) * kRow * letter;
    panel.samples.push_back({i, left, left + kSample * letter, y});
    panel.words.push_back({figure.curves[i].label, left + (kSample + kGap) * letter, y, Align::left, letter});
  }
}

}  // namespace fabricsh::plot
