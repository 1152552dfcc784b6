// Dots followed through a series of photographs.
#pragma once
#include <vector>

#include "lab/dots.hpp"
#include "lab/markers.hpp"

namespace fabricsh::lab {

struct Doubt {
  std::size_t frame, marker;
  bool lost;  // not found at all (its position is not a number); else found, but changed
};

class Tracker {
 public:
  // The first photograph's dots, which must be rows x columns; the grid is found from the steps between
  // neighbours and may be turned by 40 degrees. Error: another count, or no such grid.
  Tracker(std::size_t rows, std::size_t columns, const std::vector<Dot>& first);
  // The next photograph: every marker takes the dot nearest to where the last photographs lead to expect it
  // (its last known place under the affine map of the last step; then, twice, under that of the matches just
  // made), within 0.4 of the spacing. Lost ones are looked for again later.
  void add(const std::vector<Dot>& dots);
  // Positions in pixels, y upwards from the first photograph's first row of pixels.
  const Tracks& tracks() const { return tracks_; }
  const std::vector<Doubt>& doubts() const { return doubts_; }

 private:
  struct Place {
    double x, y, area;
  };
  void record(const std::vector<Place>& places);
  double spacing() const;

  Tracks tracks_;
  std::vector<Place> last_;                       // where each marker was, or is thought to be
  std::array<double, 6> step_{1, 0, 0, 0, 1, 0};  // x' = s0 x + s1 y + s2, y' = s3 x + s4 y + s5
  std::vector<Doubt> doubts_;
};

}  // namespace fabricsh::lab
