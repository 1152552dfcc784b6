// Points sorted into the cells of a uniform grid; within a cell they are in ascending order.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/vec.hpp"

namespace fabricsh::contact {

struct Box {
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  void add(const Vec3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  Box grown(double by) const { return {low - Vec3::Constant(by), high + Vec3::Constant(by)}; }
  bool meets(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

// Boxes in single precision, rounded outwards, for a first look at many at a time.
class Boxes {
 public:
  static constexpr std::size_t pack = 8;
  struct Bounds {
    std::array<float, 3> low, high;
  };
  static Bounds outside(const Box& box) {
    Bounds out;
    for (int k = 0; k < 3; ++k) {
      out.low[std::size_t(k)] = std::nextafter(float(box.low[k]), -std::numeric_limits<float>::infinity());
      out.high[std::size_t(k)] = std::nextafter(float(box.high[k]), std::numeric_limits<float>::infinity());
    }
    return out;
  }

  // box_of(i): the box of thing i, for all things of a list.
  template <class BoxOf>
  Boxes(const std::vector<std::int32_t>& things, BoxOf box_of) {
    const std::size_t n = things.size();
    for (auto* side : {&low_, &high_})
      for (auto& row : *side) row.assign(n + pack, 0);
#pragma omp parallel for schedule(static) if (n > 512)
    for (std::size_t i = 0; i < n; ++i) {
      const Bounds bounds = outside(box_of(things[i]));
      for (std::size_t k = 0; k < 3; ++k) {
        low_[k][i] = bounds.low[k];
        high_[k][i] = bounds.high[k];
      }
    }
  }
  // Which of the boxes from `first` on meet a box; those after the last are not to be read.
  std::array<int, pack> meeting(const Bounds& box, std::size_t first) const {
    std::array<int, pack> out;
    const float *a = &low_[0][first], *b = &low_[1][first], *c = &low_[2][first], *d = &high_[0][first],
                *e = &high_[1][first], *f = &high_[2][first];
    for (std::size_t i = 0; i < pack; ++i)
      out[i] = int(a[i] <= box.high[0]) & int(b[i] <= box.high[1]) & int(c[i] <= box.high[2]) &
               int(d[i] >= box.low[0]) & int(e[i] >= box.low[1]) & int(f[i] >= box.low[2]);
    return out;
  }

 private:
  std::array<std::vector<float>, 3> low_, high_;
};

class Grid {
 public:
  // `place(i)` returns the position of point i of `count`. Points outside `room` are left out. `cell`
  // is the cell width (m); it is increased if the room would have more than eight cells per point.
  template <class Place>
  Grid(const Box& room, double cell, std::size_t count, Place place) : room_(room) {
    const Vec3 size = (room.high - room.low).cwiseMax(1e-30);
    double most = 8 * double(count) + 64;
    while (std::max(1.0, size.x() / cell) * std::max(1.0, size.y() / cell) * std::max(1.0, size.z() / cell) >
           most)
      cell *= 1.5;
    cell_ = cell;
    for (int k = 0; k < 3; ++k) cells_[k] = std::int64_t(size[k] / cell) + 1;
    start_.assign(std::size_t(cells_[0] * cells_[1] * cells_[2]) + 1, 0);
    std::vector<std::int64_t> in(count, -1);
#pragma omp parallel for schedule(static) if (count > 512)
    for (std::size_t i = 0; i < count; ++i)
      if (const Vec3 p = place(i); Box{p, p}.meets(room)) in[i] = number(at(p, 0), at(p, 1), at(p, 2));
    for (const std::int64_t cell_of : in)
      if (cell_of >= 0) ++start_[std::size_t(cell_of) + 1];
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    points_.resize(start_.back());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t i = 0; i < count; ++i)
      if (in[i] >= 0) points_[next[std::size_t(in[i])]++] = std::int32_t(i);
  }

  // The points in the order of their cells.
  const std::vector<std::int32_t>& order() const { return points_; }

  // Calls visit(point) for every point in the cells that intersect the box.
  template <class Visit>
  void in(const Box& box, Visit visit) const {
    rows(box, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) visit(points_[i]);
    });
  }

  // Calls visit(first, last) for every row of cells that intersects the box: places in order().
  template <class Visit>
  void rows(const Box& box, Visit visit) const {
    if (!box.meets(room_)) return;
    std::int64_t from[3], to[3];
    for (int k = 0; k < 3; ++k) {
      from[k] = at(box.low, k);
      to[k] = at(box.high, k);
    }
    for (std::int64_t c = from[2]; c <= to[2]; ++c)
      for (std::int64_t b = from[1]; b <= to[1]; ++b) {
        const auto first = std::size_t(number(from[0], b, c)), last = std::size_t(number(to[0], b, c));
        visit(start_[first], start_[last + 1]);
      }
  }

 private:
  std::int64_t at(const Vec3& p, int k) const {
    const double place = std::clamp((p[k] - room_.low[k]) / cell_, 0.0, double(cells_[k] - 1));
    return std::int64_t(place);
  }
  std::int64_t number(std::int64_t a, std::int64_t b, std::int64_t c) const {
    return (c * cells_[1] + b) * cells_[0] + a;
  }
  Box room_;
  double cell_ = 1;
  std::int64_t cells_[3] = {1, 1, 1};
  std::vector<std::size_t> start_;
  std::vector<std::int32_t> points_;
};

}  // namespace fabricsh::contact
