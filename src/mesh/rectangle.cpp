#include <cmath>
#include <cstdio>
#include <string>

#include "base/error.hpp"
#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

namespace {

constexpr Index most_cells = 1'000'000'000;

void check_size(const char* field, double size) {
  if (std::isfinite(size) && size > 0) return;
  char got[32];
  std::snprintf(got, sizeof got, "%.10g", size);
  throw Error(std::string("rectangle: field '") + field + "': expected a positive length, m, got " + got);
}

void check_cells(const char* field, Index cells) {
  if (cells >= 1 && cells <= most_cells) return;
  throw Error(std::string("rectangle: field '") + field + "': expected a count from 1 to " +
              std::to_string(most_cells) + ", got " + std::to_string(cells));
}

void check(double width, double height, Index nx, Index ny, const Vec3& origin) {
  check_size("width", width);
  check_size("height", height);
  check_cells("nx", nx);
  check_cells("ny", ny);
  if (nx > most_cells / ny)
    throw Error("rectangle: nx * ny: expected at most " + std::to_string(most_cells) + " cells, got " +
                std::to_string(nx) + " x " + std::to_string(ny));
  if (!origin.allFinite()) throw Error("rectangle: field 'origin': expected finite coordinates, m");
}

void add_sets(Mesh& mesh, Index nx, Index ny) {
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
  Mesh mesh;
  mesh.nodes.reserve(static_cast<std::size_t>((nx + 1) * (ny + 1)));
  mesh.elements.reserve(static_cast<std::size_t>(nx * ny));
  for (Index j = 0; j <= ny; ++j)
    for (Index i = 0; i <= nx; ++i)
      mesh.nodes.push_back(origin + Vec3(width * (static_cast<double>(i) / static_cast<double>(nx)),
                                         height * (static_cast<double>(j) / static_cast<double>(ny)), 0.0));
  for (Index j = 0; j < ny; ++j)
    for (Index i = 0; i < nx; ++i) {
      const Index first = j * (nx + 1) + i;
      mesh.elements.push_back({first, first + 1, first + nx + 2, first + nx + 1});
    }
  add_sets(mesh, nx, ny);
  mesh.flat = true;
  mesh.origin = "rectangle " + std::to_string(nx) + "x" + std::to_string(ny);
  return mesh;
}

}  // namespace fabricsh::mesh
