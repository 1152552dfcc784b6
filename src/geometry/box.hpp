// The bounding box of points, parallel to the axes.
#pragma once
#include <vector>

#include "geometry/vec.hpp"

namespace fabricsh {

struct BoundingBox {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // m
  Vec3 size() const { return high - low; }
  Vec3 middle() const { return (low + high) / 2; }
};

// Without points both corners are zero.
inline BoundingBox box_of(const std::vector<Vec3>& points) {
  BoundingBox box;
  if (!points.empty()) box.low = box.high = points.front();
  for (const Vec3& x : points) {
    box.low = box.low.cwiseMin(x);
    box.high = box.high.cwiseMax(x);
  }
  return box;
}

}  // namespace fabricsh
