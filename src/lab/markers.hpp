// Strains from marker grids on the cloth: lateral contraction and shear [williams2010,
// sections 3.3.3, 3.3.4].
#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace fabricsh::lab {

// Positions of rows x columns markers in every frame, m (or pixels: strains do not mind). The marker of row r
// and column c is r * columns + c; rows follow each other along the pull. A lost marker is not a number.
struct Tracks {
  std::size_t rows = 0, columns = 0, frames = 0;
  std::vector<double> x, y;  // frames x markers
  std::size_t markers() const { return rows * columns; }
  std::size_t boxes() const { return (rows - 1) * (columns - 1); }
};

// Deformation gradient of a box (four neighbours) from the first frame to another, the least-squares affine
// map of its corners: F[i][J] as {F11, F12, F21, F22}. Not a number where a corner is lost.
std::array<double, 4> box_gradient(const Tracks& tracks, std::size_t box, std::size_t frame);

struct BoxStrains {
  std::vector<double> along, across;  // frames x boxes: E of the mean length of the two opposite sides
};
// E of eq. 3.2 from the sides of every box; rows follow each other along the pull.
BoxStrains box_strains(const Tracks& tracks);

// How the markers of a pull are set: a grid of rows and columns, or four pins at the tips of a diamond, whose
// diagonals lie along and across the pull.
struct Arrangement {
  bool diamond = false;
  std::array<std::size_t, 4> pins{};  // of the diamond: the two along the pull, the two across
};
// The pull is the direction that is stretched most. Four markers (2 x 2) at the tips of a diamond are known
// as such in whatever order they are named. Error: the rows of a grid lie more than 30 degrees off the pull.
// A series without a stretch of 1 % is taken for a grid.
Arrangement arrangement_of(const Tracks& tracks);

struct Ratio {
  double value = 0;        // - slope of across over along, line through the origin, boxes pooled
  double plain = 0;        // the same without the correction for noise
  double noise = 0;        // standard deviation of one coordinate, in the unit of the tracks
  double uncertainty = 0;  // standard deviation of value by leaving out a box at a time
};
// [williams2010, eq. 3.3], with errors in both strains: a coordinate carries independent noise (also in the
// first frame), so the mean square of `along` is too large by what the noise adds, and the plain slope too
// small. noise < 0: found from the scatter about the line. Frames count from the mean strain
// along of `least` on. Arranged as arrangement_of() says.
Ratio contraction_ratio(const Tracks& tracks, double noise, double least);

// In-plane shear of a box: yarns at right angles to begin with, the warp `angle` radians from x.
struct YarnShear {
  double E12 = 0;  // lambda1 lambda2 cos(phi) / 2 (eq. 3.16), tensor component
  double warp_stretch = 1, weft_stretch = 1;
};
YarnShear yarn_shear(const std::array<double, 4>& F, double angle);

// Each box's shear as a part of the mean over the boxes, the line through the origin over all frames (E12
// frames x boxes): noise and lost markers of a single frame do not decide, nor does the end of a cyclic test.
// Not a number for a box that is never seen.
std::vector<double> shear_shares(const std::vector<double>& E12, std::size_t boxes);

// Zones of a bias specimen by the box's shear beside the largest: 1 not deformed, 2 mixed (half), 3 sheared.
std::vector<int> bias_zones(const std::vector<double>& E12);

}  // namespace fabricsh::lab
