// The sheet of one file, in the length unit of the picture, with one number per cell or point.
#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include "plot/picture.hpp"

namespace fabricsh::render {

inline constexpr const char* kBody = "rigid_body";  // array of cells: 0 for the sheet, else the body's number

inline constexpr double kSharpDegrees = 30;  // a surface that bends by more has an edge there

struct BodySurfaces {
  vtkSmartPointer<vtkPolyData> faces, edges;  // null: none
};

// Takes the cells of bodies out of the grid. Faces and edges share the grid's points. An edge is one where
// the surface ends or is sharp; the facets of a round body have none.
BodySurfaces take_bodies(vtkSmartPointer<vtkUnstructuredGrid>& grid);

inline constexpr const char* kShown = "shown";  // name of the array that is shown

struct ClothSurface {
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  BodySurfaces bodies = {};
  bool of_cells = false, of_points = false;  // the values belong to cells or points; neither: no field
  double low = 0, high = 0;                  // range of the finite numbers
};

// Error: the file is missing, or it does not have the field (the message lists those that it has).
ClothSurface read_sheet(const std::string& path, const plot::Picture& picture);
// Replaces the values of cells by values of points, each the mean of the adjacent cells.
void make_smooth(ClothSurface& sheet);
// Scales the points of the sheet.
void scale(const ClothSurface& sheet, double factor);

}  // namespace fabricsh::render
