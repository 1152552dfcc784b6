
// GCC 12 cannot see that svgpp's arcs are set before they are read.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <libxml/parser.h>
#include <libxml/tree.h>

#include <svgpp/policy/xml/libxml2.hpp>
#include <svgpp/svgpp.hpp>
// Both of these need what stands above.
#include <algorithm>
#include <boost/mpl/set.hpp>
#include <boost/mpl/set/set30.hpp>
#include <map>
#include <memory>

#include "base/error.hpp"
#include "format/pattern_parts.hpp"
#include "format/source.hpp"

namespace fabricsh::format {

namespace {

using mesh::PlaneCurve;
using mesh::Vec2;

// x' = linear x + shift.
struct Affine {
  Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();
  Vec2 shift = Vec2::Zero();
  Vec2 operator()(const Vec2& x) const { return linear * x + shift; }
  Affine operator*(const Affine& inner) const {
    return {linear * inner.linear, linear * inner.shift + shift};
  }
};

// svgpp calls these functions while it walks through the document; all coordinates are absolute.
class SvgLines {
 public:
  // most: how many pieces of lines a document of this size can have.
  SvgLines(double unit, std::size_t most) : unit_(unit), left_(most) {}
  std::vector<SvgShape> result() { return std::move(shapes_); }

  template <class Tag>
  void on_enter_element(Tag) {
    levels_.push_back({{}, levels_.empty() ? upward() : levels_.back().to_drawing});
  }
  void on_exit_element() {
    Level& level = levels_.back();
    if (!level.lines.empty()) finish(level);
    levels_.pop_back();
  }
  template <class Range>
  void set(svgpp::tag::attribute::id, const Range& text) {
    levels_.back().shape.id.assign(boost::begin(text), boost::end(text));
  }
  void transform_matrix(const boost::array<double, 6>& m) {
    Affine own;
    own.linear << m[0], m[2], m[1], m[3];
    own.shift = {m[4], m[5]};
    levels_.back().to_drawing = levels_.back().to_drawing * own;
  }
  void path_move_to(double x, double y, svgpp::tag::coordinate::absolute) {
    levels_.back().lines.push_back({{{{x, y}}}, false});
  }
  void path_line_to(double x, double y, svgpp::tag::coordinate::absolute) { extend({{x, y}}); }
  void path_cubic_bezier_to(double x1, double y1, double x2, double y2, double x, double y,
                            svgpp::tag::coordinate::absolute) {
    extend({{x1, y1}, {x2, y2}, {x, y}});
  }
  void path_close_subpath() { now().closed = true; }
  void path_exit() {}

 private:
  // A line by the control points of its pieces, each without its start; the first entry is the start.
  struct ControlPoints {
    std::vector<std::vector<Vec2>> pieces;
    bool closed;
  };
  struct Level {
    SvgShape shape;
    Affine to_drawing;
    std::vector<ControlPoints> lines = {};
  };

  Affine upward() const { return {Eigen::Vector2d(unit_, -unit_).asDiagonal(), Vec2::Zero()}; }
  // After a closed line the next one begins where that began, unless there is a move.
  ControlPoints& now() {
    auto& lines = levels_.back().lines;
    if (lines.empty()) throw std::runtime_error("a path that does not begin with a move");
    return lines.back();
  }
  // An arc with one radius of zero has no end in svgpp 1.3: its pieces are not finite, or more than there can
  // be.
  void extend(std::vector<Vec2> piece) {
    for (const Vec2& x : piece)
      if (!x.allFinite())
        throw std::runtime_error("a coordinate that is not finite, as of an arc without radius");
    if (left_-- == 0) throw std::runtime_error("an arc without end");
    if (now().closed) levels_.back().lines.push_back({{now().pieces.front()}, false});
    now().pieces.push_back(std::move(piece));
  }
  void finish(Level& level);

  double unit_;  // m
  std::size_t left_;
  std::vector<Level> levels_;
  std::vector<SvgShape> shapes_;
};

void SvgLines::finish(Level& level) {
  for (const ControlPoints& points : level.lines) {
    SvgLine line{{}, points.closed};
    const Vec2 start = level.to_drawing(points.pieces.front()[0]);
    Vec2 from = start;
    const auto straight = [&](const Vec2& to) {
      if (to != from) line.pieces.push_back({PlaneCurve::line(from, to)});
      from = to;
    };
    for (std::size_t i = 1; i < points.pieces.size(); ++i) {
      std::vector<Vec2> control{from};
      for (const Vec2& x : points.pieces[i]) control.push_back(level.to_drawing(x));
      for (const Vec2& x : control)
        if (!x.allFinite()) throw std::runtime_error("a coordinate that is not finite");
      if (control.size() == 2) {
        straight(control.back());
        continue;
      }
      line.pieces.push_back({PlaneCurve::bezier(control)});
      from = control.back();
    }
    // A line that returns to its start is closed, whether it says so or not.
    const double gap = (from - start).norm();
    double length = 0;
    for (const auto& piece : line.pieces) length += piece.curve.length();
    if (line.closed && gap > 1e-6 * length) straight(start);
    if (line.pieces.empty()) continue;
    if (gap <= 1e-6 * length) line.closed = true;
    level.shape.lines.push_back(std::move(line));
  }
  if (!level.shape.lines.empty()) shapes_.push_back(std::move(level.shape));
}

using Elements = boost::mpl::set<svgpp::tag::element::svg, svgpp::tag::element::g, svgpp::tag::element::path,
                                 svgpp::tag::element::polygon, svgpp::tag::element::polyline,
                                 svgpp::tag::element::rect, svgpp::tag::element::circle,
                                 svgpp::tag::element::ellipse, svgpp::tag::element::line>::type;
using Attributes = boost::mpl::insert<
    boost::mpl::insert<svgpp::traits::shapes_attributes_by_element, svgpp::tag::attribute::transform>::type,
    svgpp::tag::attribute::id>::type;

struct FreeDocument {
  void operator()(xmlDoc* document) const { xmlFreeDoc(document); }
};

std::string attribute(xmlNode* node, const char* name) {
  xmlChar* text = xmlGetNoNsProp(node, reinterpret_cast<const xmlChar*>(name));
  if (text == nullptr) return {};
  std::string value(reinterpret_cast<const char*>(text));
  xmlFree(text);
  return value;
}

// A length with a unit of paper, m; none for pixels, percents and bare numbers.
std::optional<double> paper_length(const std::string& text) {
  static const std::map<std::string, double> units = {
      {"mm", 1e-3}, {"cm", 1e-2}, {"in", 0.0254}, {"pt", 0.0254 / 72}, {"pc", 0.0254 / 6}};
  if (text.size() < 3) return {};
  const auto unit = units.find(text.substr(text.size() - 2));
  double value = 0;
  if (unit == units.end() || !parse(std::string_view(text).substr(0, text.size() - 2), value) || !(value > 0))
    return {};
  return value * unit->second;
}

// Size of a user unit, from width, height and viewBox; without the latter it is a pixel, 1/96 inch. None if
// the page has no size on paper, or is stretched.
std::optional<double> unit_of(xmlNode* root) {
  const auto width = paper_length(attribute(root, "width")), height = paper_length(attribute(root, "height"));
  if (!width && !height) return {};
  std::string box = attribute(root, "viewBox");
  if (box.empty()) return 0.0254 / 96;
  std::replace(box.begin(), box.end(), ',', ' ');
  Source words("viewBox", box);
  double numbers[4] = {};
  for (double& x : numbers) x = words.real("a number");
  if (!(numbers[2] > 0 && numbers[3] > 0)) return {};
  const double across = width ? *width / numbers[2] : *height / numbers[3],
               down = height ? *height / numbers[3] : across;
  return std::abs(across / down - 1) < 1e-3 ? std::optional(across) : std::nullopt;
}

// Replaces each <use> by a group with a copy of what it names, so that the reader of shapes meets shapes
// only.
class UseExpander {
 public:
  explicit UseExpander(xmlDoc* document) : document_(document) {}
  void run(xmlNode* root) {
    collect(root);
    expand(root, 0);
  }
  std::size_t copied() const { return copied_; }

 private:
  static constexpr int deepest = 16;               // uses within uses
  static constexpr std::size_t most = 50'000'000;  // bytes that are copied

  static bool is(const xmlNode* node, const char* name) {
    return node->type == XML_ELEMENT_NODE && std::string(reinterpret_cast<const char*>(node->name)) == name;
  }
  void collect(xmlNode* node) {
    std::vector<xmlNode*> open{node};
    while (!open.empty()) {
      xmlNode* one = open.back();
      open.pop_back();
      if (one->type != XML_ELEMENT_NODE) continue;
      if (const std::string id = attribute(one, "id"); !id.empty()) named_.try_emplace(id, one);
      for (xmlNode* child = one->children; child != nullptr; child = child->next) open.push_back(child);
    }
  }
  static std::string target(xmlNode* use) {
    std::string name = attribute(use, "href");
    if (name.empty()) {
      xmlChar* text = xmlGetNsProp(use, reinterpret_cast<const xmlChar*>("href"),
                                   reinterpret_cast<const xmlChar*>("http://www.w3.org/1999/xlink"));
      if (text != nullptr) name = reinterpret_cast<const char*>(text);
      xmlFree(text);
    }
    if (name.size() < 2 || name[0] != '#')
      throw std::runtime_error("<use> of '" + name +
                               "', expected the id of an element of this drawing, '#id'");
    return name.substr(1);
  }
  // Children of definitions are drawn only where they are used.
  static bool is_definition(const xmlNode* node) {
    return is(node, "defs") || is(node, "symbol") || is(node, "clipPath") || is(node, "mask") ||
           is(node, "pattern") || is(node, "marker");
  }
  void expand(xmlNode* node, int depth) {
    for (xmlNode *child = node->children, *next = nullptr; child != nullptr; child = next) {
      next = child->next;
      if (child->type != XML_ELEMENT_NODE || is_definition(child)) continue;
      if (is(child, "use"))
        replace(child, depth);
      else
        expand(child, depth);
    }
  }
  static void set(xmlNode* node, const char* name, const std::string& value) {
    xmlSetProp(node, reinterpret_cast<const xmlChar*>(name), reinterpret_cast<const xmlChar*>(value.c_str()));
  }
  // About the bytes of an element with all that is in it.
  static std::size_t weight(const xmlNode* node) {
    std::size_t all = 64;
    if (node->type == XML_ELEMENT_NODE)
      for (const xmlAttr* one = node->properties; one != nullptr; one = one->next)
        for (const xmlNode* text = one->children; text != nullptr; text = text->next)
          all += 16 + static_cast<std::size_t>(xmlStrlen(text->content));
    for (const xmlNode* child = node->children; child != nullptr; child = child->next) all += weight(child);
    return all;
  }
  void replace(xmlNode* use, int depth) {
    const std::string id = target(use);
    const auto found = named_.find(id);
    if (found == named_.end()) throw std::runtime_error("<use> of '#" + id + "', and no element has this id");
    for (const xmlNode* above = use; above != nullptr; above = above->parent)
      if (above == found->second) throw std::runtime_error("<use> of '#" + id + "' inside of itself");
    copied_ += weight(found->second);
    if (depth >= deepest || copied_ > most)
      throw std::runtime_error("uses within uses without end, at '#" + id + "'");
    xmlNode* group = xmlNewDocNode(document_, use->ns, reinterpret_cast<const xmlChar*>("g"), nullptr);
    std::string x = attribute(use, "x"), y = attribute(use, "y");
    const std::string shift = x.empty() && y.empty()
                                  ? ""
                                  : "translate(" + (x.empty() ? "0" : x) + " " + (y.empty() ? "0" : y) + ")";
    set(group, "transform", attribute(use, "transform") + " " + shift);
    const bool whole = is(found->second, "symbol") || is(found->second, "svg");
    if (whole && !attribute(found->second, "viewBox").empty())
      throw std::runtime_error("<use> of '#" + id +
                               "', which has a viewBox of its own: expected one without");
    for (xmlNode* one = whole ? found->second->children : found->second; one != nullptr;
         one = whole ? one->next : nullptr) {
      xmlNode* copy = xmlDocCopyNode(one, document_, 1);
      if (copy == nullptr) continue;
      if (const std::string own = attribute(use, "id"); !whole && !own.empty()) set(copy, "id", own);
      xmlAddChild(group, copy);
    }
    xmlReplaceNode(use, group);
    xmlFreeNode(use);
    expand(group, depth + 1);
  }

  xmlDoc* document_;
  std::map<std::string, xmlNode*> named_;
  std::size_t copied_ = 0;
};

}  // namespace

std::vector<SvgShape> read_svg_shapes(const std::string& name, std::string_view bytes,
                                      std::optional<double> unit, Remarks* remarks) {
  // No network, no files: external parts of a document are not loaded.
  const std::unique_ptr<xmlDoc, FreeDocument> document(
      xmlReadMemory(bytes.data(), static_cast<int>(std::min<std::size_t>(bytes.size(), 1U << 30)), nullptr,
                    nullptr, XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING));
  xmlNode* root = document == nullptr ? nullptr : xmlDocGetRootElement(document.get());
  if (root == nullptr) throw Error(name + ": expected an SVG drawing, got what is no XML");
  const double used = unit_of_file(name, unit, unit_of(root), remarks);
  UseExpander uses(document.get());
  try {
    uses.run(root);
  } catch (const std::runtime_error& error) {
    throw Error(name + ": " + error.what());
  }
  SvgLines collector(used, 16 + bytes.size() + uses.copied());
  try {
    svgpp::document_traversal<svgpp::processed_elements<Elements>, svgpp::processed_attributes<Attributes>,
                              svgpp::transform_policy<svgpp::policy::transform::matrix>,
                              svgpp::path_policy<svgpp::policy::path::minimal>>::load_document(root,
                                                                                               collector);
  } catch (const std::exception& error) {
    throw Error(name + ": expected an SVG drawing, got what cannot be read: " + error.what());
  }
  return collector.result();
}

}  // namespace fabricsh::format
