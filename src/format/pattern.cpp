#include "format/pattern.hpp"

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <sstream>

#include "base/error.hpp"
#include "base/number.hpp"
#include "format/pattern_parts.hpp"
#include "format/source.hpp"
#include "mesh/curve.hpp"

namespace fabricsh::format {

namespace {

// --- The drawing in a DXF file of a pattern, before it becomes panels.

struct DrawnVertex {
  mesh::Vec2 x;
  double
      bulge;  // of the line that follows: tangent of a quarter of its arc's angle, positive counter-clockwise
};

struct DrawnLine {
  bool closed = false;
  std::vector<DrawnVertex> vertices;
};

// Of one block, or of no block. Lengths in units of the file.
struct Drawing {
  std::string block, name;                                // name: from a text "Piece name: ..."
  std::string size;                                       // from a text "Size: ..."
  std::map<std::string, std::vector<DrawnLine>> lines;    // by layer
  std::map<std::string, std::vector<mesh::Vec2>> points;  // by layer
  std::map<std::string, int> others;                      // by layer: entities of further kinds
};

struct Drawings {
  std::vector<Drawing> all;         // the first is what is in no block
  std::optional<double> unit = {};  // m
  bool by_word = false;             // the unit is known from a text alone
  std::string contradiction = {};   // two units that cannot both be, in words; empty if there is none
};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// The value of a text "Key: value" without blanks around it; nothing if the text has another key.
std::optional<std::string> value_of(const std::string& text, const std::string& key) {
  if (!lower(text).starts_with(key + ":")) return {};
  const std::string value = text.substr(key.size() + 1);
  const std::size_t first = value.find_first_not_of(" \t"), last = value.find_last_not_of(" \t\r");
  return first == value.npos ? std::string() : value.substr(first, last - first + 1);
}

// The unit of a drawing by the codes of $INSUNITS, m.
std::optional<double> unit_of(int code) {
  static const std::map<int, double> units = {{1, 0.0254}, {2, 0.3048}, {4, 1e-3},
                                              {5, 1e-2},   {6, 1},      {14, 0.1}};
  const auto found = units.find(code);
  return found == units.end() ? std::nullopt : std::optional(found->second);
}

// dxflib calls these functions while it reads.
class DrawingReader final : public DL_CreationAdapter {
 public:
  using DL_CreationAdapter::setVariableInt;
  DrawingReader() { drawings_.all.emplace_back(); }
  Drawings result() { return std::move(drawings_); }

  void addBlock(const DL_BlockData& block) override {
    drawings_.all.push_back({block.name, {}, {}, {}, {}, {}});
    inside_ = true;
    open_ = nullptr;
  }
  void endBlock() override {
    inside_ = false;
    open_ = nullptr;
  }

  void addPolyline(const DL_PolylineData& data) override {
    open_ = &now().lines[layer()].emplace_back();
    open_->closed = (data.flags & 1) != 0;
  }
  void addVertex(const DL_VertexData& data) override {
    if (open_ != nullptr) open_->vertices.push_back({{data.x, data.y}, data.bulge});
  }
  void addLine(const DL_LineData& data) override {
    add({false, {{{data.x1, data.y1}, 0}, {{data.x2, data.y2}, 0}}});
  }
  // Two half circles.
  void addCircle(const DL_CircleData& data) override {
    const mesh::Vec2 centre(data.cx, data.cy), side(data.radius, 0);
    add({true, {{centre + side, 1}, {centre - side, 1}}});
  }
  void addPoint(const DL_PointData& data) override { now().points[layer()].emplace_back(data.x, data.y); }
  void addText(const DL_TextData& data) override {
    if (const auto name = value_of(data.text, "piece name")) now().name = *name;
    if (const auto size = value_of(data.text, "size")) now().size = *size;
    if (const auto unit = value_of(data.text, "units"))
      if (const std::string word = lower(*unit); word == "metric" || word == "english") add_word(word);
  }
  void addArc(const DL_ArcData&) override { other(); }
  void addEllipse(const DL_EllipseData&) override { other(); }
  void addSpline(const DL_SplineData&) override { other(); }
  void setVariableInt(const std::string& key, int value, int) override {
    if (key != "$INSUNITS") return;
    drawings_.unit = unit_of(value);
    code_ = value;
  }

  // The code of the header and the word of a text may not contradict each other: an inch is no metric unit.
  void finish() {
    if (drawings_.unit && text_unit_ && (code_ == 1 || code_ == 2) == (*text_unit_ == 1e-3))
      drawings_.contradiction =
          "$INSUNITS is " + std::to_string(code_) + " (" + words_of(code_) +
          "), and a text says 'Units: " + (*text_unit_ == 1e-3 ? "METRIC'" : "ENGLISH' (inches)");
    drawings_.by_word = !drawings_.unit && text_unit_;
    if (!drawings_.unit) drawings_.unit = text_unit_;
  }

 private:
  Drawing& now() { return inside_ ? drawings_.all.back() : drawings_.all.front(); }
  // Vertices belong to the polyline before them, which is not followed by another line.
  void add(DrawnLine line) {
    open_ = nullptr;
    now().lines[layer()].push_back(std::move(line));
  }
  void add_word(const std::string& word) {
    const double unit = word == "metric" ? 1e-3 : 0.0254;
    if (text_unit_ && *text_unit_ != unit)
      drawings_.contradiction = "one text says 'Units: METRIC', another 'Units: ENGLISH'";
    text_unit_ = unit;
  }
  static std::string words_of(int code) {
    static const std::map<int, std::string> words = {{1, "inches"},      {2, "feet"},   {4, "millimetres"},
                                                     {5, "centimetres"}, {6, "metres"}, {14, "decimetres"}};
    return words.at(code);
  }
  std::string layer() { return attributes.getLayer(); }
  void other() { ++now().others[layer()]; }

  Drawings drawings_;
  DrawnLine* open_ = nullptr;
  std::optional<double> text_unit_;
  int code_ = 0;  // of $INSUNITS
  bool inside_ = false;
};

Drawings read_drawings(std::string_view bytes) {
  std::istringstream stream{std::string(bytes)};
  DrawingReader collector;
  DL_Dxf().in(stream, &collector);
  collector.finish();
  return collector.result();
}

}  // namespace

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

// Ends of lines that are nearer than this part of a piece's extent are meant to meet.
constexpr double kJoined = 2e-3;

constexpr std::size_t kMostLines = 10'000;  // of a boundary in single lines

// Open lines in the order and direction in which they follow each other.
struct Chain {
  DrawnLine line;      // closed
  std::size_t left;    // lines that do not follow
  double gap, widest;  // between its end and its start; the largest between two of its lines
  double nearest;      // from its end to the nearest line that is left
};

// The line from its end to its start. The bulge of a vertex belongs to what follows it.
DrawnLine reversed(DrawnLine line) {
  auto& v = line.vertices;
  std::reverse(v.begin(), v.end());
  for (std::size_t i = 0; i + 1 < v.size(); ++i) v[i].bulge = -v[i + 1].bulge;
  v.back().bulge = 0;
  return line;
}

// From the first line on, at each end the nearest end of those that are left, unless the start is nearer.
Chain chained(std::vector<DrawnLine> lines, double reach) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Chain chain{lines.front(), lines.size() - 1, far, 0, far};
  lines.erase(lines.begin());
  auto& v = chain.line.vertices;
  while (true) {
    const Vec2 end = v.back().x;
    std::size_t next = 0;
    bool turned = false;
    chain.gap = v.size() > 2 ? (end - v.front().x).norm() : far;
    chain.nearest = far;
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const bool backward : {false, true}) {
        const Vec2& x = backward ? lines[i].vertices.back().x : lines[i].vertices.front().x;
        if ((x - end).norm() < chain.nearest) chain.nearest = (x - end).norm(), next = i, turned = backward;
      }
    if (!(chain.nearest <= reach) || chain.gap < chain.nearest) break;
    const DrawnLine more = turned ? reversed(lines[next]) : lines[next];
    chain.widest = std::max(chain.widest, chain.nearest);
    v.back().bulge = more.vertices.front().bulge;
    v.insert(v.end(), more.vertices.begin() + 1, more.vertices.end());
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(next));
    --chain.left;
  }
  if (chain.gap <= reach && v.size() > 2) {
    chain.line.closed = true;
    v.pop_back();  // the start stands for both
  }
  return chain;
}

// From a to b with the bulge of DXF: the height of the arc over its half chord, positive to the right.
PlaneCurve bulged(const Vec2& a, const Vec2& b, double bulge) {
  if (std::abs(bulge) < 1e-9) return PlaneCurve::line(a, b);
  const Vec2 chord = b - a, right(chord.y(), -chord.x());
  return PlaneCurve::arc_through(a, (a + b) / 2 + bulge / 2 * right, b);
}

// The largest extent of lines, units of the file.
double extent_of(const std::vector<DrawnLine>& lines) {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const DrawnLine& line : lines)
    for (const DrawnVertex& v : line.vertices) {
      low = low.cwiseMin(v.x);
      high = high.cwiseMax(v.x);
    }
  return (high - low).maxCoeff();
}

// Makes one piece of a drawing.
class PieceMaker {
 public:
  // several: another drawing of the file has the same name, so that messages name the size.
  PieceMaker(const std::string& file, const Drawing& drawing, double unit, bool several)
      : drawing_(drawing), unit_(unit) {
    piece_.name = !drawing.name.empty() ? drawing.name : drawing.block;
    piece_.block = drawing.block;
    piece_.size = !drawing.size.empty() ? drawing.size : behind_name();
    who_ = file + ": piece '" + piece_.name + "'" +
           (several && !piece_.size.empty() ? ", size '" + piece_.size + "'" : "") + ": ";
  }
  // Makes the piece, or says in it why it cannot be made.
  PatternPiece make() {
    try {
      build();
    } catch (const Error& error) {
      piece_.trouble = error.what();
    }
    return std::move(piece_);
  }

 private:
  // The part of the block's name behind that of the piece: 38 of FRONT-38.
  std::string behind_name() const {
    if (drawing_.name.empty() || !drawing_.block.starts_with(drawing_.name)) return {};
    const auto at = drawing_.block.find_first_not_of(" _-.", drawing_.name.size());
    return at == std::string::npos || at == drawing_.name.size() ? std::string() : drawing_.block.substr(at);
  }

  // The boundary: one line, or the open ones joined where their ends meet.
  DrawnLine boundary_line() {
    std::vector<DrawnLine> drawn;
    for (const DrawnLine& line : lines(boundary))
      if (!line.vertices.empty()) drawn.push_back(line);
    extent_ = extent_of(drawn);
    const auto closed = std::count_if(drawn.begin(), drawn.end(), [&](const DrawnLine& line) {
      return line.closed || (line.vertices.back().x - line.vertices.front().x).norm() <= 1e-6 * extent_;
    });
    if (drawn.size() == 1 && closed == 0 && drawn.front().vertices.size() < 3) return drawn.front();
    if (drawn.size() > kMostLines)
      refuse("expected at most " + std::to_string(kMostLines) + " lines on layer 1, the boundary, got " +
             std::to_string(drawn.size()));
    if (closed > 0 || drawn.empty()) {
      if (drawn.size() != 1)
        refuse("expected one closed line on layer 1, the boundary, got " + std::to_string(drawn.size()));
      return drawn.front();
    }
    const Chain chain = chained(drawn, kJoined * extent_);
    if (chain.left > 0 || chain.gap > kJoined * extent_) {
      const Vec2 end = chain.line.vertices.back().x, start = chain.line.vertices.front().x;
      std::string words = "open: ";
      if (drawn.size() == 1)
        words += "a line ends at ";
      else
        words += std::to_string(drawn.size()) + " lines on layer 1 make no closed boundary: after " +
                 std::to_string(drawn.size() - chain.left) + " of them it ends at ";
      words += place(end) + ", " + number((end - start).norm()) + " from its start " + place(start);
      if (chain.left > 0) words += ", and " + number(chain.nearest) + " from the nearest end of another line";
      refuse(words + " (in units of the file)");
    }
    if (const double most = std::max(chain.gap, chain.widest); most > 1e-5 * extent_)
      piece_.remarks.push_back(who_ + "the lines of its boundary end up to " + number(most * unit_ * 1e3) +
                               " mm apart and are joined");
    return chain.line;
  }

  void build() {
    for (const char* layer : {boundary, cutout})
      if (drawing_.others.contains(layer))
        refuse(std::string("expected lines, polylines and circles on layer ") + layer +
               ", got an arc, an ellipse or a spline");
    piece_.panel.outline = loop(boundary_line(), true);
    name_edges(piece_.panel.outline);
    for (const DrawnLine& line : lines(cutout)) piece_.panel.holes.push_back(loop(line, false));
    add_notches();
    add_grain();
    remark_layers();
  }

  // Lines and arcs between corners, and splines through the points of a curve.
  mesh::Loop loop(const DrawnLine& line, bool outline) {
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

  // The vertices, each place once. Error: the line is open, or too short.
  std::vector<DrawnVertex> cleaned(const DrawnLine& line) const {
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

  bool smooth(const Vec2& x) const {
    const auto& marked = points(curve);
    return std::any_of(marked.begin(), marked.end(),
                       [&](const Vec2& p) { return (p - x).norm() <= 1e-4 * extent_; });
  }
  void add_notches() {
    int count = 0;
    for (const std::string& layer : notch_layers)
      for (const Vec2& x : points(layer))
        add_notch(piece_, "notch" + std::to_string(++count), unit_ * x, who_);
  }
  void add_grain() {
    const auto& all = lines(grain);
    if (all.empty() || all.front().vertices.size() < 2) return;
    const Vec2 along = all.front().vertices.back().x - all.front().vertices.front().x;
    if (along.norm() == 0) refuse("the grain line on layer 7 has no length");
    piece_.panel.grain = std::atan2(along.y(), along.x()) * 180 / std::numbers::pi;
    piece_.has_grain = true;
  }

  void remark_layers() {
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

// The largest length or width of a piece, m.
double reach_of(const PatternPiece& piece) {
  Vec2 low = piece.panel.outline.front().curve.start(), high = low;
  for (const mesh::OutlinePiece& side : piece.panel.outline) {
    low = low.cwiseMin(side.curve.start());
    high = high.cwiseMax(side.curve.start());
  }
  return (high - low).maxCoeff();
}

// Metric units are millimetres by the standard, and centimetres where programs write them. A pattern whose
// largest piece would be smaller than a hand is asked about.
void ask_for_centimetres(const std::string& name, const std::vector<PatternPiece>& pieces, Remarks* remarks) {
  constexpr double hand = 0.1;
  double reach = 0;
  for (const PatternPiece& piece : pieces)
    if (piece.trouble.empty()) reach = std::max(reach, reach_of(piece));
  if (reach == 0 || reach >= hand || remarks == nullptr) return;
  remarks->push_back(name + ": 'Units: METRIC' is taken for millimetres, and its largest piece is then " +
                     number(reach * 1e3) + " mm long: is it in cm? unit=1*cm, or unit=1*mm, says");
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
  if (!unit && !drawings.contradiction.empty())
    throw Error(name + ": its units contradict each other: " + drawings.contradiction +
                "; expected unit= (1*mm if one in the file is a millimetre)");
  const double used = unit_of_file(name, unit, drawings.unit, remarks);
  std::vector<PatternPiece> pieces;
  std::map<std::string, int> names;
  const auto name_of = [](const Drawing* drawing) {
    return drawing->name.empty() ? drawing->block : drawing->name;
  };
  for (const Drawing* drawing : drawn) ++names[name_of(drawing)];
  for (const Drawing* drawing : drawn)
    pieces.push_back(PieceMaker(name, *drawing, used, names[name_of(drawing)] > 1).make());
  if (std::all_of(pieces.begin(), pieces.end(), [](const PatternPiece& p) { return !p.trouble.empty(); }))
    throw Error(pieces.front().trouble);
  if (!unit && drawings.by_word && *drawings.unit == 1e-3) ask_for_centimetres(name, pieces, remarks);
  return pieces;
}

std::vector<PatternPiece> read_dxf_pattern(const std::string& path, std::optional<double> unit,
                                           Remarks* remarks) {
  return parse_dxf_pattern(path, read_file(path), unit, remarks);
}

}  // namespace fabricsh::format
