#include "format/pattern_drawing.hpp"

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace fabricsh::format {

namespace {

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

}  // namespace

Drawings read_drawings(std::string_view bytes) {
  std::istringstream stream{std::string(bytes)};
  DrawingReader collector;
  DL_Dxf().in(stream, &collector);
  collector.finish();
  return collector.result();
}

}  // namespace fabricsh::format
