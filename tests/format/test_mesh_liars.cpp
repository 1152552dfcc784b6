// Files that lie, that end too early, or that are no mesh at all: an Error that names the file, and nothing
// else.
#include <sys/resource.h>

#include "draws.hpp"
#include "format/frame_file.hpp"
#include "format/mesh_file.hpp"
#include "mesh_samples.hpp"
#include "message_of.hpp"
#include "scratch.hpp"
#include "system/atomic.hpp"

using namespace fabricsh;
using namespace fabricsh::format;
using fabricsh::test::draws;

namespace {

mesh::Mesh read(const std::string& name, const std::string& bytes, Remarks* remarks = nullptr) {
  if (name.ends_with(".msh")) return read_gmsh(name, bytes);
  if (name.ends_with(".obj")) return read_obj(name, bytes, remarks);
  if (name.ends_with(".inp")) return read_abaqus(name, bytes, remarks);
  if (name.ends_with(".k")) return read_dyna(name, bytes, remarks);
  if (name.ends_with(".rad")) return read_radioss(name, bytes, remarks);
  if (name.ends_with(".stl")) return read_stl(name, bytes);
  return name.ends_with(".vtu") ? read_vtu(name, bytes) : read_legacy_vtk(name, bytes);
}

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const auto at = text.find(part);
  REQUIRE(at != std::string::npos);
  return text.replace(at, part.size(), by);
}

// Every index inside, every number finite.
void check_valid(const mesh::Mesh& m) {
  const auto n = static_cast<mesh::Index>(m.nodes.size());
  bool good = !m.elements.empty();
  for (const Vec3& x : m.nodes) good = good && x.allFinite();
  for (const auto& ids : m.elements)
    for (std::size_t i = 0; i < 4; ++i) good = good && ids[i] < n && ids[i] >= (i == 3 ? -1 : 0);
  for (const auto& [name, ids] : m.sets) good = good && !ids.empty() && ids.front() >= 0 && ids.back() < n;
  CHECK(good);
}

// Reads what may be damaged: a mesh that is valid, or an Error that begins with the name of the file.
void survive(const std::string& name, const std::string& bytes) {
  try {
    check_valid(read(name, bytes));
  } catch (const Error& error) {
    CHECK(std::string(error.what()).starts_with(name + ":"));
  }
}

struct Liar {
  std::string name, from, to, says;
};

const std::string grid =
    "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 1 0 0 1 1 0 0 1 "
    "0\n"
    "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n9\nPOINT_DATA 4\nSCALARS s int 1\nLOOKUP_TABLE default\n0 1 0 1\n";

const std::string xml =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
    "byte_order=\"LittleEndian\">\n"
    "<UnstructuredGrid>\n<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">\n<Points>\n"
    "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 1 1 0 0 1 "
    "0</DataArray>\n"
    "</Points>\n<Cells>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 "
    "3</DataArray>\n"
    "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">4</DataArray>\n"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">9</DataArray>\n</Cells>\n</Piece>\n"
    "</UnstructuredGrid>\n</VTKFile>\n";

const std::string& base(const std::string& name) {
  if (name == "2.msh") return samples::gmsh_2;
  if (name == "4.msh") return samples::gmsh_4;
  if (name == "x.obj") return samples::obj;
  if (name == "x.inp") return samples::abaqus;
  if (name == "x.k") return samples::dyna;
  if (name == "x.rad") return samples::radioss;
  if (name == "x.stl") return samples::stl;
  return name == "x.vtu" ? xml : grid;
}

}  // namespace

TEST_CASE("the samples are good before they are spoilt", "[files]") {
  for (const char* name : {"2.msh", "4.msh", "x.obj", "x.inp", "x.k", "x.rad", "x.stl", "x.vtu", "x.vtk"})
    check_valid(read(name, base(name)));
}

TEST_CASE("liars are told by name and line", "[files]") {
  const std::vector<Liar> liars = {
      {"2.msh", "$MeshFormat", "MeshFormat", "2.msh:1: expected a Gmsh file"},
      {"2.msh", "2.2 0 8", "4.0 0 8", "2.msh:2: expected format 2.2 or 4.1"},
      {"2.msh", "2.2 0 8", "2.2 2 8", "expected the file type 0 (text) or 1 (binary), got 2"},
      {"2.msh", "2.2 0 8", "2.2 0 16", "expected numbers of 8 bytes, got 16"},
      {"2.msh", "2.2 0 8", "2.2 1 8", "expected the number 1 in binary"},
      {"2.msh", "$EndMeshFormat", "$EndMesh", "expected $EndMeshFormat, got '$EndMesh'"},
      {"2.msh", "$Nodes\n8", "$Nodes\n8000000000000", "2.msh:10: expected a number of nodes from 0 to"},
      {"2.msh", "$Nodes\n8", "$Nodes\n-8", "2.msh:10: expected a number of nodes from 0 to"},
      {"2.msh", "$Nodes\n8", "$Nodes\n99999999999999999999", "got '99999999999999999999'"},
      {"2.msh", "$Nodes\n8", "$Nodes\n7", "expected $EndNodes, got '99'"},
      {"2.msh", "$Nodes\n8", "$Nodes\n9", "expected the number of a node, a whole number, got '$EndNodes'"},
      {"2.msh", "12 2 0 0.125", "12 2 0 nan", "2.msh:13: node 12: a coordinate is not finite"},
      {"2.msh", "12 2 0 0.125", "12 2 0 1e999", "2.msh:13: expected a coordinate, a number, got '1e999'"},
      {"2.msh", "12 2 0 0.125", "11 2 0 0.125", "2.msh:13: node 11 is defined twice"},
      {"2.msh", "1 10 11 14 13", "1 10 11 14 77", "2.msh:24: element 3: node 77 is not in the file"},
      {"2.msh", "1 10 11 14 13", "1 10 11 14 10", "element 3: node 10 is in it twice"},
      {"2.msh", "3 3 2 9 1", "3 16 2 9 1", "element type 16 is of second order"},
      {"2.msh", "3 3 2 9 1", "3 5 2 9 1", "element type 5 is a volume"},
      {"2.msh", "3 3 2 9 1", "3 4711 2 9 1", "unknown element type 4711"},
      {"2.msh", "3 3 2 9 1", "3 3 1000000 9 1", "expected a number of tags from 0 to"},
      {"2.msh", "$Elements", "$Elephants", "has no end"},
      {"2.msh", "$EndElements\n", "", "the file ends where $EndElements should be"},
      {"2.msh", "$EndElements\n", "$EndElements\n$Nodes\n", "a second section $Nodes"},
      {"2.msh", "\"left\"", "left", "expected a name in quotes"},
      {"4.msh", "$Entities\n1 1 2 0", "$Entities\n1 1 2000000 0",
       "4.msh:10: expected a number of entities from 0"},
      {"4.msh", "0 1 0 1 7", "0 1 0 1000000 7", "expected a number of physical groups from 0"},
      {"4.msh", "3 8 10 99", "3 9 10 99", "expected 9 nodes in all, got 8"},
      {"4.msh", "2 1 0 6", "2 1 0 600000000", "expected a number of nodes from 0"},
      {"4.msh", "2 1 0 6", "2 1 7 6", "expected 0 or 1 for parametric, got 7"},
      {"4.msh", "2 1 0 6", "9 1 0 6", "expected a dimension from 0 to 3, got 9"},
      {"4.msh", "4 5 1 5", "4 4 1 5", "expected 4 elements in all, got 5"},
      {"4.msh", "2 1 3 2", "1 1 3 2", "expected elements of dimension 2, got 1"},
      {"4.msh", "2 1 3 2", "2 1 3 20000000", "expected a number of elements from 0"},
      {"x.obj", "v 1 0 0", "v 1 0", "x.obj:5: expected three coordinates, got ''"},
      {"x.obj", "v 1 0 0", "v 1 0 inf", "x.obj:5: node 2: a coordinate is not finite"},
      {"x.obj", "f 3 7 6", "f 3 7 8", "x.obj:21: vertex '8' is not above this line"},
      {"x.obj", "f 3 7 6", "f 3 7 0", "vertex '0' is not above this line"},
      {"x.obj", "f 3 7 6", "f 3 7 -9", "vertex '-9' is not above this line"},
      {"x.obj", "f 3 7 6", "f 3 7", "expected a face of 3 corners or more, got 2"},
      {"x.obj", "f 3 7 6", "f 1 3 7 5 6",
       "x.obj:21: a face of 5 corners that is not convex: cut it into triangles"},
      {"x.obj", "f 3 7 6", "f 3 7 x", "expected the number of a vertex, got 'x'"},
      {"x.inp", "11, 1., 0., 0", "11, 1., O., 0", "x.inp:6: node 11: expected a coordinate, got 'O.'"},
      {"x.inp", "11, 1., 0., 0", "11 1. 0. 0",
       "x.inp:6: expected the number of a node, a whole number, got '11 1. 0. 0'"},
      {"x.inp", "11, 1., 0., 0", "10, 1., 0., 0", "x.inp:6: node 10 is defined twice"},
      {"x.inp", "2, 11, 12, 15, 14", "2, 11, 12, 15, 77", "x.inp:17: element 2: node 77 is not in the file"},
      {"x.inp", "2, 11, 12, 15, 14", "1, 11, 12, 15, 14", "x.inp:17: element 1 is defined twice"},
      {"x.inp", "2, 11, 12, 15, 14", "2, 11, 12, 15",
       "x.inp:17: expected the number of an element and 4 nodes, got 4 numbers"},
      {"x.inp", "2, 11, 12, 15, 14", "2, 11, 12, 15, 14, 13", "and 4 nodes, got 6 numbers"},
      {"x.inp", "2, 11, 12, 15, 14", "2, 11, 12, 15,", "x.inp:18: expected the rest of the element above"},
      {"x.inp", "type=S4R", "type=C3D8", "x.inp:14: *ELEMENT, TYPE='C3D8': expected a shell or membrane"},
      {"x.inp", "type=S4R", "shape=S4R", "x.inp:14: *ELEMENT: expected TYPE=..."},
      {"x.inp", "*Node, nset=all", "*Node, system=C", "*NODE, SYSTEM=C: expected rectangular coordinates"},
      {"x.inp", "10, 13, 3", "10, 13, 0", "x.inp:23: expected a step other than 0"},
      {"x.inp", "10, 13, 3", "10", "x.inp:23: expected first, last and step, got '10'"},
      {"x.inp", "10, 13, 3", "1, 999999999999", "x.inp:23: a range from 1 to 999999999999"},
      {"x.inp", "PLATE, tip", "PLATE, top", "x.inp:25: there is no set 'TOP' of elements"},
      {"x.inp", "14, 15, 16\n*MAT", "14, 15, 17\n*MAT", "x.inp:28: node 17 is not in the file"},
      {"x.inp", "*NSET, NSET=boundary", "*NSET", "x.inp:26: *NSET: expected NSET=a name"},
      {"x.inp", "*MATERIAL, NAME=cloth", "*INCLUDE, INPUT=more.inp",
       "x.inp:29: *INCLUDE takes lines from another file"},
      {"x.inp", "*Heading", "*NGEN", "x.inp:1: *NGEN makes or moves nodes or elements"},
      {"x.k", "1.0             1.0             0.0", "1.0             one             0.0",
       "x.k:10: node 14: expected a coordinate, got 'one' in columns 25 to 40"},
      {"x.k", "      10      11      14      13", "      10      11      14      77",
       "x.k:17: element 1: node 77 is not in the file"},
      {"x.k", "      12      16      15      15", "      12      16      15      15      14",
       "x.k:23: element 3 has more than 4 nodes"},
      {"x.k", "      12      16      15      15", "      12",
       "x.k:23: expected element, part and 3 or 4 nodes"},
      {"x.k", "SHELL_THICKNESS", "SHELL_COMPOSITE",
       "x.k:16: *ELEMENT_SHELL_COMPOSITE: expected *ELEMENT_SHELL, alone or with"},
      {"x.k", "*PART", "*ELEMENT_SOLID",
       "x.k:32: *ELEMENT_SOLID: expected *ELEMENT_SHELL, with 3 or 4 nodes"},
      {"x.k", "*PART", "*INCLUDE", "*INCLUDE takes lines from another file"},
      {"x.k", "*SET_NODE_LIST_TITLE", "*SET_NODE_ADD",
       "x.k:24: *SET_NODE_ADD: expected *SET_NODE or *SET_SHELL with"},
      {"x.k", "        10        13         0", "        10        77         0",
       "x.k:27: node 77 is not in the file"},
      {"x.rad", "        14                   1                   1                   0",
       "        14                   1                 one                   0",
       "x.rad:15: node 14: expected a coordinate, got 'one' in columns 31 to 50"},
      {"x.rad", "         1        10        11        14        13",
       "         1        10        11        14        77",
       "x.rad:21: element 1: node 77 is not in the file"},
      {"x.rad", "         3        12        16        15", "         3        12        16",
       "x.rad:24: expected element and 3 nodes, got"},
      {"x.rad", "         3        12        16        15", "         1        12        16        15",
       "x.rad:24: element 1 is defined twice"},
      {"x.rad", "/MAT/ELAST", "/BRICK", "x.rad:41: /BRICK: expected /SHELL and /SH3N, and no other elements"},
      {"x.rad", "/MAT/ELAST", "/TRANSFORM", "/TRANSFORM makes or moves nodes"},
      {"x.rad", "/MAT/ELAST", "/", "a submodel (//), which is not read"},
      {"x.rad", "$ shells", "#include more.inc", "x.rad:19: #include takes lines from another file"},
      {"x.rad", "                  kg                   m                   s",
       "                  kg                 ell                   s",
       "x.rad:6: expected a unit of length, m with a prefix or a number of metres, got 'ell'"},
      {"x.rad", "                  kg                   m                   s",
       "                  kg                   m", "x.rad:6: expected units of mass, length and time, got"},
      {"x.rad", "      2022         0", "        44         0",
       "x.rad:5: expected a deck of version 51 of the format or later, got 44"},
      {"x.rad", "/NODE\n", "/NODE/5\n", "x.rad:10: /NODE has units of its own (/UNIT/5)"},
      {"x.rad", "/TITLE", "/BEGIN", "expected /BEGIN once, before all nodes"},
      {"x.rad", "        10        13\n", "        10       -13\n",
       "x.rad:30: the group takes members away (-13)"},
      {"x.rad", "        10        13\n", "        10        77\n", "x.rad:30: node 77 is not in the file"},
      {"x.rad", "all\n         7\n", "all\n         9\n", "x.rad:33: there is no set 'part 9' of elements"},
      {"x.stl", "vertex 1 0 0", "vertex 1 0 x", "x.stl:5: expected a coordinate, a number, got 'x'"},
      {"x.stl", "endfacet\nendsolid one", "endfacet\nend one",
       "x.stl:9: expected facet or endsolid, got 'end'"},
      {"x.stl", "outer", "inner", "x.stl:3: expected outer, got 'inner'"},
      {"x.stl", "solid one\nfacet", "lumpy one\nfacet", "x.stl: byte "},
      {"x.vtk", "# vtk", "% vtk", "x.vtk:1: expected a .vtk file"},
      {"x.vtk", "3.0", "9.0", "expected version 1 to 5"},
      {"x.vtk", "ASCII", "ASKEY", "expected ASCII or BINARY, got 'askey'"},
      {"x.vtk", "UNSTRUCTURED_GRID", "STRUCTURED_GRID", "x.vtk:4: expected the dataset"},
      {"x.vtk", "POINTS 4", "POINTS 400000000000", "got 400000000000 x 3"},
      {"x.vtk", "POINTS 4", "POINTS -4", "got -4 x 3"},
      {"x.vtk", "4 double", "4 string", "expected a type of numbers (int, float, double, ...), got 'string'"},
      {"x.vtk", "4 0 1 2 3", "4 0 1 2 4", "cell 0: expected points from 0 to 3, got 4"},
      {"x.vtk", "4 0 1 2 3", "5 0 1 2 3", "cell 0: expected from 0 to 4 corners, got 5"},
      {"x.vtk", "4 0 1 2 3", "-1 0 1 2 3", "cell 0: expected from 0 to 4 corners, got -1"},
      {"x.vtk", "4 0 1 2 3", "3 0 1 2 3", "the cells have 4 numbers, expected 5"},
      {"x.vtk", "CELL_TYPES 1\n9", "CELL_TYPES 1\n23", "cell 0 is of second order (type 23)"},
      {"x.vtk", "CELL_TYPES 1\n9", "CELL_TYPES 1\n12", "got type 12"},
      {"x.vtk", "CELL_TYPES 1\n9", "CELL_TYPES 1\n5", "cell 0: expected 3 corners, got 4"},
      {"x.vtk", "CELL_TYPES 1\n9", "CELL_TYPES 2\n9 9", "expected a type for each of 1 cells, got 2"},
      {"x.vtk", "POINT_DATA 4", "POINT_DATA 5", "expected data of 4 points, got 5"},
      {"x.vtk", "0 1 0 1\n", "0 1 0\n", "the file ends where a value should be"},
      {"x.vtu", "<?xml", "<!DOCTYPE x>\n<?xml", "x.vtu:1: expected a tag of XML"},
      {"x.vtu", "?>", "", "x.vtu:1: a comment or instruction has no end"},
      {"x.vtu", "<VTKFile", "<File", "expected <VTKFile>, got <File>"},
      {"x.vtu", "UnstructuredGrid\"", "PolyData\"",
       "expected a file of type UnstructuredGrid, got 'PolyData'"},
      {"x.vtu", "NumberOfPoints=\"4\"", "NumberOfPoints=\"400000000\"", "for each of 400000000 points"},
      {"x.vtu", "NumberOfPoints=\"4\"", "NumberOfPoints=\"-4\"", "x.vtu:4: <Piece>: expected NumberOfPoints"},
      {"x.vtu", "NumberOfPoints=\"4\"", "NumberOfPoints=4", "x.vtu:4: expected name=\"value\""},
      {"x.vtu", "NumberOfCells=\"1\"", "NumberOfCells=\"2\"", "expected 2 offsets of cells, got 1"},
      {"x.vtu", "1 1 0 0 1 0", "1 1 0 0 1 nan", "node 3: a coordinate is not finite"},
      {"x.vtu", "1 1 0 0 1 0", "1 1 0 0 1 zero", "x.vtu:6: expected a number, got 'zero'"},
      {"x.vtu", "0 1 2 3<", "0 1 2 4<", "cell 0: expected points from 0 to 3, got 4"},
      {"x.vtu", "0 1 2 3<", "0 1 2 -1<", "cell 0: expected points from 0 to 3, got -1"},
      {"x.vtu", ">4<", ">5<", "cell 0: expected an offset from 0 to 4, got 5"},
      {"x.vtu", ">4<", ">3<", "the cells have 3 corners in all, but the connectivity has 4"},
      {"x.vtu", ">9<", ">28<", "cell 0 is of second order (type 28)"},
      {"x.vtu", "</Points>", "</Piece>", "x.vtu:7: </Piece> closes nothing, expected </Points>"},
      {"x.vtu", "\"offsets\" format=\"ascii\"", "\"offsets\" format=\"appended\" offset=\"0\"",
       "expected an offset below 0"},
      {"x.vtu", "\"offsets\" format=\"ascii\">4",
       "\"offsets\" format=\"binary\">/////w==", "claims 4294967295 bytes"},
      {"x.vtu", "Int64\" Name=\"offsets", "Float64\" Name=\"offsets",
       "expected an array of integers, got 'Float64'"},
      {"x.vtu", "byte_order", "compressor=\"gzip\" byte_order", "unknown compressor 'gzip'"},
  };
  CHECK(liars.size() > 30);
  for (const Liar& liar : liars) {
    INFO(liar.name << ": " << liar.from << " -> " << liar.to);
    const std::string text = replaced(base(liar.name), liar.from, liar.to);
    const std::string message = message_of([&] { read(liar.name, text); });
    says(message, liar.says);
    CHECK(message.starts_with(liar.name + ":"));
  }
}

TEST_CASE("a compressed array that claims too much is refused before anything is made for it", "[files]") {
  // [1 block][size][last, 0][compressed size 1], little-endian words of 4 bytes.
  samples::Bytes header;
  header.add<std::uint32_t>({1, 0xFFFFFFF0u, 0, 1}).words("x");
  std::string text = replaced(xml, "byte_order", "compressor=\"vtkZLibDataCompressor\" byte_order");
  text = replaced(text, "</UnstructuredGrid>",
                  "</UnstructuredGrid><AppendedData encoding=\"raw\">_" + header.text);
  text = replaced(text, "\"offsets\" format=\"ascii\"", "\"offsets\" format=\"appended\" offset=\"0\"");
  says(message_of([&] { read_vtu("x.vtu", text); }), "claims more bytes than it can hold");
}

TEST_CASE("groups that repeat all nodes without end are refused", "[files]") {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\ng";
  for (int i = 0; i < 1000; ++i) text += " " + std::to_string(i);
  for (int i = 0; i < 1000; ++i) text += "\nf 1 2 3";
  says(message_of([&] { read_obj("x.obj", text); }), "more members than a file of this size can name");
}

// From one byte that is tried to the next: all of them, or the share of the draws.
std::size_t stride(const std::string& content) {
  const int size = static_cast<int>(content.size());
  return static_cast<std::size_t>(size / draws(size));
}

TEST_CASE("a file that ends anywhere is an error or a mesh", "[files]") {
  for (const auto& [name, content] : samples::every()) {
    INFO(name);
    for (std::size_t n = 0; n < content.size(); n += stride(content)) survive(name, content.substr(0, n));
  }
}

// The message on a file: why it is refused, or the one remark on it; empty: nothing.
std::string said_of(const std::string& name, const std::string& bytes) {
  Remarks remarks;
  try {
    read(name, bytes, &remarks);
  } catch (const Error& error) {
    return error.what();
  }
  CHECK(remarks.size() <= 1);
  return remarks.empty() ? "" : remarks.front();
}

TEST_CASE("a deck that was cut short is refused or remarked on", "[files]") {
  for (const char* name : {"x.obj", "x.inp", "x.k", "x.rad"}) CHECK(said_of(name, base(name)).empty());
  for (std::size_t n = 1; n < base("x.k").find("*END") + 4; ++n) {
    INFO("x.k: " << n);
    CHECK(said_of("x.k", base("x.k").substr(0, n)).starts_with("x.k:"));
  }
  for (std::size_t n = 1; n < base("x.rad").find("/END") + 4; ++n) {
    INFO("x.rad: " << n);
    CHECK(said_of("x.rad", base("x.rad").substr(0, n)).starts_with("x.rad:"));
  }
  // These two need no last line: what ends between two lines is a file, outside of what the first has to
  // close.
  for (const char* name : {"x.obj", "x.inp"}) {
    const std::string& text = base(name);
    const std::size_t step = std::min(text.find("*STEP"), text.size());
    for (std::size_t n = 1; n + 1 < text.size(); ++n) {
      const std::size_t line = text.rfind('\n', n - 1) + 1;
      const bool between = line == n;
      INFO(name << ": " << n);
      if (!between || n > step + 5) CHECK(said_of(name, text.substr(0, n)).starts_with(name));
    }
  }
}

TEST_CASE("messages on a deck that ends early, and on one that need not end later", "[files]") {
  const std::string part = "; if the file was cut short, part of the mesh is missing";
  const std::string nodes = "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n",
                    inp = nodes + "*ELEMENT, TYPE=S3, ELSET=e\n1,1,2,3";
  CHECK(said_of("x.inp", inp) == "x.inp:6: the last line has no end" + part);
  CHECK(said_of("x.inp", inp + "\n").empty());
  CHECK(said_of("x.inp", inp + "\n** a comment\n").empty());
  CHECK(said_of("x.inp", inp + "\n** a com") == "x.inp:7: the last line has no end" + part);
  CHECK(said_of("x.inp", inp + "\n   ").empty());
  CHECK(said_of("x.inp", inp + "\n*NSET, NSET=a\n1, 2").starts_with("x.inp:8: the last line has no end"));
  CHECK(said_of("x.inp", inp + "\n*ELEM").starts_with("x.inp:7: the last line has no end"));
  const std::string without = ": the file ends without *END ";
  CHECK(said_of("x.inp", inp + "\n*STEP\n*STATIC\n").starts_with("x.inp:9" + without + "STEP;"));
  for (const char* end : {"*END STEP", "*ENDSTEP", "*End  Step", "* endstep", "*END STEP\n** cut comm"})
    CHECK(said_of("x.inp", inp + "\n*STEP\n*STATIC\n" + end).empty());
  CHECK(said_of("x.inp", inp + "\n*STEP\n*STATIC\n*ENDSTEPS\n").starts_with("x.inp:10" + without + "STEP;"));
  CHECK(said_of("x.inp", "*PART, NAME=p\n" + inp + "\n").starts_with("x.inp:8" + without + "PART;"));
  CHECK(said_of("x.inp", "*PART, NAME=p\n" + inp + "\n*END PART\n*ASSEMBLY, NAME=a\n*INSTANCE, PART=p\n")
            .starts_with("x.inp:11" + without + "INSTANCE;"));
  const std::string k = "*KEYWORD\n" + nodes + "*ELEMENT_SHELL\n1,1,1,2,3";
  CHECK(said_of("x.k", k + "\n") ==
        "x.k:8: the file ends without *END; if it was cut short, part of the mesh is missing");
  for (const char* end : {"*end", "*END$", "*END $ of the file"})
    CHECK(said_of("x.k", k + "\n" + end).empty());
  CHECK(said_of("x.k", k + "\n*ENDING\n").starts_with("x.k:9" + without.substr(0, without.size() - 1)));
  const std::string remarked =
      "*KEYWORD $ 1\n*NODE $ 2\n1,0,0,0\n2,1,0,0\n3,0,1,0\n*ELEMENT_SHELL $ 3\n1,1,1,2,3\n*END";
  CHECK(said_of("x.k", remarked).empty());
  CHECK(said_of("x.k", k + "\n*END\nanything").empty());
  const std::string rad =
      "/NODE\n         1\n         2                   1\n         3                   1" +
      std::string(19, ' ') + "1\n/SH3N/1\n         1         1         2         3";
  CHECK(said_of("x.rad", rad) == "x.rad:6: the last line has no end" + part);
  CHECK(said_of("x.rad", rad + "\n").empty());
  CHECK(
      said_of("x.rad", "/BEGIN\nx\n\n\n\n" + rad + "\n").starts_with("x.rad:12: the file ends without /END"));
  CHECK(said_of("x.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3") ==
        "x.obj:5: the last line has no end" + part);
  CHECK(said_of("x.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n# half a com") ==
        "x.obj:5: the last line has no end" + part);
}

TEST_CASE("a file with any one byte changed is an error or a mesh", "[files]") {
  for (const auto& [name, content] : samples::every()) {
    INFO(name);
    unsigned random = 1;
    for (std::size_t i = 0; i < content.size(); i += stride(content)) {
      random = random * 1664525u + 1013904223u;
      std::string changed = content;
      changed[i] = static_cast<char>(random >> 24);
      survive(name, changed);
      changed[i] = '9';
      survive(name, changed);
    }
  }
}

TEST_CASE("an .stl or a frame of a series with any one byte changed is an error or whole", "[files]") {
  const auto changed = [](const std::string& content, const std::function<void(const std::string&)>& look) {
    unsigned random = 1;
    for (std::size_t i = 0; i < content.size(); ++i) {
      random = random * 1664525u + 1013904223u;
      std::string text = content;
      text[i] = static_cast<char>(random >> 24);
      look(text);
      look(content.substr(0, i));
    }
  };
  changed(samples::stl, [](const std::string& text) { survive("x.stl", text); });
  changed(xml, [](const std::string& text) {
    try {
      const FrameFile frame = read_vtu_frame("x.vtu", text, {});
      bool good = true;
      for (const auto& cell : frame.cells)
        for (std::size_t k = 0; k < 4; ++k)
          good =
              good && cell[k] < static_cast<mesh::Index>(frame.points.size()) && cell[k] >= (k == 3 ? -1 : 0);
      CHECK(good);
    } catch (const Error& error) {
      CHECK(std::string(error.what()).starts_with("x.vtu:"));
    }
  });
}

TEST_CASE("no mesh at all", "[files]") {
  const ScratchFolder folder;
  for (const char* name : {"x.msh", "x.obj", "x.inp", "x.k", "x.rad", "x.stl", "x.vtu", "x.vtk"}) {
    INFO(name);
    system::write_file(folder / name, "", system::Sync::no);
    CHECK(message_of([&] { read_mesh(folder / name); }) == folder / name + ": the file is empty");
    for (const std::string& junk :
         {std::string(" \n"), std::string(5000, '\0'), std::string(5000, '\xFF'), std::string(100000, '<'),
          std::string("\x7F"
                      "ELF\x02\x01\x01")}) {
      system::write_file(folder / name, junk, system::Sync::no);
      says(message_of([&] { read_mesh(folder / name); }), folder / name + ":");
    }
  }
  says(message_of([] { read_obj("x.obj", "v 0 0 0\n"); }), "no triangle or quadrilateral is in it");
}

// Address space far below what any of the claims would take; a plain std::bad_alloc would fail the test.
TEST_CASE("huge counts allocate nothing", "[files]") {
  const std::string huge = "999999999999";
  for (const char* name : {"2.msh", "4.msh", "x.inp", "x.k", "x.rad", "x.vtk", "x.vtu"}) {
    const std::string& text = base(name);
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] < '0' || text[i] > '9' || (i > 0 && text[i - 1] >= '0' && text[i - 1] <= '9')) continue;
      std::string changed = text;
      survive(name, changed.replace(i, 1, huge));
    }
  }
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  CHECK(used.ru_maxrss < 1 << 20);  // KiB
}
