// Shared by the readers of patterns: the names of edges, and notches beside a boundary.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "format/mesh_file.hpp"
#include "format/pattern.hpp"
#include "mesh/panel.hpp"

namespace fabricsh::format {

// Starts a closed line at its sharpest corner and names its edges edge1, edge2, ...: one ends where the
// direction turns by more than 30 degrees.
void name_edges(mesh::Loop& loop);
// The point of the outline that is nearest to x, m.
mesh::Vec2 on_boundary(const PatternPiece& piece, const mesh::Vec2& x);
// Adds a notch at the place of the outline that is nearest to x (m). Off by more than 2 mm it is left out,
// with a remark that begins with `who`.
void add_notch(PatternPiece& piece, const std::string& name, const mesh::Vec2& x, const std::string& who);
// Remarks if a unit was given and the file has another; returns the one to be used, m. Error: there is none.
double unit_of_file(const std::string& file, std::optional<double> given, std::optional<double> own,
                    Remarks* remarks);

// --- The shapes of an SVG drawing as closed and open lines.

struct SvgLine {
  mesh::Loop pieces;
  bool closed = false;
};

struct SvgShape {
  std::string id;
  std::vector<SvgLine> lines;  // of a path, as many as it has moves
};

// Reads path, polygon, polyline, rect, circle, ellipse and line, in m, with y upward and all transformations
// done; arcs become cubic Bezier curves. unit: of the drawing's lengths, m; without it width, height and
// viewBox have to say. Errors: not XML, not SVG, a path that cannot be read, no unit.
std::vector<SvgShape> read_svg_shapes(const std::string& name, std::string_view bytes,
                                      std::optional<double> unit, Remarks* remarks);

}  // namespace fabricsh::format
