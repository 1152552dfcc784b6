// The shapes of an SVG drawing as closed and open lines.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "format/mesh_file.hpp"
#include "mesh/panel.hpp"

namespace fabricsh::format {

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
