// Rigid bodies in the picture of a sheet: their surfaces, and the edges that are drawn of them.
#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

namespace fabricsh::render {

inline constexpr const char* kBody = "rigid_body";  // array of cells: 0 for the sheet, else the body's number

inline constexpr double kSharpDegrees = 30;  // a surface that bends by more has an edge there

struct BodySurfaces {
  vtkSmartPointer<vtkPolyData> faces, edges;  // null: none
};

// Takes the cells of bodies out of the grid. Faces and edges share the grid's points. An edge is one where
// the surface ends or is sharp; the facets of a round body have none.
BodySurfaces take_bodies(vtkSmartPointer<vtkUnstructuredGrid>& grid);

}  // namespace fabricsh::render
