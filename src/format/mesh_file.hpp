// Reading and writing meshes; the extension of the file determines the format. Every reading error names the
// file and, if there is one, the line. No memory is allocated beyond what the size of the file justifies.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::format {

// .msh (Gmsh 2 and 4.1, text and binary; physical groups become sets), .vtu and .vtk (integer arrays become
// sets), .obj (groups become sets), .inp of Abaqus and CalculiX, .k of LS-DYNA (sets of nodes and of
// elements; parts, if there are several), .rad of OpenRadioss (groups; parts as well; lengths in the units
// that it states, else in m), .stl (equal vertices are joined; solids, if there are several), .ply. Reads
// triangles and quadrilaterals; lines and points are used for sets only. Nodes that no element uses are
// dropped; the sets all and boundary are added if missing. An end that a file may lack, but one that was cut
// short lacks as well, is said in the remarks: the *END of a .k, the /END of a .rad, *END STEP and the like
// of an .inp, the end of the last line of an .inp or .obj. So is what was passed over or changed (statements
// of an .obj, facets without area of an .stl, faces of many corners cut into triangles), and a size that no
// cloth has.
using Remarks = std::vector<std::string>;
inline constexpr const char* no_line_end =
    "the last line has no end; if the file was cut short, part of the mesh is missing";
mesh::Mesh read_mesh(const std::string& path, Remarks* remarks = nullptr);
// The same mesh in the stress-free shape that an .inp, a .k or a .rad has beside it; read_mesh names such a
// shape in a remark. Error: there is none.
mesh::Mesh read_mesh_at_rest(const std::string& path, Remarks* remarks = nullptr);
// Whether the file states what its lengths are, so that they are m when it has been read: a .rad with /BEGIN.
bool states_units(const std::string& path);
// With sets of nodes: .vtu (point arrays of 0 and 1), .msh (Gmsh 4.1 text: physical points), .inp, .k, .rad;
// the surface alone: .obj, .ply, .stl.
void write_mesh(const std::string& path, const mesh::Mesh& mesh);
// ".msh, .vtu ... or .k", for messages; from the table in mesh_file.cpp.
std::string read_endings();
std::string written_endings();

// One reader for each format; `name` is the name of the file in errors.
mesh::Mesh read_gmsh(const std::string& name, std::string_view bytes);
mesh::Mesh read_obj(const std::string& name, std::string_view bytes, Remarks* remarks = nullptr);
mesh::Mesh read_vtu(const std::string& name, std::string_view bytes);
mesh::Mesh read_legacy_vtk(const std::string& name, std::string_view bytes);
mesh::Mesh read_abaqus(const std::string& name, std::string_view bytes, Remarks* remarks = nullptr,
                       bool at_rest = false);
mesh::Mesh read_dyna(const std::string& name, std::string_view bytes, Remarks* remarks = nullptr,
                     bool at_rest = false);
mesh::Mesh read_radioss(const std::string& name, std::string_view bytes, Remarks* remarks = nullptr,
                        bool at_rest = false);
mesh::Mesh read_stl(const std::string& name, std::string_view bytes, Remarks* remarks = nullptr);
mesh::Mesh read_ply(const std::string& name, std::string_view bytes, Remarks* remarks = nullptr);
std::string gmsh_text(const mesh::Mesh& mesh);
std::string obj_text(const mesh::Mesh& mesh);
std::string ply_text(const mesh::Mesh& mesh);
std::string stl_text(const mesh::Mesh& mesh);

// --- A mesh as other solvers write it: nodes, shells of 3 and 4 nodes, sets of nodes. Numbers count from 1
// in the mesh's order. The rest of a deck (materials, supports, steps) surrounds these lines.

struct DeckForm {
  double length = 1;             // what a metre is in the deck
  bool membrane = false;         // Abaqus: M3D4R and M3D3 in the place of S4 and S3
  std::string elements = "all";  // Abaqus: name of the set of all elements
};

// Errors: a set's name that the format can't hold, a mesh too large for its columns.
std::string abaqus_lines(const mesh::Mesh& mesh, const DeckForm& form = {});
std::string dyna_lines(const mesh::Mesh& mesh,
                       const DeckForm& form = {});  // part 1; set k is the k-th by name
std::string radioss_lines(const mesh::Mesh& mesh, const DeckForm& form = {});  // part 1; group k as well

}  // namespace fabricsh::format
