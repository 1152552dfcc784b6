#include "plot/gnuplot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "system/child.hpp"

namespace fabricsh::plot {

namespace {

// gnuplot repeats the line with the error, marks a place in it, and gives the reason in the last
// line, preceded by a position in a script that the user has never seen. This returns the reason.
std::string reason_in(const std::string& said) {
  const std::size_t start = said.find_last_of('\n');
  std::string last = start == std::string::npos ? said : said.substr(start + 1);
  if (const std::size_t place = last.find("line "); place != std::string::npos)
    if (const std::size_t colon = last.find(": ", place); colon != std::string::npos)
      last.erase(0, colon + 2);
  last.erase(0, std::min(last.find_first_not_of(' '), last.size()));
  return last.empty() ? "it gave no reason" : last;
}

// XML requires "]]>" to be escaped in any text; gnuplot
// does not use CDATA sections and does not escape it.
void escape_ends(std::string& svg) {
  for (std::size_t at = 0; (at = svg.find("]]>", at)) != std::string::npos;) svg.replace(at + 2, 1, "&gt;");
}

void replace_once(std::string& text, const std::string& from, const std::string& to) {
  if (const std::size_t at = text.find(from); at != std::string::npos) text.replace(at, from.size(), to);
}

// Replaces the text from the first `from` to the next `to`, both included.
void replace_span(std::string& text, const std::string& from, const std::string& to, const std::string& by) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) return;
  const std::size_t end = text.find(to, at + from.size());
  if (end != std::string::npos) text.replace(at, end + to.size() - at, by);
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

void number_curves(std::string& svg) {
  const std::string mark = "id=\"gnuplot_plot_";
  int count = 0;
  for (std::size_t at = 0; (at = svg.find(mark, at)) != std::string::npos; at += mark.size()) {
    const std::size_t first = at + mark.size(), last = svg.find('"', first);
    if (last != std::string::npos) svg.replace(first, last - first, std::to_string(++count));
  }
}

std::string two_decimals(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

std::uint32_t cyclic_redundancy(const std::string& bytes) {
  std::uint32_t sum = 0xffffffffU;
  for (const char c : bytes) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ ((sum & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return ~sum;
}

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xffU);
  return bytes;
}

}  // namespace

std::string run_gnuplot(const std::string& script) {
  const system::ChildResult result =
      system::run_child({"gnuplot", "-d"}, script, "figure");  // -d: ignore the user's start-up file
  if (!result.found)
    throw NoGnuplot("figure: gnuplot is needed to draw and is not installed (apt-get install gnuplot-nox)");
  if (!result.good) throw Error("figure: gnuplot failed: " + reason_in(result.said));
  if (result.out.empty()) throw Error("figure: gnuplot drew nothing: " + reason_in(result.said));
  return result.out;
}

std::string finished_svg(std::string svg, double width, double height, double canvas_height, bool own_font) {
  constexpr double mm = 25.4 / 72;
  replace_span(svg, " width=\"", "\"", " width=\"" + two_decimals(width * mm) + "mm\"");
  replace_span(svg, " height=\"", "\"", " height=\"" + two_decimals(height * mm) + "mm\"");
  replace_span(svg, " viewBox=\"", "\"",
               " viewBox=\"0 " + two_decimals(canvas_height - height) + " " + two_decimals(width) + " " +
                   two_decimals(height) + "\"");
  replace_once(svg, "<title>Gnuplot</title>\n", "");
  if (!own_font) replace_all(svg, "font-family=\"Helvetica\"", "font-family=\"Helvetica,Arial,sans-serif\"");
  number_curves(svg);
  escape_ends(svg);
  return svg;
}

std::string finished_eps(std::string eps) {
  replace_span(eps, "%%CreationDate:", "\n", "");
  return eps;
}

// The signature and the header of a PNG have 33 bytes.
std::string finished_png(const std::string& png, double dpi) {
  if (png.size() < 33) return png;
  const auto per_metre = static_cast<std::uint32_t>(std::lround(dpi / 0.0254));
  const std::string piece = "pHYs" + big_endian(per_metre) + big_endian(per_metre) + '\1';
  return png.substr(0, 33) + big_endian(9) + piece + big_endian(cyclic_redundancy(piece)) + png.substr(33);
}

}  // namespace fabricsh::plot
