// The readers of a series on any bytes: a .pvd and a frame whose cells name points that are there, or an
// Error.
#include <cstdint>
#include <cstdlib>

#include "base/error.hpp"
#include "format/frame_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fabricsh;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    format::read_pvd("fuzz", bytes);
  } catch (const Error&) {
  }
  try {
    const auto frame = format::read_vtu_frame("fuzz", bytes, {"left", "plate", "flow", "heat & <cold>"});
    const auto count = static_cast<mesh::Index>(frame.points.size());
    for (const auto& cell : frame.cells)
      for (std::size_t i = 0; i < cell.size(); ++i)
        if (cell[i] >= count || (cell[i] < 0 && i < 3)) std::abort();
    for (const auto& array : frame.arrays)
      if (array.values.size() !=
          array.components * (array.on_cells ? frame.cells.size() : frame.points.size()))
        std::abort();
  } catch (const Error&) {
  }
  return 0;
}
