#include "format/vtu.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSignedCharArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersion.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>

#include "base/error.hpp"
#include "format/source.hpp"
#include "format/xml.hpp"

namespace fabricsh::format {

namespace {

void check_length(const Array& array, std::size_t items, const char* of) {
  const std::size_t wanted = items * static_cast<std::size_t>(array.components);
  if (array.components >= 1 && array.values.size() == wanted) return;
  throw Error("array '" + array.name + "': expected " + std::to_string(array.components) +
              " values for each of " + std::to_string(items) + " " + of + ", got " +
              std::to_string(array.values.size()) + " in all");
}

// VTK writes names of arrays without escaping characters that mean something in XML.
void add_flags(vtkDataSetAttributes* data, const Array& array) {
  vtkNew<vtkSignedCharArray> copy;
  copy->SetName(escaped(array.name).c_str());
  for (const double value : array.values) copy->InsertNextValue(value != 0 ? 1 : 0);
  data->AddArray(copy);
}

void add(vtkDataSetAttributes* data, const Array& array) {
  if (array.flags) return add_flags(data, array);
  vtkNew<vtkDoubleArray> copy;
  copy->SetName(escaped(array.name).c_str());
  copy->SetNumberOfComponents(array.components);
  for (std::size_t c = 0; c < array.component_names.size(); ++c)
    copy->SetComponentName(static_cast<vtkIdType>(c), array.component_names[c].c_str());
  copy->SetNumberOfTuples(static_cast<vtkIdType>(array.values.size()) / array.components);
  std::copy(array.values.begin(), array.values.end(), copy->GetPointer(0));
  if (!array.unit.empty())
    copy->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), escaped(array.unit).c_str());
  data->AddArray(copy);
}

void add_points(vtkUnstructuredGrid* data, const VtuGrid& grid) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(grid.points.size()));
  for (std::size_t i = 0; i < grid.points.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), grid.points[i].data());
  data->SetPoints(points);
}

void add_cells(vtkUnstructuredGrid* data, const VtuGrid& grid) {
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> types;
  for (const auto& cell : grid.cells) {
    const int corners = cell[3] < 0 ? 3 : 4;
    cells->InsertNextCell(corners);
    for (int i = 0; i < corners; ++i)
      cells->InsertCellPoint(static_cast<vtkIdType>(cell[static_cast<std::size_t>(i)]));
    types->InsertNextValue(corners == 3 ? VTK_TRIANGLE : VTK_QUAD);
  }
  data->SetCells(types, cells);
}

void add_time(vtkUnstructuredGrid* data, double time) {
  vtkNew<vtkDoubleArray> value;
  value->SetName("TimeValue");  // the name that ParaView looks for
  value->InsertNextValue(time);
  data->GetFieldData()->AddArray(value);
}

// The units once more where people look: ParaView shows the names of components of field data. Text would be
// plainer, but there are readers that refuse a file with text in it.
void add_units(vtkUnstructuredGrid* data, const VtuGrid& grid) {
  std::vector<std::string> words;
  for (const auto* arrays : {&grid.point_data, &grid.cell_data})
    for (const Array& array : *arrays) {
      const std::string word = array.name + " in " + array.unit;
      if (!array.unit.empty() && std::find(words.begin(), words.end(), word) == words.end())
        words.push_back(word);
    }
  if (words.empty()) return;
  vtkNew<vtkUnsignedCharArray> units;
  units->SetName("units");
  units->SetNumberOfComponents(static_cast<int>(words.size()));
  for (std::size_t i = 0; i < words.size(); ++i) {
    units->SetComponentName(static_cast<vtkIdType>(i), escaped(words[i]).c_str());
    units->InsertNextValue(1);
  }
  data->GetFieldData()->AddArray(units);
}

// The document is made in memory; this room writes the file, so that errors have the system's reason.
std::string document(vtkUnstructuredGrid* data) {
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->SetCompressorTypeToZLib();
  writer->WriteToOutputStringOn();
  if (writer->Write() != 1) throw Error("VTK could not make the grid");
  return writer->GetOutputString();
}

}  // namespace

FileSum sum_of(std::string_view bytes) { return {static_cast<std::int64_t>(bytes.size()), checksum(bytes)}; }

FileSum write_vtu(const std::string& path, const VtuGrid& grid, system::Sync sync, system::Folder folder) {
  vtkNew<vtkUnstructuredGrid> data;
  for (const Array& array : grid.point_data) check_length(array, grid.points.size(), "points");
  for (const Array& array : grid.cell_data) check_length(array, grid.cells.size(), "cells");
  add_points(data, grid);
  add_cells(data, grid);
  for (const Array& array : grid.point_data) add(data->GetPointData(), array);
  for (const Array& array : grid.cell_data) add(data->GetCellData(), array);
  if (grid.time) add_time(data, *grid.time);
  add_units(data, grid);
  const std::string bytes = document(data);
  system::write_file(path, bytes, sync, folder);
  return sum_of(bytes);
}

std::vector<Library> libraries() { return {{"VTK", vtkVersion::GetVTKVersion()}}; }

}  // namespace fabricsh::format
