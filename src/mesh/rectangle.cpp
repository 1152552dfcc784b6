#include <string>

#include "base/error.hpp"
#include "mesh/lattice.hpp"

namespace fabricsh::mesh {

namespace {

void check(double width, double height, Index nx, Index ny, const Vec3& origin) {
  check_length("rectangle", "width", width);
  check_length("rectangle", "height", height);
  check_count("rectangle", "nx", nx);
  check_count("rectangle", "ny", ny);
  check_product("rectangle", "nx * ny", nx, ny);
  if (!origin.allFinite()) throw Error("rectangle: field 'origin': expected finite coordinates, m");
}

void name_sides(Mesh& mesh, Index nx, Index ny) {
  NodeSet left, right, bottom, top, boundary, all;
  for (Index j = 0; j <= ny; ++j)
    for (Index i = 0; i <= nx; ++i) {
      const Index id = j * (nx + 1) + i;
      all.push_back(id);
      if (i == 0) left.push_back(id);
      if (i == nx) right.push_back(id);
      if (j == 0) bottom.push_back(id);
      if (j == ny) top.push_back(id);
      if (i == 0 || i == nx || j == 0 || j == ny) boundary.push_back(id);
    }
  mesh.sets = {{"left", left}, {"right", right},       {"bottom", bottom},
               {"top", top},   {"boundary", boundary}, {"all", all}};
  mesh.sets["corners"] = {0, nx, ny * (nx + 1), ny * (nx + 1) + nx};
}

}  // namespace

Mesh rectangle(double width, double height, Index nx, Index ny, const Vec3& origin) {
  check(width, height, nx, ny, origin);
  Mesh mesh = fill(Lattice{nx, ny},
                   [&](double u, double v) -> Vec3 { return origin + Vec3(width * u, height * v, 0); });
  name_sides(mesh, nx, ny);
  mesh.flat = true;
  mesh.origin = "rectangle " + std::to_string(nx) + "x" + std::to_string(ny);
  return mesh;
}

void split(Mesh& mesh, Index across) {
  std::vector<std::array<Index, 4>> triangles;
  triangles.reserve(2 * mesh.elements.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto [a, b, c, d] = mesh.elements[e];
    const auto cell = static_cast<Index>(e);
    if ((cell % across + cell / across) % 2 == 0) {
      triangles.push_back({a, b, c, -1});
      triangles.push_back({a, c, d, -1});
    } else {
      triangles.push_back({a, b, d, -1});
      triangles.push_back({b, c, d, -1});
    }
  }
  mesh.elements = std::move(triangles);
  mesh.origin += " in triangles";
}

}  // namespace fabricsh::mesh
