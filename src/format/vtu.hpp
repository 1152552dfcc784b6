// A surface with fields, as a VTK unstructured grid for ParaView.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/archive.hpp"
#include "base/version.hpp"
#include "mesh/mesh.hpp"
#include "system/atomic.hpp"

namespace fabricsh::format {

using mesh::Index;

// The values of one field: component c of item i is values[i * components + c].
struct Array {
  std::string name;
  int components = 1;
  std::vector<double> values;
  std::vector<std::string> component_names = {};  // empty, or one name per component, shown by ParaView
  bool flags = false;                             // 0 and 1, written as integers of one byte
  std::string unit = {};                          // kept with the array, for programs that show units
};

struct VtuGrid {
  const std::vector<Vec3>& points;                 // m, global
  const std::vector<std::array<Index, 4>>& cells;  // node ids from 0; a triangle has -1 in the last place
  std::vector<Array> point_data = {}, cell_data = {};
  std::optional<double> time = {};  // s
};

// Identifies the content of a file.
struct FileSum {
  std::int64_t size = 0;  // bytes
  std::uint32_t sum = 0;  // checksum of them
  bool operator==(const FileSum&) const = default;
  void keep(Archive& archive) { archive(size, sum); }
};
FileSum sum_of(std::string_view bytes);

// Replaces the file, compressed; returns the size and checksum of its new content. Error: an
// array whose length is not components times points (or cells), or a file that cannot be written.
FileSum write_vtu(const std::string& path, const VtuGrid& grid, system::Sync sync = system::Sync::yes,
                  system::Folder folder = system::Folder::make);

std::vector<Library> libraries();  // VTK

}  // namespace fabricsh::format
