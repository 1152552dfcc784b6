// Patterns in SVG drawings: each closed path is a piece.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/error.hpp"
#include "format/pattern_parts.hpp"
#include "format/source.hpp"
#include "mesh/rim.hpp"

namespace fabricsh::format {

using mesh::PlaneCurve;
using mesh::Vec2;

namespace {

bool begins(const std::string& id, std::string_view word) {
  return id.size() >= word.size() && std::equal(word.begin(), word.end(), id.begin(),
                                                [](char a, char b) { return a == b || a == b - 'A' + 'a'; });
}

// The middle of the extent of a shape, m.
Vec2 middle(const SvgShape& shape) {
  Vec2 low = shape.lines.front().pieces.front().curve.start(), high = low;
  for (const SvgLine& line : shape.lines)
    for (const mesh::OutlinePiece& piece : line.pieces)
      for (int i = 0; i <= 16; ++i) {
        const Vec2 x = piece.curve.at(piece.curve.length() * i / 16);
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
      }
  return (low + high) / 2;
}

void add_grain(PatternPiece& piece, const SvgShape& shape) {
  const mesh::Loop& line = shape.lines.front().pieces;
  const Vec2 along = line.back().curve.end() - line.front().curve.start();
  if (along.norm() == 0) return;
  piece.panel.grain = std::atan2(along.y(), along.x()) * 180 / std::numbers::pi;
  piece.has_grain = true;
}

// The name, with a number behind it if another piece has it: copies of one shape have one id.
std::string distinct(std::map<std::string, int>& taken, const std::string& name) {
  std::string made = name;
  for (int& k = taken[name]; k > 0 && taken.contains(made);) made = name + "-" + std::to_string(++k);
  taken[made] = std::max(taken[made], 1);
  return made;
}

// All closed shapes but grain lines and notches; the names of open ones are added to `unused`.
std::vector<PatternPiece> pieces_of(const std::vector<SvgShape>& shapes, std::string& unused) {
  std::vector<PatternPiece> pieces;
  std::map<std::string, int> taken;
  for (const SvgShape& shape : shapes) {
    if (begins(shape.id, "grain") || begins(shape.id, "notch")) continue;
    const auto closed = [](const SvgLine& line) { return line.closed; };
    if (!std::all_of(shape.lines.begin(), shape.lines.end(), closed)) {
      unused += (unused.empty() ? "'" : ", '") + shape.id + "'";
      continue;
    }
    PatternPiece& piece = pieces.emplace_back();
    piece.name = shape.id.empty() ? "piece" + std::to_string(pieces.size()) : shape.id;
    piece.name = distinct(taken, piece.name);
    piece.panel.outline = shape.lines.front().pieces;
    for (std::size_t i = 1; i < shape.lines.size(); ++i) piece.panel.holes.push_back(shape.lines[i].pieces);
    name_edges(piece.panel.outline);
  }
  return pieces;
}

// The piece whose boundary is nearest to x.
PatternPiece& nearest(std::vector<PatternPiece>& pieces, const Vec2& x) {
  const auto off = [&x](const PatternPiece& piece) { return (on_boundary(piece, x) - x).norm(); };
  return *std::min_element(pieces.begin(), pieces.end(),
                           [&](const PatternPiece& a, const PatternPiece& b) { return off(a) < off(b); });
}

}  // namespace

std::vector<PatternPiece> parse_svg_pattern(const std::string& name, std::string_view bytes,
                                            std::optional<double> unit, Remarks* remarks) {
  const std::vector<SvgShape> shapes = read_svg_shapes(name, bytes, unit, remarks);
  std::string unused;
  std::vector<PatternPiece> pieces = pieces_of(shapes, unused);
  if (pieces.empty())
    throw Error(name + ": no piece: expected a closed path, got " +
                (unused.empty() ? "none" : "open ones: " + unused));
  if (!unused.empty() && remarks != nullptr)
    remarks->push_back(name + ": open lines that are not used: " + unused);
  for (const SvgShape& shape : shapes) {
    const Vec2 x = middle(shape);
    if (begins(shape.id, "notch")) add_notch(nearest(pieces, x), shape.id, x, name + ": ");
    if (begins(shape.id, "grain"))
      for (PatternPiece& piece : pieces)
        if (mesh::encloses(mesh::sampled(piece.panel.outline), x)) add_grain(piece, shape);
  }
  return pieces;
}

std::vector<PatternPiece> read_svg_pattern(const std::string& path, std::optional<double> unit,
                                           Remarks* remarks) {
  return parse_svg_pattern(path, read_file(path), unit, remarks);
}

}  // namespace fabricsh::format
