#include "plot/layout.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/error.hpp"
#include "base/number.hpp"
#include "plot/text.hpp"
#include "plot/visible.hpp"

namespace fabricsh::plot {

namespace {

// --- The legend of a figure: its size, its position and its entries.

struct KeySize {
  int rows = 0, columns = 1;
  double column = 0;             // column width, points
  double width = 0, height = 0;  // total
};

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

// Below the axes the legend has as many columns as fit into the width, elsewhere one.
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

// Box for a legend of this size. false: Key::best was asked for, and every corner is covered by a curve.
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

// Adds the texts and line samples of the legend in panel.key.
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

// --- The page.

constexpr double kPoints = 72 / 0.0254;  // in a metre

// Margins before and behind the axes: of a column of panels from left to right, of a row from top to bottom.
struct Track {
  double before = 0, behind = 0;
  void widen(double a, double b) { before = std::max(before, a), behind = std::max(behind, b); }
};

struct Margins {
  double left = 0, right = 0, bottom = 0, top = 0;
};

class PageDraft {
 public:
  explicit PageDraft(const Page& page) : page_(page), letter_(page.paper.font_size) {
    const int n = static_cast<int>(page.panels.size());
    columns_ = page.columns > 0 ? page.columns : std::min(n, 2);
    rows_ = page.rows > 0 ? page.rows : (n + columns_ - 1) / columns_;
    if (rows_ * columns_ < n)
      throw Error("figure: " + std::to_string(n) + " panels have no room in " + std::to_string(rows_) +
                  " x " + std::to_string(columns_) + " places");
    layout_.width = kPoints * (page.paper.width > 0 ? page.paper.width : columns_ > 1 ? 0.170 : 0.085);
    layout_.height = kPoints * (page.paper.height > 0 ? page.paper.height : 0.060 * rows_);
    layout_.panels.resize(page.panels.size());
    for (const Figure& f : page.panels) {
      spans_.push_back(visible_span(f));
      keys_.push_back(f.key);
    }
  }

  // A legend without a free corner is moved below the axes. This changes the axes of all panels, because they
  // have equal sizes; therefore the layout is repeated.
  PageLayout made() {
    while (!placed()) {
    }
    for (std::size_t i = 0; i < layout_.panels.size(); ++i) words(i);
    return layout_;
  }

 private:
  bool placed() {
    across_.assign(static_cast<std::size_t>(columns_), {}), down_.assign(static_cast<std::size_t>(rows_), {});
    layout_.warnings.clear();
    for (int pass = 0; pass < 2; ++pass) {  // the tick labels depend slightly on the length of the axes
      for (std::size_t i = 0; i < layout_.panels.size(); ++i) frame(i);
      for (std::size_t i = 0; i < layout_.panels.size(); ++i) widen(i, wanted(i));
    }
    for (std::size_t i = 0; i < layout_.panels.size(); ++i) frame(i);
    for (std::size_t i = 0; i < layout_.panels.size(); ++i)
      if (!place_key(i)) {
        keys_[i] = Key::below;
        return false;
      }
    return true;
  }

  std::size_t row(std::size_t i) const { return i / static_cast<std::size_t>(columns_); }
  std::size_t column(std::size_t i) const { return i % static_cast<std::size_t>(columns_); }

  void widen(std::size_t i, const Margins& m) {
    across_[column(i)].widen(m.left, m.right);
    down_[row(i)].widen(m.top, m.bottom);
  }

  // Length of the axes, equal in all panels.
  static double each(double whole, const std::vector<Track>& tracks) {
    for (const Track& t : tracks) whole -= t.before + t.behind;
    return whole / static_cast<double>(tracks.size());
  }
  // Where track number n begins.
  static double begin(double whole, const std::vector<Track>& tracks, std::size_t n) {
    double at = static_cast<double>(n) * each(whole, tracks);
    for (std::size_t k = 0; k < n; ++k) at += tracks[k].before + tracks[k].behind;
    return at;
  }
  // The area of panel i with its margins.
  PageBox cell(std::size_t i) const {
    const std::size_t r = row(i), c = column(i);
    return {begin(layout_.width, across_, c), layout_.height - begin(layout_.height, down_, r + 1),
            begin(layout_.width, across_, c + 1), layout_.height - begin(layout_.height, down_, r)};
  }

  void frame(std::size_t i) {
    PlacedPanel& p = layout_.panels[i];
    const PageBox all = cell(i);
    const Track &x = across_[column(i)], &y = down_[row(i)];
    p.frame = {all.left + x.before, all.bottom + y.behind, all.right - x.behind, all.top - y.before};
    if (p.frame.width() < 3 * letter_ || p.frame.height() < 3 * letter_)
      throw Error("figure: " + number(std::round(layout_.width / kPoints * 1000)) + " x " +
                  number(std::round(layout_.height / kPoints * 1000)) +
                  " mm have no room for axes and words of " + number(letter_) +
                  " points; ask for a larger size, or for smaller letters");
    const Figure& f = page_.panels[i];
    p.x = scale_of(f.x, spans_[i].x_low, spans_[i].x_high, p.frame.width(), letter_, false);
    p.y = scale_of(f.y, spans_[i].y_low, spans_[i].y_high, p.frame.height(), letter_, true);
  }

  double widest(const Scale& scale) const {
    double all = 0;
    for (const Tick& tick : scale.ticks) all = std::max(all, text_width(tick.text, letter_));
    return all;
  }

  bool lettered() const { return page_.letters && page_.panels.size() > 1; }

  std::string heading(std::size_t i) const {
    const std::string title = page_.panels[i].title;
    if (!lettered()) return title;
    std::string letter = i < 26 ? std::string(1, static_cast<char>('a' + i)) : std::to_string(i + 1);
    return "(" + letter + ")" + (title.empty() ? "" : " " + title);
  }

  Margins wanted(std::size_t i) const {
    const Figure& f = page_.panels[i];
    const PlacedPanel& p = layout_.panels[i];
    Margins m;
    m.left = (f.y.label.empty() ? 0.3 : 1.7) * letter_ + widest(p.y) + 0.5 * letter_;
    m.bottom = (f.x.label.empty() ? 0.3 : 1.7) * letter_ + 1.4 * letter_;
    m.top = (heading(i).empty() ? 0.8 : 1.8) * letter_;
    const double last = p.x.ticks.empty() || p.x.ticks.back().text.empty()
                            ? 0
                            : text_width(p.x.ticks.back().text, letter_) / 2;
    m.right = std::max(0.7 * letter_, last + 0.2 * letter_);
    const KeySize key = key_size(f, letter_, std::max(p.frame.width(), 3 * letter_), keys_[i]);
    if (keys_[i] == Key::below) m.bottom += key.height + 0.4 * letter_;
    if (keys_[i] == Key::right) m.right += key.width + 0.8 * letter_;
    return m;
  }

  // false: every corner is covered by a curve.
  bool place_key(std::size_t i) {
    const Figure& f = page_.panels[i];
    PlacedPanel& p = layout_.panels[i];
    p.samples.clear(), p.words.clear();
    const KeySize size = key_size(f, letter_, p.frame.width(), keys_[i]);
    if (size.rows == 0 || keys_[i] == Key::none) return p.key = {}, true;
    if (!key_box(f, p, size, letter_, keys_[i], p.key)) return false;
    fill_key(f, p, size, letter_);
    std::vector<PlacedWord> words;
    words.swap(p.words);
    const double end = cell(i).right;
    for (const PlacedWord& word : words) fitted(i, word, end - word.x);
    return true;
  }

  // Uses a smaller font if the room is too narrow, at least 6 points, and warns if even that is too large.
  void fitted(std::size_t i, PlacedWord word, double room) {
    const double needed = text_width(word.text, word.size);
    if (needed > room) word.size = std::max(std::min(6.0, word.size), word.size * room / needed);
    // Estimated widths are at least a tenth too large.
    if (0.85 * text_width(word.text, word.size) > room)
      layout_.warnings.push_back("'" + word.text + "' is longer than its room of " +
                                 number(std::round(room / kPoints * 1000)) +
                                 " mm even in letters of 6 points; shorter words, or a larger size");
    layout_.panels[i].words.push_back(word);
  }

  void words(std::size_t i) {
    const Figure& f = page_.panels[i];
    const PlacedPanel& p = layout_.panels[i];
    const PageBox b = p.frame;
    std::vector<PlacedWord>& out = layout_.panels[i].words;
    for (const Tick& t : p.x.ticks)
      if (!t.text.empty())
        out.push_back({t.text, b.left + p.x.part(t.value) * b.width(), b.bottom - 0.9 * letter_,
                       Align::centre, letter_});
    for (const Tick& t : p.y.ticks)
      if (!t.text.empty())
        out.push_back({t.text, b.left - 0.5 * letter_, b.bottom + p.y.part(t.value) * b.height(),
                       Align::right, letter_});
    const PageBox all = cell(i);
    const double w = all.width(), h = all.height(), edge = all.left, floor = all.bottom;
    const auto inside = [&](double centre, double text, double from, double room) {
      const double half = std::min(text, room) / 2;
      return std::clamp(centre, from + half, from + room - half);
    };
    if (!f.x.label.empty())
      fitted(i,
             {f.x.label, inside((b.left + b.right) / 2, text_width(f.x.label, letter_), edge, w),
              b.bottom - 2.2 * letter_, Align::centre, letter_},
             w);
    if (!f.y.label.empty())
      fitted(i,
             {f.y.label, edge + 0.85 * letter_,
              inside((b.bottom + b.top) / 2, text_width(f.y.label, letter_), floor, h), Align::centre,
              letter_, true},
             h);
    if (const std::string head = heading(i); !head.empty()) {
      const double room = lettered() ? edge + w - b.left : w, from = lettered() ? b.left : edge;
      const double centre =
          lettered() ? b.left : inside((b.left + b.right) / 2, text_width(head, letter_), from, room);
      fitted(i, {head, centre, b.top + 0.95 * letter_, lettered() ? Align::left : Align::centre, letter_},
             room);
    }
  }

  const Page& page_;
  double letter_;
  int rows_ = 1, columns_ = 1;
  std::vector<Track> across_, down_;  // of columns and rows
  std::vector<Span> spans_;
  std::vector<Key> keys_;
  PageLayout layout_;
};

constexpr double kSmallest = 1e-290, kLargest = 1e290;  // beyond them steps and powers of ten are lost

const std::string times = "\u00d7", minus = "\u2212";

std::string with_decimals(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", std::clamp(decimals, 0, 20), std::abs(value));
  const bool zero = std::string(text).find_first_not_of("0.") == std::string::npos;
  return (value < 0 && !zero ? minus : "") + std::string(text);
}

// Number of decimals that distinguishes multiples of this step.
int decimals_of(double step) { return -static_cast<int>(std::floor(std::log10(step) + 1e-9)); }

// Values from 0.001 to a million are written plainly, others with a power of ten.
std::string text_of(double value, double step, double largest) {
  if (std::abs(value) < 1e-9 * step) return "0";
  if (largest >= 1e-3 && largest < 1e6) return with_decimals(value, decimals_of(step));
  const int power = static_cast<int>(std::floor(std::log10(largest) + 1e-9));
  return with_decimals(value / std::pow(10, power), decimals_of(step) + power) + times + "10" +
         superscript(power);
}

std::string decade_text(int power) {
  if (power >= -3 && power <= 4) return with_decimals(std::pow(10, power), -power);
  return "10" + superscript(power);
}

// Fixed ends are kept; the others are the next multiples of half the step.
Scale linear(const Axis& axis, double low, double high, double step) {
  Scale s;
  const double half_step = step / 2;  // values may exceed a tick by a thousandth of it (rounding errors)
  s.low = axis.low.value_or(std::min(low, half_step * std::floor(low / half_step + 1e-3)));
  s.high = axis.high.value_or(std::max(high, half_step * std::ceil(high / half_step - 1e-3)));
  const double largest = std::max(std::abs(s.low), std::abs(s.high)), slack = 1e-9 * (s.high - s.low);
  const double first = std::ceil((s.low - slack) / half_step);
  for (int i = 0; i < 1000; ++i) {
    const double half = first + i, value = half * half_step;
    if (value > s.high + slack) break;
    const bool numbered = std::fmod(half, 2) == 0;
    s.ticks.push_back({value, numbered ? text_of(value, step, largest) : ""});
  }
  return s;
}

double room_of(const Scale& s, double letter, bool upright) {
  double widest = 0;
  for (const Tick& tick : s.ticks) widest = std::max(widest, text_width(tick.text, letter));
  return upright ? 2.2 * letter : widest + 0.9 * letter;
}

Scale with_round_steps(const Axis& axis, double low, double high, double length, double letter,
                       bool upright) {
  const double range = axis.high.value_or(high) - axis.low.value_or(low);
  if (!std::isfinite(range) || range < kSmallest)
    throw Error("figure: the values from " + number(low) + " to " + number(high) +
                " can't be shown on one axis");
  const double decade = std::pow(10, std::floor(std::log10(range)) - 1);
  Scale s;
  for (const double part : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
    const double step = part * decade;
    if (range / step > 12) continue;
    s = linear(axis, low, high, step);
    if (length * step / (s.high - s.low) >= room_of(s, letter, upright)) break;
  }
  return s;
}

// A tick with its name at 1, 2, ..., half a step from the ends.
Scale named(const Axis& axis) {
  Scale s;
  s.low = axis.low.value_or(0.5);
  s.high = axis.high.value_or(static_cast<double>(axis.names.size()) + 0.5);
  for (std::size_t i = 0; i < axis.names.size(); ++i)
    if (const auto value = static_cast<double>(i + 1); value >= s.low && value <= s.high)
      s.ticks.push_back({value, axis.names[i]});
  return s;
}

void add_decade(Scale& s, int power, bool numbered) {
  const double decade = std::pow(10, power);
  if (decade >= s.low * (1 - 1e-9) && decade <= s.high * (1 + 1e-9))
    s.ticks.push_back({decade, numbered ? decade_text(power) : ""});
}

Scale decades(const Axis& axis, double low, double high, double length, double letter, bool upright) {
  const double first_shown = axis.low.value_or(low), last_shown = axis.high.value_or(high);
  if (first_shown < kSmallest || last_shown > kLargest)
    throw Error("figure: a logarithmic axis has room for values from " + number(kSmallest) + " to " +
                number(kLargest) + ", got " + number(first_shown) + " to " + number(last_shown) +
                "; give a range of the axis");
  Scale s;
  s.logarithmic = true;
  s.low = axis.low.value_or(std::min(low, std::pow(10, std::floor(std::log10(low) + 1e-9))));
  s.high = axis.high.value_or(std::max(high, std::pow(10, std::ceil(std::log10(high) - 1e-9))));
  if (!(s.low < s.high)) (axis.high ? s.low /= 10 : s.high *= 10);
  const int first = static_cast<int>(std::floor(std::log10(s.low))),
            last = static_cast<int>(std::ceil(std::log10(s.high)));
  const double each = length / std::log10(s.high / s.low),
               needed = upright ? 2.2 * letter : text_width("10000", letter) + 0.9 * letter;
  const int every = std::max(1, static_cast<int>(std::ceil(needed / each)));
  for (int power = first; power <= last; ++power) {
    add_decade(s, power, power % every == 0);
    if (every > 1) continue;
    for (int k = 2; k < 10; ++k)
      if (const double v = k * std::pow(10, power); v >= s.low && v <= s.high)
        // Less than a decade holds no power of ten, or one.
        s.ticks.push_back(
            {v, last - first <= 1 && (k == 2 || k == 5) ? with_decimals(v, -power) : std::string()});
  }
  return s;
}

}  // namespace

PageBox box_of(const PlacedWord& word) {
  const double length = text_width(word.text, word.size), high = 0.6 * word.size;
  const double before = word.align == Align::left ? 0 : word.align == Align::right ? length : length / 2;
  if (word.upright) return {word.x - high, word.y - before, word.x + high, word.y - before + length};
  return {word.x - before, word.y - high, word.x - before + length, word.y + high};
}

PageLayout layout_of(const Page& page) {
  if (page.panels.empty()) throw Error("figure: expected at least one panel");
  return PageDraft(page).made();
}

double Scale::part(double value) const {
  return logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

double Scale::held(double value) const { return logarithmic && value <= 0 ? low : value; }

double Scale::at(double part) const {
  return logarithmic ? low * std::pow(high / low, part) : low + part * (high - low);
}

Scale scale_of(const Axis& axis, double low, double high, double length, double letter, bool upright) {
  if (!axis.names.empty()) return named(axis);
  if (axis.logarithmic) return decades(axis, low, high, length, letter, upright);
  if (low == high) {
    const double around = low == 0 ? 1 : 0.1 * std::abs(low);
    low -= around, high += around;
  }
  return with_round_steps(axis, low, high, length, letter, upright);
}

}  // namespace fabricsh::plot
