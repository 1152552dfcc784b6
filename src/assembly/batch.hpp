// Eight elements of one kind side by side, as the kernels take them. Internal to the assembly.
#pragma once
#include <array>

#include "assembly/assembly.hpp"

namespace fabricsh::assembly {

// Fewer are done by one thread: waking the others costs more, above all on a busy machine.
inline constexpr Index few_batches = 16;

struct Assembly::Batch {
  std::array<Index, lanes> element{};  // lanes from `used` on repeat the last one
  std::array<std::array<Index, 4>, lanes> nodes{};
  int used = 0;
  const Kind* kind = nullptr;
  std::size_t geometry = 0, law = 0, force = 0;  // where its numbers begin
  element::Sharing sharing = element::Sharing::none;
};

}  // namespace fabricsh::assembly
