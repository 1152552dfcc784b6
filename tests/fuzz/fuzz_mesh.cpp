// A mesh reader (READER) on any bytes: a mesh whose elements name nodes that are there, or an Error.
#include <cstdint>
#include <cstdlib>

#include "base/error.hpp"
#include "format/mesh_file.hpp"
#include "mesh/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fabricsh;
  try {
    const mesh::Mesh mesh = format::READER("fuzz", {reinterpret_cast<const char*>(data), size});
    const auto count = static_cast<mesh::Index>(mesh.nodes.size());
    for (const auto& element : mesh.elements)
      for (std::size_t i = 0; i < element.size(); ++i)
        if (element[i] >= count || (element[i] < 0 && i < 3)) std::abort();
    for (const auto& [name, ids] : mesh.sets)
      for (const mesh::Index id : ids)
        if (id < 0 || id >= count) std::abort();
    mesh::check(mesh);
  } catch (const Error&) {
  }
  return 0;
}
