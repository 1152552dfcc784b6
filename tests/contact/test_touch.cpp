// Closest points: against sampling, and both derivatives of the distance by slope, on every feature.
#include <map>

#include "catch.hpp"
#include "contact/slope.hpp"

using namespace fabricsh;
using namespace fabricsh::contact;
using test::Random;

namespace {

using Kernel = std::function<Touch(const Corners&)>;

Touch facet(const Corners& x) { return point_triangle(x).touch; }

Corners random_corners(Random& random) {
  return {random.vector(1), random.vector(1), random.vector(1), random.vector(1)};
}

// Both derivatives in random directions at random corners that stay on one feature.
void check_slopes(const Kernel& kernel, int cases, int features) {
  Random random(1);
  std::map<Feature, int> seen;
  for (int n = 0; n < cases; ++n) {
    const Corners x = random_corners(random);
    const Touch touch = kernel(x);
    const Vector12 by = random.direction();
    const double h = 1e-3;
    if (touch.distance < 0.2 || kernel(test::moved(x, by, h)).feature != touch.feature ||
        kernel(test::moved(x, by, -h)).feature != touch.feature)
      continue;
    ++seen[touch.feature];
    const Vector12 along = random.direction();
    const double first = distance_gradient(touch).dot(by);
    const double second = along.dot(distance_hessian(x, touch) * by);
    INFO("case " << n << " feature " << int(touch.feature));
    CHECK(test::order([&](const Corners& y) { return kernel(y).distance; }, first, x, by, h) > 1.8);
    CHECK(test::order([&](const Corners& y) { return distance_gradient(kernel(y)).dot(along); }, second, x,
                      by, h) > 1.8);
  }
  CHECK(int(seen.size()) == features);
  for (const auto& [feature, count] : seen) CHECK(count > 20);
}

}  // namespace

TEST_CASE("touch: derivatives of the distance by slope, point and segment", "[contact]") {
  check_slopes([](const Corners& x) { return point_point(x, 0, 1); }, 100, 1);
  check_slopes([](const Corners& x) { return point_segment(x, 0, 1, 2); }, 300, 2);
}

TEST_CASE("touch: derivatives of the distance by slope, point and triangle", "[contact]") {
  check_slopes(facet, 1000, 3);
}

TEST_CASE("touch: derivatives of the distance by slope, point and plane", "[contact]") {
  check_slopes(point_plane, 300, 1);
}

TEST_CASE("touch: planes that points meet in turn are not taken for each other", "[contact]") {
  Random random(5);
  for (int n = 0; n < 50; ++n) {
    const Corners one = random_corners(random);
    Corners other = one;
    other[std::size_t(1 + n % 3)][n % 2] += 1e-9;  // one corner of the plane a little elsewhere
    const auto normal = [](const Corners& x) { return (x[2] - x[1]).cross(x[3] - x[1]).normalized().eval(); };
    for (const Corners& x : {one, other, other, one}) {
      const Touch touch = point_plane(x);
      CHECK(touch.normal == normal(x));
      CHECK(touch.distance == normal(x).dot(x[0] - x[1]));
    }
  }
}

TEST_CASE("touch: derivatives of the distance by slope, two segments", "[contact]") {
  check_slopes(segment_segment, 1000, 3);
}

TEST_CASE("touch: no sampled point of a triangle is nearer than the closest", "[contact]") {
  Random random(2);
  for (int n = 0; n < 2000; ++n) {
    const Corners x = random_corners(random);
    const Touch touch = facet(x);
    double least = 1e9;
    for (int i = 0; i <= 40; ++i)
      for (int j = 0; i + j <= 40; ++j)
        least = std::min(least, (x[0] - x[1] - i / 40.0 * (x[2] - x[1]) - j / 40.0 * (x[3] - x[1])).norm());
    REQUIRE(touch.distance <= least + 1e-14);
    REQUIRE(touch.distance >= least - 0.05);
    REQUIRE(touch.distance * touch.distance ==
            Approx(squared_point_triangle(x[0], x[1], x[2], x[3])).epsilon(1e-10).margin(1e-15));
  }
}

TEST_CASE("touch: no sampled points of two segments are nearer than the closest", "[contact]") {
  Random random(3);
  for (int n = 0; n < 2000; ++n) {
    Corners x = random_corners(random);
    if (n % 4 == 0) x[3] = x[2] + random(0.5, 2) * (x[1] - x[0]) + random.vector(1e-9);  // all but parallel
    const Touch touch = segment_segment(x);
    double least = 1e9;
    for (int i = 0; i <= 50; ++i)
      least = std::min(least, std::sqrt(squared_point_segment(x[0] + i / 50.0 * (x[1] - x[0]), x[2], x[3])));
    REQUIRE(touch.distance <= least * (1 + 1e-12));
    REQUIRE(touch.distance >= least - 0.05);
    REQUIRE(touch.distance * touch.distance ==
            Approx(squared_segment_segment(x[0], x[1], x[2], x[3])).epsilon(1e-10).margin(1e-15));
  }
}

TEST_CASE("touch: weights add up on each side and rebuild the vector between the closest points",
          "[contact]") {
  Random random(4);
  for (int n = 0; n < 500; ++n) {
    const Corners x = random_corners(random);
    for (const Touch& touch : {facet(x), segment_segment(x), point_plane(x)}) {
      double sum = 0;
      Vec3 r = Vec3::Zero();
      for (std::size_t i = 0; i < 4; ++i) {
        sum += touch.weight[i];
        r += touch.weight[i] * x[i];
      }
      CHECK(std::fabs(sum) < 1e-13);
      CHECK((r - touch.distance * touch.normal).norm() < 1e-12);
    }
  }
}
