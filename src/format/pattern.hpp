// Sewing patterns: the pieces in a DXF file as apparel programs write them (AAMA/ASTM D6673), or in an SVG
// drawing.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "format/mesh_file.hpp"
#include "mesh/panel.hpp"

namespace fabricsh::format {

// A piece of a pattern. Its panel lacks the size of the elements; the grain is in the panel if `has_grain`.
struct PatternPiece {
  std::string name;
  std::string size = {};   // of the garment; empty if the file does not say
  std::string block = {};  // what the file calls it besides
  mesh::Panel panel;
  bool has_grain = false;
  Remarks remarks = {};      // about this piece
  std::string trouble = {};  // why it cannot be made, though others of the file can; empty: it is made
};

// All pieces of a file, in its order, lengths in m. unit: what one unit of the file is in m; without it the
// file has to say so ($INSUNITS of its header, or a text "Units: metric", millimetres, or "Units: english",
// inches). A piece is a block with one closed line on layer 1, the boundary, or a chain of open ones whose
// ends meet; without such a block, the drawing itself. Its size is that of a text "Size: ..."; without one,
// what the name of its block has behind that of the piece. Layer 3 marks the points of curves, through which
// go splines; layers 4 and 80 to 83 are notches, notch1, notch2,
// ...; layer 7 is the grain line, layer 11 has cutouts. An edge of the boundary (edge1, edge2, ..., from its
// sharpest corner on) ends where its direction turns by more than 30 degrees. Remarks: layers that are not
// used; a boundary that is half of a mirrored one; notches off the boundary, which are left out. Errors: no
// piece, no unit, units that contradict each other; and where no piece can be made, two boundaries in one, or
// a boundary that is open. Otherwise such a piece has `trouble`.
std::vector<PatternPiece> read_dxf_pattern(const std::string& path, std::optional<double> unit,
                                           Remarks* remarks);
// The same from the bytes of a file; name is for messages.
std::vector<PatternPiece> parse_dxf_pattern(const std::string& name, std::string_view bytes,
                                            std::optional<double> unit, Remarks* remarks);

// All pieces of an SVG drawing: each shape whose lines are closed, named by its id, or piece1, piece2, ...;
// the further lines of a path are holes. A line whose id begins with "grain" is the grain of the piece around
// its middle, a shape whose id begins with "notch" a notch of that name. Edges are named as in a DXF file.
// The unit follows from width, height and viewBox. Remarks: open lines that are not used, notches off the
// boundary. Errors: no piece, no unit, not a drawing.
std::vector<PatternPiece> read_svg_pattern(const std::string& path, std::optional<double> unit,
                                           Remarks* remarks);
std::vector<PatternPiece> parse_svg_pattern(const std::string& name, std::string_view bytes,
                                            std::optional<double> unit, Remarks* remarks);

}  // namespace fabricsh::format
