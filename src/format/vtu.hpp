// One picture of a surface and what is known on it, as a VTK unstructured grid that ParaView reads.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/archive.hpp"
#include "mesh/mesh.hpp"
#include "system/atomic.hpp"

namespace fabricsh::format {

using mesh::Index;

// Values of one name, item by item: component c of item i at values[i * components + c].
struct Array {
  std::string name;
  int components = 1;
  std::vector<double> values;
  std::vector<std::string> component_names = {};  // none, or one per component: shown by ParaView
  bool flags = false;                             // 0 and 1, written as integers of one byte
};

struct Grid {
  const std::vector<Vec3>& points;                 // m, global
  const std::vector<std::array<Index, 4>>& cells;  // node ids from 0; a triangle has -1 in the last place
  std::vector<Array> point_data = {}, cell_data = {};
  std::optional<double> time = {};  // s
};

// What tells a file's content from another's.
struct FileSum {
  std::int64_t size = 0;  // bytes
  std::uint32_t sum = 0;  // checksum of them
  bool operator==(const FileSum&) const = default;
  void keep(Archive& archive) { archive(size, sum); }
};
FileSum sum_of(std::string_view bytes);

// Replaces the file, compressed; returns what is in it now. Error: an array whose length is not components
// times points (or cells), a file that cannot be written.
FileSum write_vtu(const std::string& path, const Grid& grid, system::Sync sync = system::Sync::yes,
                  system::Folder folder = system::Folder::make);

}  // namespace fabricsh::format
