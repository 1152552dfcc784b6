#include "format/pattern.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/number.hpp"
#include "format/pattern_drawing.hpp"
#include "format/pattern_parts.hpp"
#include "format/source.hpp"

namespace fabricsh::format {

using mesh::PlaneCurve;
using mesh::Vec2;

namespace {

// The layers of ASTM D6673 that are used here; "turn" are the corners, which follow from the curves.
constexpr const char *boundary = "1", *turn = "2", *curve = "3", *mirror = "6", *grain = "7", *cutout = "11";
const std::vector<std::string> notch_layers = {"4", "80", "81", "82", "83"};

std::string layer_words(const std::string& layer) {
  static const std::map<std::string, std::string> known = {
      {"5", "grading"},      {"8", "inner lines"}, {"9", "stripes"},    {"10", "plaid"},
      {"13", "drill holes"}, {"14", "sew line"},   {"15", "annotation"}};
  const auto found = known.find(layer);
  return "'" + layer + "'" + (found == known.end() ? "" : " (" + found->second + ")");
}

// Makes one piece of a drawing.
class PieceMaker {
 public:
  PieceMaker(const std::string& file, const Drawing& drawing, double unit) : drawing_(drawing), unit_(unit) {
    piece_.name = !drawing.name.empty() ? drawing.name : drawing.block;
    who_ = file + ": piece '" + piece_.name + "': ";
  }
  PatternPiece make();

 private:
  mesh::Loop loop(const DrawnLine& line, bool outline);
  std::vector<DrawnVertex> cleaned(const DrawnLine& line) const;
  bool smooth(const Vec2& x) const;
  void add_notches();
  void add_grain();
  void remark_layers();
  [[noreturn]] void refuse(const std::string& why) const { throw Error(who_ + why); }
  std::string place(const Vec2& x) const { return "(" + number(x.x()) + ", " + number(x.y()) + ")"; }
  const std::vector<DrawnLine>& lines(const std::string& layer) const {
    static const std::vector<DrawnLine> none;
    const auto found = drawing_.lines.find(layer);
    return found == drawing_.lines.end() ? none : found->second;
  }
  const std::vector<Vec2>& points(const std::string& layer) const {
    static const std::vector<Vec2> none;
    const auto found = drawing_.points.find(layer);
    return found == drawing_.points.end() ? none : found->second;
  }

  const Drawing& drawing_;
  double unit_;
  std::string who_;
  PatternPiece piece_;
  double extent_ = 0;  // of the boundary, units of the file
};

// The vertices, each place once. Error: the line is open, or too short.
std::vector<DrawnVertex> PieceMaker::cleaned(const DrawnLine& line) const {
  std::vector<DrawnVertex> kept;
  for (const DrawnVertex& v : line.vertices) {
    if (!v.x.allFinite() || !std::isfinite(v.bulge)) refuse("a vertex that is not finite");
    if (kept.empty() || (kept.back().x - v.x).norm() > 1e-6 * extent_) kept.push_back(v);
  }
  if (kept.empty()) refuse("a line without vertices");
  const double gap = (kept.back().x - kept.front().x).norm();
  if (kept.size() > 1 && gap <= 1e-6 * extent_)
    kept.pop_back();
  else if (!line.closed)
    refuse("open: a line ends at " + place(kept.back().x) + ", " + number(gap) + " from its start " +
           place(kept.front().x) + " (in units of the file)");
  if (kept.size() < 2) refuse("a line of less than two points");
  return kept;
}

bool PieceMaker::smooth(const Vec2& x) const {
  const auto& marked = points(curve);
  return std::any_of(marked.begin(), marked.end(),
                     [&](const Vec2& p) { return (p - x).norm() <= 1e-4 * extent_; });
}

// From a to b with the bulge of DXF: the height of the arc over its half chord, positive to the right.
PlaneCurve bulged(const Vec2& a, const Vec2& b, double bulge) {
  if (std::abs(bulge) < 1e-9) return PlaneCurve::line(a, b);
  const Vec2 chord = b - a, right(chord.y(), -chord.x());
  return PlaneCurve::arc_through(a, (a + b) / 2 + bulge / 2 * right, b);
}

// Lines and arcs between corners, and splines through the points of a curve.
mesh::Loop PieceMaker::loop(const DrawnLine& line, bool outline) {
  std::vector<DrawnVertex> vertices = cleaned(line);
  const auto is_smooth = [&](const DrawnVertex& v) { return outline && smooth(v.x); };
  const auto corner = std::find_if_not(vertices.begin(), vertices.end(), is_smooth);
  if (corner != vertices.end()) std::rotate(vertices.begin(), corner, vertices.end());
  mesh::Loop made;
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i < n;) {
    std::vector<Vec2> through{unit_ * vertices[i].x};
    const double bulge = vertices[i].bulge;
    do through.push_back(unit_ * vertices[++i % n].x);
    while (i < n && is_smooth(vertices[i % n]));
    made.push_back(
        {through.size() > 2 ? PlaneCurve::spline(through) : bulged(through[0], through[1], bulge)});
  }
  return made;
}

void PieceMaker::add_notches() {
  int count = 0;
  for (const std::string& layer : notch_layers)
    for (const Vec2& x : points(layer)) add_notch(piece_, "notch" + std::to_string(++count), unit_ * x, who_);
}

void PieceMaker::add_grain() {
  const auto& all = lines(grain);
  if (all.empty() || all.front().vertices.size() < 2) return;
  const Vec2 along = all.front().vertices.back().x - all.front().vertices.front().x;
  if (along.norm() == 0) refuse("the grain line on layer 7 has no length");
  piece_.panel.grain = std::atan2(along.y(), along.x()) * 180 / std::numbers::pi;
  piece_.has_grain = true;
}

void PieceMaker::remark_layers() {
  std::map<std::string, bool> present;
  for (const auto& [layer, drawn] : drawing_.lines) present[layer] = true;
  for (const auto& [layer, drawn] : drawing_.points) present[layer] = true;
  for (const auto& [layer, drawn] : drawing_.others) present[layer] = true;
  if (present.contains(mirror))
    piece_.remarks.push_back(who_ + "has a mirror line (layer 6): this is one half of it");
  for (const char* used : {boundary, turn, curve, mirror, grain, cutout}) present.erase(used);
  for (const std::string& used : notch_layers) present.erase(used);
  std::string words;
  for (const auto& [layer, is] : present) words += (words.empty() ? "" : ", ") + layer_words(layer);
  if (!words.empty()) piece_.remarks.push_back(who_ + "layers that are not used: " + words);
}

PatternPiece PieceMaker::make() {
  const auto& outlines = lines(boundary);
  if (outlines.size() != 1)
    refuse("expected one closed line on layer 1, the boundary, got " + std::to_string(outlines.size()));
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const DrawnVertex& v : outlines.front().vertices) {
    low = low.cwiseMin(v.x);
    high = high.cwiseMax(v.x);
  }
  extent_ = (high - low).maxCoeff();
  for (const char* layer : {boundary, cutout})
    if (drawing_.others.contains(layer))
      refuse(std::string("expected lines, polylines and circles on layer ") + layer +
             ", got an arc, an ellipse or a spline");
  piece_.panel.outline = loop(outlines.front(), true);
  name_edges(piece_.panel.outline);
  for (const DrawnLine& line : lines(cutout)) piece_.panel.holes.push_back(loop(line, false));
  add_notches();
  add_grain();
  remark_layers();
  return std::move(piece_);
}

bool has_boundary(const Drawing& drawing) { return drawing.lines.contains(boundary); }

// The layers that the file draws on.
std::string layers_of(const Drawings& drawings) {
  std::map<std::string, bool> layers;
  for (const Drawing& drawing : drawings.all) {
    for (const auto& [layer, drawn] : drawing.lines) layers[layer] = true;
    for (const auto& [layer, drawn] : drawing.points) layers[layer] = true;
    for (const auto& [layer, drawn] : drawing.others) layers[layer] = true;
  }
  std::string words;
  for (const auto& [layer, is] : layers) words += (words.empty() ? "" : ", ") + layer_words(layer);
  return words.empty() ? "none" : words;
}

}  // namespace

std::vector<PatternPiece> parse_dxf_pattern(const std::string& name, std::string_view bytes,
                                            std::optional<double> unit, Remarks* remarks) {
  const Drawings drawings = read_drawings(bytes);
  std::vector<const Drawing*> drawn;
  for (std::size_t i = 1; i < drawings.all.size(); ++i)
    if (has_boundary(drawings.all[i])) drawn.push_back(&drawings.all[i]);
  if (drawn.empty() && has_boundary(drawings.all.front())) drawn.push_back(&drawings.all.front());
  if (drawn.empty())
    throw Error(name + ": no piece: expected a closed line on layer 1, got layers " + layers_of(drawings));
  const double used = unit_of_file(name, unit, drawings.unit, remarks);
  std::vector<PatternPiece> pieces;
  for (const Drawing* drawing : drawn) pieces.push_back(PieceMaker(name, *drawing, used).make());
  return pieces;
}

std::vector<PatternPiece> read_dxf_pattern(const std::string& path, std::optional<double> unit,
                                           Remarks* remarks) {
  return parse_dxf_pattern(path, read_file(path), unit, remarks);
}

}  // namespace fabricsh::format
