// The functions of fabric.mesh.*, in several groups.
#pragma once
#include "mesh/mesh.hpp"
#include "script/bind/rooms.hpp"

namespace fabricsh::script {

inline Argument join_() {
  return flag_("join", "make one node of those at one place (within 1e-6 of the mesh's size)");
}
std::vector<Entry> mesh_generator_rows();
std::vector<Entry> mesh_file_rows();
std::vector<Entry> panel_rows();  // outlines, holes, darts and notches
// The mesh in a file; warns where the file may have been cut short.
// unit: what one of the file's lengths is in m, 0 where the deck does not say and m are taken.
mesh::Mesh read_mesh_file(const Call& call, const std::string& path, bool at_rest = false, double unit = 0);

}  // namespace fabricsh::script
