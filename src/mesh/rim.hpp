// The border of a panel: its lines with darts cut, and the nodes on them.
#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "mesh/panel.hpp"

namespace fabricsh::mesh {

// "panel: field 'FIELD': words".
[[noreturn]] void refuse_panel(const std::string& field, const std::string& words);
// "(0.1, 0.2)".
std::string place_text(const Vec2& x);

// A piece of the border with what messages about it say.
struct Side {
  PlaneCurve curve;
  std::string edge;
  double step;                // distance of its nodes, m
  bool even;                  // whatever the lattice: its number of elements was given
  std::string field, words;   // "outline", "edge 'hem'"
  std::vector<double> stops;  // places that get a node, ascending
};

// Counter-clockwise; a hole clockwise. So the cloth is to the left of every side.
using Border = std::vector<std::vector<Side>>;  // the outline, then the holes
// Orients the lines, cuts the darts and marks the notches. notch: the place of each, in the order of the
// shape.
Border border_of(const Panel& shape, std::vector<Vec2>& notches);

// Axes along and across the rows of elements, and the lattice of squares that fits the extent of the panel.
struct Weave {
  Vec2 along, across;
  Vec2 low = Vec2::Zero(), size = Vec2::Zero();  // of the panel, in these axes, m
  Vec2 step = Vec2::Zero();                      // of the lattice, m
  std::array<Index, 2> cells = {};
  Vec2 local(const Vec2& x) const { return {x.dot(along), x.dot(across)}; }
  Vec2 global(const Vec2& l) const { return l.x() * along + l.y() * across; }
};
Weave weave_of(const Panel& shape, const Border& border);

struct Rim {
  struct RimEdge {
    Index first, second;  // nodes; the cloth is to the left
    std::size_t loop, side;
  };
  std::vector<Vec2> nodes;  // m
  std::vector<RimEdge> links;
  std::map<std::string, NodeSet> sets;
};
// halved: every other node is the middle between two that are laid as usual, all on the curves.
Rim lay_nodes(const Border& border, const Weave& weave, bool halved);

// Twice the area that a closed line through the points encloses, m2; positive if it runs counter-clockwise.
double doubled_area(const std::vector<Vec2>& line);
// Points on a closed line, close enough to see its shape.
std::vector<Vec2> sampled(const Loop& loop);
bool encloses(const std::vector<Vec2>& line, const Vec2& x);

}  // namespace fabricsh::mesh
