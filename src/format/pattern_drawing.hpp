// What a DXF file of a pattern draws, before it becomes panels.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/curve.hpp"

namespace fabricsh::format {

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

Drawings read_drawings(std::string_view bytes);

}  // namespace fabricsh::format
