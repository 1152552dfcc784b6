// The functions of fabric.mesh.*, in several groups.
#pragma once
#include "script/bind/rooms.hpp"

namespace fabricsh::script {

std::vector<Entry> mesh_generator_rows();
std::vector<Entry> mesh_file_rows();

}  // namespace fabricsh::script
