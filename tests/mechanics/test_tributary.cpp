// Shares of nodes in what is distributed over a set, where no two elements are alike.
#include <numeric>

#include "catch.hpp"
#include "mechanics/mesh_tools.hpp"

using namespace fabricsh;

namespace {

// A rectangle of 3 x 2 quadrilaterals with lines at other distances: x = 0, 1, 3, 7 and y = 0, 2, 5.
mesh::Mesh uneven() {
  mesh::Mesh mesh = mesh::rectangle(3, 2, 3, 2);
  const double x[] = {0, 1, 3, 7}, y[] = {0, 2, 5};
  mesh.map([&](const Vec3& X) { return Vec3(x[std::lround(X.x())], y[std::lround(X.y())], 0); });
  return mesh;
}

}  // namespace

TEST_CASE("an area is shared by the bilinear functions of each element: a quarter of every rectangle") {
  const mesh::Mesh mesh = uneven();
  const auto all = mechanics::tributary(mesh, mesh.set("all"));
  CHECK(all.kind == mechanics::Tributary::MeasureKind::area);
  CHECK(all.total == Approx(35).epsilon(1e-14));
  const double half_x[] = {0.5, 1.5, 3, 2}, half_y[] = {1, 2.5, 1.5};
  for (std::size_t n = 0; n < 12; ++n)
    CHECK(all.measure[n] == Approx(half_x[n % 4] * half_y[n / 4]).epsilon(1e-14));
  // A part of the elements: those whose nodes are all in the set.
  const auto part = mechanics::tributary(mesh, {1, 2, 5, 6, 3});
  CHECK(part.kind == mechanics::Tributary::MeasureKind::area);
  CHECK(part.total == Approx(4).epsilon(1e-14));
  CHECK(part.measure == std::vector<double>{1, 1, 1, 1, 0});
}

TEST_CASE("an edge is shared by halves of its pieces, and nodes without edges alike") {
  const mesh::Mesh mesh = uneven();
  const auto bottom = mechanics::tributary(mesh, mesh.set("bottom"));
  CHECK(bottom.kind == mechanics::Tributary::MeasureKind::length);
  CHECK(bottom.total == Approx(7).epsilon(1e-14));
  CHECK(bottom.measure == std::vector<double>{0.5, 1.5, 3, 2});
  const auto left = mechanics::tributary(mesh, mesh.set("left"));
  CHECK(left.measure == std::vector<double>{1, 2.5, 1.5});
  const auto apart = mechanics::tributary(mesh, {0, 2, 11});
  CHECK(apart.kind == mechanics::Tributary::MeasureKind::count);
  CHECK(std::accumulate(apart.measure.begin(), apart.measure.end(), 0.0) == Approx(apart.total));
  CHECK(apart.measure[0] == apart.measure[2]);
}
