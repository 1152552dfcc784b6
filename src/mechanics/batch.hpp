// Eight elements of the same kind and region, in the layout of the kernels.
#pragma once
#include <array>
#include <cstddef>

#include "element/shell3.hpp"
#include "element/shell4.hpp"
#include "mechanics/mesh_tools.hpp"

namespace fabricsh::mechanics {

// Below this number of batches one thread is used: waking the others would cost more than it saves.
inline constexpr Index few_batches = 16;

// The position of an element in the batches.
struct BatchLane {
  Index batch;
  int lane;
};

// Properties of a kind of element with a given number of thickness points.
struct BatchKind {
  element::Shell4Kernels kernels;
  int corners, in_plane, dofs;
  int first_point;    // where in the geometry column the points' transforms begin, eight numbers each
  int geometry_size;  // length of the geometry column of one lane
  int point(int g, int k, int points) const { return first_point + 8 * (points * g + k); }
};

struct Batch {
  std::array<Index, lanes> element{};  // the last element is repeated in lanes from `used` on
  std::array<std::array<Index, 4>, lanes> nodes{};
  int used = 0;
  const BatchKind* kind = nullptr;
  const section::Section* section = nullptr;
  const double* geometry = nullptr;  // batches with the same numbers share them
  std::size_t law = 0, force = 0;    // indices at which its data begin
  element::Sharing sharing = element::Sharing::none;
};

}  // namespace fabricsh::mechanics
