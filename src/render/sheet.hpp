// The sheet of one file, in the length unit of the picture, with one number per cell or point.
#pragma once
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include "plot/picture.hpp"

namespace fabricsh::render {

inline constexpr const char* kRigid = "rigid";  // name of the array that marks rigid bodies
inline constexpr const char* kShown = "shown";  // name of the array that is shown

struct Sheet {
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  bool of_cells = false, of_points = false;  // the values belong to cells or points; neither: no field
  double low = 0, high = 0;                  // range of the finite numbers
};

// Error: the file is missing, or it does not have the field (the message lists those that it has).
Sheet read_sheet(const std::string& path, const plot::Picture& picture);
// Of a file that marks its rigid bodies (cells with `rigid` = 1): the cloth alone, and the bodies with
// normals that are continuous but over sharp edges; null: there are none.
vtkSmartPointer<vtkUnstructuredGrid> cloth_of(const Sheet& sheet);
vtkSmartPointer<vtkUnstructuredGrid> bodies_of(const Sheet& sheet);
// Replaces the values of cells by values of points, each the mean of the adjacent cells.
void make_smooth(Sheet& sheet);
// Scales the points of the sheet.
void scale(const Sheet& sheet, double factor);

}  // namespace fabricsh::render
