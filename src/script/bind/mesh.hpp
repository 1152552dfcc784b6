// The rows of fabric.mesh.*, in parts.
#pragma once
#include "script/bind/rooms.hpp"

namespace fabricsh::script {

std::vector<Entry> mesh_generator_rows();
std::vector<Entry> mesh_file_rows();

}  // namespace fabricsh::script
