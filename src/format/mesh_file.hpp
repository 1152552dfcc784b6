// Meshes from and to files; the ending of the name says the format. Every error of reading names the file
// and, where there is one, its line, and nothing is allocated that the size of the file does not justify.
#pragma once
#include <string>
#include <string_view>

#include "mesh/mesh.hpp"
#include "system/atomic.hpp"

namespace fabricsh::format {

// .msh (Gmsh 2 and 4.1, text and binary; physical groups become sets), .vtu and .vtk (arrays of integers
// become sets), .obj (groups become sets). Triangles and quadrilaterals; lines and points count for sets
// alone. Nodes that no element uses are left out; sets all and boundary are added where the file has none.
mesh::Mesh read_mesh(const std::string& path);
// .vtu (sets as arrays of 0 and 1 on the points) or .msh (Gmsh 4.1 text: sets as physical points).
void write_mesh(const std::string& path, const mesh::Mesh& mesh);

// One format each; `name` stands for the file in errors.
mesh::Mesh read_gmsh(const std::string& name, std::string_view bytes);
mesh::Mesh read_obj(const std::string& name, std::string_view bytes);
mesh::Mesh read_vtu(const std::string& name, std::string_view bytes);
mesh::Mesh read_legacy_vtk(const std::string& name, std::string_view bytes);
std::string gmsh_text(const mesh::Mesh& mesh);

}  // namespace fabricsh::format
