// Strains from marker grids on the cloth: lateral contraction and shear [williams2010,
// sections 3.3.3, 3.3.4].
#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace fabricsh::lab {

// Positions of rows x columns markers in every frame, m (or pixels, because strains are relative). The marker
// in row r and column c is r * columns + c; the rows follow each other along the pull. A lost marker is NaN.
struct Tracks {
  std::size_t rows = 0, columns = 0, frames = 0;
  std::vector<double> x, y;  // frames x markers
  std::size_t markers() const { return rows * columns; }
  std::size_t boxes() const { return (rows - 1) * (columns - 1); }
};

// Deformation gradient of a box (four adjacent markers) from the first frame to another: the least-squares
// affine map of its corners, F[i][J] as {F11, F12, F21, F22}. NaN if a corner is lost.
std::array<double, 4> box_gradient(const Tracks& tracks, std::size_t box, std::size_t frame);

struct BoxStrains {
  std::vector<double> along, across;  // frames x boxes: E from the mean length of two opposite sides
};
// E of eq. 3.2 from the sides of every box; the rows follow each other along the pull.
BoxStrains box_strains(const Tracks& tracks);

// The arrangement of markers in a tensile test: a grid of rows and columns, or four pins at the corners of a
// diamond with its diagonals along and across the pull.
struct Arrangement {
  bool diamond = false;
  std::array<std::size_t, 4> pins{};  // corners of the diamond: two along the pull, two across it
};
// The pull is the direction of the largest stretch. Four markers (2 x 2) in a diamond are recognised in any
// order. Error: the rows of a grid are more than 30 degrees off the pull. A series with less than 1 % stretch
// is taken as a grid.
Arrangement arrangement_of(const Tracks& tracks);

struct Ratio {
  double value = 0;        // - slope of across over along, line through the origin, all boxes
  double plain = 0;        // the same without the correction for noise
  double noise = 0;        // standard deviation of one coordinate, in the unit of the tracks
  double uncertainty = 0;  // standard deviation of value, by leaving out one box at a time
};
// [williams2010, eq. 3.3] with errors in both strains. The coordinates have independent noise, also in the
// first frame, which makes the mean square of `along` too large and the plain slope too small; this is
// corrected. noise < 0: estimated from the scatter about the line. Only frames with a mean strain along the
// pull of at least `least` are used. The arrangement is that of arrangement_of().
Ratio contraction_ratio(const Tracks& tracks, double noise, double least);

// In-plane shear of a box whose yarns are initially at right angles, the warp at `angle` radians from x.
struct YarnShear {
  double E12 = 0;  // lambda1 lambda2 cos(phi) / 2 (eq. 3.16), tensor component
  double warp_stretch = 1, weft_stretch = 1;
};
YarnShear yarn_shear(const std::array<double, 4>& F, double angle);

// The shear of each box relative to the mean over the boxes: slope of a line through the origin over all
// frames (E12: frames x boxes), so that noise and lost markers in single frames have little effect, and also
// the end of a cyclic test. NaN for a box that is never visible.
std::vector<double> shear_ratios(const std::vector<double>& E12, std::size_t boxes);

// Zones of a bias specimen by shear relative to the largest: 1 undeformed, 2 mixed (half), 3 sheared.
std::vector<int> bias_zones(const std::vector<double>& E12);

}  // namespace fabricsh::lab
