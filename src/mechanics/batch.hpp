// Eight elements of one kind and region side by side, as the kernels take them.
#pragma once
#include <array>
#include <cstddef>

#include "element/shell3.hpp"
#include "element/shell4.hpp"
#include "mechanics/mesh_tools.hpp"

namespace fabricsh::mechanics {

// Fewer are done by one thread: waking the others costs more, above all on a busy machine.
inline constexpr Index few_batches = 16;

// Where an element sits in the batches.
struct Place {
  Index batch;
  int lane;
};

// What must be known of a kind of element with a number of thickness points.
struct Kind {
  element::Shell4Kernels kernels;
  int corners, in_plane, dofs;
  int first_point;    // of the geometry column: where the points' transforms begin, eight numbers each
  int geometry_size;  // of the column of one lane
  int point(int g, int k, int points) const { return first_point + 8 * (points * g + k); }
};

struct Batch {
  std::array<Index, lanes> element{};  // lanes from `used` on repeat the last one
  std::array<std::array<Index, 4>, lanes> nodes{};
  int used = 0;
  const Kind* kind = nullptr;
  const section::Section* section = nullptr;
  std::size_t geometry = 0, law = 0, force = 0;  // where its numbers begin
  element::Sharing sharing = element::Sharing::none;
};

}  // namespace fabricsh::mechanics
