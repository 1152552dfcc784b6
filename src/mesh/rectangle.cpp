#include <cmath>
#include <string>

#include "base/error.hpp"
#include "base/number.hpp"
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

// Lines of nodes: 0 to the size, each beyond the one before.
void check_lines(const char* axis, const std::vector<double>& lines, double size) {
  constexpr double equal = 1e-9;  // of the size
  const std::string field = std::string("rectangle: field 'grading.") + axis + "': ";
  if (lines.size() < 2 || !(std::abs(lines.front()) <= equal * size) ||
      !(std::abs(lines.back() - size) <= equal * size))
    throw Error(field + "expected positions of the lines of nodes from 0 to " + number(size) + " m" +
                (lines.empty() ? ", got none"
                               : ", got " + number(lines.front()) + " to " + number(lines.back()) + " m"));
  for (std::size_t i = 1; i < lines.size(); ++i)
    if (!(lines[i] > lines[i - 1]))
      throw Error(field + "expected positions that ascend, got " + number(lines[i]) + " m after " +
                  number(lines[i - 1]) + " m at place " + std::to_string(i + 1));
}

}  // namespace

Mesh rectangle(double width, double height, const Grading& lines, const Vec3& origin) {
  check_lines("x", lines.x, width);
  check_lines("y", lines.y, height);
  const auto nx = static_cast<Index>(lines.x.size()) - 1, ny = static_cast<Index>(lines.y.size()) - 1;
  Mesh mesh = rectangle(width, height, nx, ny, origin);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    mesh.nodes[n] = origin + Vec3(lines.x[n % lines.x.size()], lines.y[n / lines.x.size()], 0);
  mesh.origin += " graded";
  return mesh;
}

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
