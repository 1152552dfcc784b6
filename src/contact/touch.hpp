// The closest points of two simplices (point, segment, triangle), and their dependence on the corners.
//
// A pair has up to four corners x_i. The vector between its closest points is r = sum weight_i x_i, and the
// distance is |r|. The weights are signed: on the first simplex they are positive with the sum 1, on the
// second negative with the sum -1. Because the closest points are stationary, the first derivative of the
// distance is weight_i n with n = r/|r|; the motion of the closest points enters only the second derivative.
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "geometry/vec.hpp"

namespace fabricsh::contact {

using Corners = std::array<Vec3, 4>;
using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

// The parts of a pair on which its closest points lie.
enum class Feature : std::uint8_t {
  point_point,  // two corners
  point_edge,   // a corner, and the inside of a segment
  face,         // a corner, and the inside of a triangle
  crossing      // the insides of two segments
};

struct Touch {
  double distance = 0;             // m
  Vec3 normal = Vec3::Zero();      // unit, from the second simplex to the first; zero at distance 0
  std::array<double, 4> weight{};  // of each corner, without unit
  Feature feature = Feature::point_point;
  // The closest points have as many free parameters as their feature has dimensions. Along parameter k
  // the weight of corner plus[k] grows at the rate 1 and that of corner minus[k] falls at the same rate.
  std::array<std::int8_t, 2> plus{}, minus{};

  int freedoms() const {
    return feature == Feature::point_point ? 0 : feature == Feature::point_edge ? 1 : 2;
  }
  // The corners, a bit each, that the distance depends on.
  unsigned corners() const {
    unsigned out = 0;
    for (std::size_t i = 0; i < 4; ++i) out |= (weight[i] != 0 ? 1u : 0u) << i;
    for (std::size_t k = 0; k < std::size_t(freedoms()); ++k)
      out |= 1u << unsigned(plus[k]) | 1u << unsigned(minus[k]);
    return out;
  }
};
// Calls visit(i) for the corners whose bits are set.
template <class Visit>
void each_corner(unsigned corners, Visit visit) {
  for (std::size_t i = 0; i < 4; ++i)
    if ((corners >> i & 1) != 0) visit(i);
}

// Corners are given by their index in `x`; corners that are not named have the weight zero.
Touch point_point(const Corners& x, int p, int q);
// Point p against the segment from a to b.
Touch point_segment(const Corners& x, int p, int a, int b);
// Point 0 against the triangle 1, 2, 3. `part` is what of it is closest, see nearest_part().
struct FacetTouch {
  Touch touch;
  std::size_t part = 0;
};
FacetTouch point_triangle(const Corners& x);
// 0: the inside of the triangle is closest; k, 1 to 3: the side opposite to corner k; 3 + k: that corner.
std::size_t nearest_part(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);
// Point 0 against the whole plane through 1, 2, 3; the distance is signed, positive on the side that sees
// 1, 2, 3 counter-clockwise.
Touch point_plane(const Corners& x);
// The segment from 0 to 1 against the segment from 2 to 3.
Touch segment_segment(const Corners& x);
// The same, if the closest points are inside of both.
std::optional<Touch> segments_crossing(const Corners& x);

// Squared distances alone, m2: for searches.
double squared_point_segment(const Vec3& p, const Vec3& a, const Vec3& b);
double squared_point_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);
double squared_segment_segment(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
// Infinity where they do not cross.
double squared_crossing(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

// d xi_k / d x_j (1/m) for each free parameter k of the closest points and each corner j; row vectors.
using Slides = std::array<std::array<Vec3, 4>, 2>;
Slides slides(const Corners& x, const Touch& touch);

// Blocks of a matrix by the corners of a pair: of the corners whose bits are set.
struct Blocks {
  unsigned rows = 15, columns = 15;
};
// First and second derivative of the distance by the corners' coordinates (x, y, z of corner 0 first).
Vector12 distance_gradient(const Touch& touch);
Matrix12 distance_hessian(const Corners& x, const Touch& touch, Blocks of = {});  // other blocks are zero

}  // namespace fabricsh::contact
