// A mesh as a bare surface, without sets: .obj, .ply, .stl.
#include "base/number.hpp"
#include "format/mesh_file.hpp"
#include "mesh/edges.hpp"

namespace fabricsh::format {

namespace {

std::string surface_point(const Vec3& x) {
  return exact_number(x.x()) + " " + exact_number(x.y()) + " " + exact_number(x.z());
}

using mesh::corner_count;

std::string facet(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 across = (b - a).cross(c - a);
  const double length = across.norm();
  const Vec3 normal = length > 0 ? Vec3(across / length) : Vec3(Vec3::Zero());
  std::string text = "facet normal " + surface_point(normal) + "\nouter loop\n";
  for (const Vec3& x : {a, b, c}) text += "vertex " + surface_point(x) + "\n";
  return text + "endloop\nendfacet\n";
}

}  // namespace

std::string obj_text(const mesh::Mesh& mesh) {
  std::string text;
  for (const Vec3& x : mesh.nodes) text += "v " + surface_point(x) + "\n";
  for (const auto& ids : mesh.elements) {
    text += "f";
    for (std::size_t k = 0; k < corner_count(ids); ++k) text += " " + std::to_string(ids[k] + 1);
    text += "\n";
  }
  return text;
}

std::string ply_text(const mesh::Mesh& mesh) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(mesh.nodes.size()) +
                     "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                     std::to_string(mesh.elements.size()) +
                     "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& x : mesh.nodes) text += surface_point(x) + "\n";
  for (const auto& ids : mesh.elements) {
    text += std::to_string(corner_count(ids));
    for (std::size_t k = 0; k < corner_count(ids); ++k) text += " " + std::to_string(ids[k]);
    text += "\n";
  }
  return text;
}

// A quadrilateral is two facets, cut from its first corner.
std::string stl_text(const mesh::Mesh& mesh) {
  std::string text = "solid cloth\n";
  const auto at = [&mesh](mesh::Index id) -> const Vec3& { return mesh.nodes[static_cast<std::size_t>(id)]; };
  for (const auto& ids : mesh.elements) {
    text += facet(at(ids[0]), at(ids[1]), at(ids[2]));
    if (corner_count(ids) == 4) text += facet(at(ids[0]), at(ids[2]), at(ids[3]));
  }
  return text + "endsolid cloth\n";
}

}  // namespace fabricsh::format
