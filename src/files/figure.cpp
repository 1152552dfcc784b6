#include "files/figure.hpp"

#include <array>
#include <cmath>
#include <filesystem>

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

// Between single quotes gnuplot takes all but the quote itself as it is; a line end would end the command.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    const bool line_end = c == '\n' || c == '\r' || c == '\0';
    out += c == '\'' ? std::string("''") : std::string(1, line_end ? ' ' : c);
  }
  return out + "'";
}

std::string with(CurveStyle style) {
  switch (style) {
    case CurveStyle::dashed:
      return "lines dashtype 2";
    case CurveStyle::points:
      return "points pointtype 6";
    case CurveStyle::line_points:
      return "linespoints pointtype 7 pointsize 0.5";
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

std::string plot_item(std::size_t index, const Curve& curve) {
  const std::string key = curve.label.empty() ? "notitle" : "title " + quoted(curve.label);
  return "$curve" + std::to_string(index) + " using 1:2 with " + with(curve.style) +
         " linewidth 2 linecolor rgb '" + colours[index % colours.size()] + "' " + key;
}

void check(const std::vector<Curve>& curves) {
  if (curves.empty()) throw Error("figure: expected at least one curve");
  for (const Curve& curve : curves)
    if (curve.x.size() != curve.y.size())
      throw Error("figure: curve '" + curve.label + "': expected as many y as x, got " +
                  std::to_string(curve.y.size()) + " and " + std::to_string(curve.x.size()));
}

}  // namespace

void figure(const std::string& path, const std::string& title, const std::string& xlabel,
            const std::string& ylabel, const std::vector<Curve>& curves) {
  check(curves);
  std::string script = "set terminal " + terminal(path) + "\n";
  AtomicFile file(path);
  script +=
      "set output " + quoted(file.temporary()) + "\nset title " + quoted(title) + "\nset xlabel " +
      quoted(xlabel) + "\nset ylabel " + quoted(ylabel) +
      "\nset grid linecolor rgb '#dddddd'\nset key below Left reverse\nset tics nomirror\nset border 3\n";
  std::string plot = "plot ";
  for (std::size_t i = 0; i < curves.size(); ++i) {
    script += block(i, curves[i]);
    plot += (i > 0 ? ", " : "") + plot_item(i, curves[i]);
  }
  run_gnuplot(script + plot + "\nset output\n");
  file.commit(Sync::no);
}

}  // namespace fabricsh::files
