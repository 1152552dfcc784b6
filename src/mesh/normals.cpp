#include "mesh/normals.hpp"

#include <cmath>

namespace fabricsh::mesh {

std::vector<Vec3> node_normals(const Mesh& mesh) {
  if (mesh.whole && !mesh.hinged) {  // all nodes at a place have the normal of the sheet there
    const std::vector<Vec3> of_places = node_normals(*mesh.whole);
    std::vector<Vec3> normals;
    for (const Index place : mesh.place) normals.push_back(of_places[static_cast<std::size_t>(place)]);
    return normals;
  }
  std::vector<Vec3> normals(mesh.nodes.size(), Vec3::Zero());
  for (const auto& e : mesh.elements) {
    const int n = e[3] < 0 ? 3 : 4;
    for (int a = 0; a < n; ++a) {
      const Vec3& here = mesh.nodes[e[a]];
      normals[e[a]] += (mesh.nodes[e[(a + 1) % n]] - here).cross(mesh.nodes[e[(a + n - 1) % n]] - here);
    }
  }
  for (Vec3& normal : normals)
    if (normal.norm() > 0) normal.normalize();
  return normals;
}

namespace {

bool triangle_spans(const Vec3 (&x)[4], const Vec3 (&d)[4]) {
  const Vec3 normal = (x[1] - x[0]).cross(x[2] - x[0]);
  for (int k = 0; k < 3; ++k)
    if (!(normal.dot(d[0] + d[1] + d[2] + 3 * d[k]) > 0)) return false;
  return true;
}

bool quadrilateral_spans(const Vec3 (&x)[4], const Vec3 (&d)[4]) {
  const double g = 1 / std::sqrt(3.0);
  for (const double r : {-g, g})
    for (const double s : {-g, g}) {
      const double N[4] = {(1 - r) * (1 - s), (1 + r) * (1 - s), (1 + r) * (1 + s), (1 - r) * (1 + s)};
      const Vec3 along = (1 - s) * (x[1] - x[0]) + (1 + s) * (x[2] - x[3]);
      const Vec3 across = (1 - r) * (x[3] - x[0]) + (1 + r) * (x[2] - x[1]);
      const Vec3 director = N[0] * d[0] + N[1] * d[1] + N[2] * d[2] + N[3] * d[3];
      if (!(along.cross(across).dot(director) > 0)) return false;
    }
  return true;
}

}  // namespace

bool spans_volume(const Mesh& mesh, const std::array<Index, 4>& element, const std::vector<Vec3>& directors) {
  Vec3 x[4], d[4];
  const int n = element[3] < 0 ? 3 : 4;
  for (int a = 0; a < n; ++a) {
    x[a] = mesh.nodes[element[a]];
    d[a] = directors[element[a]];
  }
  return n == 3 ? triangle_spans(x, d) : quadrilateral_spans(x, d);
}

}  // namespace fabricsh::mesh
