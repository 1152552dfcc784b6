#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "format/pvd.hpp"
#include "format/vtu.hpp"
#include "message_of.hpp"
#include "scratch.hpp"

using namespace fabricsh;
using namespace fabricsh::format;
using Names = std::set<std::string>;

namespace {

// A quadrilateral and a triangle on its right edge.
struct Sample {
  std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0.1}, {1, 1, 0}, {0, 1, 1.0 / 3.0}, {2, 0.5, 0}};
  std::vector<std::array<Index, 4>> cells = {{0, 1, 2, 3}, {1, 4, 2, -1}};
  VtuGrid grid() const {
    VtuGrid grid{points, cells};
    grid.point_data.push_back({"height", 1, {0, 1, 2, 3, 4}});
    grid.point_data.push_back({"u", 3, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}});
    grid.cell_data.push_back({"E", 5, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, {"11", "22", "23", "13", "12"}});
    return grid;
  }
};

void read(vtkXMLUnstructuredGridReader* reader, const std::string& path) {
  reader->SetFileName(path.c_str());
  reader->Update();
  REQUIRE(reader->GetErrorCode() == 0);
}

}  // namespace

TEST_CASE("a grid reads back: points and cells", "[files]") {
  const ScratchFolder folder;
  const Sample sample;
  write_vtu(folder / "out/x.vtu", sample.grid());
  CHECK(folder.listing() == Names{"out", "out/x.vtu"});
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  read(reader, folder / "out/x.vtu");
  vtkUnstructuredGrid* grid = reader->GetOutput();
  REQUIRE(grid->GetNumberOfPoints() == 5);
  for (int i = 0; i < 5; ++i) CHECK(Vec3(grid->GetPoint(i)) == sample.points[static_cast<std::size_t>(i)]);
  REQUIRE(grid->GetNumberOfCells() == 2);
  CHECK(grid->GetCellType(0) == VTK_QUAD);
  CHECK(grid->GetCellType(1) == VTK_TRIANGLE);
  CHECK(grid->GetCell(1)->GetPointId(1) == 4);
}

TEST_CASE("a grid reads back: arrays, their component names, the time", "[files]") {
  const ScratchFolder folder;
  const Sample sample;
  VtuGrid written = sample.grid();
  written.time = 0.25;
  write_vtu(folder / "x.vtu", written, system::Sync::no);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  read(reader, folder / "x.vtu");
  vtkUnstructuredGrid* grid = reader->GetOutput();
  CHECK(grid->GetPointData()->GetNumberOfArrays() == 2);
  CHECK(grid->GetPointData()->GetArray("height")->GetComponent(3, 0) == 3);
  CHECK(grid->GetPointData()->GetArray("u")->GetComponent(4, 2) == 15);
  vtkDataArray* strain = grid->GetCellData()->GetArray("E");
  REQUIRE(strain->GetNumberOfComponents() == 5);
  CHECK(strain->GetComponent(1, 2) == 8);
  CHECK(std::string(strain->GetComponentName(3)) == "13");
  CHECK(grid->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0) == 0.25);
}

TEST_CASE("a grid reads back: the units of arrays, and once more as names in the field data", "[files]") {
  const ScratchFolder folder;
  const Sample sample;
  VtuGrid written = sample.grid();
  written.point_data[1].unit = "m";
  written.cell_data[0].unit = "Pa & <s>";
  write_vtu(folder / "x.vtu", written, system::Sync::no);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  read(reader, folder / "x.vtu");
  vtkUnstructuredGrid* grid = reader->GetOutput();
  const auto unit = [](vtkDataArray* array) {
    const char* text = array->GetInformation()->Get(vtkDataArray::UNITS_LABEL());
    return text == nullptr ? std::string("none") : std::string(text);
  };
  CHECK(unit(grid->GetPointData()->GetArray("height")) == "none");
  CHECK(unit(grid->GetPointData()->GetArray("u")) == "m");
  vtkDataArray* units = grid->GetFieldData()->GetArray("units");
  REQUIRE(units->GetNumberOfComponents() == 2);
  CHECK(std::string(units->GetComponentName(0)) == "u in m");
}

TEST_CASE("a grid without cells is a file too", "[files]") {
  const ScratchFolder folder;
  const std::vector<Vec3> points;
  const std::vector<std::array<Index, 4>> cells;
  write_vtu(folder / "empty.vtu", VtuGrid{points, cells});
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  read(reader, folder / "empty.vtu");
  CHECK(reader->GetOutput()->GetNumberOfPoints() == 0);
}

TEST_CASE("an array of the wrong length is refused by name, and nothing is written", "[files]") {
  const ScratchFolder folder;
  const Sample sample;
  VtuGrid grid = sample.grid();
  grid.cell_data.push_back({"S11", 1, {1, 2, 3}});
  says(message_of([&] { write_vtu(folder / "x.vtu", grid); }),
       "array 'S11': expected 1 values for each of 2 cells, got 3 in all");
  grid.cell_data.back() = {"S11", 0, {}};
  says(message_of([&] { write_vtu(folder / "x.vtu", grid); }), "array 'S11'");
  CHECK(folder.listing().empty());
}

TEST_CASE("a series: the .pvd names every frame that is there", "[files]") {
  const ScratchFolder folder;
  const Sample sample;
  PvdSeries series(folder / "out/sheet & co");
  CHECK(content_of(series.path()).find("<Collection>\n  </Collection>") != std::string::npos);
  series.frame(0, sample.grid());
  series.frame(0.1, sample.grid());
  CHECK(series.frames() == 2);
  const std::string index = content_of(folder / "out/sheet & co.pvd");
  CHECK(index.find("timestep=\"0\" file=\"sheet &amp; co_00000.vtu\"") != std::string::npos);
  CHECK(index.find("timestep=\"0.1\" file=\"sheet &amp; co_00001.vtu\"") != std::string::npos);
  CHECK(folder.listing() ==
        Names{"out", "out/sheet & co.pvd", "out/sheet & co_00000.vtu", "out/sheet & co_00001.vtu"});
}

TEST_CASE("a series takes its name with or without .pvd", "[files]") {
  const ScratchFolder folder;
  CHECK(PvdSeries(folder / "a.pvd").path() == folder / "a.pvd");
  CHECK(PvdSeries(folder / "b.c").path() == folder / "b.c.pvd");
  says(message_of([&] { PvdSeries series(folder / ""); }), "expected a name");
}

TEST_CASE("two series on one path do not mix: the one that was there before says so", "[files]") {
  const ScratchFolder folder;
  const Sample sample;
  PvdSeries first(folder / "x");
  first.frame(0, sample.grid());
  PvdSeries second(folder / "x");
  for (int i = 0; i < 3; ++i) second.frame(i, sample.grid());
  const std::string index = content_of(second.path());
  says(message_of([&] { first.frame(1, sample.grid()); }),
       "'" + first.path() + "': another file has taken its place");
  says(message_of([&] { first.keep(0); }), "another file has taken its place");
  CHECK(content_of(second.path()) == index);
  second.frame(3, sample.grid());
  std::filesystem::remove(second.path());  // what is gone is written again
  second.frame(4, sample.grid());
  CHECK(folder.listing() ==
        Names{"x.pvd", "x_00000.vtu", "x_00001.vtu", "x_00002.vtu", "x_00003.vtu", "x_00004.vtu"});
}

TEST_CASE("a frame that fails leaves the series as it was", "[files]") {
  const ScratchFolder folder;
  const Sample sample;
  PvdSeries series(folder / "x");
  series.frame(0, sample.grid());
  const std::string before = content_of(series.path());
  VtuGrid wrong = sample.grid();
  wrong.point_data[0].values.pop_back();
  says(message_of([&] { series.frame(1, wrong); }), "'height'");
  CHECK(content_of(series.path()) == before);
  CHECK(folder.listing() == Names{"x.pvd", "x_00000.vtu"});
}

TEST_CASE("a series in a folder that cannot be is refused at once", "[files]") {
  const ScratchFolder folder;
  std::ofstream(folder / "plain") << "x";
  says(message_of([&] { PvdSeries series(folder / "plain/x"); }), "Not a directory");
}
