// Slits along lines of edges, and rectangles with given lines of nodes.
#include <algorithm>

#include "mesh/corners.hpp"
#include "mesh/edges.hpp"
#include "mesh/generators.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::mesh;

namespace {

// Parts of a mesh that hang together by edges.
int pieces(const Mesh& m) {
  std::vector<Index> part(m.nodes.size());
  for (std::size_t i = 0; i < part.size(); ++i) part[i] = static_cast<Index>(i);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& e : m.elements)
      for (const Index n : e)
        if (part[n] != part[e[0]]) {
          part[n] = part[e[0]] = std::min(part[n], part[e[0]]);
          changed = true;
        }
  }
  std::sort(part.begin(), part.end());
  return static_cast<int>(std::unique(part.begin(), part.end()) - part.begin());
}

}  // namespace

TEST_CASE("a slit from the rim doubles its nodes but for its tip") {
  Mesh m = rectangle(0.3, 0.5, 3, 5);
  const CrackFaces crack_faces = slit(m, {0.1, 0, 0}, {0.1, 0.3, 0});
  CHECK(m.nodes.size() == 24 + 3);
  CHECK((crack_faces.left == NodeSet{1, 5, 9, 13}));
  CHECK((crack_faces.right == NodeSet{13, 24, 25, 26}));
  for (Index i = 0; i < 3; ++i) CHECK(m.nodes[24 + i] == m.nodes[crack_faces.left[i]]);
  // Seen against the normal, what is to the left of the way up is at smaller x.
  CHECK((m.elements[0] == std::array<Index, 4>{0, 1, 5, 4}));
  CHECK((m.elements[1] == std::array<Index, 4>{24, 2, 6, 25}));
  CHECK(pieces(m) == 1);
  CHECK((m.set("bottom") == NodeSet{0, 1, 2, 3, 24}));
  CHECK(m.set("all").size() == 27);
  CHECK(m.set("boundary") == free_nodes(m));
  CHECK(std::binary_search(m.set("boundary").begin(), m.set("boundary").end(), Index{13}));
  CHECK(m.flat);
}

TEST_CASE("slits inside, through, across each other and on the way back") {
  Mesh m = rectangle(0.4, 0.4, 4, 4);
  slit(m, {0.1, 0.2, 0}, {0.3, 0.2, 0});
  CHECK(m.nodes.size() == 25 + 1);
  slit(m, {0.2, 0.4, 0}, {0.2, 0.2, 0});  // ends at the crack faces of the first
  CHECK(m.nodes.size() == 26 + 3);
  CHECK(pieces(m) == 1);
  Mesh through = rectangle(0.4, 0.4, 4, 4);
  const CrackFaces crack_faces = slit(through, {0.4, 0.3, 0}, {0, 0.3, 0});
  CHECK(pieces(through) == 2);
  CHECK(crack_faces.left.size() == 5);
  CHECK(through.nodes[through.elements[0][0]].y() == 0);
  CHECK(crack_faces.right.front() == 25);  // above, seen on the way to smaller x
  CHECK(through.elements[12][0] == 25);
}

TEST_CASE("a slit that does not follow edges is refused with the place") {
  const auto why = [](Vec3 from, Vec3 to) {
    Mesh m = rectangle(0.3, 0.5, 3, 5);
    const std::string words = message_of([&] { slit(m, from, to); });
    CHECK(m.nodes.size() == 24);
    return words;
  };
  says(why({0.15, 0, 0}, {0.15, 0.3, 0}), "has no edge at (0.15, 0, 0) m: expected a line of edges");
  says(why({0.1, 0, 0}, {0.1, 0.25, 0}), "leaves the edges at (0.1, 0.2, 0) m");
  says(why({0.1, 0.05, 0}, {0.1, 0.3, 0}), "leaves the edges at (0.1, 0.05, 0) m");
  says(why({0, 0, 0}, {0.3, 0.5, 0}), "has no edge at (0, 0, 0) m");
  says(why({0.1, 0.1, 0}, {0.1, 0.2, 0}), "is one edge inside the mesh, which cannot open");
  says(why({0, 0.1, 0}, {0, 0.3, 0}), "follows a free edge at (0, 0.1, 0) m");
  says(why({0.1, 0.1, 0}, {0.1, 0.1, 0}), "expected two points");
  Mesh used = rectangle(0.3, 0.5, 3, 5);
  used.in_use = true;
  says(message_of([&] { slit(used, {0.1, 0, 0}, {0.1, 0.3, 0}); }), "slit: a compiled model uses this mesh");
}

TEST_CASE("a graded rectangle has its lines of nodes where they are given") {
  const Grading lines{{0, 0.01, 0.03, 0.07}, {0, 0.02, 0.05}};
  const Mesh m = rectangle(0.07, 0.05, lines, {1, 2, 3});
  CHECK(m.nodes.size() == 12);
  CHECK((m.nodes[6] - Vec3(1.03, 2.02, 3)).norm() < 1e-15);
  CHECK((m.set("right") == NodeSet{3, 7, 11}));
  const auto why = [](std::vector<double> x) {
    return message_of([&] { rectangle(0.07, 0.05, Grading{std::move(x), {0, 0.05}}); });
  };
  says(why({0, 0.03, 0.02, 0.07}),
       "rectangle: field 'grading.x': expected positions that ascend, got 0.02 m after 0.03 m at place 3");
  says(why({0, 0.06}), "expected positions of the lines of nodes from 0 to 0.07 m, got 0 to 0.06 m");
  says(why({}), "from 0 to 0.07 m, got none");
}
