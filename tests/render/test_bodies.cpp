// Rigid bodies are taken out of the sheet's grid, with the edges that have a corner.
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "catch.hpp"
#include "render/sheet.hpp"

using namespace fabricsh::render;

namespace {

// Triangles with their own copies of all corners, the copies differing by rounding.
class Facets {
 public:
  Facets() { points_->SetDataTypeToDouble(); }

  void triangle(const std::array<std::array<double, 3>, 3>& corners, double body) {
    std::array<vtkIdType, 3> ids{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double off = 1e-15 * static_cast<double>(points_->GetNumberOfPoints() % 3);
      ids[k] = points_->InsertNextPoint(corners[k][0] + off, corners[k][1] - off, corners[k][2] + off);
    }
    grid_->InsertNextCell(VTK_TRIANGLE, 3, ids.data());
    bodies_->InsertNextValue(body);
  }

  // A tube about z with caps: a square prism of 4 sides, round with many.
  void tube(int sides, double body) {
    const auto at = [&](int i, double z) {
      const double a = 2 * std::numbers::pi * i / sides;
      return std::array{std::cos(a), std::sin(a), z};
    };
    for (int i = 0; i < sides; ++i) {
      triangle({at(i, 0), at(i + 1, 0), at(i + 1, 1)}, body);
      triangle({at(i, 0), at(i + 1, 1), at(i, 1)}, body);
      triangle({at(i + 1, 0), at(i, 0), {0, 0, 0}}, body);
      triangle({at(i, 1), at(i + 1, 1), {0, 0, 1}}, body);
    }
  }

  vtkSmartPointer<vtkUnstructuredGrid> grid() {
    bodies_->SetName(kBody);
    grid_->SetPoints(points_);
    grid_->GetCellData()->AddArray(bodies_);
    return grid_.Get();
  }

 private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkUnstructuredGrid> grid_;
  vtkNew<vtkDoubleArray> bodies_;
};

}  // namespace

TEST_CASE("a square prism has twelve edges, a round tube those of its caps alone", "[render]") {
  for (const auto& [sides, edges] : {std::pair{4, 12}, {6, 18}, {40, 80}}) {
    Facets facets;
    facets.tube(sides, 1);
    auto grid = facets.grid();
    const BodySurfaces bodies = take_bodies(grid);
    REQUIRE(bodies.faces != nullptr);
    CHECK(bodies.faces->GetNumberOfPolys() == 4 * sides);
    CHECK(bodies.edges->GetNumberOfLines() == edges);
    CHECK(grid->GetNumberOfCells() == 0);
  }
}

TEST_CASE("where a surface ends there is an edge, a facet without an area has none", "[render]") {
  Facets facets;
  facets.triangle({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, 2);
  facets.triangle({{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}, 2);
  facets.triangle({{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}}, 2);
  auto grid = facets.grid();
  CHECK(take_bodies(grid).edges->GetNumberOfLines() == 4);
}

TEST_CASE("the sheet keeps its cells with their values", "[render]") {
  Facets facets;
  facets.triangle({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, 0);
  facets.tube(12, 1);
  facets.triangle({{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}}}, 0);
  auto grid = facets.grid();
  vtkNew<vtkDoubleArray> values;
  values->SetName("S11");
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) values->InsertNextValue(static_cast<double>(c));
  grid->GetCellData()->AddArray(values);
  take_bodies(grid);
  REQUIRE(grid->GetNumberOfCells() == 2);
  CHECK(grid->GetCellData()->GetArray("S11")->GetComponent(0, 0) == 0);
  CHECK(grid->GetCellData()->GetArray("S11")->GetComponent(1, 0) == 49);
  Facets none;
  none.triangle({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, 0);
  auto bare = none.grid();
  CHECK(take_bodies(bare).faces == nullptr);
  CHECK(bare->GetNumberOfCells() == 1);
}
