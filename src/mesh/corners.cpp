#include "mesh/corners.hpp"

#include <numeric>

namespace fabricsh::mesh {

std::shared_ptr<Mesh> split_corners(std::shared_ptr<const Mesh> whole, const std::vector<Index>& elements) {
  auto out = std::make_shared<Mesh>();
  out->nodes = whole->nodes;
  out->elements = whole->elements;
  out->flat = whole->flat;
  out->warp = whole->warp;
  out->origin = whole->origin;
  out->parts = whole->parts;
  out->place.resize(whole->nodes.size());
  std::iota(out->place.begin(), out->place.end(), Index{0});
  std::vector<char> splits(whole->elements.size(), 0), taken(whole->nodes.size(), 0);
  for (const Index e : elements) splits[static_cast<std::size_t>(e)] = 1;
  for (std::size_t e = 0; e < splits.size(); ++e)
    for (const Index n : whole->elements[e])
      if (n >= 0 && splits[e] == 0) taken[static_cast<std::size_t>(n)] = 1;
  for (const Index e : elements)
    for (Index& n : out->elements[static_cast<std::size_t>(e)]) {
      if (n < 0) continue;
      const Index place = n;
      char& used = taken[static_cast<std::size_t>(place)];
      if (used != 0) {
        n = static_cast<Index>(out->nodes.size());
        out->nodes.push_back(whole->nodes[static_cast<std::size_t>(place)]);
        out->place.push_back(place);
      }
      used = 1;
    }
  out->whole = std::move(whole);
  return out;
}

}  // namespace fabricsh::mesh
