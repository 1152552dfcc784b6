#include "files/figure.hpp"

#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "base/error.hpp"
#include "files/atomic.hpp"
#include "files/gnuplot.hpp"
#include "files/number.hpp"

namespace fabricsh::files {

namespace {

// Told apart by most colour-blind readers and in grey print.
constexpr std::array<const char*, 6> colours = {"#0072b2", "#d55e00", "#009e73",
                                                "#cc79a7", "#e69f00", "#000000"};

std::string terminal(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".svg") return "svg size 800,600 noenhanced background '#ffffff' font 'sans,14'";
  if (ending == ".png") return "pngcairo size 1600,1200 noenhanced fontscale 2 linewidth 2 pointscale 2";
  if (ending == ".pdf") return "pdfcairo size 16cm,12cm noenhanced";
  throw Error("figure: expected a file name that ends in .svg, .png or .pdf, got '" + path + "'");
}

// Letters, digits, blanks and what is not ASCII as they are, all else by its octal number: nothing is left
// that gnuplot could take for the end of the text, a command in backquotes or a macro. Control characters are
// blanks.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    char code[8];
    std::snprintf(code, sizeof code, "\\%03o", byte);
    if (byte < 32 || byte == 127)
      out += ' ';
    else if (byte >= 128 || byte == ' ' || std::isalnum(byte) != 0)
      out += c;
    else
      out += code;
  }
  return out + "\"";
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

// A number that is not finite leaves an empty line, which interrupts the curve.
std::string block(std::size_t index, const Curve& curve) {
  std::string text = "$curve" + std::to_string(index) + " << END_OF_CURVE\n";
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]))
      text += number(curve.x[i]) + " " + number(curve.y[i]);
    text += "\n";
  }
  return text + "END_OF_CURVE\n";
}

// In letters each line type has its own mark.
std::string plot_item(std::size_t index, const Curve& curve, bool letters) {
  const std::string key = curve.label.empty() ? "notitle" : "title " + quoted(curve.label);
  const std::string look =
      letters ? " linetype " + std::to_string(index + 1)
              : " linewidth 2 linecolor rgb '" + std::string(colours[index % colours.size()]) + "'";
  return "$curve" + std::to_string(index) + " using 1:2 with " + with(curve.style, letters) + look + " " +
         key;
}

// Without blanks at the ends of lines, and without empty lines before the first.
std::string trimmed(const std::string& text) {
  std::string out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line.erase(line.find_last_not_of(" \f") + 1);
    if (!out.empty() || !line.empty()) out += (out.empty() ? "" : "\n") + line;
  }
  return out;
}

void check(const std::vector<Curve>& curves) {
  if (curves.empty()) throw Error("figure: expected at least one curve");
  for (const Curve& curve : curves)
    if (curve.x.size() != curve.y.size())
      throw Error("figure: curve '" + curve.label + "': expected as many y as x, got " +
                  std::to_string(curve.y.size()) + " and " + std::to_string(curve.x.size()));
}

std::string axis(const std::string& name, const Axis& a) {
  const auto end = [](const std::optional<double>& value) {
    return value ? number(*value) : std::string("*");
  };
  return "set " + name + "label " + quoted(a.label) + "\nset " + name + "range [" + end(a.low) + ":" +
         end(a.high) + "]\n" + (a.logarithmic ? "set logscale " + name + "\n" : "");
}

// All but the terminal and where it writes. In letters lines are told apart by their own marks.
std::string script_of(const Figure& f, bool letters) {
  check(f.curves);
  std::string script = "set title " + quoted(f.title) + "\n" + axis("x", f.x) + axis("y", f.y) +
                       "set key below Left reverse\nset tics nomirror\nset border 3\n";
  if (!letters) script += "set grid linecolor rgb '#dddddd'\nset xlabel offset 0,0.4\n";
  std::string plot = "plot ";
  for (std::size_t i = 0; i < f.curves.size(); ++i) {
    script += block(i, f.curves[i]);
    plot += (i > 0 ? ", " : "") + plot_item(i, f.curves[i], letters);
  }
  return script + plot + "\n";
}

}  // namespace

void draw(const std::string& path, const Figure& figure) {
  const std::string start = "set terminal " + terminal(path) + "\n";
  write_file(path, run_gnuplot(start + script_of(figure, false) + "unset output\n"), Sync::no);
}

// The label of y, which letters can't turn, stands above the axis.
std::string drawn_in_letters(const Figure& figure, int columns, int lines) {
  Figure with_label = figure;
  if (!figure.y.label.empty()) with_label.title += (figure.title.empty() ? "" : ": ") + figure.y.label;
  const std::string size = std::to_string(columns) + "," + std::to_string(lines);
  return trimmed(
      run_gnuplot("set terminal dumb size " + size + " noenhanced mono\n" + script_of(with_label, true)));
}

}  // namespace fabricsh::files
