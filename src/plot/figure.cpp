#include "plot/figure.hpp"

#include <cmath>
#include <filesystem>
#include <sstream>

#include "base/error.hpp"
#include "base/number.hpp"
#include "plot/gnuplot.hpp"
#include "plot/layout.hpp"
#include "plot/script.hpp"
#include "plot/text.hpp"
#include "plot/visible.hpp"
#include "system/atomic.hpp"

namespace fabricsh::plot {

namespace {

std::string ending_of(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".svg" || ending == ".png" || ending == ".pdf" || ending == ".eps") return ending;
  throw Error("figure: expected a file name that ends in .svg, .pdf, .eps or .png, got '" + path + "'");
}

// gnuplot accepts only whole points or pixels, so the canvas may be slightly larger than the page.
struct Canvas {
  std::string terminal;
  double width = 0, height = 0;  // points
};

std::string font_of(const Paper& paper) {
  const std::string family = paper.font.empty() ? "Helvetica" : paper.font;
  return quoted(family + "," + number(paper.font_size));
}

// gnuplot's units differ: in its PDF and EPS a font size of 1 is 4/3 points and a line width of 1 half a
// point; in its PNG they are 4/3 pixels and one pixel. Dashes scale with the line width.
Canvas canvas_for(const std::string& ending, const PageLayout& l, const Paper& paper) {
  const std::string common = " noenhanced font " + font_of(paper);
  if (ending == ".svg") {
    const double w = std::ceil(l.width), h = std::ceil(l.height);
    return {"svg size " + number(w) + "," + number(h) + common + " background '#ffffff'", w, h};
  }
  if (ending == ".pdf" || ending == ".eps") {
    const double w = std::round(l.width), h = std::round(l.height);
    return {(ending == ".pdf" ? "pdfcairo size " : "epscairo size ") + full_number((w + 0.01) / 72) + "," +
                full_number((h + 0.01) / 72) + common +
                " fontscale 0.75 linewidth 2 pointscale 1 dashlength 1.8",
            w, h};
  }
  const double scale = paper.dpi / 72, w = std::round(scale * l.width), h = std::round(scale * l.height);
  const std::string by = full_number(scale);
  return {"pngcairo size " + number(w) + "," + number(h) + common + " fontscale " +
              full_number(0.75 * scale) + " linewidth " + by + " pointscale " + by + " dashlength 1.8",
          w / scale, h / scale};
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

}  // namespace

std::vector<std::string> draw(const std::string& path, const Page& page) {
  const std::string ending = ending_of(path);
  const PageLayout layout = layout_of(page);
  const Canvas canvas = canvas_for(ending, layout, page.paper);
  std::string drawn =
      run_gnuplot("set terminal " + canvas.terminal + "\n" +
                  script_of(page, layout, canvas.width, canvas.height, ending == ".eps") + "unset output\n");
  if (ending == ".svg")
    drawn =
        finished_svg(std::move(drawn), layout.width, layout.height, canvas.height, !page.paper.font.empty());
  if (ending == ".eps") drawn = finished_eps(std::move(drawn));
  if (ending == ".png") drawn = finished_png(drawn, page.paper.dpi);
  system::write_file(path, drawn, system::Sync::no);
  std::vector<std::string> warnings = layout.warnings;
  for (std::string& words : left_out(page)) warnings.push_back(std::move(words));
  return warnings;
}

std::vector<std::string> draw(const std::string& path, const Figure& figure) {
  Page page;
  page.panels = {figure};
  return draw(path, page);
}

// The label of y is placed above the axis, because text cannot be rotated in text mode.
std::string drawn_in_letters(const Page& page, int columns, int lines) {
  const std::string size = std::to_string(columns) + "," + std::to_string(lines);
  std::string all;
  for (const Figure& figure : page.panels) {
    Figure with_label = figure;
    if (!figure.y.label.empty()) with_label.title += (figure.title.empty() ? "" : ": ") + figure.y.label;
    all +=
        (all.empty() ? "" : "\n\n") + trimmed(run_gnuplot("set terminal dumb size " + size +
                                                          " noenhanced mono\n" + letters_script(with_label)));
  }
  return all;
}

std::string drawn_in_letters(const Figure& figure, int columns, int lines) {
  Page page;
  page.panels = {figure};
  return drawn_in_letters(page, columns, lines);
}

}  // namespace fabricsh::plot
