// One small mesh in every format that is read: two quadrilaterals and a triangle on their right, a set "left"
// (two nodes), a set "plate" (all but the tip).
//
//   3---4---5
//   | 1 | 2 | 3 > 6
//   0---1---2
#pragma once
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::samples {

inline mesh::Mesh plate() {
  mesh::Mesh m;
  m.nodes = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0.125}, {0, 1, 0}, {1, 1, 0}, {2, 1, 1.0 / 3.0}, {3, 0.5, 0}};
  m.elements = {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 6, 5, -1}};
  m.define("left", {0, 3});
  m.define("plate", {0, 1, 2, 3, 4, 5});
  m.define("all", {0, 1, 2, 3, 4, 5, 6});
  m.define("boundary", {0, 1, 2, 3, 4, 5, 6});
  return m;
}

inline const std::string gmsh_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n2\n1 7 \"left\"\n2 9 \"plate\"\n$EndPhysicalNames\n"
    "$Nodes\n8\n10 0 0 0\n11 1 0 0\n12 2 0 0.125\n13 0 1 0\n14 1 1 0\n15 2 1 0.3333333333333333\n"
    "16 3 0.5 0\n99 5 5 5\n$EndNodes\n"
    "$Elements\n5\n1 15 2 0 1 99\n2 1 2 7 4 10 13\n3 3 2 9 1 10 11 14 13\n4 3 2 9 1 11 12 15 14\n"
    "5 2 2 0 2 12 16 15\n$EndElements\n";

inline const std::string gmsh_4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n2\n1 7 \"left\"\n2 9 \"plate\"\n$EndPhysicalNames\n"
    "$Entities\n1 1 2 0\n1 5 5 5 0\n4 0 0 0 0 1 0 1 7 2 1 -2\n"
    "1 0 0 0 2 1 0.5 1 9 1 4\n2 2 0 0 3 1 0.5 0 0\n$EndEntities\n"
    "$Nodes\n3 8 10 99\n2 1 0 6\n10\n11\n12\n13\n14\n15\n0 0 0\n1 0 0\n2 0 0.125\n0 1 0\n1 1 0\n"
    "2 1 0.3333333333333333\n2 2 1 1\n16\n3 0.5 0 0.1 0.2\n0 1 0 1\n99\n5 5 5\n$EndNodes\n"
    "$Elements\n4 5 1 5\n0 1 15 1\n1 99\n1 4 1 1\n2 10 13\n2 1 3 2\n3 10 11 14 13\n4 11 12 15 14\n"
    "2 2 2 1\n5 12 16 15\n$EndElements\n";

inline const std::string obj =
    "# a plate\nmtllib x.mtl\no sheet\nv 0 0 0\nv 1 0 0\nv 2 0 0.125\nv 0 1 0\nv 1 1 0\n"
    "v 2 1 0.3333333333333333\nv 3 0.5 0\nvt 0 0\nvn 0 0 1\ng left\nl 1 4\n"
    "g plate\nusemtl blue\nf 1/1/1 2//1 5/1 4\nf -6 -5 -2 -3\ng\ns off\nf 3 7 6\n";

// The same with all that these decks have: comments, sets by number, range and name, sets of elements, what
// belongs to the problem, and lines that go on.
inline const std::string abaqus =
    "*Heading\n a plate, 1, 2\n** nodes\n*Node, nset=all\n10, 0, 0\n11, 1., 0., 0\n12, 2, 0, 1.25D-1\n"
    "13, 0, 1, 0\n14, 1, 1, 0\n15, 2, 1, 0.3333333333333333\n16, 3, .5, 0\n99, 5, 5, 5\n"
    "*ELEMENT, type=S4R,\n ELSET = plate\n1, 10, 11, 14,\n13\n2, 11, 12, 15, 14\n"
    "*ELEMENT, TYPE=S3, ELSET=tip\n3, 12, 16, 15\n*ELEMENT, TYPE=T3D2\n4, 10, 13\n"
    "*NSET, NSET=left, GENERATE\n10, 13, 3\n*Elset, elset=whole\nPLATE, tip\n"
    "*NSET, NSET=boundary\n10, 11, 12, 13,\n14, 15, 16\n"
    "*MATERIAL, NAME=cloth\n*ELASTIC\n1e6, 0.3\n*STEP\n*NODE PRINT, NSET=left\nRF\n*END STEP\n";

inline const std::string stl =
    "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\n"
    "endsolid one\nsolid two\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 "
    "0\nendloop\n"
    "endfacet\nendsolid two\n";

// In columns, in long ones and between commas.
inline const std::string dyna =
    "$ a plate\n*KEYWORD\n*TITLE\na plate\n*NODE\n"
    "      10               0               0               0       0       0\n"
    "      11               1               0               0\n"
    "12,2.,0.,0.125\n      13             0.0             1.0             0.0\n"
    "      14             1.0             1.0             0.0\n"
    "*NODE +\n                  15                 2.0                 1.0  0.3333333333333333\n"
    "*NODE\n      16             3.0             0.5             0.0\n"
    "      99             5.0             5.0             5.0\n"
    "*ELEMENT_SHELL_THICKNESS\n       1       7      10      11      14      13\n"
    "           0.001           0.001           0.001           0.001\n"
    "       2       7      11      12      15      14\n$ thickness\n"
    "           0.001           0.001           0.001           0.001\n"
    "*ELEMENT_SHELL\n       3       7      12      16      15      15\n"
    "*SET_NODE_LIST_TITLE\nleft\n         1       0.0\n        10        13         0         0\n"
    "*SET_SHELL_LIST_GENERATE_TITLE\nplate\n         1\n         1         2\n"
    "*PART\nsheet\n         7         1         1\n*END\nanything\n";

// With groups of nodes, ranges, parts and shells, and what belongs to the problem.
inline const std::string radioss =
    "#RADIOSS STARTER\n"
    "# a plate\n"
    "/BEGIN\n"
    "plate\n"
    "      2022         0\n"
    "                  kg                   m                   s\n"
    "                  kg                   m                   s\n"
    "/TITLE\n"
    "a plate\n"
    "/NODE\n"
    "        10                   0                   0                   0\n"
    "        11                   1                   0\n"
    "        12                  2.                  0.             1.25D-1\n"
    "        13                   0                   1                   0\n"
    "        14                   1                   1                   0\n"
    "        15                   2                   1  0.3333333333333333\n"
    "        16                   3                  .5                   0\n"
    "        99                   5                   5                   5\n"
    "$ shells\n"
    "/SHELL/7\n"
    "         1        10        11        14        13\n"
    "         2        11        12        15        14                  0.               0.001\n"
    "/SH3N/7\n"
    "         3        12        16        15\n"
    "/PART/7\n"
    "sheet\n"
    "         1         1         0\n"
    "/GRNOD/NODE/1\n"
    "left\n"
    "        10        13\n"
    "/GRNOD/PART/3\n"
    "all\n"
    "         7\n"
    "/GRSHEL/SHEL/2\n"
    "plate\n"
    "         1\n"
    "         2\n"
    "/GRNOD/GENE/4\n"
    "boundary\n"
    "        10        16\n"
    "/MAT/ELAST/1\n"
    "cloth\n"
    "                1e-6\n"
    "/END\n"
    "anything\n";

// Bytes one after the other, as a program on this machine or on one of the other kind writes them.
struct Bytes {
  bool reversed = false;
  std::string text = {};
  template <class T>
  Bytes& add(std::initializer_list<T> values) {
    for (T value : values) {
      char raw[sizeof value];
      std::memcpy(raw, &value, sizeof value);
      text += reversed ? std::string(std::reverse_iterator(raw + sizeof value), std::reverse_iterator(raw))
                       : std::string(raw, sizeof value);
    }
    return *this;
  }
  Bytes& ints(std::initializer_list<std::int32_t> values) { return add(values); }
  Bytes& sizes(std::initializer_list<std::uint64_t> values) { return add(values); }
  Bytes& reals(std::initializer_list<double> values) { return add(values); }
  Bytes& words(const std::string& words) {
    text += words;
    return *this;
  }
};

inline const std::string gmsh_names = "$PhysicalNames\n2\n1 7 \"left\"\n2 9 \"plate\"\n$EndPhysicalNames\n";

inline std::string gmsh_2_binary(bool reversed = false) {
  Bytes b{reversed};
  b.words("$MeshFormat\n2.2 1 8\n").ints({1}).words("\n$EndMeshFormat\n" + gmsh_names + "$Nodes\n8\n");
  const auto m = plate();
  for (int i = 0; i < 7; ++i) {
    const Vec3& x = m.nodes[static_cast<std::size_t>(i)];
    b.ints({10 + i}).reals({x.x(), x.y(), x.z()});
  }
  b.ints({99}).reals({5, 5, 5}).words("\n$EndNodes\n$Elements\n5\n");
  b.ints({15, 1, 2, 1, 0, 1, 99}).ints({1, 1, 2, 2, 7, 4, 10, 13});
  b.ints({3, 2, 2, 3, 9, 1, 10, 11, 14, 13, 4, 9, 1, 11, 12, 15, 14}).ints({2, 1, 2, 5, 0, 2, 12, 16, 15});
  return b.words("\n$EndElements\n").text;
}

inline std::string gmsh_4_binary(bool reversed = false) {
  Bytes b{reversed};
  b.words("$MeshFormat\n4.1 1 8\n").ints({1}).words("\n$EndMeshFormat\n" + gmsh_names + "$Entities\n");
  b.sizes({1, 1, 2, 0}).ints({1}).reals({5, 5, 5}).sizes({0});
  b.ints({4}).reals({0, 0, 0, 0, 1, 0}).sizes({1}).ints({7}).sizes({2}).ints({1, -2});
  b.ints({1}).reals({0, 0, 0, 2, 1, 0.5}).sizes({1}).ints({9}).sizes({1}).ints({4});
  b.ints({2}).reals({2, 0, 0, 3, 1, 0.5}).sizes({0, 0}).words("\n$EndEntities\n$Nodes\n");
  b.sizes({3, 8, 10, 99}).ints({2, 1, 0}).sizes({6, 10, 11, 12, 13, 14, 15});
  const auto m = plate();
  for (std::size_t i = 0; i < 6; ++i) b.reals({m.nodes[i].x(), m.nodes[i].y(), m.nodes[i].z()});
  b.ints({2, 2, 1}).sizes({1, 16}).reals({3, 0.5, 0, 0.1, 0.2});
  b.ints({0, 1, 0}).sizes({1, 99}).reals({5, 5, 5}).words("\n$EndNodes\n$Elements\n");
  b.sizes({4, 5, 1, 5}).ints({0, 1, 15}).sizes({1, 1, 99}).ints({1, 4, 1}).sizes({1, 2, 10, 13});
  b.ints({2, 1, 3})
      .sizes({2, 3, 10, 11, 14, 13, 4, 11, 12, 15, 14})
      .ints({2, 2, 2})
      .sizes({1, 5, 12, 16, 15});
  return b.words("\n$EndElements\n").text;
}

// By VTK's own writers: every form that they have, by a name that says it and ends as the file would.
std::map<std::string, std::string> from_vtk();

// All of the above.
inline std::map<std::string, std::string> every() {
  auto all = from_vtk();
  all.insert({{"2.msh", gmsh_2},
              {"4.msh", gmsh_4},
              {"2-binary.msh", gmsh_2_binary()},
              {"4-binary.msh", gmsh_4_binary()},
              {"2-reversed.msh", gmsh_2_binary(true)},
              {"4-reversed.msh", gmsh_4_binary(true)},
              {"plate.obj", obj},
              {"plate.inp", abaqus},
              {"plate.k", dyna},
              {"plate.rad", radioss}});
  return all;
}

}  // namespace fabricsh::samples
