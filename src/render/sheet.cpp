#include "render/sheet.hpp"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <vector>

#include "base/error.hpp"
#include "geometry/vec.hpp"
#include "render/complaints.hpp"

namespace fabricsh::render {

namespace {

constexpr double kSharp = 0.77;  // cosine of the angle between facets beyond which an edge is sharp

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
bool show(vtkDataSetAttributes* data, const plot::Picture& picture, Sheet& sheet) {
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

}  // namespace

Sheet read_sheet(const std::string& path, const plot::Picture& picture) {
  std::error_code trouble;
  if (!std::filesystem::is_regular_file(path, trouble)) throw Error("render: no file '" + path + "'");
  const auto reader = vtkSmartPointer<vtkXMLUnstructuredGridReader>::New();
  reader->SetFileName(path.c_str());
  take_complaint();
  reader->Update();
  if (const std::string why = take_complaint(); !why.empty())
    throw Error("render: '" + path + "' is not whole, or no .vtu file: " + why);
  Sheet sheet;
  sheet.grid = reader->GetOutput();
  if (sheet.grid == nullptr || sheet.grid->GetNumberOfCells() == 0)
    throw Error("render: '" + path + "' holds no sheet");
  if (picture.array.empty()) return sheet;
  sheet.of_cells = show(sheet.grid->GetCellData(), picture, sheet);
  sheet.of_points = !sheet.of_cells && show(sheet.grid->GetPointData(), picture, sheet);
  if (!sheet.of_cells && !sheet.of_points)
    throw Error("render: '" + path + "' has no field '" + picture.array + "' " + picture.component +
                "; cells:" + names(sheet.grid->GetCellData()) +
                "; points:" + names(sheet.grid->GetPointData()));
  return sheet;
}

vtkSmartPointer<vtkUnstructuredGrid> cloth_of(const Sheet& sheet) {
  vtkDataArray* rigid = sheet.grid->GetCellData()->GetArray(kRigid);
  if (rigid == nullptr) return sheet.grid;
  const auto out = vtkSmartPointer<vtkUnstructuredGrid>::New();
  out->SetPoints(sheet.grid->GetPoints());
  out->GetPointData()->ShallowCopy(sheet.grid->GetPointData());
  out->GetCellData()->CopyAllocate(sheet.grid->GetCellData());
  const auto corners = vtkSmartPointer<vtkIdList>::New();
  for (vtkIdType c = 0; c < sheet.grid->GetNumberOfCells(); ++c) {
    if (rigid->GetComponent(c, 0) != 0) continue;
    sheet.grid->GetCellPoints(c, corners);
    const vtkIdType cell = out->InsertNextCell(sheet.grid->GetCellType(c), corners);
    out->GetCellData()->CopyData(sheet.grid->GetCellData(), c, cell);
  }
  return out;
}

vtkSmartPointer<vtkUnstructuredGrid> bodies_of(const Sheet& sheet) {
  vtkDataArray* rigid = sheet.grid->GetCellData()->GetArray(kRigid);
  if (rigid == nullptr) return nullptr;
  struct Facet {
    std::vector<vtkIdType> points;
    Vec3 normal;  // its length is twice the area, m2
  };
  std::vector<Facet> facets;
  std::vector<std::vector<std::size_t>> at(static_cast<std::size_t>(sheet.grid->GetNumberOfPoints()));
  const auto place = [&](vtkIdType id) {
    Vec3 p;
    sheet.grid->GetPoint(id, p.data());
    return p;
  };
  const auto corners = vtkSmartPointer<vtkIdList>::New();
  for (vtkIdType c = 0; c < sheet.grid->GetNumberOfCells(); ++c) {
    if (rigid->GetComponent(c, 0) == 0) continue;
    sheet.grid->GetCellPoints(c, corners);
    Facet facet;
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k) {
      facet.points.push_back(corners->GetId(k));
      at[static_cast<std::size_t>(corners->GetId(k))].push_back(facets.size());
    }
    const Vec3 a = place(facet.points[0]);
    facet.normal = (place(facet.points[1]) - a).cross(place(facet.points[2]) - a);
    facets.push_back(std::move(facet));
  }
  if (facets.empty()) return nullptr;
  const auto out = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const auto points = vtkSmartPointer<vtkPoints>::New();
  const auto normals = vtkSmartPointer<vtkDoubleArray>::New();
  normals->SetNumberOfComponents(3);
  normals->SetName("Normals");
  for (const Facet& facet : facets) {
    std::vector<vtkIdType> ids;
    for (const vtkIdType p : facet.points) {
      Vec3 sum = Vec3::Zero();
      for (const std::size_t f : at[static_cast<std::size_t>(p)]) {
        const Vec3& other = facets[f].normal;
        if (other.dot(facet.normal) > kSharp * other.norm() * facet.normal.norm()) sum += other;
      }
      if (!(sum.norm() > 0)) sum = Vec3::UnitZ();
      ids.push_back(points->InsertNextPoint(place(p).data()));
      normals->InsertNextTuple(Vec3(sum.normalized()).data());
    }
    out->InsertNextCell(ids.size() == 3 ? VTK_TRIANGLE : VTK_QUAD, static_cast<vtkIdType>(ids.size()),
                        ids.data());
  }
  out->SetPoints(points);
  out->GetPointData()->SetNormals(normals);
  return out;
}

void make_smooth(Sheet& sheet) {
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

void scale(const Sheet& sheet, double factor) {
  vtkPoints* points = sheet.grid->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) {
    double p[3];
    points->GetPoint(i, p);
    points->SetPoint(i, factor * p[0], factor * p[1], factor * p[2]);
  }
  points->Modified();
}

}  // namespace fabricsh::render
