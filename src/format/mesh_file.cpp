#include "format/mesh_file.hpp"

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "base/number.hpp"
#include "format/deck_write.hpp"
#include "format/source.hpp"
#include "format/vtu.hpp"
#include "geometry/box.hpp"

namespace fabricsh::format {

namespace {

std::string ending(const std::string& path) {
  std::string text = std::filesystem::path(path).extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
  return text;
}

using Reader = mesh::Mesh (*)(const std::string&, std::string_view, Remarks*);

// A reader of files that are complete or refused.
template <mesh::Mesh (*read)(const std::string&, std::string_view)>
mesh::Mesh complete(const std::string& name, std::string_view bytes, Remarks*) {
  return read(name, bytes);
}

Reader reader_of(const std::string& path) {
  const std::string text = ending(path);
  if (text == ".msh") return complete<read_gmsh>;
  if (text == ".obj") return read_obj;
  if (text == ".vtu") return complete<read_vtu>;
  if (text == ".vtk") return complete<read_legacy_vtk>;
  if (text == ".inp") return read_abaqus;
  if (text == ".k" || text == ".key") return read_dyna;
  if (text == ".stl") return read_stl;
  if (text == ".ply") return read_ply;
  throw Error("cannot read '" + path +
              "': expected a name that ends in .msh, .vtu, .vtk, .obj, .stl, .ply, .inp or .k");
}

void write_vtu_mesh(const std::string& path, const mesh::Mesh& mesh) {
  Grid grid{mesh.nodes, mesh.elements};
  for (const auto& [name, ids] : mesh.sets) {
    Array array{name, 1, std::vector<double>(mesh.nodes.size(), 0.0)};
    for (const Index id : ids) array.values[static_cast<std::size_t>(id)] = 1;
    array.flags = true;
    grid.point_data.push_back(std::move(array));
  }
  write_vtu(path, grid);
}

// Asks about units where lengths in m would be those of no cloth.
void ask_about_size(const std::string& path, const mesh::Mesh& mesh, Remarks& remarks) {
  constexpr double most = 10, least = 1e-4;  // m
  const double size = box_of(mesh.nodes).size().maxCoeff();
  if (size > least && size < most) return;
  remarks.push_back(path + ": the mesh spans " + number(size, 3) +
                    " m, far from what cloth is: are its lengths in m? mesh:map changes them, as in "
                    "mesh:map(function(x, y, z) return x/1000, y/1000, z/1000 end) for a file in mm");
}

constexpr const char* units_word = "lengths in m";

}  // namespace

std::optional<std::string> mesh_text(const std::string& path, const mesh::Mesh& mesh) {
  const std::string text = ending(path);
  if (text == ".msh") return gmsh_text(mesh);
  if (text == ".obj") return obj_text(mesh);
  if (text == ".ply") return ply_text(mesh);
  if (text == ".stl") return stl_text(mesh);
  if (text == ".inp") return "** a mesh of shells, " + std::string(units_word) + "\n" + abaqus_lines(mesh);
  if (text == ".k")
    return "*KEYWORD\n$ a mesh of shells, " + std::string(units_word) + "\n" + dyna_lines(mesh) + "*END\n";
  if (text == ".rad") return "# a mesh of shells, " + std::string(units_word) + "\n" + radioss_lines(mesh);
  return {};
}

mesh::Mesh read_mesh(const std::string& path, Remarks* remarks) {
  const Reader read = reader_of(path);
  const std::string bytes = read_file(path);
  if (bytes.empty()) throw Error(path + ": the file is empty");
  mesh::Mesh mesh = read(path, bytes, remarks);
  if (remarks != nullptr) ask_about_size(path, mesh, *remarks);
  return mesh;
}

void write_mesh(const std::string& path, const mesh::Mesh& mesh) {
  const std::string text = ending(path);
  if (mesh.elements.empty()) throw Error("cannot write '" + path + "': the mesh has no element");
  if (text == ".vtu") return write_vtu_mesh(path, mesh);
  if (const auto lines = mesh_text(path, mesh)) return system::write_file(path, *lines);
  throw Error("cannot write '" + path + "': expected a name that ends in " + mesh_endings);
}

}  // namespace fabricsh::format
