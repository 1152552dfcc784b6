#include "mesh/corners.hpp"

#include <algorithm>
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
  std::vector<Index*> further;  // corners that need a node of their own
  for (const Index e : elements)
    for (Index& n : out->elements[static_cast<std::size_t>(e)]) {
      if (n < 0) continue;
      char& used = taken[static_cast<std::size_t>(n)];
      if (used != 0) further.push_back(&n);
      used = 1;
    }
  // In the order of the places: what goes over all of these reads the nodes of a place one after the other.
  std::stable_sort(further.begin(), further.end(), [](const Index* a, const Index* b) { return *a < *b; });
  for (Index* corner : further) {
    const Index place = *corner;
    *corner = static_cast<Index>(out->nodes.size());
    out->nodes.push_back(whole->nodes[static_cast<std::size_t>(place)]);
    out->place.push_back(place);
  }
  out->whole = std::move(whole);
  return out;
}

}  // namespace fabricsh::mesh
