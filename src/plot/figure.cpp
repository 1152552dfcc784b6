#include "plot/figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "base/error.hpp"
#include "base/number.hpp"
#include "plot/gnuplot.hpp"
#include "system/atomic.hpp"

namespace fabricsh::plot {

namespace {

// These colours are distinguishable for most colour-blind readers and in grey print.
constexpr std::array<const char*, 6> colours = {"#0072b2", "#d55e00", "#009e73",
                                                "#cc79a7", "#e69f00", "#000000"};

std::string terminal(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".svg") return "svg size 800,600 noenhanced background '#ffffff' font 'sans,14'";
  if (ending == ".png") return "pngcairo size 1600,1200 noenhanced fontscale 2 linewidth 2 pointscale 2";
  if (ending == ".pdf") return "pdfcairo size 16cm,12cm noenhanced";
  throw Error("figure: expected a file name that ends in .svg, .png or .pdf, got '" + path + "'");
}

// Length of the UTF-8 character at `at`; 0: invalid UTF-8, or a character that XML does not allow.
std::size_t character(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return static_cast<unsigned char>(i < text.size() ? text[i] : '\0');
  };
  const unsigned first = byte(at);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 0;
  unsigned code = first & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(at + i) & 0x3fU);
  }
  const bool too_long = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool no_character = (code >= 0xd800 && code < 0xe000) || code > 0x10ffff || (code & 0xfffe) == 0xfffe;
  return too_long || no_character ? 0 : length;
}

// Between single quotes gnuplot interprets no character: no escapes, commands, macros or formats.
// Only a single quote itself must be doubled, but some releases fail if a text begins with one;
// so it is appended between double quotes instead. Characters that would make the SVG invalid are
// replaced: control characters by blanks, bytes that are not UTF-8 by the replacement character.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character(text, at);
    const auto byte = static_cast<unsigned char>(text[at]);
    if (length == 0)
      out += "\xef\xbf\xbd";
    else if (byte < 32 || byte == 127)
      out += ' ';
    else
      out += byte == '\'' ? R"('."'".')" : text.substr(at, length);
    at += std::max<std::size_t>(length, 1);
  }
  return out + "'";
}

std::string with(CurveStyle style, bool letters) {
  switch (style) {
    case CurveStyle::dashed:
      return letters ? "lines" : "lines dashtype 2";
    case CurveStyle::points:
      return letters ? "points pointtype 'o'" : "points pointtype 6";
    case CurveStyle::line_points:
      return letters ? "linespoints pointtype 'o'" : "linespoints pointtype 7 pointsize 0.5";
    default:
      return "lines";
  }
}

// A value that is not finite gives an empty line, which interrupts the curve.
std::string block(std::size_t index, const Curve& curve) {
  std::string text = "$curve" + std::to_string(index) + " << END_OF_CURVE\n";
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]))
      text += full_number(curve.x[i]) + " " + full_number(curve.y[i]);
    text += "\n";
  }
  return text + "END_OF_CURVE\n";
}

// In text mode each line type has a different mark.
std::string plot_item(std::size_t index, const Curve& curve, bool letters) {
  const std::string key = curve.label.empty() ? "notitle" : "title " + quoted(curve.label);
  const std::string look =
      letters ? " linetype " + std::to_string(index + 1)
              : " linewidth 2 linecolor rgb '" + std::string(colours[index % colours.size()]) + "'";
  return "$curve" + std::to_string(index) + " using 1:2 with " + with(curve.style, letters) + look + " " +
         key;
}

// Removes blanks at the ends of lines and empty lines at the beginning.
std::string trimmed(const std::string& text) {
  std::string out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line.erase(line.find_last_not_of(" \f") + 1);
    if (!out.empty() || !line.empty()) out += (out.empty() ? "" : "\n") + line;
  }
  return out;
}

bool shows(const Axis& axis, double value) {
  return std::isfinite(value) && (value > 0 || !axis.logarithmic);
}

bool in_range(const Axis& axis, double value) {
  return value >= axis.low.value_or(value) && value <= axis.high.value_or(value);
}

void check_axis(const std::string& name, const Axis& axis) {
  if (axis.logarithmic && (axis.low.value_or(1) <= 0 || axis.high.value_or(1) <= 0))
    throw Error("figure: a logarithmic axis has no room for zero and below, got a range of " + name +
                " from " + number(axis.low.value_or(1)) + " to " + number(axis.high.value_or(1)));
}

void check_curve(const Figure& f, const Curve& curve) {
  const std::string who = "figure: curve '" + curve.label + "': ";
  if (curve.x.size() != curve.y.size())
    throw Error(who + "expected as many y as x, got " + std::to_string(curve.y.size()) + " and " +
                std::to_string(curve.x.size()));
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    if (shows(f.x, curve.x[i]) && shows(f.y, curve.y[i])) return;
  const bool logarithmic = f.x.logarithmic || f.y.logarithmic;
  throw Error(who + "nothing to draw: none of its " + std::to_string(curve.x.size()) + " points is finite" +
              (logarithmic ? " and positive on the logarithmic axis" : ""));
}

// An axis without a given range is scaled by the points that lie within the range of the other axis.
void check_ranges(const Figure& f) {
  for (const Curve& curve : f.curves)
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      if (shows(f.x, curve.x[i]) && shows(f.y, curve.y[i]) && in_range(f.x, curve.x[i]) &&
          in_range(f.y, curve.y[i]))
        return;
  throw Error("figure: no point of any curve lies inside the range asked for");
}

void check(const Figure& f) {
  if (f.curves.empty()) throw Error("figure: expected at least one curve");
  check_axis("x", f.x);
  check_axis("y", f.y);
  for (const Curve& curve : f.curves) check_curve(f, curve);
  check_ranges(f);
}

std::string axis(const std::string& name, const Axis& a) {
  const auto end = [](const std::optional<double>& value) {
    return value ? full_number(*value) : std::string("*");
  };
  return "set " + name + "label " + quoted(a.label) + "\nset " + name + "range [" + end(a.low) + ":" +
         end(a.high) + "]\n" + (a.logarithmic ? "set logscale " + name + "\n" : "");
}

// Everything but the terminal and the output. In text mode lines are distinguished by their marks.
std::string script_of(const Figure& f, bool letters) {
  check(f);
  std::string script = "set encoding utf8\nset title " + quoted(f.title) + "\n" + axis("x", f.x) +
                       axis("y", f.y) + "set key below Left reverse" +
                       (letters ? "" : " spacing 1.3 height 0.5") + "\nset tics nomirror\nset border 3\n";
  if (!letters) script += "set grid linecolor rgb '#dddddd'\nset xlabel offset 0,0.4\n";
  std::string plot = "plot ";
  for (std::size_t i = 0; i < f.curves.size(); ++i) {
    script += block(i, f.curves[i]);
    plot += (i > 0 ? ", " : "") + plot_item(i, f.curves[i], letters);
  }
  return script + plot + "\n";
}

// XML requires "]]>" to be escaped in any text; gnuplot
// does not use CDATA sections and does not escape it.
void escape_ends(std::string& svg) {
  for (std::size_t at = 0; (at = svg.find("]]>", at)) != std::string::npos;) svg.replace(at + 2, 1, "&gt;");
}

}  // namespace

void draw(const std::string& path, const Figure& figure) {
  const std::string start = "set terminal " + terminal(path) + "\n";
  std::string drawn = run_gnuplot(start + script_of(figure, false) + "unset output\n");
  if (path.ends_with(".svg")) escape_ends(drawn);
  system::write_file(path, drawn, system::Sync::no);
}

// The label of y is placed above the axis, because text cannot be rotated in text mode.
std::string drawn_in_letters(const Figure& figure, int columns, int lines) {
  Figure with_label = figure;
  if (!figure.y.label.empty()) with_label.title += (figure.title.empty() ? "" : ": ") + figure.y.label;
  const std::string size = std::to_string(columns) + "," + std::to_string(lines);
  return trimmed(
      run_gnuplot("set terminal dumb size " + size + " noenhanced mono\n" + script_of(with_label, true)));
}

}  // namespace fabricsh::plot
