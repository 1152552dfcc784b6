#include "format/mesh_file.hpp"

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "format/source.hpp"
#include "format/vtu.hpp"
#include "mesh/check.hpp"

namespace fabricsh::format {

namespace {

std::string ending(const std::string& path) {
  std::string text = std::filesystem::path(path).extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
  return text;
}

// A reader of files that are complete or refused.
template <mesh::Mesh (*read)(const std::string&, std::string_view)>
mesh::Mesh complete(const std::string& name, std::string_view bytes, Remarks*) {
  return read(name, bytes);
}

template <auto read, bool at_rest>
mesh::Mesh deck(const std::string& name, std::string_view bytes, Remarks* remarks) {
  return read(name, bytes, remarks, at_rest);
}

template <std::string (*text)(const mesh::Mesh&)>
void write_text(const std::string& path, const mesh::Mesh& mesh) {
  system::write_file(path, text(mesh));
}

void write_vtu_mesh(const std::string& path, const mesh::Mesh& mesh) {
  VtuGrid grid{mesh.nodes, mesh.elements};
  for (const auto& [name, ids] : mesh.sets) {
    Array array{name, 1, std::vector<double>(mesh.nodes.size(), 0.0)};
    for (const Index id : ids) array.values[static_cast<std::size_t>(id)] = 1;
    array.flags = true;
    grid.point_data.push_back(std::move(array));
  }
  write_vtu(path, grid);
}

std::string abaqus_text(const mesh::Mesh& mesh) {
  return "** a mesh of shells, lengths in m\n" + abaqus_lines(mesh);
}

std::string dyna_text(const mesh::Mesh& mesh) {
  return "*KEYWORD\n$ a mesh of shells, lengths in m\n" + dyna_lines(mesh) + "*END\n";
}

std::string radioss_text(const mesh::Mesh& mesh) {
  return "# a mesh of shells, lengths in m\n" + radioss_lines(mesh);
}

struct MeshFormat {
  const char* ending;
  mesh::Mesh (*read)(const std::string& name, std::string_view bytes, Remarks* remarks);  // null: not read
  void (*write)(const std::string& path, const mesh::Mesh& mesh) = nullptr;               // null: not written
  // The stress-free shape that a file may hold beside the mesh; null: files of this kind have none.
  mesh::Mesh (*read_at_rest)(const std::string& name, std::string_view bytes, Remarks* remarks) = nullptr;
};

constexpr MeshFormat forms[] = {
    {".msh", complete<read_gmsh>, write_text<gmsh_text>},
    {".vtu", complete<read_vtu>, write_vtu_mesh},
    {".vtk", complete<read_legacy_vtk>},
    {".obj", read_obj, write_text<obj_text>},
    {".stl", read_stl, write_text<stl_text>},
    {".ply", read_ply, write_text<ply_text>},
    {".inp", deck<read_abaqus, false>, write_text<abaqus_text>, deck<read_abaqus, true>},
    {".k", deck<read_dyna, false>, write_text<dyna_text>, deck<read_dyna, true>},
    {".key", deck<read_dyna, false>, nullptr, deck<read_dyna, true>},
    {".rad", deck<read_radioss, false>, write_text<radioss_text>, deck<read_radioss, true>},
};

// The endings of the forms that have the function, ".obj, .stl or .ply".
template <class Function>
std::string endings(Function MeshFormat::*has) {
  std::vector<std::string> all;
  for (const MeshFormat& form : forms)
    if (form.*has != nullptr) all.emplace_back(form.ending);
  std::string text = all.front();
  for (std::size_t i = 1; i < all.size(); ++i) text += (i + 1 < all.size() ? ", " : " or ") + all[i];
  return text;
}

template <class Function>
Function function_of(const std::string& path, Function MeshFormat::*has, const char* what) {
  const std::string text = ending(path);
  for (const MeshFormat& form : forms)
    if (text == form.ending && form.*has != nullptr) return form.*has;
  throw Error("cannot " + std::string(what) + " '" + path + "': expected a name that ends in " +
              endings(has));
}

// Asks about units where lengths in m would be those of no cloth.
void ask_about_size(const std::string& path, const mesh::Mesh& mesh, Remarks& remarks) {
  const std::string doubt = mesh::doubt_about_units(mesh);
  if (doubt.empty()) return;
  remarks.push_back(
      path + ": " + doubt +
      " mesh:map changes them, as in mesh:map(function(x, y, z) return x/1000, y/1000, z/1000 end) "
      "for a file in mm");
}

}  // namespace

std::string read_endings() { return endings(&MeshFormat::read); }
std::string written_endings() { return endings(&MeshFormat::write); }

namespace {

template <class Read>
mesh::Mesh read_by(Read read, const std::string& path, Remarks* remarks) {
  const std::string bytes = read_file(path);
  if (bytes.empty()) throw Error(path + ": the file is empty");
  mesh::Mesh mesh = read(path, bytes, remarks);
  if (remarks != nullptr) ask_about_size(path, mesh, *remarks);
  return mesh;
}

}  // namespace

mesh::Mesh read_mesh(const std::string& path, Remarks* remarks) {
  return read_by(function_of(path, &MeshFormat::read, "read"), path, remarks);
}

mesh::Mesh read_mesh_at_rest(const std::string& path, Remarks* remarks) {
  return read_by(function_of(path, &MeshFormat::read_at_rest, "read a stress-free shape of"), path, remarks);
}

bool states_units(const std::string& path) {
  if (ending(path) != ".rad") return false;
  const std::string bytes = read_file(path);
  return bytes.starts_with("/BEGIN") || bytes.find("\n/BEGIN") != bytes.npos;
}

void write_mesh(const std::string& path, const mesh::Mesh& mesh) {
  const auto write = function_of(path, &MeshFormat::write, "write");
  if (mesh.elements.empty()) throw Error("cannot write '" + path + "': the mesh has no element");
  write(path, mesh);
}

}  // namespace fabricsh::format
