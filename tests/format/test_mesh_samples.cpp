// The sample mesh by VTK's writers, and that every sample reads as the same mesh.
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSignedCharArray.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>

#include "format/mesh_file.hpp"
#include "mesh/generators.hpp"
#include "mesh_samples.hpp"
#include "message_of.hpp"
#include "scratch.hpp"
#include "system/atomic.hpp"

using namespace fabricsh;
using namespace fabricsh::format;

namespace {

// left as flags on the points, plate as flags on the cells, and what a reader has to pass over.
void add_arrays(vtkDataSet* data, const mesh::Mesh& m) {
  vtkNew<vtkSignedCharArray> left;
  left->SetName("left");
  vtkNew<vtkDoubleArray> heat, flow;
  heat->SetName("heat & <cold>");
  flow->SetName("flow");
  flow->SetNumberOfComponents(3);
  vtkNew<vtkIntArray> numbers, plate;
  numbers->SetName("numbers");
  plate->SetName("plate");
  for (mesh::Index i = 0; i < 7; ++i) {
    left->InsertNextValue(i == 0 || i == 3 ? 1 : 0);
    heat->InsertNextValue(0.5);
    flow->InsertNextTuple(m.nodes[static_cast<std::size_t>(i)].data());
    numbers->InsertNextValue(static_cast<int>(i));
  }
  for (const int in : {1, 1, 0}) plate->InsertNextValue(in);
  data->GetPointData()->AddArray(heat);
  data->GetPointData()->AddArray(left);
  data->GetPointData()->AddArray(numbers);
  data->GetPointData()->SetVectors(flow);
  data->GetCellData()->AddArray(plate);
}

vtkNew<vtkPoints> points_of(const mesh::Mesh& m) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& x : m.nodes) points->InsertNextPoint(x.data());
  return points;
}

template <class Insert>
void each_cell(const mesh::Mesh& m, const Insert& insert) {
  for (const auto& ids : m.elements) {
    vtkIdType corners[4];
    const int n = ids[3] < 0 ? 3 : 4;
    for (int i = 0; i < n; ++i) corners[i] = ids[static_cast<std::size_t>(i)];
    insert(n, corners);
  }
}

template <class Writer>
std::string written(Writer* writer, vtkDataSet* data) {
  writer->SetInputData(data);
  writer->WriteToOutputStringOn();
  REQUIRE(writer->Write() == 1);
  if constexpr (requires { writer->GetOutputStdString(); })
    return writer->GetOutputStdString();
  else
    return writer->GetOutputString();
}

void add_xml(std::map<std::string, std::string>& all, vtkUnstructuredGrid* grid) {
  const std::array modes{"ascii", "inline", "raw", "base64"};
  const std::array compressors{"plain", "zlib", "lz4", "lzma"};
  for (std::size_t mode = 0; mode < 4; ++mode)
    for (int compressor = 0; compressor < 4; ++compressor)
      for (const bool wide : {false, true}) {
        vtkNew<vtkXMLUnstructuredGridWriter> writer;
        writer->SetDataMode(mode == 0   ? vtkXMLWriter::Ascii
                            : mode == 1 ? vtkXMLWriter::Binary
                                        : vtkXMLWriter::Appended);
        writer->SetEncodeAppendedData(mode == 3);
        writer->SetCompressorType(compressor);
        writer->SetBlockSize(64);  // several blocks to an array
        if (wide) {
          writer->SetHeaderTypeToUInt64();
          writer->SetByteOrderToBigEndian();
        }
        const std::string name =
            std::string(modes[mode]) + "-" + compressors[static_cast<std::size_t>(compressor)];
        all[name + (wide ? "-wide" : "") + ".vtu"] = written(writer.GetPointer(), grid);
      }
}

template <class Writer>
void add_legacy(std::map<std::string, std::string>& all, const std::string& name, vtkDataSet* data) {
  for (const bool binary : {false, true})
    for (const bool old : {false, true}) {
      vtkNew<Writer> writer;
      writer->SetFileVersion(old ? 42 : 51);
      if (binary) writer->SetFileTypeToBinary();
      all[name + (binary ? "-binary" : "-text") + (old ? "-4" : "-5") + ".vtk"] =
          written(writer.GetPointer(), data);
    }
}

}  // namespace

std::map<std::string, std::string> samples::from_vtk() {
  const auto m = plate();
  const auto points = points_of(m);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  each_cell(
      m, [&grid](int n, vtkIdType* ids) { grid->InsertNextCell(n == 3 ? VTK_TRIANGLE : VTK_QUAD, n, ids); });
  add_arrays(grid, m);
  vtkNew<vtkCellArray> polygons;
  each_cell(m, [&polygons](int n, vtkIdType* ids) { polygons->InsertNextCell(n, ids); });
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(polygons);
  add_arrays(surface, m);
  std::map<std::string, std::string> all;
  add_xml(all, grid);
  add_legacy<vtkUnstructuredGridWriter>(all, "grid", grid);
  add_legacy<vtkPolyDataWriter>(all, "surface", surface);
  return all;
}

TEST_CASE("every format and form of it reads as the same mesh", "[files]") {
  const ScratchFolder folder;
  const auto wanted = samples::plate();
  for (const auto& [name, content] : samples::every()) {
    INFO(name);
    system::write_file(folder / name, content, system::Sync::no);
    const auto m = read_mesh(folder / name);
    REQUIRE(m.nodes.size() == wanted.nodes.size());
    // VTK's text has 11 digits.
    const double off = name.find("ascii") == 0 || name.find("-text-") != std::string::npos ? 1e-10 : 0;
    for (std::size_t i = 0; i < m.nodes.size(); ++i) CHECK((m.nodes[i] - wanted.nodes[i]).norm() <= off);
    CHECK(m.elements == wanted.elements);
    CHECK(m.set("left") == wanted.set("left"));
    CHECK(m.set("plate") == wanted.set("plate"));
    CHECK(m.set("all") == wanted.set("all"));
    CHECK(m.set("boundary") == wanted.set("boundary"));
    const std::size_t more = name == "plate.obj" ? 1 : name == "plate.inp" ? 2 : 0;  // sheet; tip and whole
    CHECK(m.sets.size() == 4 + more);
    CHECK_FALSE(m.flat);
    CHECK(m.origin == "file " + name);
  }
}

TEST_CASE("a mesh that is written reads back equal", "[files]") {
  const ScratchFolder folder;
  const mesh::Mesh meshes[] = {samples::plate(), mesh::disk({.radius = 0.05, .cells = 3}),
                               mesh::cylinder({.radius = 1.0 / 3, .length = 1, .around = 5, .along = 2})};
  for (const auto& m : meshes)
    for (const char* name : {"x.vtu", "x.msh"}) {
      write_mesh(folder / name, m);
      const auto back = read_mesh(folder / name);
      CHECK(back.nodes == m.nodes);
      CHECK(back.elements == m.elements);
      CHECK(back.sets == m.sets);
    }
}

TEST_CASE("a mesh that is written in columns reads back as far as they hold digits", "[files]") {
  const ScratchFolder folder;
  auto m = mesh::cylinder({.radius = 1.0 / 3, .length = 1, .around = 5, .along = 2});
  m.nodes[3].x() = -1.0 / 3e-7;
  // 15 characters: 8 digits beside -, . and e-17; 20: 13 beside e-300 as well.
  for (const auto& [name, off] :
       {std::pair{"x.k", 1e-8}, std::pair{"x.inp", 1e-13}, std::pair{"x.rad", 1e-12}}) {
    write_mesh(folder / name, m);
    const auto back = read_mesh(folder / name);
    REQUIRE(back.nodes.size() == m.nodes.size());
    for (std::size_t i = 0; i < m.nodes.size(); ++i)
      for (int k = 0; k < 3; ++k)
        CHECK(std::abs(back.nodes[i][k] - m.nodes[i][k]) <= off * std::abs(m.nodes[i][k]));
    CHECK(back.elements == m.elements);
    CHECK(back.sets == m.sets);
  }
}

TEST_CASE("a number fills the 20 characters that Abaqus reads, and no more", "[files]") {
  auto m = samples::plate();
  m.nodes[1].x() = -1.2345678901234567e-105;
  const ScratchFolder folder;
  write_mesh(folder / "x.inp", m);
  const std::string text = content_of(folder / "x.inp");
  CHECK(text.find("2, -1.234567890123e-105, 0, 0\n") != text.npos);
}

TEST_CASE("a surface without sets: .obj, .ply, .stl", "[files]") {
  const ScratchFolder folder;
  const auto m = samples::plate();
  write_mesh(folder / "x.obj", m);
  const auto obj = read_mesh(folder / "x.obj");
  CHECK(obj.nodes == m.nodes);
  CHECK(obj.elements == m.elements);
  write_mesh(folder / "x.stl", m);
  const auto stl = read_mesh(folder / "x.stl");
  CHECK(stl.nodes.size() == 7);
  CHECK(stl.elements.size() == 5);
  write_mesh(folder / "x.ply", m);
  CHECK(content_of(folder / "x.ply").find("end_header\n0 0 0\n1 0 0\n2 0 0.125\n") != std::string::npos);
  CHECK(content_of(folder / "x.ply").ends_with("4 0 1 4 3\n4 1 2 5 4\n3 2 6 5\n"));
  const auto ply = read_mesh(folder / "x.ply");
  CHECK(ply.nodes == m.nodes);
  CHECK(ply.elements == m.elements);
}

namespace {

template <class T>
void add_bytes(std::string& text, T value, bool high_first) {
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
  if (high_first) std::reverse(bytes.begin(), bytes.end());
  text += bytes;
}

// Four corners of a wedge and a face of each kind, with a property and an element that nobody needs.
std::string binary_ply(bool high_first) {
  std::string text =
      "ply\r\nformat binary_" + std::string(high_first ? "big" : "little") +
      "_endian 1.0\ncomment made by hand\nelement vertex 5\nproperty float x\nproperty uchar red\n"
      "property double y\nproperty float z\nelement edge 1\nproperty list uchar short ends\nelement "
      "face 2\nproperty list uchar int vertex_index\nproperty short flag\nend_header\n";
  const double places[5][3] = {{0, 0, 0}, {2, 0, 0.5}, {3, 1.25, 0}, {1, 2, 0}, {-0.5, 1, 0}};
  for (const auto& x : places) {
    add_bytes(text, static_cast<float>(x[0]), high_first);
    text += '\x07';
    add_bytes(text, x[1], high_first);
    add_bytes(text, static_cast<float>(x[2]), high_first);
  }
  text += '\x02';
  for (const std::int16_t end : {1, 2}) add_bytes(text, end, high_first);
  text += '\x05';
  for (const std::int32_t corner : {0, 1, 2, 3, 4}) add_bytes(text, corner, high_first);
  add_bytes(text, std::int16_t{-1}, high_first);
  text += '\x03';
  for (const std::int32_t corner : {0, 4, 1}) add_bytes(text, corner, high_first);
  add_bytes(text, std::int16_t{-1}, high_first);
  return text;
}

}  // namespace

TEST_CASE("PLY: text and both orders of bytes, faces of many corners as triangles", "[files]") {
  for (const bool high_first : {false, true}) {
    Remarks remarks;
    const auto m = read_ply("x.ply", binary_ply(high_first), &remarks);
    CHECK(m.nodes[2] == Vec3(3, 1.25, 0));
    CHECK(m.nodes[1].z() == 0.5);
    CHECK(m.elements == decltype(m.elements){{0, 1, 2, -1}, {0, 2, 3, -1}, {0, 3, 4, -1}, {0, 4, 1, -1}});
    CHECK(remarks ==
          Remarks{"x.ply: 1 face with more than four corners cut into triangles from the first corner"});
  }
  says(message_of([] { read_ply("x.ply", "plx\n"); }), "x.ply:1: expected a file that begins with 'ply'");
  says(message_of([] {
         read_ply("x.ply", "ply\nformat ascii 1.0\nelement face 999999999\nproperty int a\nend_header\n1");
       }),
       "expected a number of elements from 0 to");
  const std::string cut = binary_ply(false);
  says(message_of([&] { read_ply("x.ply", cut.substr(0, cut.size() - 9)); }), "x.ply: byte ");
}

TEST_CASE("OBJ: unknown lines are passed over and told, names have blanks, faces many corners", "[files]") {
  Remarks remarks;
  const auto m =
      read_obj("x.obj",
               "o my shirt\nv 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 2 0.5\nv -1 1 0\ncstype bezier\nf 1 2 3 4 5\n"
               "o the other\nv 0 -1 0\nf 1 6 2\nmg 1\n",
               &remarks);
  CHECK(m.elements == decltype(m.elements){{0, 1, 2, -1}, {0, 2, 3, -1}, {0, 3, 4, -1}, {0, 5, 1, -1}});
  CHECK(m.set("my shirt") == mesh::NodeSet{0, 1, 2, 3, 4});
  CHECK(m.set("the other") == mesh::NodeSet{0, 1, 5});
  CHECK(remarks ==
        Remarks{"x.obj:7: statement 'cstype' is not known and is passed over (2 such lines)",
                "x.obj: 1 face with more than four corners cut into triangles from the first corner"});
}

TEST_CASE("OBJ: a backslash at the end of a line goes on below, from Windows too", "[files]") {
  const auto m = read_obj(
      "x.obj", "v 0 0 \\\r\n0\r\nv 2 0 0\r\nv 3 1 0\r\nv 1 2 0\r\nf 1/1 \\ \n 2//3 \\\r\n3 4 # all\r\n");
  CHECK(m.nodes.size() == 4);
  CHECK(m.elements == decltype(m.elements){{0, 1, 2, 3}});
  CHECK(read_obj("x.obj", "v 0 0 0\nv 2 0 0\nv 3 1 0\nf 1 2 3 \\").elements ==
        decltype(m.elements){{0, 1, 2, -1}});
}

TEST_CASE("STL: facets without area are left out and told, thin ones are kept", "[files]") {
  const std::map<char, const char*> at = {
      {'a', "0 0 0"}, {'b', "1 0 0"}, {'c', "0.25 1 0"}, {'d', "0.1 0.4000001 0"}, {'e', "0.4 1e-5 0"}};
  const auto facet = [&](const char* corners) {
    std::string text = " facet normal 0 0 1\n  outer loop\n";
    for (const char* c = corners; *c != 0; ++c) text += std::string("vertex ") + at.at(*c) + "\n";
    return text + "endloop\nendfacet\n";
  };
  Remarks remarks;
  const auto m = read_stl(
      "x.stl",
      "solid\n" + facet("abc") + facet("aab") + facet("cbc") + facet("acd") + facet("aeb") + "endsolid\n",
      &remarks);
  CHECK(m.elements.size() == 2);
  CHECK(m.nodes.size() == 4);  // not what only a facet without area has
  CHECK(remarks == Remarks{"x.stl: 3 facets without area left out (corners at one place or on one line), the "
                           "first is facet 2"});
}

TEST_CASE("Gmsh: the parts of a mesh that is cut into partitions keep their groups", "[files]") {
  // surface 3 is cut into 4 and 5, curve 1 into 6: 4 has groups of its own, 5 and 6 those of the whole
  const auto m = read_gmsh(
      "x.msh",
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 7 \"left\"\n2 8 \"plate\"\n2 9 \"sheet\"\n"
      "$EndPhysicalNames\n$Entities\n0 1 1 0\n1 0 0 0 0 1 0 1 7 0\n3 0 0 0 2 1 0 1 9 1 1\n$EndEntities\n"
      "$PartitionedEntities\n2\n1\n1 2\n0 1 2 0\n6 1 1 1 1 0 0 0 0 1 0 0 0\n4 2 3 1 1 0 0 0 1 1 0 1 8 1 6\n"
      "5 2 3 2 1 2 1 0 0 2 1 0 0 0\n$EndPartitionedEntities\n"
      "$Nodes\n1 6 1 6\n2 4 0 6\n1\n2\n3\n4\n5\n6\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n$EndNodes\n"
      "$Elements\n3 3 1 3\n1 6 1 1\n1 1 4\n2 4 3 1\n2 1 2 5 4\n2 5 3 1\n3 2 3 6 5\n$EndElements\n");
  CHECK(m.set("left") == mesh::NodeSet{0, 3});
  CHECK(m.set("plate") == mesh::NodeSet{0, 1, 3, 4});
  CHECK(m.set("sheet") == mesh::NodeSet{1, 2, 4, 5});
}

TEST_CASE("a mesh of 20 m or of 20 um is asked about its units", "[files]") {
  const ScratchFolder folder;
  for (const double size : {20.0, 20e-6, 0.5}) {
    write_mesh(folder / "x.obj", mesh::rectangle(size, size / 3, 2, 2));
    Remarks remarks;
    read_mesh(folder / "x.obj", &remarks);
    REQUIRE(remarks.size() == (size == 0.5 ? 0 : 1));
    if (size != 0.5)
      says(remarks[0], size > 1 ? "the mesh spans 20 m, far from what cloth is: are its lengths in m?"
                                : "the mesh spans 2e-05 m, far from what cloth is");
  }
}

// A square of two facets, with 0 and -0 for one corner.
std::string binary_stl(const std::string& head) {
  std::string text = head + std::string(80 - head.size(), ' ');
  const auto add = [&text](auto value) { text.append(reinterpret_cast<const char*>(&value), sizeof value); };
  add(std::uint32_t{2});
  for (const std::array<float, 9>& facet : {std::array<float, 9>{0, 0, 0, 1, 0, 0, 1, 1, 0},
                                            std::array<float, 9>{-0.0f, 0, 0, 1, 1, 0, 0, 1, 0.1f}}) {
    for (int i = 0; i < 3; ++i) add(0.0f);
    for (const float x : facet) add(x);
    add(std::uint16_t{0});
  }
  return text;
}

TEST_CASE("STL: equal vertices are one node, in text and in bytes", "[files]") {
  for (const char* head : {"a binary file", "solid like a text"}) {
    const auto m = read_stl("x.stl", binary_stl(head));
    CHECK(m.nodes.size() == 4);
    CHECK(m.elements == decltype(m.elements){{0, 1, 2, -1}, {0, 2, 3, -1}});
    CHECK(m.nodes[3] == Vec3(0, 1, double(0.1f)));
  }
  const std::string facet =
      " facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1e0 0 0\n   vertex 1 1 0\n"
      "  endloop\n endfacet\n";
  CHECK(read_stl("x.stl", "solid one two\n" + facet + "endsolid one two\n").sets.size() == 2);
  const auto both =
      read_stl("x.stl", "solid one two\n" + facet + "endsolid\nsolid\nendsolid\nsolid b\r\n" +
                            " facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\n"
                            "endloop\nendfacet\nendsolid b");
  CHECK(both.set("one two") == mesh::NodeSet{0, 1, 2});
  CHECK(both.set("b") == mesh::NodeSet{0, 2, 3});
}

TEST_CASE("Abaqus: commas, numbers and names of sets within quotes", "[files]") {
  const auto mesh = read_abaqus(
      "x.inp",
      "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n*ELEMENT, TYPE=S3\n1,1,2,3\n*NSET, NSET=\"x, y\"\n1, 2\n"
      "*NSET, NSET=\"3\"\n1\n*NSET, NSET=both\n\"X, Y\", 3\n*NSET, NSET=named\n\"3\", \"x, y\"\n");
  CHECK(mesh.set("x, y") == mesh::NodeSet{0, 1});
  CHECK(mesh.set("both") == mesh::NodeSet{0, 1, 2});
  CHECK(mesh.set("named") == mesh::NodeSet{0, 1});
  CHECK(mesh.set("3") == mesh::NodeSet{0});
}

TEST_CASE("Abaqus: one part in an assembly, sets of sets, names in quotes", "[files]") {
  const auto m = read_abaqus(
      "x.inp",
      "*PART, NAME=sheet\n*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n*ELEMENT,TYPE=M3D3,ELSET=e\n7,1,2,3\n*END PART\n"
      "*ASSEMBLY, NAME=a\n*INSTANCE, NAME=s, PART=sheet\n0., 0., 0.\n*END INSTANCE\n"
      "*NSET, NSET=\"the grip\", INSTANCE=s\n1, s.2\n*NSET, NSET=b\nThe Grip\n*NSET, NSET=of, ELSET=E\n*END "
      "ASSEMBLY\n");
  CHECK(m.set("the grip") == mesh::NodeSet{0, 1});
  CHECK(m.set("b") == mesh::NodeSet{0, 1});
  CHECK(m.set("of") == mesh::NodeSet{0, 1, 2});
}

TEST_CASE("LS-DYNA: parts are sets where there are several", "[files]") {
  const std::string nodes =
      "*KEYWORD\n*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,1,1,0\n*ELEMENT_SHELL\n1,1,1,2,3\n2,5,2,4,3,3\n";
  const auto m = read_dyna("x.k", nodes + "*PART\nthe tip\n5,1,1\n*SET_NODE_COLUMN\n9\n4\n2\n*END\n");
  CHECK(m.set("part_1") == mesh::NodeSet{0, 1, 2});
  CHECK(m.set("the tip") == mesh::NodeSet{1, 2, 3});
  CHECK(m.set("set_9") == mesh::NodeSet{1, 3});
}

TEST_CASE("OpenRadioss: lengths in the units of the deck, groups of groups", "[files]") {
  const auto field = [](int width, const std::string& text) {
    return std::string(static_cast<std::size_t>(width) - text.size(), ' ') + text;
  };
  const auto ints = [&](std::initializer_list<int> numbers) {
    std::string line;
    for (const int number : numbers) line += field(10, std::to_string(number));
    return line + "\n";
  };
  const std::string mesh = "/NODE\n" + ints({1}) + ints({2}).substr(0, 10) + field(20, "250.") + "\n" +
                           ints({4}).substr(0, 10) + field(20, "0.25E3") + field(20, "500") + "\n/SHELL/1\n" +
                           ints({9, 1, 2, 4, 4}) + "/GRSHEL/GEN_INCR/5\n\n" + ints({7, 11, 2}) +
                           "/GRNOD/GRSHEL/1\nshells\n" + ints({5}) + "/GRNOD/GRNOD/2\nboth\n" + ints({3, 1}) +
                           "/GRNOD/NODE/3\ntwo\n" + ints({2}) + "/PART/1\n\n" + ints({1}) + "/END\n";
  const auto begin = [&](const std::string& first, const std::string& second) {
    return "#RADIOSS STARTER\n/BEGIN\nx\n" + ints({2022, 0}) + first + "\n" + second + "\n";
  };
  const std::string work = field(20, "kg") + field(20, "cm") + field(20, "ms");
  for (const auto& [text, length] :
       {std::pair{mesh, 1.0}, std::pair{begin("Mg mm s", work) + mesh, 1e-3},
        std::pair{begin("", work) + mesh, 1e-2}, std::pair{begin("1 0.0254 1", work) + mesh, 0.0254}}) {
    const auto m = read_radioss("x.rad", text);
    CHECK(m.nodes[1] == Vec3(length * 250, 0, 0));
    CHECK(m.nodes[2] == Vec3(length * 250, length * 500, 0));
    CHECK(m.elements == std::vector<std::array<mesh::Index, 4>>{{0, 1, 2, -1}});
    CHECK(m.set("two") == mesh::NodeSet{1});
    CHECK(m.set("group_5") == mesh::NodeSet{0, 1, 2});
    CHECK(m.set("both") == mesh::NodeSet{0, 1, 2});
    CHECK(m.set("shells") == mesh::NodeSet{0, 1, 2});
  }
  auto circle = mesh;
  circle.replace(circle.find("/GRNOD/NODE/3"), 13, "/GRNOD/GRNOD/3");
  says(message_of([&] { read_radioss("x.rad", circle); }),
       "group 'nodes 3' is made of others further down: expected groups in the order in which they are used");
}

TEST_CASE("names that cannot be written or read by their ending", "[files]") {
  const ScratchFolder folder;
  const auto m = samples::plate();
  says(message_of([&] { write_mesh(folder / "x.step", m); }),
       "expected a name that ends in .msh, .vtu, .obj, .stl, .ply, .inp, .k or .rad");
  says(message_of([&] { read_mesh("x.igs"); }),
       "expected a name that ends in .msh, .vtu, .vtk, .obj, .stl, .ply, .inp, .k, .key or .rad");
  says(message_of([&] { read_mesh(folder / "none.msh"); }), "No such file or directory");
  says(message_of([&] { read_mesh("/dev/null/x.msh"); }), "Not a directory");
  std::filesystem::create_directory(folder / "folder.msh");
  says(message_of([&] { read_mesh(folder / "folder.msh"); }), "it is a folder");
  says(message_of([&] { write_mesh(folder / "x.vtu", mesh::Mesh()); }), "no element");
  auto odd = m;
  odd.define("a \"b\"", mesh::NodeSet{1});
  says(message_of([&] { write_mesh(folder / "x.msh", odd); }), "does not go into a Gmsh file");
  says(message_of([&] { write_mesh(folder / "x.k", odd); }), "does not go into a deck");
  auto two = m;
  two.define("Left", mesh::NodeSet{1});
  says(message_of([&] { write_mesh(folder / "x.inp", two); }),
       "sets 'Left' and 'left' are one in a deck of Abaqus");
  write_mesh(folder / "X.VTU", odd);
  CHECK(read_mesh(folder / "X.VTU").set("a \"b\"") == mesh::NodeSet{1});
}

TEST_CASE("integers on points and cells become sets by value", "[files]") {
  const std::string head =
      "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 1 1 0 0 1 0\n"
      "POLYGONS 1 5\n4 0 1 2 3\n";
  const auto m =
      read_legacy_vtk("x.vtk", head +
                                   "POINT_DATA 4\nSCALARS region int 1\nLOOKUP_TABLE default\n5 7 7 5\n"
                                   "SCALARS id int\nLOOKUP_TABLE t\n9 8 7 6\nLOOKUP_TABLE t 1\n0 0 0 1\n"
                                   "FIELD f 1\nnone%20at%20all 1 4 int\n0 0 0 0\n");
  CHECK(m.set("region_5") == mesh::NodeSet{0, 3});
  CHECK(m.set("region_7") == mesh::NodeSet{1, 2});
  CHECK(m.sets.size() == 4);  // with all and boundary
}

TEST_CASE("Gmsh: groups without a name, one name for two groups, sections of no interest", "[files]") {
  std::string text = samples::gmsh_2;
  text.erase(text.find("$PhysicalNames"), text.find("$Nodes") - text.find("$PhysicalNames"));
  text.insert(text.find("$Nodes"), "$Comments\n$ any 1 2 3\n$EndComments\n");
  const auto bare = read_gmsh("x.msh", text);
  CHECK(bare.set("curve_7").size() == 2);
  CHECK(bare.set("surface_9").size() == 6);
  text = samples::gmsh_4;
  text.replace(text.find("\"left\""), 6, "\"plate\"");
  CHECK(read_gmsh("x.msh", text).sets.size() == 3);
}
