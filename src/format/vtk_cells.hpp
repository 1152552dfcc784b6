// Shared by the readers of VTK's formats: turns cells and integer arrays into a surface mesh with sets.
#pragma once

#include "format/mesh_builder.hpp"

namespace fabricsh::format {

struct VtkCells {
  std::vector<double> points;                           // x y z of each point, m
  std::vector<std::int64_t> connectivity, ends, types;  // ends: index after the last corner of each cell
  std::size_t count() const { return ends.size(); }
  std::span<const std::int64_t> corners(std::size_t cell) const;
};

// Triangles and quadrilaterals become elements, vertices and lines are used
// for sets only, other types are refused. Numbers count from 0, as in VTK.
class VtkMesh {
 public:
  VtkMesh(const Source& source, VtkCells cells);
  std::size_t points() const { return builder_.nodes(); }
  std::size_t cells() const { return cells_.count(); }
  // One integer for each point or cell. If all are 0 or 1, the items with 1
  // form the set `name`; otherwise each value v gives a set name_v. Arrays
  // that number their items, or that have more than 256 values, give no sets.
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
