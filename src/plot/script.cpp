#include "plot/script.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/number.hpp"
#include "plot/text.hpp"
#include "plot/visible.hpp"

namespace fabricsh::plot {

namespace {

constexpr double kLine = 1, kAxis = 0.5, kMark = 0.8;  // line widths, points
constexpr double kMarkSize = 0.55;                     // in units of gnuplot; about 3.3 points
constexpr double kDot = 0.35;                          // likewise: a point of a line without neighbours

std::string fixed(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4f", value);
  return text;
}

// The rows of which the axes can show every value.
using Rows = std::vector<bool>;
Rows shown_rows(const Figure& f, const std::vector<double>& x,
                const std::vector<const std::vector<double>*>& columns) {
  Rows out(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    out[i] = shows(f.x, x[i]) && std::all_of(columns.begin(), columns.end(),
                                             [&](const auto* column) { return shows(f.y, (*column)[i]); });
  return out;
}

// A band that reaches zero or below on a logarithmic axis begins at the frame's edge, or where it ends if
// that is below the frame.
Ends held_band(Ends band, const Scale& y) {
  for (std::size_t i = 0; i < band.low.size(); ++i)
    if (band.high[i] > 0) band.low[i] = std::min(band.high[i], y.held(band.low[i]));
  return band;
}

// Those without a neighbour, to which no line leads.
Rows lone_rows(const Rows& shown) {
  Rows out(shown.size());
  for (std::size_t i = 0; i < shown.size(); ++i)
    out[i] = shown[i] && (i == 0 || !shown[i - 1]) && (i + 1 == shown.size() || !shown[i + 1]);
  return out;
}
bool any(const Rows& rows) { return std::find(rows.begin(), rows.end(), true) != rows.end(); }

// A row that is not shown becomes an empty line, which interrupts the curve.
std::string block(const std::string& name, const Rows& shown,
                  const std::vector<const std::vector<double>*>& columns) {
  std::string text = name + " << END_OF_CURVE\n";
  for (std::size_t i = 0; i < shown.size(); ++i) {
    std::string row;
    for (const auto* column : columns)
      if (shown[i]) row += (row.empty() ? "" : " ") + full_number((*column)[i]);
    text += row + "\n";
  }
  return text + "END_OF_CURVE\n";
}

class Script {
 public:
  Script(const Page& page, const PageLayout& layout, double width, double height, bool opaque)
      : page_(page), layout_(layout), width_(width), height_(height), opaque_(opaque) {}

  std::string made() {
    const bool several = page_.panels.size() > 1;
    text_ =
        "set encoding utf8\nunset key\nset clip two\nset border 15 back linewidth " + number(kAxis) + "\n";
    if (several) text_ += "set multiplot\n";
    for (std::size_t i = 0; i < page_.panels.size(); ++i) panel(page_.panels[i], layout_.panels[i]);
    return text_ + (several ? "unset multiplot\n" : "");
  }

 private:
  std::string across(double points) const { return fixed(points / width_); }
  std::string up(double points) const { return fixed(points / height_); }
  std::string at(double x, double y) const { return "screen " + across(x) + "," + up(y); }

  void panel(const Figure& f, const PlacedPanel& p) {
    text_ += "unset label\nunset arrow\nunset object\nunset logscale\n";
    text_ += "set lmargin at screen " + across(p.frame.left) + "\nset rmargin at screen " +
             across(p.frame.right) + "\nset bmargin at screen " + up(p.frame.bottom) +
             "\nset tmargin at screen " + up(p.frame.top) + "\n";
    axis("x", p.x);
    axis("y", p.y);
    for (const PlacedWord& word : p.words) write(word);
    for (const LegendLine& sample : p.samples)
      draw_sample(f.curves[sample.curve], look_of(f, sample.curve), sample);
    curves(f, p);
  }

  void axis(const std::string& name, const Scale& s) {
    if (s.logarithmic) text_ += "set logscale " + name + "\n";
    text_ += "set " + name + "range [" + full_number(s.low) + ":" + full_number(s.high) + "]\nset " + name +
             "tics in mirror scale " + number(page_.paper.font_size / 13) + "," +
             number(page_.paper.font_size / 24) + " (";
    std::string list;
    for (const Tick& t : s.ticks)
      list += (list.empty() ? "" : ", ") + ("'' " + full_number(t.value)) + (t.text.empty() ? " 1" : " 0");
    text_ += list + ")\n";
  }

  void write(const PlacedWord& word) {
    const char* align = word.align == Align::left ? "left" : word.align == Align::right ? "right" : "center";
    text_ += "set label " + quoted(word.text) + " at " + at(word.x, word.y) + " " + align +
             (word.upright ? " rotate by 90" : "");
    if (word.size != page_.paper.font_size) text_ += " font '," + number(word.size) + "'";
    text_ += " front\n";
  }

  // Curves with an explicit colour are counted separately, for their marks and patterns.
  static CurveAppearance look_of(const Figure& f, std::size_t curve) {
    const PlottedCurve& c = f.curves[curve];
    std::size_t place = 0;
    for (std::size_t i = 0; i < curve; ++i) place += f.curves[i].colour.empty() == c.colour.empty() ? 1 : 0;
    CurveAppearance result = look(place, c.style);
    if (!c.colour.empty()) result.colour = c.colour;
    return result;
  }

  static std::string coloured(const CurveAppearance& l) { return " linecolor rgb '" + l.colour + "'"; }
  static std::string line(const CurveAppearance& l) {
    return " linewidth " + number(kLine) + (l.dashes.empty() ? "" : " dashtype (" + l.dashes + ")") +
           coloured(l);
  }
  static std::string mark(const CurveAppearance& l) {
    return " pointtype " + std::to_string(l.marker) + " pointsize " + number(kMarkSize) + " linewidth " +
           number(kMark) + coloured(l);
  }

  // A fifth of the colour over white.
  static std::string opaque_shade(const std::string& colour) {
    std::string out = "#";
    for (std::size_t at = 1; at < 7; at += 2) {
      char text[8];
      std::snprintf(text, sizeof text, "%02x", 204 + std::stoi(colour.substr(at, 2), nullptr, 16) / 5);
      out += text;
    }
    return out;
  }
  std::string shade(const CurveAppearance& l) const {
    return opaque_ ? " fillstyle solid 1 noborder fillcolor rgb '" + opaque_shade(l.colour) + "'"
                   : " fillstyle transparent solid 0.2 noborder fillcolor rgb '" + l.colour + "'";
  }

  void draw_sample(const PlottedCurve& c, const CurveAppearance& l, const LegendLine& s) {
    const double half = 0.35 * page_.paper.font_size;
    if (!c.band.empty())
      text_ += "set object rectangle from " + at(s.left, s.y - half) + " to " + at(s.right, s.y + half) +
               " front" + shade(l) + "\n";
    if (c.y.empty()) return;
    const double centre = (s.left + s.right) / 2;
    if (l.line)
      text_ +=
          "set arrow from " + at(s.left, s.y) + " to " + at(s.right, s.y) + " nohead front" + line(l) + "\n";
    if (!c.error.empty()) bar(l, at(centre, s.y - 1.3 * half), at(centre, s.y + 1.3 * half));
    if (!c.x_error.empty()) bar(l, at(centre - 1.3 * half, s.y), at(centre + 1.3 * half, s.y));
    if (l.marker > 0) text_ += "set label '' at " + at(centre, s.y) + " point" + mark(l) + " front\n";
  }

  void bar(const CurveAppearance& l, const std::string& from, const std::string& to) {
    text_ += "set arrow from " + from + " to " + to + " nohead front linewidth " + number(kMark) +
             coloured(l) + "\n";
  }

  // Upright lines across a band at places without a neighbour.
  static std::string lone_bands(const std::string& name, const Rows& lone, const std::vector<double>& x,
                                const Ends& band) {
    std::string text = name + " << END_OF_CURVE\n";
    for (std::size_t i = 0; i < lone.size(); ++i)
      if (lone[i])
        text += full_number(x[i]) + " " + full_number(band.low[i]) + "\n" + full_number(x[i]) + " " +
                full_number(band.high[i]) + "\n\n";
    return text + "END_OF_CURVE\n";
  }

  // A bar from `from` to `to`, each {x, y}, with caps that reach from a to b along the other axis. A bar that
  // reaches zero or below on a logarithmic axis is drawn from the frame's edge, without a cap there.
  using Place = std::array<double, 2>;
  static std::string bar_lines(Place from, Place to, std::size_t along, double a, double b,
                               const Scale& scale) {
    const bool cut = scale.held(from[along]) != from[along];
    from[along] = scale.held(from[along]);
    if (cut && to[along] <= from[along]) return "";  // all of it lies below the frame
    std::string text;
    const auto line = [&text](const Place& p, const Place& q) {
      text += full_number(p[0]) + " " + full_number(p[1]) + "\n" + full_number(q[0]) + " " +
              full_number(q[1]) + "\n\n";
    };
    const auto cap = [&](Place p) {
      Place q = p;
      p[1 - along] = a, q[1 - along] = b;
      line(p, q);
    };
    line(from, to);
    if (!cut) cap(from);
    cap(to);
    return text;
  }

  // Vertical lines with a cap at each end, as wide as a mark.
  std::string error_block(const std::string& name, const PlottedCurve& c, const PlacedPanel& p) const {
    const double half = 1.8 / p.frame.width();
    std::string text = name + " << END_OF_CURVE\n";
    for (std::size_t i = 0; i < c.x.size(); ++i) {
      const double low = c.error.low[i], high = c.error.high[i], part = p.x.part(c.x[i]);
      if (!std::isfinite(low + high + part)) continue;
      text += bar_lines({c.x[i], low}, {c.x[i], high}, 1, p.x.at(part - half), p.x.at(part + half), p.y);
    }
    return text + "END_OF_CURVE\n";
  }

  // Horizontal lines likewise.
  std::string x_error_block(const std::string& name, const PlottedCurve& c, const PlacedPanel& p) const {
    const double half = 1.8 / p.frame.height();
    std::string text = name + " << END_OF_CURVE\n";
    for (std::size_t i = 0; i < c.x.size(); ++i) {
      const double low = c.x_error.low[i], high = c.x_error.high[i], part = p.y.part(c.y[i]);
      if (!std::isfinite(low + high + part)) continue;
      text += bar_lines({low, c.y[i]}, {high, c.y[i]}, 0, p.y.at(part - half), p.y.at(part + half), p.x);
    }
    return text + "END_OF_CURVE\n";
  }

  static double width_of(const Ends& band) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < band.low.size(); ++i)
      if (const double width = band.high[i] - band.low[i]; std::isfinite(width)) sum += width, ++count;
    return count > 0 ? sum / count : 0;
  }

  // First all bands, then error bars, then the curves, so that bands lie behind the curves.
  void curves(const Figure& f, const PlacedPanel& p) {
    std::string bars, lines;
    std::vector<std::pair<double, std::string>> bands;  // with their mean widths
    for (std::size_t i = 0; i < f.curves.size(); ++i) {
      const PlottedCurve& c = f.curves[i];
      const CurveAppearance l = look_of(f, i);
      const std::string number_of = std::to_string(i);
      const std::string title = c.label.empty() ? " notitle" : " title " + quoted(c.label);
      const std::string thin = " with lines linewidth " + fabricsh::number(kMark) + coloured(l) + " notitle";
      if (!c.band.empty()) {
        const Ends band = held_band(c.band, p.y);
        const Rows shown = shown_rows(f, c.x, {&band.low, &band.high}), lone = lone_rows(shown);
        text_ += block("$band" + number_of, shown, {&c.x, &band.low, &band.high});
        if (any(lone)) {
          text_ += lone_bands("$lone_band" + number_of, lone, c.x, band);
          bars += ", $lone_band" + number_of + " using 1:2" + thin;
        }
        bands.push_back({width_of(c.band), ", $band" + number_of + " using 1:2:3 with filledcurves" +
                                               shade(l) + (c.y.empty() ? title : " notitle")});
      }
      if (!c.error.empty()) {
        text_ += error_block("$error" + number_of, c, p);
        bars += ", $error" + number_of + " using 1:2" + thin;
      }
      if (c.y.empty()) continue;
      if (!c.x_error.empty()) {
        text_ += x_error_block("$across" + number_of, c, p);
        bars += ", $across" + number_of + " using 1:2" + thin;
      }
      const Rows shown = shown_rows(f, c.x, {&c.y}), lone = lone_rows(shown);
      text_ += block("$curve" + number_of, shown, {&c.x, &c.y});
      if (l.line) lines += ", $curve" + number_of + " using 1:2 with lines" + line(l) + title;
      if (l.marker > 0)
        lines += ", $curve" + number_of + " using 1:2 with points" + mark(l) + (l.line ? " notitle" : title);
      if (l.marker == 0 && any(lone)) {
        text_ += block("$lone" + number_of, lone, {&c.x, &c.y});
        lines += ", $lone" + number_of + " using 1:2 with points pointtype 7 pointsize " +
                 fabricsh::number(kDot) + coloured(l) + " notitle";
      }
    }
    if (opaque_)
      std::stable_sort(bands.begin(), bands.end(),
                       [](const auto& a, const auto& b) { return a.first > b.first; });
    std::string all;
    for (const auto& [width, band] : bands) all += band;
    text_ += "plot " + (all + bars + lines).substr(2) + "\n";
  }

  const Page& page_;
  const PageLayout& layout_;
  double width_, height_;
  bool opaque_;
  std::string text_;
};

std::string letters_axis(const std::string& name, const Axis& a) {
  const auto end = [](const std::optional<double>& value) {
    return value ? full_number(*value) : std::string("*");
  };
  std::string names;
  for (std::size_t i = 0; i < a.names.size(); ++i)
    names +=
        (names.empty() ? "set " + name + "tics (" : ", ") + quoted(a.names[i]) + " " + std::to_string(i + 1);
  if (!names.empty()) names += ")\n";
  return "set " + name + "label " + quoted(a.label) + "\nset " + name + "range [" + end(a.low) + ":" +
         end(a.high) + "]\n" + names + (a.logarithmic ? "set logscale " + name + "\n" : "");
}

constexpr const char* letters_points = "points pointtype 'o'";

std::string letters_style(CurveStyle style) {
  if (style == CurveStyle::points) return letters_points;
  return style == CurveStyle::line_points ? "linespoints pointtype 'o'" : "lines";
}

}  // namespace

std::string script_of(const Page& page, const PageLayout& layout, double canvas_width, double canvas_height,
                      bool opaque) {
  return Script(page, layout, canvas_width, canvas_height, opaque).made();
}

// In text mode each line type has a different mark. A band is shown by two lines; error bars are not shown.
std::string letters_script(const Figure& f) {
  const Span span = visible_span(f);
  const Scale y_scale = scale_of(f.y, span.y_low, span.y_high, 100, 8, true);
  scale_of(f.x, span.x_low, span.x_high, 100, 8, false);  // says so if the values have no room on one axis
  std::string script = "set encoding utf8\nset title " + quoted(f.title) + "\n" + letters_axis("x", f.x) +
                       letters_axis("y", f.y) + "set tics nomirror\nset border 3\n" +
                       (f.key == Key::none ? "unset key\n" : "set key below Left reverse\n");
  std::string plot;
  const auto add_rows = [&](std::size_t i, const std::string& name, const Rows& shown,
                            const std::vector<double>& y, const std::string& with, bool named) {
    const PlottedCurve& c = f.curves[i];
    script += block(name, shown, {&c.x, &y});
    plot += (plot.empty() ? "plot " : ", ") + name + " using 1:2 with " + with + " linetype " +
            std::to_string(i + 1) + (named && !c.label.empty() ? " title " + quoted(c.label) : " notitle");
  };
  const auto add = [&](std::size_t i, const std::string& name, const std::vector<double>& y,
                       const std::string& with, bool named) {
    const Rows shown = shown_rows(f, f.curves[i].x, {&y}), lone = lone_rows(shown);
    add_rows(i, name, shown, y, with, named);
    if (with == "lines" && any(lone)) add_rows(i, name + "_lone", lone, y, letters_points, false);
  };
  for (std::size_t i = 0; i < f.curves.size(); ++i) {
    const PlottedCurve& c = f.curves[i];
    const std::string place = std::to_string(i);
    if (!c.band.empty()) {
      const Ends band = held_band(c.band, y_scale);
      add(i, "$low" + place, band.low, "lines", c.y.empty());
      add(i, "$high" + place, band.high, "lines", false);
    }
    if (!c.y.empty()) add(i, "$curve" + place, c.y, letters_style(c.style), true);
  }
  return script + plot + "\n";
}

namespace {

// The colours of M. Okabe and K. Ito without the yellow, which is too pale on white paper. In this
// order successive colours are well separated for each kind of colour blindness.
constexpr std::array<const char*, kColours> colours = {"#0072b2", "#d55e00", "#cc79a7", "#000000",
                                                       "#009e73", "#e69f00", "#56b4e9"};
// The style "dashed" has its own pattern.
constexpr const char* asked_dashes = "7,3.5";
constexpr std::array<const char*, kPatterns> patterns = {"", "12,3,2,3", "2,3", "18,4"};
// Circle, square, triangle, diamond, triangle on its tip, pentagon: open, and filled.
constexpr std::array<int, kMarkers> open = {6, 4, 8, 12, 10, 14}, filled = {7, 5, 9, 13, 11, 15};

}  // namespace

CurveAppearance look(std::size_t place, CurveStyle style) {
  const std::size_t round = place / kColours, shape = place % kMarkers;
  CurveAppearance result{colours[place % kColours], patterns[round % kPatterns]};
  if (style == CurveStyle::dashed) result.dashes = asked_dashes;
  if (style == CurveStyle::line_points) result.marker = filled[shape];
  if (style == CurveStyle::points) result.marker = open[shape], result.line = false;
  return result;
}

}  // namespace fabricsh::plot
