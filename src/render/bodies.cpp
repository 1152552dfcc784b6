#include "render/bodies.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkPointData.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

namespace fabricsh::render {

namespace {

using Point = std::array<double, 3>;
const double kSharpCosine = std::cos(kSharpDegrees * std::numbers::pi / 180);

// The facets on both sides of each edge. Its ends are identified by position, in millionths of the scene:
// a body may hold a point twice.
struct EdgeFacets {
  vtkIdType from = 0, to = 0;
  std::vector<Point> normals = {};
};
using Place = std::array<long long, 3>;
using Sides = std::map<std::pair<Place, Place>, EdgeFacets>;

Place place_of(const Point& p, double unit) {
  return {std::llround(p[0] / unit), std::llround(p[1] / unit), std::llround(p[2] / unit)};
}

Point normal_of(const Point& a, const Point& b, const Point& c) {
  const Point u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  Point n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (length > 0)
    for (double& x : n) x /= length;
  return n;
}

void add_sides(Sides& sides, vtkPoints* points, vtkIdList* corners, double unit) {
  const vtkIdType n = corners->GetNumberOfIds();
  std::vector<Point> at(static_cast<std::size_t>(n));
  for (vtkIdType k = 0; k < n; ++k)
    points->GetPoint(corners->GetId(k), at[static_cast<std::size_t>(k)].data());
  const Point normal = normal_of(at[0], at[1], at[2]);
  std::vector<Place> places;
  for (const Point& p : at) places.push_back(place_of(p, unit));
  if (places[0] == places[1] || places[1] == places[2] || places[2] == places[0]) return;  // without an area
  for (std::size_t k = 0; k < at.size(); ++k) {
    const std::size_t next = (k + 1) % at.size();
    const Place &a = places[k], &b = places[next];
    EdgeFacets& side = sides[a < b ? std::pair{a, b} : std::pair{b, a}];
    side.from = corners->GetId(static_cast<vtkIdType>(k)),
    side.to = corners->GetId(static_cast<vtkIdType>(next));
    side.normals.push_back(normal);
  }
}

bool sharp(const EdgeFacets& side) {
  if (side.normals.size() != 2) return true;
  const Point &a = side.normals[0], &b = side.normals[1];
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < kSharpCosine;
}

}  // namespace

BodySurfaces take_bodies(vtkSmartPointer<vtkUnstructuredGrid>& grid) {
  vtkDataArray* body = grid->GetCellData()->GetArray(kBody);
  if (body == nullptr || body->GetRange()[1] == 0) return {};
  const auto sheet = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const auto faces = vtkSmartPointer<vtkCellArray>::New(), lines = vtkSmartPointer<vtkCellArray>::New();
  const auto corners = vtkSmartPointer<vtkIdList>::New();
  sheet->SetPoints(grid->GetPoints());
  sheet->GetPointData()->ShallowCopy(grid->GetPointData());
  sheet->GetCellData()->CopyAllocate(grid->GetCellData());
  sheet->Allocate(grid->GetNumberOfCells());
  Sides sides;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
    grid->GetCellPoints(c, corners);
    if (body->GetComponent(c, 0) == 0) {
      sheet->GetCellData()->CopyData(grid->GetCellData(), c,
                                     sheet->InsertNextCell(grid->GetCellType(c), corners));
      continue;
    }
    faces->InsertNextCell(corners);
    add_sides(sides, grid->GetPoints(), corners, 1e-6 * grid->GetLength());
  }
  for (const auto& [ends, side] : sides) {
    if (!sharp(side)) continue;
    const vtkIdType line[2] = {side.from, side.to};
    lines->InsertNextCell(2, line);
  }
  BodySurfaces out{vtkSmartPointer<vtkPolyData>::New(), vtkSmartPointer<vtkPolyData>::New()};
  out.faces->SetPoints(grid->GetPoints());
  out.faces->SetPolys(faces);
  out.edges->SetPoints(grid->GetPoints());
  out.edges->SetLines(lines);
  grid = sheet;
  return out;
}

}  // namespace fabricsh::render
