// Follows dots through a series of photographs.
#pragma once
#include <vector>

#include "photograph/dots.hpp"

namespace fabricsh::photograph {

using lab::DoubtfulMarker;
using lab::Tracks;

class Tracker {
 public:
  // The dots of the first photograph, rows x columns. The grid is found from the vectors between neighbours
  // and may be rotated by 40 degrees. Error: another number of dots, or no such grid.
  Tracker(std::size_t rows, std::size_t columns, const std::vector<Dot>& first);
  // Adds the next photograph. Each marker takes the dot nearest to its predicted position (the last one under
  // the affine map of the last step, then twice under that of the new matches), within 0.4 of the spacing.
  // Lost markers are searched again later.
  void add(const std::vector<Dot>& dots);
  // Positions in pixels, y upwards from the first row of pixels in the first photograph.
  const Tracks& tracks() const { return tracks_; }
  const std::vector<DoubtfulMarker>& doubts() const { return doubts_; }

 private:
  struct DotPosition {
    double x, y, area;
  };
  void record(const std::vector<DotPosition>& places);
  double spacing() const;

  Tracks tracks_;
  std::vector<DotPosition> last_;                 // last or predicted position of each marker
  std::array<double, 6> step_{1, 0, 0, 0, 1, 0};  // x' = s0 x + s1 y + s2, y' = s3 x + s4 y + s5
  std::vector<DoubtfulMarker> doubts_;
};

}  // namespace fabricsh::photograph
