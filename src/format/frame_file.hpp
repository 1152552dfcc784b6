// The frames of a series, read back: the sheets of .vtu files with chosen arrays, and the .pvd that names
// them.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::format {

struct FrameArray {
  std::string name;
  bool on_cells = false;
  std::size_t components = 1;
  std::vector<std::string> component_names = {};  // "" where the file has none
  std::vector<double> values = {};                // item by item
};

struct FrameFile {
  std::vector<Vec3> points;                       // m
  std::vector<std::array<mesh::Index, 4>> cells;  // ids from 0; a triangle has -1 in the last place
  std::vector<FrameArray> arrays;
  const FrameArray* find(std::string_view name) const;  // on the points before that on the cells; or none
  std::string names;                                    // of all arrays of numbers, for messages
};
// Of the arrays only those asked for. Error: as the readers of meshes.
FrameFile read_vtu_frame(const std::string& name, std::string_view bytes,
                         const std::vector<std::string>& wanted);

struct SeriesEntry {
  double time = 0;  // s
  std::int64_t part = 0;
  std::string file;
};
std::vector<SeriesEntry> read_pvd(const std::string& name, std::string_view bytes);

}  // namespace fabricsh::format
