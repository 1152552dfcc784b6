#include "plot/picture.hpp"

#include <unistd.h>

#include <cstring>
#include <functional>
#include <sstream>

#include "base/error.hpp"
#include "base/number.hpp"
#include "plot/gnuplot.hpp"
#include "system/atomic.hpp"
#include "system/child.hpp"

namespace fabricsh::plot {

namespace {

// One line "name value"; line ends inside a text would break the format and are replaced.
std::string line(const char* name, std::string value) {
  for (char& c : value)
    if (c == '\n' || c == '\r' || c == '\0') c = ' ';
  return std::string(name) + " " + value + "\n";
}

PicturePanel& last(Picture& p) { return p.panels.at(p.panels.size() - 1); }

using Setter = std::function<void(Picture&, const std::string&)>;

const std::vector<std::pair<std::string, Setter>>& setters() {
  using P = Picture;
  static const std::vector<std::pair<std::string, Setter>> all = {
      {"png", [](P& p, const std::string& v) { p.png = v; }},
      {"panel", [](P& p, const std::string& v) { p.panels.push_back({v}); }},
      {"label", [](P& p, const std::string& v) { last(p).label = v; }},
      {"azimuth", [](P& p, const std::string& v) { last(p).azimuth = std::stod(v); }},
      {"elevation", [](P& p, const std::string& v) { last(p).elevation = std::stod(v); }},
      {"columns", [](P& p, const std::string& v) { p.columns = std::stoi(v); }},
      {"title", [](P& p, const std::string& v) { p.title = v; }},
      {"array", [](P& p, const std::string& v) { p.array = v; }},
      {"component", [](P& p, const std::string& v) { p.component = v; }},
      {"factor", [](P& p, const std::string& v) { p.factor = std::stod(v); }},
      {"bar", [](P& p, const std::string& v) { p.bar = v; }},
      {"low", [](P& p, const std::string& v) { p.low = std::stod(v), p.fixed_range = true; }},
      {"high", [](P& p, const std::string& v) { p.high = std::stod(v), p.fixed_range = true; }},
      {"width", [](P& p, const std::string& v) { p.width = std::stoi(v); }},
      {"height", [](P& p, const std::string& v) { p.height = std::stoi(v); }},
      {"edges", [](P& p, const std::string& v) { p.edges = v == "1"; }},
      {"axes", [](P& p, const std::string& v) { p.axes = v == "1"; }},
      {"bodies", [](P& p, const std::string& v) { p.bodies = std::stod(v); }},
      {"fit", [](P& p, const std::string& v) { p.fit = v == "1"; }},
      {"smooth", [](P& p, const std::string& v) { p.smooth = v == "1"; }},
      {"dpi", [](P& p, const std::string& v) { p.dpi = std::stod(v); }},
      {"font_size", [](P& p, const std::string& v) { p.font_size = std::stod(v); }},
  };
  return all;
}

}  // namespace

std::string picture_text(const Picture& p) {
  std::string text = line("png", p.png);
  for (const PicturePanel& panel : p.panels)
    text += line("panel", panel.vtu) + line("label", panel.label) +
            line("azimuth", full_number(panel.azimuth)) + line("elevation", full_number(panel.elevation));
  text += line("columns", std::to_string(p.columns)) + line("title", p.title) + line("array", p.array) +
          line("component", p.component) + line("factor", full_number(p.factor)) + line("bar", p.bar);
  if (p.fixed_range) text += line("low", full_number(p.low)) + line("high", full_number(p.high));
  return text + line("smooth", p.smooth ? "1" : "0") + line("dpi", full_number(p.dpi)) +
         line("font_size", full_number(p.font_size)) + line("width", std::to_string(p.width)) +
         line("height", std::to_string(p.height)) + line("edges", p.edges ? "1" : "0") +
         line("axes", p.axes ? "1" : "0") + line("bodies", full_number(p.bodies)) +
         line("fit", p.fit ? "1" : "0");
}

Picture read_picture(std::istream& text) {
  Picture picture;
  for (std::string row; std::getline(text, row);) {
    const std::size_t blank = std::min(row.find(' '), row.size());
    const std::string name = row.substr(0, blank), value = blank < row.size() ? row.substr(blank + 1) : "";
    bool known = false;
    for (const auto& [word, set] : setters()) {
      if (word != name) continue;
      known = true;
      try {
        set(picture, value);
      } catch (const std::exception&) {
        throw Error("picture: '" + row + "' can't be read");
      }
    }
    if (!known) throw Error("picture: unknown line '" + row + "'");
  }
  return picture;
}

namespace {

// VTK does not write the resolution of a picture.
void say_resolution(const system::AtomicFile& file, double dpi) {
  std::string drawn;
  {
    const system::Descriptor in = system::Gate::of_process().open(file.temporary());
    char bytes[1 << 16];
    for (ssize_t n = 0; (n = ::read(in.number(), bytes, sizeof bytes)) > 0;)
      drawn.append(bytes, static_cast<std::size_t>(n));
  }
  const system::Descriptor out = file.open();
  if (const int reason = out.write(finished_png(drawn, dpi))) system::cannot_write(file.temporary(), reason);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

std::vector<std::string> render(const Picture& picture, const std::string& program) {
  system::AtomicFile file(picture.png);
  Picture request = picture;
  request.png = file.temporary();
  const system::ChildResult result = system::run_child({program}, picture_text(request), "render");
  if (!result.found)
    throw Error("render: no drawing program: '" + program + "' (build the target fabricsh-render)");
  if (!result.good && result.said.starts_with("render: ")) throw Error(result.said);
  if (!result.good)
    throw Error("render: the program that draws ended before the picture was whole: '" + program + "'" +
                (result.signal != 0 ? std::string(", by the signal ") + strsignal(result.signal) : "") +
                (result.said.empty() ? "" : ", saying: " + result.said.substr(0, result.said.find('\n'))));
  if (picture.dpi > 0) say_resolution(file, picture.dpi);
  file.commit(system::Sync::no);
  return lines_of(result.out);
}

}  // namespace fabricsh::plot
