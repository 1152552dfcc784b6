#include "render/sheet.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <numbers>
#include <vector>

#include "base/error.hpp"
#include "render/draw.hpp"

namespace fabricsh::render {

namespace {

std::string names(vtkFieldData* data) {
  std::string list;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    list += std::string(" ") + array->GetName();
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      if (const char* word = array->GetComponentName(c)) list += std::string(c == 0 ? "(" : " ") + word;
    if (array->GetComponentName(0) != nullptr) list += ")";
  }
  return list;
}

// -1: the magnitude; -2: no such component.
int component_of(vtkDataArray* array, const std::string& name) {
  if (name.empty()) return array->GetNumberOfComponents() > 1 ? -1 : 0;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    if (const char* word = array->GetComponentName(c); word != nullptr && name == word) return c;
  if (name.size() == 1 && array->GetNumberOfComponents() == 3 && name >= "x" && name <= "z")
    return name[0] - 'x';
  return -2;
}

double value(vtkDataArray* array, vtkIdType i, int component) {
  if (component >= 0) return array->GetComponent(i, component);
  double sum = 0;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    sum += array->GetComponent(i, c) * array->GetComponent(i, c);
  return std::sqrt(sum);
}

// Adds the array of the values to be drawn; false: this data set does not have the field.
bool show(vtkDataSetAttributes* data, const plot::Picture& picture, ClothSurface& sheet) {
  vtkDataArray* array = data->GetArray(picture.array.c_str());
  const int component = array != nullptr ? component_of(array, picture.component) : -2;
  if (component == -2) return false;
  const auto shown = vtkSmartPointer<vtkDoubleArray>::New();
  shown->SetName(kShown);
  sheet.low = std::numeric_limits<double>::infinity(), sheet.high = -sheet.low;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    const double v = picture.factor * value(array, i, component);
    shown->InsertNextValue(v);
    if (std::isfinite(v)) sheet.low = std::min(sheet.low, v), sheet.high = std::max(sheet.high, v);
  }
  data->AddArray(shown);
  data->SetActiveScalars(kShown);
  return true;
}

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

ClothSurface read_sheet(const std::string& path, const plot::Picture& picture) {
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code)) throw Error("render: no file '" + path + "'");
  const auto reader = vtkSmartPointer<vtkXMLUnstructuredGridReader>::New();
  reader->SetFileName(path.c_str());
  take_complaint();
  reader->Update();
  if (const std::string why = take_complaint(); !why.empty())
    throw Error("render: '" + path + "' is not whole, or no .vtu file: " + why);
  ClothSurface sheet;
  sheet.grid = reader->GetOutput();
  if (sheet.grid == nullptr || sheet.grid->GetNumberOfCells() == 0)
    throw Error("render: '" + path + "' holds no sheet");
  sheet.bodies = take_bodies(sheet.grid);
  if (picture.array.empty()) return sheet;
  // A field of elements may be there at the points, too, recovered better than by the mean of neighbours.
  sheet.of_points = picture.smooth && show(sheet.grid->GetPointData(), picture, sheet);
  sheet.of_cells = !sheet.of_points && show(sheet.grid->GetCellData(), picture, sheet);
  sheet.of_points = sheet.of_points || (!sheet.of_cells && show(sheet.grid->GetPointData(), picture, sheet));
  if (!sheet.of_cells && !sheet.of_points)
    throw Error("render: '" + path + "' has no field '" + picture.array + "' " + picture.component +
                "; cells:" + names(sheet.grid->GetCellData()) +
                "; points:" + names(sheet.grid->GetPointData()));
  return sheet;
}

void make_smooth(ClothSurface& sheet) {
  if (!sheet.of_cells) return;
  vtkDataArray* cells = sheet.grid->GetCellData()->GetArray(kShown);
  const auto count = static_cast<std::size_t>(sheet.grid->GetNumberOfPoints());
  std::vector<double> sum(count, 0), weight(count, 0);
  const auto corners = vtkSmartPointer<vtkIdList>::New();
  for (vtkIdType c = 0; c < sheet.grid->GetNumberOfCells(); ++c) {
    const double v = cells->GetComponent(c, 0);
    if (!std::isfinite(v)) continue;
    sheet.grid->GetCellPoints(c, corners);
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k) {
      const auto node = static_cast<std::size_t>(corners->GetId(k));
      sum[node] += v, weight[node] += 1;
    }
  }
  const auto shown = vtkSmartPointer<vtkDoubleArray>::New();
  shown->SetName(kShown);
  sheet.low = std::numeric_limits<double>::infinity(), sheet.high = -sheet.low;
  for (std::size_t i = 0; i < count; ++i) {
    const double v = weight[i] > 0 ? sum[i] / weight[i] : std::numeric_limits<double>::quiet_NaN();
    shown->InsertNextValue(v);
    if (std::isfinite(v)) sheet.low = std::min(sheet.low, v), sheet.high = std::max(sheet.high, v);
  }
  sheet.grid->GetCellData()->RemoveArray(kShown);
  sheet.grid->GetPointData()->AddArray(shown);
  sheet.grid->GetPointData()->SetActiveScalars(kShown);
  sheet.of_cells = false, sheet.of_points = true;
}

void scale(const ClothSurface& sheet, double factor) {
  vtkPoints* points = sheet.grid->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) {
    double p[3];
    points->GetPoint(i, p);
    points->SetPoint(i, factor * p[0], factor * p[1], factor * p[2]);
  }
  points->Modified();
}

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
