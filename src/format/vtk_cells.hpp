// What the readers of VTK's formats share: cells and arrays of integers as a surface mesh with sets.
#pragma once
#include <set>

#include "format/mesh_builder.hpp"

namespace fabricsh::format {

struct VtkCells {
  std::vector<double> points;                           // x y z by turns, m
  std::vector<std::int64_t> connectivity, ends, types;  // ends: behind the last corner of each cell
  std::size_t count() const { return ends.size(); }
  std::span<const std::int64_t> corners(std::size_t cell) const;
};

// The cells as they go into a mesh: triangles and quadrilaterals become elements, vertices and lines are for
// sets alone, other types are refused. Numbers count from 0, as VTK does.
class VtkMesh {
 public:
  VtkMesh(const Source& source, VtkCells cells);
  std::size_t points() const { return builder_.nodes(); }
  std::size_t cells() const { return cells_.count(); }
  // One integer for each point or cell. Where all are 0 or 1, those with 1 are the set `name`; else each
  // value v has a set name_v. An array that numbers its items, or that has more than 256 values, makes no
  // sets.
  void add_sets(const std::string& name, bool on_cells, std::span<const std::int64_t> values);
  mesh::Mesh finish() { return builder_.finish(); }

 private:
  void check_ends() const;
  void add_cell(std::size_t cell);
  std::vector<std::int64_t> nodes_where(std::int64_t value, bool on_cells,
                                        std::span<const std::int64_t> values) const;

  const Source& source_;
  VtkCells cells_;
  MeshBuilder builder_;
};

}  // namespace fabricsh::format
